package org.phrenic.patient.segmentation;

import java.util.Optional;

/**
 * Where the voxels of a lung lie.
 *
 * @param centre their mean, mm
 * @param lowest least height of one, mm
 * @param highest greatest height of one, mm
 * @param isCutAbove whether the lung reaches the upper end of the volume
 */
record LungVoxels(double[] centre, double lowest, double highest, boolean isCutAbove) {
    /** @return empty if no voxel has the name */
    static Optional<LungVoxels> of(Segmentation s, String name) {
        int segment = s.find(name);
        double[] centre = new double[3];
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        int ends = 0;
        int count = 0;
        for (int v = 0; segment > 0 && v < s.voxels.length; v++) {
            if (s.segmentAt(v) == segment) {
                count++;
                for (int axis = 0; axis < 3; axis++) {
                    centre[axis] += (s.coordinate(v, axis) - centre[axis]) / count;
                }
                lowest = Math.min(lowest, s.coordinate(v, 2));
                highest = Math.max(highest, s.coordinate(v, 2));
                ends |= s.ends(v);
            }
        }
        boolean cut = (ends & s.endsToward(true)) != 0;
        return count == 0 ? Optional.empty() : Optional.of(new LungVoxels(centre, lowest, highest, cut));
    }
}
