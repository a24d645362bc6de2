package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.engine.math.OrderStatistic;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.Specks;

/** Heights of the vertebrae of a volume, and of the vertebral ends of its ribs. */
final class VertebraHeights {
    /** Level of the fifth lumbar vertebra. */
    private static final int LAST = StructureName.FIRST_LUMBAR + 4;
    /** Below all levels: no vertebra. */
    private static final int NONE = LAST + 1;

    /** Usual distance of lumbar vertebrae from each other and from the twelfth thoracic one, mm. */
    private static final double LUMBAR_MM = 30;

    /** Share of a rib's voxels nearest to the spine that make its vertebral end. */
    private static final double END_SHARE = 0.03;
    /** Greatest distance of a vertebral end from the median plane, mm. */
    private static final double HEAD_MM = 60;

    /** Least height of two vertebrae under one label over that of their neighbours; one has at most 1.25 of these. */
    private static final double DOUBLE = 1.6;
    /**
     * Least distance of the vertebrae next to two under one label, in usual ones; 2 about one vertebra, 3 about two.
     */
    private static final double APART = 2.5;

    /** Greatest height of a half of a vertebra over that of its neighbours, and least and greatest one of both. */
    private static final double HALF = 0.65;

    private static final double LEAST_WHOLE = 0.8;
    private static final double MOST_WHOLE = 1.3;
    /** Greatest distance of two vertebrae that follow each other over that of their neighbours. */
    private static final double NEXT = 1.5;

    /** By level, mm; NaN if the volume shows none. */
    private final double[] vertebraZ = new double[LAST + 1];

    private final boolean[] isShown = new boolean[LAST + 1];
    /**
     * Vertical extent of the anterior half, that of an even distribution with the same variance, mm; 0 for none and
     * where the scan ends above or below in it.
     */
    private final double[] extent = new double[LAST + 1];
    /** Level of the highest vertebra that the volume shows, {@link #NONE} if there is none. */
    private final int highest;

    /**
     * Heights of vertebral bodies: means over the anterior halves of the vertebrae. Those that the scan does not show
     * are taken to follow at the usual distance. Specks are left out.
     */
    VertebraHeights(Segmentation s) {
        this(s, Specks.ofBones(s));
    }

    /** @param specks voxels that are left out */
    VertebraHeights(Segmentation s, Specks specks) {
        Arrays.fill(vertebraZ, Double.NaN);
        readShown(s, specks);
        highest = IntStream.rangeClosed(1, LAST)
                .filter(level -> !Double.isNaN(vertebraZ[level]))
                .findFirst()
                .orElse(NONE);
        for (int level = 1; level <= LAST; level++) {
            isShown[level] = !Double.isNaN(vertebraZ[level]);
        }
        for (int level = LAST - 1; level > 0; level--) {
            vertebraZ[level] = Double.isNaN(vertebraZ[level]) ? vertebraZ[level + 1] + toNext(level) : vertebraZ[level];
        }
        for (int level = 2; level <= LAST; level++) {
            vertebraZ[level] =
                    Double.isNaN(vertebraZ[level]) ? vertebraZ[level - 1] - toNext(level - 1) : vertebraZ[level];
        }
    }

    private void readShown(Segmentation s, Specks specks) {
        double[][] sums = new double[LabelGrid.MAX_BYTE_LABEL + 1][4];
        boolean[] cut = new boolean[sums.length];
        int ends = s.endsToward(true) | s.endsToward(false);
        int[] levels = new int[sums.length];
        for (String name : s.names()) {
            StructureName.parse(name)
                    .filter(n -> n.kind() == StructureKind.VERTEBRA && n.level() <= LAST)
                    .ifPresent(n -> levels[s.find(name)] = n.level());
        }
        for (int pass = 0; pass < 2; pass++) {
            for (int v = 0; v < s.voxels().length; v++) {
                int segment = s.segmentAt(v);
                if (levels[segment] > 0 && !specks.contain(v)) {
                    double y = s.coordinate(v, 1);
                    double[] sum = sums[segment];
                    if (pass == 0) {
                        sum[0] += y;
                        sum[1]++;
                    } else if (y < sum[0]) {
                        sum[1]++;
                        double z = s.coordinate(v, 2);
                        sum[2] += z;
                        sum[3] += z * z;
                        cut[segment] |= (s.ends(v) & ends) != 0;
                    }
                }
            }
            for (int segment = 0; segment < sums.length; segment++) {
                if (sums[segment][1] > 0 && pass == 0) {
                    sums[segment][0] /= sums[segment][1];
                    sums[segment][1] = 0;
                } else if (sums[segment][1] > 0) {
                    double mean = sums[segment][2] / sums[segment][1];
                    vertebraZ[levels[segment]] = mean;
                    double variance = sums[segment][3] / sums[segment][1] - mean * mean;
                    extent[levels[segment]] = cut[segment] ? 0 : Math.sqrt(12 * Math.max(0, variance));
                }
            }
        }
    }

