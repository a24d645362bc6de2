package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.patient.label.LabelTable;

/**
 * Mending of voxels: pits, dropped voxels and holes are filled, pieces of a bone joined, specks and stray parts left
 * out.
 */
public final class SegmentationRepair {
    /** Smallest volume of specks that a note states, ml. */
    private static final double LEAST_NOTED_ML = 0.01;
    /** Pieces of a bone below this share of its voxels are specks. */
    private static final double BONE_SPECK = 0.005;
    /** Pieces of an organ below this share of its voxels are specks. */
    private static final double ORGAN_SPECK = 0.002;

    /** Number of voxels below which a piece of any structure is a speck. */
    static final int SPECK_VOXELS = 10;

    /**
     * Largest gap that is bridged between the pieces of a rib, or of a sternum, whose halves may stand apart after it
     * was split, mm.
     */
    private static final double LONG_GAP_MM = 20;
    /** The same of another bone, mm. */
    private static final double BONE_GAP_MM = 10;
    /** Share of filled bone voxels from which a note is made. */
    private static final double NOTED_FILL = 0.02;

    private final Segmentation s;
    /** By segment number, whether bones may take its voxels: background, and what fills the space like it. */
    private final boolean[] free;

    private final List<String> notes = new ArrayList<>();
    private int specks;
    private int speckSegments;
    private boolean cleared;

    private SegmentationRepair(Segmentation s) {
        this.s = s;
        free = new boolean[s.names().size() + 1];
        free[0] = true;
        s.names().stream().filter(LabelTable::fillsBetweenOrgans).forEach(name -> free[s.find(name)] = true);
    }

    /**
     * Fills pits and holes, joins the pieces of bones and leaves out specks and stray parts of organs. To be called
     * when all structures are told apart: filling would join bones that share a label.
     *
     * @return notes, one sentence each
     */
    public static List<String> mend(Segmentation s) {
        SegmentationRepair repair = new SegmentationRepair(s);
        repair.fill();
        repair.join();
        if (repair.cleared) {
            // Where specks and stray parts lay within a structure.
            HoleFilling.fill(s);
        }
        return repair.notes;
    }

    static Optional<StructureKind> kind(String name) {
        return StructureName.parse(name).map(StructureName::kind);
    }

    private static boolean isBone(String name) {
        return kind(name)
                .filter(k -> switch (k) {
                    case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC, BONE -> true;
                    default -> false;
                })
                .isPresent();
    }

    private void fill() {
        int[] counts = s.counts();
        List<Integer> bones = s.names().stream()
                .filter(SegmentationRepair::isBone)
                .map(s::find)
                .toList();
        int before = bones.stream().mapToInt(bone -> counts[bone]).sum();
        int filled = BoneClosing.close(s, bones, free) + HoleFilling.fill(s);
        if (before > 0 && filled > NOTED_FILL * before) {
            notes.add(String.format(
                    Locale.ROOT, "holes and pits are filled, %.1f ml", s.grid().volumeMl(filled)));
        }
    }

    private void join() {
        VoxelRuns runs = VoxelRuns.ofSegments(s);
        List<TreeMap<Integer, Integer>> sizes = new ArrayList<>();
        for (int segment = 0; segment <= s.names().size(); segment++) {
            sizes.add(new TreeMap<>());
        }
        for (int run = 0; run < runs.count(); run++) {
            int component = runs.component(run);
            sizes.get(s.segmentAt(runs.from(run))).put(component, runs.size(component));
        }
        boolean[] kept = new boolean[runs.count()];
        Arrays.fill(kept, true);
        TreeMap<Integer, List<int[]>> pieces = new TreeMap<>();
        for (int segment = 1; segment < sizes.size(); segment++) {
            sort(segment, sizes.get(segment), kept, pieces);
        }
        Optional<String> stray = new StrayParts(s, runs).leaveOut(kept);
        stray.ifPresent(notes::add);
        collect(runs, kept, pieces);
        List<String> joined = new ArrayList<>();
        pieces.forEach((segment, components) -> joinBone(segment, components, joined));
        if (!joined.isEmpty()) {
            notes.add("joined from several pieces, their number in brackets: " + String.join(", ", joined));
        }
        if (specks > 0) {
            notes.add(String.format(
                    Locale.ROOT,
                    "specks of %d structure%s are left out, %.2f ml in all",
                    speckSegments,
                    speckSegments == 1 ? "" : "s",
                    Math.max(LEAST_NOTED_ML, s.grid().volumeMl(specks))));
        }
    }

