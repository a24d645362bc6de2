package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.StructureKind;

/**
 * Stray parts of organs and large vessels: components that are small beside the organ and lie away from its main ones,
 * as where a segmentation takes gas of the bowel for lung. The lobes of both lungs count as one organ, and so do all
 * parts of the bowel, of which loops may lie apart. Branches of a vessel within an organ may lie apart as well.
 * Distances are judged on a grid of coarse cells: a component is near another if their cells touch.
 */
final class StrayParts {
    /** A component of at least this share of its structure is a main one, as is the largest. */
    private static final double MAIN_SHARE = 0.1;
    /**
     * The same of a part of one organ that lies farther from its largest part than that is long: a speck of some size
     * is much of an adrenal gland. Parts of a kidney or a spleen lie nearer, and those of a pair under one label are
     * alike.
     */
    private static final double FAR_SHARE = 1 / 3.0;
    /** Edge of the coarse cells, mm. */
    private static final double CELL_MM = 10;

    /** Least volume of a loop of bowel that lies apart, ml. */
    private static final double LOOP_ML = 2;

    /** Vessels that do not branch within an organ, without their sides. */
    private static final Set<String> TRUNKS = Set.of(
            "aorta",
            "inferior_vena_cava",
            "superior_vena_cava",
            "portal_and_splenic_vein",
            "brachiocephalic_trunk",
            "brachiocephalic_vein",
            "subclavian_artery",
            "common_carotid_artery",
            "iliac_artery",
            "iliac_vein");

    /** Names of what may lie in several places, as cysts and what a table calls no organ of a name of its own. */
    private static final Pattern SCATTERED = Pattern.compile("kidney_cyst.*|organ_.*");

    private final Segmentation s;
    private final VoxelRuns runs;
    /** Number of voxels along each edge of a coarse cell. */
    private final int[] voxels = new int[3];

    private final int columns;
    private final int rows;
    /** The organ of each segment: the number of its first segment; 0 for bones, branching vessels and others. */
    private final int[] organ;
    /**
     * Whether a segment is one organ by itself: neither lung nor bowel, nor a vessel, of which far parts may be true.
     */
    private final boolean[] isCompact;

    StrayParts(Segmentation s, VoxelRuns runs) {
        this.s = s;
        this.runs = runs;
        for (int axis = 0; axis < 3; axis++) {
            voxels[axis] = Math.max(1, (int) Math.round(CELL_MM / s.grid().spacing(axis)));
        }
        // A margin of one cell at either end spares the neighbours of a cell a test.
        columns = s.columns / voxels[0] + 3;
        rows = s.rows / voxels[1] + 3;
        isCompact = new boolean[s.names().size() + 1];
        organ = organs(isCompact.length);
    }

    /**
     * Marks the components that are to be left out.
     *
     * @param kept by component; set to false for stray ones
     * @return a sentence that names them, if there are any
     */
    Optional<String> leaveOut(boolean[] kept) {
        BitSet near = main();
        BitSet[] cells = occupied(near);
        for (int run = 0; run < runs.count(); run++) {
            if (!near.get(runs.component(run)) && touches(cells[organ[s.segmentAt(runs.from(run))]], run)) {
                near.set(runs.component(run));
            }
        }
        int[] stray = new int[organ.length];
        for (int run = 0; run < runs.count(); run++) {
            int component = runs.component(run);
            if (component == run && kept[component] && !near.get(component) && !isLoop(component)) {
                stray[s.segmentAt(runs.from(run))] += runs.size(component);
                kept[component] = false;
            }
        }
        return sentence(stray);
    }

    /** The main components of organs, and all components of other structures. */
    private BitSet main() {
        int[] largest = new int[organ.length];
        int[] total = new int[organ.length];
        for (int run = 0; run < runs.count(); run++) {
            int segment = s.segmentAt(runs.from(run));
            total[segment] += runs.to(run) - runs.from(run);
            largest[segment] = Math.max(largest[segment], runs.size(runs.component(run)));
        }
        BitSet main = new BitSet();
        for (int run = 0; run < runs.count(); run++) {
            int segment = s.segmentAt(runs.from(run));
            int size = runs.size(runs.component(run));
            if (organ[segment] == 0 || size == largest[segment] || size >= MAIN_SHARE * total[segment]) {
                main.set(runs.component(run));
            }
        }
        Map<Integer, int[]> boxes = boxes(main);
        for (int component : boxes.keySet()) {
            int segment = s.segmentAt(runs.from(component));
            boolean small = runs.size(component) < Math.min(largest[segment], FAR_SHARE * total[segment]);
            if (small
                    && boxes.entrySet().stream()
                            .filter(other -> s.segmentAt(runs.from(other.getKey())) == segment
                                    && runs.size(other.getKey()) == largest[segment])
                            .allMatch(other -> isFar(boxes.get(component), other.getValue()))) {
                main.clear(component);
            }
        }
        return main;
    }

