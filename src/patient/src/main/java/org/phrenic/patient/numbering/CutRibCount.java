package org.phrenic.patient.numbering;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * Number of the highest rib of a side in a scan that cuts ribs off above or below, where neither labels nor vertebrae
 * tell it. A scan that cuts ribs above and none below shows the last one: it is the twelfth, three fifths as long from
 * end to end as the eleventh, or the eleventh where its length is nearer to that of the rib above it. A scan that cuts
 * ribs below and none above shows the first one. Where the last rib of one side alone is short, both are the twelfth if
 * they end at one height of the spine.
 */
final class CutRibCount {
    private static final int LAST = 12;
    /**
     * Length of the lowest rib over that of the one above, between the twelfth over the eleventh (0.60 to 0.64) and the
     * eleventh over the tenth (0.83 to 0.84), from end to end in adults.
     */
    private static final double SHORT = 0.73;
    /** Ribs whose vertebral ends differ in height by less than this share of their distance have the same number. */
    private static final double SAME_HEIGHT = 0.5;

    private CutRibCount() {}

    /**
     * Finds the numbers of the highest ribs of two sides.
     *
     * @param sides ribs of each side from top to bottom
     * @param endZ heights of their vertebral ends, mm
     * @return for each side; empty if the scan cuts its ribs at both ends or at none
     */
    static OptionalInt[] first(Segmentation s, List<List<RibComponents.Rib>> sides, List<double[]> endZ) {
        OptionalInt[] last = sides.stream()
                .map(ribs -> isCut(s, ribs, true) && !isCut(s, ribs, false)
                        ? OptionalInt.of(last(s, ribs))
                        : OptionalInt.empty())
                .toArray(OptionalInt[]::new);
        for (int n = 0; n < last.length; n++) {
            int other = last.length - 1 - n;
            if (last[n].equals(OptionalInt.of(LAST - 1)) && last[other].equals(OptionalInt.of(LAST))) {
                compare(sides, endZ, n, last);
                break;
            }
        }
        OptionalInt[] first = new OptionalInt[last.length];
        for (int n = 0; n < first.length; n++) {
            List<RibComponents.Rib> ribs = sides.get(n);
            first[n] = last[n].isPresent()
                    ? OptionalInt.of(last[n].getAsInt() - ribs.size() + 1)
                    : isCut(s, ribs, false) && !isCut(s, ribs, true) ? OptionalInt.of(1) : OptionalInt.empty();
        }
        return first;
    }

    /**
     * Brings the last ribs of two sides into line, of which one is long enough for the eleventh and the other is taken
     * for the twelfth. At one height they have the same number, that of the short one if its length is known: some
     * people's twelfth rib is long. Of two heights the lower one is the twelfth.
     *
     * @param eleventh index of the side that ends with the eleventh rib by its length
     * @param last numbers of the last ribs
     */
    private static void compare(
            List<List<RibComponents.Rib>> sides, List<double[]> endZ, int eleventh, OptionalInt[] last) {
        int twelfth = last.length - 1 - eleventh;
        double[] z = endZ.get(eleventh);
        double[] otherZ = endZ.get(twelfth);
        double below = otherZ[otherZ.length - 1] - z[z.length - 1];
        double spacing = z[z.length - 2] - z[z.length - 1];
        boolean all = sides.get(twelfth).size() == LAST;
        if (Math.abs(below) < SAME_HEIGHT * spacing) {
            boolean isShort = all || showsLast(sides.get(twelfth));
            Arrays.fill(last, OptionalInt.of(isShort ? LAST : LAST - 1));
        } else if (below > 0) {
            last[eleventh] = OptionalInt.of(LAST);
            last[twelfth] = OptionalInt.of(all ? LAST : LAST - 1);
        }
    }

    /** Whether the scan cuts off one of the ribs of a side above or below. */
    private static boolean isCut(Segmentation s, List<RibComponents.Rib> ribs, boolean above) {
        return ribs.stream().anyMatch(rib -> (rib.ends & s.endsToward(above)) != 0);
    }

    private static int last(Segmentation s, List<RibComponents.Rib> ribs) {
        boolean isShort =
                !showsLast(ribs) || isTwelfth(s, ribs.get(ribs.size() - 1).voxels, ribs.get(ribs.size() - 2).voxels);
        return isShort || ribs.size() == LAST ? LAST : LAST - 1;
    }

    /** Whether the scan shows the whole of the rib above the last one. */
    private static boolean showsLast(List<RibComponents.Rib> ribs) {
        return ribs.size() > 1 && ribs.get(ribs.size() - 2).ends == 0;
    }

    /** Whether a last rib is as short beside the one above as the twelfth is. */
    static boolean isTwelfth(Segmentation s, IntList last, IntList above) {
        return length(s, last) < SHORT * length(s, above);
    }

    /** Diagonal of the box of a rib, mm. */
    static double length(Segmentation s, IntList voxels) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < voxels.size(); i++) {
                double at = s.coordinate(voxels.get(i), axis);
                low = Math.min(low, at);
                high = Math.max(high, at);
            }
            square += (high - low) * (high - low);
        }
        return Math.sqrt(square);
    }
}
