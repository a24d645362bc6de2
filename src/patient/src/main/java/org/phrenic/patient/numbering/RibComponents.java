package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.VoxelRuns;

/**
 * The ribs of a volume as connected parts of the union of all rib labels. Parts that lie end to end under one label are
 * one rib: pieces of a broken rib, or what an end of the volume, or a field of view that is narrower than the cage,
 * leaves of a rib that passes through it.
 */
final class RibComponents {
    /** Parts smaller than this share of the usual one are fragments. */
    private static final double FRAGMENT = 0.05;
    /** Least share of the usual one of a last rib that lies apart below the others; the shortest have 0.03. */
    private static final double LAST = 0.02;

    static final int MIN_VOXELS = 20;
    /** Share of a label or of a part from which an overlap counts. */
    static final double SUBSTANTIAL = 0.15;
    /** Share of the shorter part's range of angle that two parts of one rib may have in common. */
    private static final double MAX_COMMON_ANGLE = 0.3;

    /** The same of two pieces of a broken rib that override, with less than {@link #OVERRIDING_MM} between. */
    private static final double MAX_OVERRIDING_ANGLE = 0.6;
    /** Gap between pieces that override, mm: less than a space between two ribs. */
    private static final double OVERRIDING_MM = 8;

    private static final int ANGLES = 72;
    /** Share of the shorter part within {@link #BESIDE_MM} of the gap's width from which on two lie side by side. */
    private static final double MAX_BESIDE = 0.4;

    private static final double BESIDE_MM = 12;
    /** Largest gap between two pieces of a rib, and distance of a fragment's centre from its rib, mm. */
    private static final double NEAR_MM = 25;

    private static final int SAMPLES = 100;
    /** Greatest number of directions between two parts in line, {@value #ANGLES} in a turn. */
    private static final int MAX_GAP = 16;
    /** Numbers of directions from whose first to whose last the slope of an end is taken. */
    private static final int LEAST_SLOPE = 2;

    private static final int MOST_SLOPE = 6;
    /** Greatest distance half way between the ends of parts in line, mm: less than half of that between two ribs. */
    private static final double IN_LINE_MM = 9;

    /** One rib: its voxels, and how many of them carry each segment number. */
    static final class Rib {
        final IntList voxels;
        final TreeMap<Integer, Integer> segments = new TreeMap<>();
        /** Number of voxels, and sum of their heights (mm), in each direction about the body's long axis. */
        final int[] inDirection = new int[ANGLES];

        final double[] heights = new double[ANGLES];
        /** Ends of the volume that the rib reaches, as {@link Segmentation#ends}. */
        int ends;

        final double[] centre = new double[3];

        Rib(Segmentation s, IntList voxels) {
            this.voxels = voxels;
            for (int i = 0; i < voxels.size(); i++) {
                int voxel = voxels.get(i);
                segments.merge(s.segmentAt(voxel), 1, Integer::sum);
                ends |= s.ends(voxel);
                for (int axis = 0; axis < 3; axis++) {
                    centre[axis] += s.coordinate(voxel, axis) / voxels.size();
                }
            }
        }

        /** Finds its directions about an axis of this x and y, mm. */
        void findAngles(Segmentation s, double[] axis) {
            for (int i = 0; i < voxels.size(); i++) {
                int voxel = voxels.get(i);
                double angle = StrictMath.atan2(s.coordinate(voxel, 1) - axis[1], s.coordinate(voxel, 0) - axis[0]);
                int bin = Math.min(ANGLES - 1, (int) ((angle + Math.PI) / (2 * Math.PI) * ANGLES));
                inDirection[bin]++;
                heights[bin] += s.coordinate(voxel, 2);
            }
        }

        /** Share of the rib's voxels that carry a segment number. */
        double share(int segment) {
            return segments.getOrDefault(segment, 0) / (double) voxels.size();
        }

        /** Mean height above another rib in the directions of both, mm; of the centres if they share none. */
        double heightAbove(Rib other) {
            return IntStream.range(0, ANGLES)
                    .filter(bin -> inDirection[bin] > 0 && other.inDirection[bin] > 0)
                    .mapToDouble(bin -> heightIn(bin) - other.heightIn(bin))
                    .average()
                    .orElse(centre[2] - other.centre[2]);
        }

        /** Mean height in a direction that it has, mm. */
        double heightIn(int direction) {
            return heights[direction] / inDirection[direction];
        }

        int dominantSegment() {
            return segments.entrySet().stream()
                    .max(Comparator.comparingInt(Map.Entry::getValue))
                    .orElseThrow()
                    .getKey();
        }
    }

    private final Segmentation s;
    private final List<Rib> ribs = new ArrayList<>();
    private final List<Rib> fragments = new ArrayList<>();
    private final String parted;

