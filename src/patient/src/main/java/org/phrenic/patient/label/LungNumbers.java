package org.phrenic.patient.label;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Whether labels that a table takes for lungs, and for nothing else, are lungs: places and volumes make too few
 * comparisons to tell two lungs, or their lobes, from other structures that somebody numbered.
 */
final class LungNumbers {
    private static final String RIGHT = "lung_R";
    private static final String LEFT = "lung_L";
    /** Greatest factor by which one lung is larger than the other. */
    private static final double MOST_BETWEEN_LUNGS = 5;
    /** Least share of a lobe in both lungs: a middle lobe that has collapsed. */
    private static final double LEAST_LOBE_SHARE = 0.005;
    /** Least distance of the lungs' middles from side to side, over the sum of their standard deviations that way. */
    private static final double LEAST_APART = 2;

    /** A lung: number of voxels, mean and mean square of their coordinates. */
    private record Lung(double count, double[] mean, double[] square) {
        static Lung of(LabelPositions positions, List<Integer> labels) {
            double count = 0;
            double[] mean = new double[3];
            double[] square = new double[3];
            for (int label : labels) {
                count += positions.count(label);
                for (int axis = 0; axis < 3; axis++) {
                    double share = positions.count(label) / count;
                    double centre = positions.centre(label)[axis];
                    mean[axis] += share * (centre - mean[axis]);
                    square[axis] += share * (positions.variance(label)[axis] + centre * centre - square[axis]);
                }
            }
            return new Lung(count, mean, square);
        }

        double deviation(int axis) {
            return Math.sqrt(square[axis] - mean[axis] * mean[axis]);
        }

        boolean isTall() {
            return deviation(2) > deviation(0);
        }
    }

    private LungNumbers() {}

    /**
     * Whether labels may be those of their structures. Each label of a lung lies on its side of each of the other one
     * and is large enough for a lobe; the lungs lie apart, are about as large as each other and taller than wide. What
     * the volume may cut off tells no volume and no height.
     *
     * @param structures structure by label, of the labels that the volume has
     */
    static boolean arePossible(LabelPositions positions, Map<Integer, String> structures) {
        if (!Set.copyOf(structures.values()).equals(Set.of(RIGHT, LEFT))) {
            return true;
        }
        List<Integer> right = labels(structures, RIGHT);
        List<Integer> left = labels(structures, LEFT);
        boolean sides = right.stream().allMatch(r -> left.stream()
                .allMatch(l -> positions.centre(r)[0] < positions.centre(l)[0]));
        Lung one = Lung.of(positions, right);
        Lung two = Lung.of(positions, left);
        boolean lobes = structures.keySet().stream()
                .allMatch(label -> positions.isAtEnd(label)
                        || positions.count(label) > LEAST_LOBE_SHARE * (one.count + two.count));
        double apart = two.mean[0] - one.mean[0];
        boolean whole = structures.keySet().stream().noneMatch(positions::isAtEnd);
        boolean alike = Math.max(one.count, two.count) < MOST_BETWEEN_LUNGS * Math.min(one.count, two.count);
        return sides
                && lobes
                && apart > LEAST_APART * (one.deviation(0) + two.deviation(0))
                && (!whole || (alike && one.isTall() && two.isTall()));
    }

    private static List<Integer> labels(Map<Integer, String> structures, String lung) {
        return structures.keySet().stream()
                .filter(label -> structures.get(label).equals(lung))
                .toList();
    }
}