    /** Decides which components of a segment are specks; bones in several pieces are entered to be joined. */
    private void sort(int segment, Map<Integer, Integer> sizes, boolean[] kept, Map<Integer, List<int[]>> pieces) {
        String name = s.names().get(segment - 1);
        boolean bone = isBone(name) && !LabelTable.isSeveralBones(name);
        boolean organ = kind(name)
                .filter(k -> k.isNamed() || k == StructureKind.LUNG || k == StructureKind.LIVER)
                .isPresent();
        if (sizes.size() < 2 || !(bone || organ)) {
            return;
        }
        int total = sizes.values().stream().mapToInt(Integer::intValue).sum();
        int largest = sizes.values().stream().mapToInt(Integer::intValue).max().orElseThrow();
        // A structure of specks alone is none.
        double least = largest < SPECK_VOXELS
                ? SPECK_VOXELS
                : Math.min(largest, Math.max(SPECK_VOXELS, (bone ? BONE_SPECK : ORGAN_SPECK) * total));
        int small = 0;
        for (var component : sizes.entrySet()) {
            if (component.getValue() < least) {
                kept[component.getKey()] = false;
                small += component.getValue();
            }
        }
        specks += small;
        speckSegments += small > 0 ? 1 : 0;
        if (bone && sizes.values().stream().filter(size -> size >= least).count() > 1) {
            pieces.put(segment, new ArrayList<>());
        }
    }

    /** Clears specks and collects the voxels of the pieces of bones, the largest piece first. */
    private void collect(VoxelRuns runs, boolean[] kept, Map<Integer, List<int[]>> pieces) {
        runs.voxels(run -> kept[runs.component(run)] && pieces.containsKey(s.segmentAt(runs.from(run))))
                .values()
                .forEach(list -> pieces.get(s.segmentAt(list.get(0))).add(list.toArray()));
        pieces.values().forEach(list -> list.sort(Comparator.comparingInt((int[] piece) -> -piece.length)));
        for (int run = 0; run < runs.count(); run++) {
            if (!kept[runs.component(run)]) {
                cleared = true;
                Arrays.fill(s.voxels, runs.from(run), runs.to(run), (byte) 0);
            }
        }
    }

    private void joinBone(int segment, List<int[]> components, List<String> joined) {
        String name = s.names().get(segment - 1);
        boolean far = kind(name)
                .filter(k -> k == StructureKind.RIB || k == StructureKind.STERNUM)
                .isPresent();
        PieceJoiner joiner = new PieceJoiner(s, segment, components, far ? LONG_GAP_MM : BONE_GAP_MM, free);
        List<Integer> unreached = joiner.unreached();
        if (unreached.size() + 1 < components.size()) {
            joined.add(name + " (" + (components.size() - unreached.size()) + ")");
        }
        int lost = 0;
        for (int piece : unreached) {
            lost += components.get(piece).length;
            for (int voxel : components.get(piece)) {
                s.voxels[voxel] = 0;
            }
        }
        if (lost > 0) {
            cleared = true;
            notes.add(String.format(
                    Locale.ROOT,
                    "%s: what lies too far from its largest piece is left out, %.1f ml",
                    name,
                    s.grid().volumeMl(lost)));
        }
    }
}