    /** Boxes of the components of compact organs in a set: first column, row and slice, then the last ones. */
    private Map<Integer, int[]> boxes(BitSet components) {
        TreeMap<Integer, int[]> boxes = new TreeMap<>();
        for (int run = 0; run < runs.count(); run++) {
            int component = runs.component(run);
            if (components.get(component) && isCompact[s.segmentAt(runs.from(run))]) {
                int row = runs.from(run) / s.columns;
                int[] first = {runs.from(run) % s.columns, row % s.rows, row / s.rows};
                int[] last = {(runs.to(run) - 1) % s.columns, first[1], first[2]};
                int[] box = boxes.computeIfAbsent(
                        component, none -> new int[] {first[0], first[1], first[2], last[0], last[1], last[2]});
                for (int axis = 0; axis < 3; axis++) {
                    box[axis] = Math.min(box[axis], first[axis]);
                    box[3 + axis] = Math.max(box[3 + axis], last[axis]);
                }
            }
        }
        return boxes;
    }

    /** Whether a box lies farther from another than that is long from corner to corner. */
    private boolean isFar(int[] box, int[] other) {
        double gap = 0;
        double length = 0;
        for (int axis = 0; axis < 3; axis++) {
            double spacing = s.grid().spacing(axis);
            int between = Math.max(0, Math.max(box[axis] - other[3 + axis], other[axis] - box[3 + axis]));
            gap = StrictMath.hypot(gap, spacing * between);
            length = StrictMath.hypot(length, spacing * (other[3 + axis] - other[axis] + 1));
        }
        return gap > length;
    }

    /** The coarse cells of the main components of each organ. */
    private BitSet[] occupied(BitSet main) {
        BitSet[] cells = new BitSet[organ.length];
        Arrays.setAll(cells, i -> new BitSet());
        for (int run = 0; run < runs.count(); run++) {
            int number = organ[s.segmentAt(runs.from(run))];
            if (number > 0 && main.get(runs.component(run))) {
                int row = rowOfCells(run);
                cells[number].set(row + firstCell(run), row + lastCell(run) + 1);
            }
        }
        return cells;
    }

    private int[] organs(int segments) {
        int[] organ = new int[segments];
        int lung = 0;
        int bowel = 0;
        for (int segment = 1; segment < segments; segment++) {
            StructureKind kind =
                    SegmentationRepair.kind(s.names().get(segment - 1)).orElse(StructureKind.OTHER);
            if (kind == StructureKind.LUNG) {
                lung = lung == 0 ? segment : lung;
                organ[segment] = lung;
            } else if (isBowel(segment)) {
                bowel = bowel == 0 ? segment : bowel;
                organ[segment] = bowel;
            } else if (kind == StructureKind.LIVER || kind == StructureKind.ORGAN || isTrunk(segment)) {
                organ[segment] = segment;
                isCompact[segment] = !isTrunk(segment)
                        && !SCATTERED.matcher(s.names().get(segment - 1)).matches();
            }
        }
        return organ;
    }

    private boolean isLoop(int component) {
        return isBowel(s.segmentAt(runs.from(component))) && s.grid().volumeMl(runs.size(component)) >= LOOP_ML;
    }

    private boolean isTrunk(int segment) {
        return TRUNKS.contains(s.names().get(segment - 1).replaceFirst("_[LR]$", ""));
    }

    private boolean isBowel(int segment) {
        return OrganNames.isBowel(s.names().get(segment - 1).toLowerCase(Locale.ROOT));
    }

    private int rowOfCells(int run) {
        int row = runs.from(run) / s.columns;
        int j = row % s.rows / voxels[1] + 1;
        int k = row / s.rows / voxels[2] + 1;
        return columns * (j + rows * k);
    }

    private int firstCell(int run) {
        return runs.from(run) % s.columns / voxels[0] + 1;
    }

    private int lastCell(int run) {
        return (runs.to(run) - 1) % s.columns / voxels[0] + 1;
    }

    private boolean touches(BitSet cells, int run) {
        int from = firstCell(run) - 1;
        int to = lastCell(run) + 1;
        for (int k = -1; k <= 1; k++) {
            for (int j = -1; j <= 1; j++) {
                int row = rowOfCells(run) + columns * (j + rows * k);
                int next = cells.nextSetBit(row + from);
                if (next >= 0 && next <= row + to) {
                    return true;
                }
            }
        }
        return false;
    }

    private Optional<String> sentence(int[] stray) {
        List<String> named = new ArrayList<>();
        for (int segment = 1; segment < stray.length; segment++) {
            if (stray[segment] > 0) {
                named.add(String.format(
                        Locale.ROOT,
                        "%s (%.1f ml)",
                        s.names().get(segment - 1),
                        s.grid().volumeMl(stray[segment])));
            }
        }
        return named.isEmpty()
                ? Optional.empty()
                : Optional.of("parts that lie away from their organ are left out: " + String.join(", ", named));
    }
}