    /**
     * @param groupOfSegment 1 for each segment of a rib, otherwise 0
     * @param isParted whether ribs that hang together are parted
     * @throws org.phrenic.file.BadInputException if they cannot be
     */
    RibComponents(Segmentation s, byte[] groupOfSegment, boolean isParted) {
        this.s = s;
        List<Rib> all = new VoxelRuns(s, groupOfSegment, true)
                .voxels(run -> true).values().stream()
                        .map(voxels -> new Rib(s, voxels))
                        .toList();
        List<Rib> parts = all.stream()
                .filter(rib -> rib.voxels.size() >= MIN_VOXELS)
                .sorted(Comparator.comparingInt((Rib rib) -> -rib.voxels.size()))
                .toList();
        int large = RibSides.usualSize(parts, FRAGMENT);
        for (Rib rib : all) {
            (rib.voxels.size() >= Math.max(MIN_VOXELS, FRAGMENT * large) ? ribs : fragments).add(rib);
        }
        double acrossRibs =
                ribs.stream().mapToDouble(rib -> rib.centre[0]).average().orElse(0);
        // Of the ribs of one side, the mean lies beside the axis about which they curve.
        double[] middle = {
            new RibSides(s, ribs).middle().orElse(acrossRibs),
            ribs.stream().mapToDouble(rib -> rib.centre[1]).average().orElse(0)
        };
        ShortRibs shortest = new ShortRibs(s, ribs, fragments, middle[0]);
        shortest.take(Math.max(MIN_VOXELS, LAST * large));
        FusedRibs.partByLabels(s, ribs, middle);
        parted = isParted ? FusedRibs.part(s, ribs, middle[0]) : "";
        ribs.forEach(rib -> rib.findAngles(s, middle));
        while (joinTwo(middle[0])) {
            // A part that has grown may lie in line with what its pieces did not.
        }
        shortest.giveBack();
    }

    /**
     * Joins two parts of one label alone that lie end to end: in different directions about the body's axis, and near
     * to each other or at one end of the volume; or near with their ends alone, as parts of a first rib, which curves
     * about the axis itself. Those on the two sides of the median plane, whose x is given in mm, are never one rib.
     *
     * @return whether there were two
     */
    private boolean joinTwo(double middle) {
        for (int i = 0; i < ribs.size(); i++) {
            for (int j = ribs.size() - 1; j > i; j--) {
                if (isOneRib(ribs.get(i), ribs.get(j), middle)) {
                    append(ribs.get(i), ribs.remove(j));
                    return true;
                }
            }
        }
        return false;
    }

    private boolean isOneRib(Rib a, Rib b, double middle) {
        int label = a.dominantSegment();
        boolean pure = a.share(label) > 1 - SUBSTANTIAL && b.share(label) > 1 - SUBSTANTIAL;
        double angle = commonAngle(a, b);
        boolean apart = angle <= MAX_COMMON_ANGLE;
        boolean common = LabelTable.isRibs(s.names().get(label - 1));
        // Under one label for all, other ribs lie in the same directions.
        if (!pure || a.centre[0] < middle != b.centre[0] < middle || (!apart && common)) {
            return false;
        }
        // Under one label for all, the front of a rib and the back of another end at the top of a scan.
        int ends = a.ends & b.ends & (common ? ~(s.endsToward(true) | s.endsToward(false)) : -1);
        if (apart && (ends != 0 || (!common && isInLine(a, b)))) {
            return true;
        }
        double[] distances = a.voxels.size() > b.voxels.size() ? distances(a, b) : distances(b, a);
        double gap = Arrays.stream(distances).min().orElseThrow();
        boolean overriding = angle <= MAX_OVERRIDING_ANGLE && gap < OVERRIDING_MM;
        long beside = Arrays.stream(distances).filter(d -> d < gap + BESIDE_MM).count();
        return gap < NEAR_MM && (apart || overriding || beside / (double) distances.length <= MAX_BESIDE);
    }

    /** Whether the heights of two parts, continued toward each other, meet half way. */
    private static boolean isInLine(Rib a, Rib b) {
        for (int gap = 1; gap <= MAX_GAP; gap++) {
            for (int from = 0; from < ANGLES; from++) {
                for (int step = -1; step <= 1; step += 2) {
                    int to = Math.floorMod(from + step * gap, ANGLES);
                    if (a.inDirection[from] > 0 && b.inDirection[to] > 0) {
                        double ofA = continued(a, from, -step, 0.5 * gap);
                        double ofB = continued(b, to, step, 0.5 * gap);
                        return Math.abs(ofA - ofB) < IN_LINE_MM;
                    }
                }
            }
        }
        return false;
    }

    /**
     * Height of a part so many directions beyond its end, mm; NaN if it is too short to have a slope.
     *
     * @param inward step from the end into the part
     */
    private static double continued(Rib rib, int end, int inward, double beyond) {
        int length = 0;
        while (length < MOST_SLOPE && rib.inDirection[Math.floorMod(end + inward * (length + 1), ANGLES)] > 0) {
            length++;
        }
        double height = rib.heightIn(end);
        double slope = (height - rib.heightIn(Math.floorMod(end + inward * length, ANGLES))) / length;
        return length < LEAST_SLOPE ? Double.NaN : height + beyond * slope;
    }