    /** Usual distance of a vertebra from the next one below, mm. */
    private static double toNext(int level) {
        return level < RibNumbering.RIBS ? RibNumbering.VERTEBRA_MM : LUMBAR_MM;
    }

    /** Height of the vertebra of a level, mm; NaN if the volume shows none at all. */
    double at(int level) {
        return vertebraZ[level];
    }

    /** Usual height of the vertebral end of the rib of a number, mm. */
    double ribEnd(int number) {
        return at(number) - RibDeviations.usual(number) * spacing(number);
    }

    /** Whether a height is nearer to the usual end of the twelfth rib than to the first lumbar vertebra. */
    boolean isAboveLumbar(double z) {
        return z > 0.5 * (ribEnd(RibNumbering.RIBS) + at(StructureName.FIRST_LUMBAR));
    }

    /** Distance of the vertebra of a number from the one above it, mm; of the first from the second. */
    double spacing(int number) {
        return at(Math.max(1, number - 1)) - at(Math.max(2, number));
    }

    /** Whether the volume shows the vertebra of a level and the one that its {@link #spacing} is taken from. */
    boolean showsSpacing(int level) {
        return isShown[level] && isShown[level == 1 ? 2 : level - 1];
    }

    /** Whether a vertebra between two others is as tall as two of them. */
    boolean isDouble(int level) {
        double least = Math.min(extent[level - 1], extent[level + 1]);
        return least > 0 && extent[level] > DOUBLE * Math.max(extent[level - 1], extent[level + 1]);
    }

    /**
     * Height of a vertebra over that of the taller of the next ones shown above and below it, and over the median of
     * these and the next but one; 0 if there are none on both sides or the scan ends in them, or if the next ones are
     * not as far apart as with two between, as of a whole vertebra between collapsed ones.
     */
    double tallness(int level) {
        int[] above = next(level, -1);
        int[] below = next(level, 1);
        double[] all = IntStream.concat(Arrays.stream(above), Arrays.stream(below))
                .mapToDouble(at -> extent[at])
                .toArray();
        if (above.length == 0 || below.length == 0 || Arrays.stream(all).anyMatch(height -> height == 0)) {
            return 0;
        }
        double[] usual = Stream.of(above, below)
                .filter(two -> two.length == 2)
                .mapToDouble(two -> (at(two[0]) - at(two[1])) / (two[1] - two[0]))
                .toArray();
        boolean apart = at(above[0]) - at(below[0])
                > APART * Arrays.stream(usual).average().orElse(Double.POSITIVE_INFINITY);
        return apart
                ? extent[level] / Math.max(OrderStatistic.median(all), Math.max(extent[above[0]], extent[below[0]]))
                : 0;
    }

    /** Up to two shown vertebrae within three levels of one, from the nearest on. */
    private int[] next(int level, int step) {
        return IntStream.rangeClosed(1, 3)
                .map(n -> level + n * step)
                .filter(at -> at > 0 && at <= LAST && isShown[at])
                .limit(2)
                .toArray();
    }

    /** Whether a vertebra and the next one below it, between two others, are as tall as one of these. */
    boolean areHalves(int level) {
        double above = extent[level - 1];
        double below = extent[level + 2];
        double usual = 0.5 * (above + below);
        double both = extent[level] + extent[level + 1];
        double taller = Math.max(extent[level], extent[level + 1]);
        boolean known = Math.min(Math.min(above, below), both - taller) > 0;
        return known && taller < HALF * usual && both > LEAST_WHOLE * usual && both < MOST_WHOLE * usual;
    }

    /** Whether the vertebra of a level is missing between two that follow each other. */
    boolean isSkipped(int level) {
        boolean known = isShown[level - 2] && isShown[level - 1] && isShown[level + 1] && isShown[level + 2];
        double usual = 0.5 * (at(level - 2) - at(level - 1) + at(level + 1) - at(level + 2));
        return known && !isShown[level] && at(level - 1) - at(level + 1) < NEXT * usual;
    }

