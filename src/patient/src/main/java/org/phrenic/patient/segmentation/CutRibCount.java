package org.phrenic.patient.segmentation;

import java.util.List;
import java.util.OptionalInt;
import org.phrenic.mesh.IntList;

/**
 * Number of the highest rib of a side in a scan that cuts ribs off above or below, where neither labels nor vertebrae
 * tell it. A scan that cuts ribs above and none below shows the last one: it is the twelfth, three fifths as long from
 * end to end as the eleventh, or the eleventh where its length is nearer to that of the rib above it. A scan that cuts
 * ribs below and none above shows the first one.
 */
final class CutRibCount {
    private static final int LAST = 12;
    /**
     * Length of the lowest rib over that of the one above, between the twelfth over the eleventh (0.60 to 0.64) and the
     * eleventh over the tenth (0.83 to 0.84), from end to end in adults.
     */
    private static final double SHORT = 0.73;

    private CutRibCount() {}

    /**
     * Finds the number.
     *
     * @param ribs from top to bottom
     * @return empty if the scan cuts ribs at both ends or at none
     */
    static OptionalInt first(Segmentation s, List<RibComponents.Rib> ribs) {
        boolean above = ribs.stream().anyMatch(rib -> (rib.ends & s.endsToward(true)) != 0);
        boolean below = ribs.stream().anyMatch(rib -> (rib.ends & s.endsToward(false)) != 0);
        if (above == below) {
            return OptionalInt.empty();
        }
        return OptionalInt.of(below ? 1 : last(s, ribs) - ribs.size() + 1);
    }

    private static int last(Segmentation s, List<RibComponents.Rib> ribs) {
        int n = ribs.size();
        boolean known = n > 1 && ribs.get(n - 2).ends == 0;
        boolean isShort = !known || isTwelfth(s, ribs.get(n - 1).voxels, ribs.get(n - 2).voxels);
        return isShort || n == LAST ? LAST : LAST - 1;
    }

    /** Whether a last rib is as short beside the one above as the twelfth is. */
    static boolean isTwelfth(Segmentation s, IntList last, IntList above) {
        return length(s, last) < SHORT * length(s, above);
    }

    /** Diagonal of the box of a rib, mm. */
    private static double length(Segmentation s, IntList voxels) {
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