    /** Distances of some voxels of the shorter part from the longer one, mm. */
    private double[] distances(Rib longer, Rib shorter) {
        int stride = Math.max(1, shorter.voxels.size() / SAMPLES);
        VoxelBlocks blocks = new VoxelBlocks(s, longer.voxels);
        return IntStream.iterate(0, i -> i < shorter.voxels.size(), i -> i + stride)
                .map(shorter.voxels::get)
                .mapToDouble(v -> blocks.distance(s.point(v)))
                .toArray();
    }

    private static void append(Rib a, Rib b) {
        double share = b.voxels.size() / (double) (a.voxels.size() + b.voxels.size());
        for (int axis = 0; axis < 3; axis++) {
            a.centre[axis] += share * (b.centre[axis] - a.centre[axis]);
        }
        for (int i = 0; i < b.voxels.size(); i++) {
            a.voxels.add(b.voxels.get(i));
        }
        a.ends |= b.ends;
        b.segments.forEach((segment, count) -> a.segments.merge(segment, count, Integer::sum));
        for (int bin = 0; bin < ANGLES; bin++) {
            a.inDirection[bin] += b.inDirection[bin];
            a.heights[bin] += b.heights[bin];
        }
    }

    /** Share of the shorter part's directions that two parts have in common, but for one in which both may end. */
    static double commonAngle(Rib a, Rib b) {
        int common = 0;
        int ofA = 0;
        int ofB = 0;
        for (int bin = 0; bin < ANGLES; bin++) {
            common += a.inDirection[bin] > 0 && b.inDirection[bin] > 0 ? 1 : 0;
            ofA += a.inDirection[bin] > 0 ? 1 : 0;
            ofB += b.inDirection[bin] > 0 ? 1 : 0;
        }
        return Math.max(0, common - 1) / (double) Math.min(ofA, ofB);
    }

    /** A clause that ends a sentence and names ribs that hang together and are parted; empty for none. */
    String parted() {
        return parted;
    }

    /** The ribs, without fragments. */
    List<Rib> ribs() {
        return ribs;
    }

    /** Adds each fragment to the nearest of the ribs that it may go to; returns those that are near none. */
    List<Rib> attachFragments(Predicate<Rib> to) {
        List<Rib> left = new ArrayList<>();
        List<Rib> open = ribs.stream().filter(to).toList();
        List<VoxelBlocks> blocks =
                open.stream().map(rib -> new VoxelBlocks(s, rib.voxels)).toList();
        for (Rib fragment : fragments) {
            OptionalInt nearest = VoxelBlocks.nearest(blocks, fragment.centre, NEAR_MM);
            if (nearest.isPresent()) {
                append(open.get(nearest.getAsInt()), fragment);
                blocks.get(nearest.getAsInt()).extend();
            } else {
                left.add(fragment);
            }
        }
        return left;
    }

    /**
     * Gives voxels that carry another rib's label to the rib that they are connected to. A label of which the rib holds
     * a substantial part stays: two ribs may touch.
     */
    void relabelBleeding() {
        Map<Integer, Integer> totals = totals(ribs);
        for (Rib rib : ribs) {
            int dominant = rib.dominantSegment();
            for (int i = 0; i < rib.voxels.size(); i++) {
                int segment = s.segmentAt(rib.voxels.get(i));
                if (rib.segments.get(segment) < Math.max(MIN_VOXELS, SUBSTANTIAL * totals.get(segment))) {
                    s.voxels()[rib.voxels.get(i)] = (byte) dominant;
                }
            }
        }
    }

    /** Whether another part holds more than so many times its voxels of a part's label, not the common one. */
    boolean isStray(Rib part, double times) {
        int label = part.dominantSegment();
        double held = times * part.segments.get(label);
        return !LabelTable.isRibs(s.names().get(label - 1))
                && ribs.stream().anyMatch(rib -> rib != part && rib.segments.getOrDefault(label, 0) > held);
    }

    /** Voxels of each segment in some ribs. */
    static Map<Integer, Integer> totals(List<Rib> ribs) {
        TreeMap<Integer, Integer> totals = new TreeMap<>();
        ribs.forEach(rib -> rib.segments.forEach((segment, count) -> totals.merge(segment, count, Integer::sum)));
        return totals;
    }

    /** A segment that makes substantial parts of two ribs, and no mere specks in them, if there is one. */
    Optional<Integer> dividedSegment() {
        Map<Integer, Integer> totals = totals(ribs);
        return totals.keySet().stream()
                .filter(segment -> ribs.stream()
                                .filter(rib -> rib.segments.getOrDefault(segment, 0)
                                        > SUBSTANTIAL * Math.max(totals.get(segment), rib.voxels.size()))
                                .count()
                        > 1)
                .findFirst();
    }
}
