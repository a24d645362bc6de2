package org.phrenic.rehearsal;

import java.util.List;
import org.phrenic.geometry.Vectors;

/**
 * How a target moves over a breath.
 *
 * @param places of its middle, LPS, mm; not to be written to
 */
public record TargetMotion(List<double[]> places) {
    /** Greatest distance between two places, mm: "the target moves X mm". */
    public double mostMm() {
        double most = 0;
        for (double[] a : places) {
            for (double[] b : places) {
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
            range[axis] = places.stream().mapToDouble(t -> t[k]).max().orElse(0)
                    - places.stream().mapToDouble(t -> t[k]).min().orElse(0);
        }
        return range;
    }
}
