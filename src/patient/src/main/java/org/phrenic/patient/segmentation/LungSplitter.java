package org.phrenic.patient.segmentation;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import org.phrenic.patient.label.LabelTable;

/**
 * Splits a label that two lungs share. Where the lungs have labels as well, it holds vessels or the like, which go to
 * the lung about them. Where one of them has, its largest component is the other lung if it is large enough and lies
 * beside the one, and vessels of the one otherwise; where it is both lungs, or far larger than the one, the one is a
 * lobe and the label is split as without it. Else the label is eroded until it separates into two large components side
 * by side, or has a small one beside the large one soon, as where air or fluid about a lung makes it collapse, apart
 * from the other or joined to it by the bronchi. These are then grown back, with each voxel assigned to the nearer one.
 * The component closer to the patient's right is the right lung.
 */
public final class LungSplitter {
    /**
     * Minimum size of the smaller lung relative to the larger one. A left lung usually has 0.85 of the right lung's
     * volume.
     */
    private static final double MIN_SHARE = 0.3;
    /** The same of a collapsed lung, which lies apart from the other and beside it. */
    private static final double MIN_SHARE_COLLAPSED = 0.05;
    /** Least size of a lobe that lies apart from its lung, over that of the label. */
    private static final double LEAST_LOBE = 0.1;
    /** Least volume of a collapsed lung, and of what is left out with a note, ml. */
    private static final double MIN_ML = 30;
    /** Greatest width of one lung over its depth; two that touch are at least 1.3 times as wide as deep. */
    private static final double MAX_WIDTH = 1.15;

    private static final int MAX_EROSIONS = 60;
    /** Depth up to which a collapsed lung comes apart from the bronchi that join it to the other, mm. */
    private static final double BRONCHUS_MM = 6;

    private static final String RIGHT = "lung_R";
    private static final String LEFT = "lung_L";

    private LungSplitter() {}

    /**
     * Replaces the common segment by one per lung.
     *
     * @param notes receives a sentence if much belongs to neither lung
     * @return a sentence if the lungs cannot be split
     */
    public static Optional<String> split(Segmentation segmentation, List<String> notes) {
        int both = segmentation.find(LabelTable.LUNGS);
        boolean right = segmentation.find(RIGHT) > 0;
        boolean left = segmentation.find(LEFT) > 0;
        if (right != left) {
            nameOther(segmentation, right);
        } else if (!right) {
            Optional<String> problem = part(segmentation, (ofRight, ofLeft) -> true);
            if (problem.isPresent()) {
                return problem;
            }
        }
        if (segmentation.counts()[both] > 0) {
            join(segmentation, new VoxelRegion(segmentation, both), notes);
        }
        return Optional.empty();
    }

    /**
     * Gives each of two bodies side by side, with all that is connected to it, to the lung of its side.
     *
     * @param areLungs whether a right and a left body may be the lungs
     * @return a sentence if there are none
     */
    private static Optional<String> part(Segmentation segmentation, BiPredicate<LungPlace, LungPlace> areLungs) {
        VoxelRegion region = new VoxelRegion(segmentation, segmentation.find(LabelTable.LUNGS));
        region.computeDepths();
        byte[] piece = new byte[region.cells()];
        int[] whole = new int[2];
        Optional<String> tooSmall = Optional.empty();
        double voxelMm = IntStream.range(0, 3)
                .mapToDouble(segmentation.grid()::spacing)
                .min()
                .orElseThrow();
        for (int erosion = 0; erosion < MAX_EROSIONS; erosion++) {
            int[] sizes = region.connectedComponents(erosion, piece);
            int first = largest(sizes, 0);
            int second = largest(sizes, first);
            if (erosion == 0) {
                whole = new int[] {sizes[first], sizes[second]};
            }
            boolean isLarge = sizes[second] > MIN_SHARE * sizes[first];
            if (second > 0 && (isLarge || (erosion - 1) * voxelMm < BRONCHUS_MM)) {
                LungPlace large = LungPlace.of(segmentation, region, piece, first);
                LungPlace small = LungPlace.of(segmentation, region, piece, second);
                if (!isLarge) {
                    LungPlace.growBack(region, piece.clone(), large, small);
                }
                // The x axis points to the patient's left.
                LungPlace right = large.centre(0) < small.centre(0) ? large : small;
                LungPlace left = right == large ? small : large;
                if ((isLarge ? small.isBeside(large) : isCollapsed(segmentation, small, large))
                        && areLungs.test(right, left)) {
                    divide(segmentation, region, piece, right, left);
                    return Optional.empty();
                }
                if (tooSmall.isEmpty() && erosion > 0 && small.isBeside(large)) {
                    tooSmall = tooSmall(
                            segmentation.grid().volumeMl(large.grown()),
                            segmentation.grid().volumeMl(small.grown()));
                }
            }
            if (first == 0) {
                break;
            }
        }
        return Optional.of(refusal(
                segmentation.grid().volumeMl(whole[0]), segmentation.grid().volumeMl(whole[1]), tooSmall));
    }

