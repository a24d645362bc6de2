package org.phrenic.access;

import java.util.List;
import org.phrenic.mesh.Vectors;

/**
 * How a target moves over a breath.
 *
 * @param positions of its middle, LPS, mm; not to be written to
 */
public record TargetMotion(List<double[]> positions) {
    /** Greatest distance between two places, mm: "the target moves X mm". */
    public double excursionMm() {
        double most = 0;
        for (double[] a : positions) {
            for (double[] b : positions) {
                most = Math.max(most, Vectors.distance(a, b));
            }
        }
        return most;
    }

    /** Range in x, y, z (to the left, backwards, upwards), mm. */
    public double[] rangeMm() {
        double[] range = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            int k = axis;
            range[axis] = positions.stream().mapToDouble(t -> t[k]).max().orElse(0)
                    - positions.stream().mapToDouble(t -> t[k]).min().orElse(0);
        }
        return range;
    }
}
