package org.phrenic.anatomy;

import org.phrenic.engine.PrescribedMotion;

/**
 * Points carried by bones: each by up to {@value BoneWeights#MOST_BODIES} bodies, x = Σ w T_k X with weights that sum to 1 (linear blending: exact for a
 * point on one bone, smooth between two).
 */
public final class BlendedMotion implements PrescribedMotion {
    private final RibCagePose pose;
    private final double[] rest;
    private final int[] body;
    private final double[] weight;

    /**
     * @param pose of the rib cage
     * @param rest where the points are at rest, mm
     * @param bones the weights of each point
     */
    public BlendedMotion(RibCagePose pose, double[] rest, BoneWeights.Blend bones) {
        this.pose = pose;
        this.rest = rest.clone();
        this.body = bones.body();
        this.weight = bones.weight();
    }

    @Override
    public int pointCount() {
        return rest.length / 3;
    }

    @Override
    public void at(double time, double[] position, double[] velocity) {
        pose.update(time);
        int most = BoneWeights.MOST_BODIES;
        for (int i = 0, p = 0; i < rest.length; i += 3, p += most) {
            double x = 0;
            double y = 0;
            double z = 0;
            double vx = 0;
            double vy = 0;
            double vz = 0;
            for (int k = p; k < p + most; k++) {
                double w = weight[k];
                if (w == 0) {
                    continue;
                }
                double[] t = pose.pose(body[k]);
                double[] s = pose.twist(body[k]);
                double bx = t[0] * rest[i] + t[1] * rest[i + 1] + t[2] * rest[i + 2] + t[3];
                double by = t[4] * rest[i] + t[5] * rest[i + 1] + t[6] * rest[i + 2] + t[7];
                double bz = t[8] * rest[i] + t[9] * rest[i + 1] + t[10] * rest[i + 2] + t[11];
                x += w * bx;
                y += w * by;
                z += w * bz;
                vx += w * (s[1] * bz - s[2] * by + s[3]);
                vy += w * (s[2] * bx - s[0] * bz + s[4]);
                vz += w * (s[0] * by - s[1] * bx + s[5]);
            }
            position[i] = x;
            position[i + 1] = y;
            position[i + 2] = z;
            velocity[i] = vx;
            velocity[i + 1] = vy;
            velocity[i + 2] = vz;
        }
    }
}