    private static Optional<String> tooSmall(double largeMl, double smallMl) {
        return smallMl < MIN_ML
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "one body that parts into two side by side of %.0f and %.0f ml, of which the second is too"
                                + " small or does not lie at the height of the first",
                        largeMl,
                        smallMl));
    }

    /** @param tooSmall words on a body that parts into two of unlike size */
    private static String refusal(double firstMl, double secondMl, Optional<String> tooSmall) {
        String found = secondMl < MIN_ML
                ? tooSmall.orElse("one body that does not part into two side by side")
                : String.format(
                        Locale.ROOT,
                        "a body of %.0f ml that does not part into two, and one of %.0f ml that is too small or does"
                                + " not lie beside it",
                        firstMl,
                        secondMl);
        return LabelTable.LUNGS + ": found " + found + ", expected both lungs (or label one as lung_R or lung_L)";
    }

    /** Whether a component is a small lung beside another, not touching it. */
    private static boolean isCollapsed(Segmentation s, LungPlace small, LungPlace lung) {
        return small.grown() > MIN_SHARE_COLLAPSED * lung.grown()
                && s.grid().volumeMl(small.grown()) >= MIN_ML
                && lung.size(0) <= MAX_WIDTH * lung.size(1)
                && small.isBeside(lung)
                && small.isAtHeightOf(lung);
    }

    /** Names the lung that has no label, unless what is there is too small or not beside the one that has. */
    private static void nameOther(Segmentation s, boolean isRightLabelled) {
        VoxelRegion region = new VoxelRegion(s, s.find(LabelTable.LUNGS));
        byte[] piece = new byte[region.cells()];
        int[] sizes = region.connectedComponents(0, piece);
        int first = largest(sizes, 0);
        if (first == 0) {
            return;
        }
        LungPlace labelled = LungPlace.ofLargest(s, new VoxelRegion(s, s.find(isRightLabelled ? RIGHT : LEFT)));
        LungPlace largest = LungPlace.of(s, region, piece, first);
        if (largest.voxels() <= MIN_SHARE * labelled.voxels() && !isCollapsed(s, largest, labelled)) {
            return;
        }
        boolean isOneLung = largest.size(0) <= MAX_WIDTH * largest.size(1)
                && labelled.voxels() > MIN_SHARE * largest.voxels()
                && sizes[largest(sizes, first)] <= MIN_SHARE * largest.voxels()
                && isRightLabelled == labelled.centre(0) < largest.centre(0);
        boolean isApart = isOneLung ? !labelled.spans(largest.centre(0)) : largest.isBeside(labelled);
        boolean isLobe = !isApart || labelled.voxels() <= MIN_SHARE * region.memberCount();
        BiPredicate<LungPlace, LungPlace> areLungs =
                (right, left) -> isRightLabelled ? labelled.isPartOf(right, left) : labelled.isPartOf(left, right);
        boolean areBoth = !isOneLung && isLobe && part(s, areLungs).isEmpty();
        if (isApart && !areBoth) {
            String other = isRightLabelled ? LEFT : RIGHT;
            region.assign(piece, first, s.segment(other));
            s.inheritFrom(other, LabelTable.LUNGS);
            giveLobes(
                    s, region, piece, sizes, isRightLabelled ? List.of(labelled, largest) : List.of(largest, labelled));
        }
    }

    /**
     * Gives each component of a lobe's size but the largest that lies beside one lung and not beside the other to that
     * other.
     *
     * @param lungs the right and the left one
     */
    private static void giveLobes(
            Segmentation s, VoxelRegion region, byte[] piece, int[] sizes, List<LungPlace> lungs) {
        for (int p = 1; p < sizes.length; p++) {
            if (p == largest(sizes, 0) || sizes[p] <= LEAST_LOBE * region.memberCount()) {
                continue;
            }
            LungPlace lobe = LungPlace.of(s, region, piece, p);
            boolean besideRight = lobe.isBeside(lungs.get(0));
            boolean besideLeft = lobe.isBeside(lungs.get(1));
            if (besideRight != besideLeft) {
                assign(s, region, piece, lobe, besideRight ? LEFT : RIGHT);
            }
        }
    }

    /**
     * Gives the voxels of the common segment to the lungs that have segments of their own, each to the lung from which
     * fewer steps through the common segment lead to it. Voxels that no lung leads to are discarded.
     */
    private static void join(Segmentation s, VoxelRegion region, List<String> notes) {
        byte[] lungs = {(byte) s.find(RIGHT), (byte) s.find(LEFT)};
        byte[] piece = new byte[region.cells()];
        int[] steps = s.steps();
        for (int cell = 0; cell < piece.length; cell++) {
            for (int step = 0; step < 6 && region.isMember(cell) && piece[cell] == 0; step++) {
                int v = region.voxel(cell);
                byte next = s.isAtBorder(v, step) ? 0 : s.voxels[v + steps[step]];
                piece[cell] = (byte) (next == 0 ? 0 : next == lungs[0] ? 1 : next == lungs[1] ? 2 : 0);
            }
        }
        region.growRegions(piece);
        noteRest(s, region, piece, notes);
        for (int cell = 0; cell < piece.length; cell++) {
            if (region.isMember(cell)) {
                s.voxels[region.voxel(cell)] = piece[cell] == 0 ? 0 : lungs[piece[cell] - 1];
            }
        }
    }

    static int largest(int[] sizes, int but) {
        int largest = 0;
        for (int p = 1; p < sizes.length; p++) {
            if (p != but && sizes[p] > sizes[largest]) {
                largest = p;
            }
        }
        return largest;
    }

    private static void divide(
            Segmentation segmentation, VoxelRegion region, byte[] piece, LungPlace right, LungPlace left) {
        LungPlace.growBack(region, piece, right, left);
        assign(segmentation, region, piece, right, RIGHT);
        assign(segmentation, region, piece, left, LEFT);
    }

    private static void assign(Segmentation s, VoxelRegion region, byte[] piece, LungPlace place, String lung) {
        TreeSet<Integer> labels = new TreeSet<>(s.labels(LabelTable.LUNGS));
        labels.addAll(s.find(lung) > 0 ? s.labels(lung) : List.of());
        region.assign(piece, place.mark, s.segment(lung));
        s.setLabels(lung, List.copyOf(labels));
    }

    /** Notes what belongs to neither lung. */
    private static void noteRest(Segmentation s, VoxelRegion region, byte[] piece, List<String> notes) {
        int rest = 0;
        for (int cell = 0; cell < piece.length; cell++) {
            rest += region.isMember(cell) && piece[cell] == 0 ? 1 : 0;
        }
        if (s.grid().volumeMl(rest) >= MIN_ML) {
            notes.add(String.format(
                    Locale.ROOT,
                    "%s: %.0f ml that lie apart from both lungs are left out; a lobe of its own takes a label of its"
                            + " own, as lung_R or lung_L",
                    LabelTable.LUNGS,
                    s.grid().volumeMl(rest)));
        }
    }
}