    /**
     * The voxels of a vertebra above, or below, the plane across the spine through the middle of its anterior half.
     *
     * @param above a vertebra above it, a segment
     * @param below one below it
     */
    static IntList half(Segmentation s, int vertebra, int above, int below, boolean upper) {
        double[] top = mean(s, above, Double.POSITIVE_INFINITY);
        double[] bottom = mean(s, below, Double.POSITIVE_INFINITY);
        double[] middle = mean(s, vertebra, mean(s, vertebra, Double.POSITIVE_INFINITY)[1]);
        IntList half = new IntList();
        for (int v = 0; v < s.voxels().length; v++) {
            if (s.segmentAt(v) == vertebra) {
                double[] p = s.point(v);
                double along = 0;
                for (int axis = 0; axis < 3; axis++) {
                    along += (top[axis] - bottom[axis]) * (p[axis] - middle[axis]);
                }
                if (along > 0 == upper) {
                    half.add(v);
                }
            }
        }
        return half;
    }

    /** Mean of the voxels of a segment before a coronal plane. */
    private static double[] mean(Segmentation s, int segment, double before) {
        double[] mean = new double[3];
        int count = 0;
        for (int v = 0; v < s.voxels().length; v++) {
            if (s.segmentAt(v) == segment && s.coordinate(v, 1) < before) {
                count++;
                for (int axis = 0; axis < 3; axis++) {
                    mean[axis] += (s.coordinate(v, axis) - mean[axis]) / count;
                }
            }
        }
        return mean;
    }

    /** Whether the volume shows a vertebra. */
    boolean areShown() {
        return highest != NONE;
    }

    /** Whether the volume shows a thoracic vertebra. */
    boolean showThorax() {
        return highest <= RibNumbering.RIBS;
    }

    /** Whether the volume shows a vertebra above the last thoracic one. */
    boolean showAboveLast() {
        return highest < RibNumbering.RIBS;
    }

    /** Name of the vertebra at a height in mm, such as T5; empty if the volume shows none at all. */
    Optional<String> nameAt(double z) {
        return IntStream.rangeClosed(0, LAST)
                .boxed()
                .min(Comparator.comparingDouble(level -> Math.abs((level > 0 ? at(level) : at(1) + toNext(0)) - z)))
                .filter(level -> areShown())
                .map(level -> level == 0
                        ? "C7"
                        : level < StructureName.FIRST_LUMBAR
                                ? "T" + level
                                : "L" + (level - StructureName.FIRST_LUMBAR + 1));
    }

    /**
     * The end of a rib toward the spine.
     *
     * @param z height, mm
     * @param isCut whether the scan cuts the rib off before it reaches the spine
     * @param isWhole whether it is near the spine and the scan cuts nothing off the rib
     */
    record VertebralEnd(double z, boolean isCut, boolean isWhole) {}

    /** The vertebral end of a rib: the part of its posterior half that is nearest to the median plane, x in mm. */
    static VertebralEnd vertebralEnd(Segmentation s, RibComponents.Rib rib, double middle) {
        List<double[]> posterior = posterior(s, rib.voxels, rib.centre[1], middle);
        boolean far = isFarFromSpine(posterior);
        return new VertebralEnd(
                endHeight(posterior, rib.voxels.size()).orElse(rib.centre[2]),
                rib.ends != 0 && far,
                rib.ends == 0 && !far);
    }

    /**
     * Distance from the median plane and height of each voxel of a rib behind its centre, mm, and the ends of the scan
     * that it lies at, as {@link Segmentation#ends}.
     */
    static List<double[]> posterior(Segmentation s, IntList voxels, double centreY, double middle) {
        List<double[]> posterior = new ArrayList<>();
        for (int i = 0; i < voxels.size(); i++) {
            double[] p = s.point(voxels.get(i));
            if (p[1] >= centreY) {
                posterior.add(new double[] {Math.abs(p[0] - middle), p[2], s.ends(voxels.get(i))});
            }
        }
        return posterior;
    }

    /** Whether the posterior half of a rib ends far from the spine. */
    static boolean isFarFromSpine(List<double[]> posterior) {
        return !posterior.isEmpty() && posterior.stream().allMatch(p -> p[0] > HEAD_MM);
    }

    /** Whether the scan ends at the voxels of a rib that are nearest to the spine. */
    static boolean isEndCut(List<double[]> posterior, int voxels) {
        return nearest(posterior, voxels).anyMatch(p -> p[2] != 0);
    }

    /**
     * Mean height of the vertebral end of a rib: of the voxels nearest to the spine.
     *
     * @param posterior distance from the spine and height of each posterior voxel, mm
     * @param voxels number of voxels of the rib
     */
    static OptionalDouble endHeight(List<double[]> posterior, int voxels) {
        return nearest(posterior, voxels).mapToDouble(p -> p[1]).average();
    }

    private static Stream<double[]> nearest(List<double[]> posterior, int voxels) {
        return posterior.stream()
                .sorted(Comparator.comparingDouble((double[] p) -> p[0]).thenComparingDouble(p -> p[1]))
                .limit(Math.max(1, (int) (END_SHARE * voxels)));
    }
}
