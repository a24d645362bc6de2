package org.phrenic.motion;

import org.phrenic.engine.kinematics.HelicalBody;

/** Displacement of a rigid body. */
final class RigidField implements RegionField {
    private final double[] pose;

    /** @param pose as {@link HelicalBody#transformPoints} takes it */
    RigidField(double[] pose) {
        this.pose = pose.clone();
    }

    @Override
    public void at(double x, double y, double z, double[] out) {
        out[0] = pose[0] * x + pose[1] * y + pose[2] * z + pose[3] - x;
        out[1] = pose[4] * x + pose[5] * y + pose[6] * z + pose[7] - y;
        out[2] = pose[8] * x + pose[9] * y + pose[10] * z + pose[11] - z;
    }

    /** The displacement back. */
    RigidField inverse() {
        double[] p = pose;
        double[] back = {p[0], p[4], p[8], 0, p[1], p[5], p[9], 0, p[2], p[6], p[10], 0};
        for (int row = 0; row < 12; row += 4) {
            back[row + 3] = -(back[row] * p[3] + back[row + 1] * p[7] + back[row + 2] * p[11]);
        }
        return new RigidField(back);
    }
}
