package org.phrenic.anatomy.cage;

import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.parallel.Workers;

/**
 * Linear blend skinning of points: x = Σ w_k T_k X over up to {@value SkinningWeights#MAX_BODIES} bodies, with weights
 * that sum to 1. The motion is rigid for a point on one bone and smooth between bones.
 */
public final class LinearBlendSkinning implements PrescribedMotion {
    private static final int POINTS_PER_BLOCK = 512;

    private final RibCagePose pose;
    private final Workers workers;
    private final double[] rest;
    private final int[] body;
    private final double[] weight;
    private final Workers.Task task = this::skinBlock;
    private double[] position;
    private double[] velocity;

    /**
     * @param pose pose of the rib cage
     * @param rest positions of the points at rest, mm
     * @param bones skinning weights of the points
     * @param workers threads that share the points; only the thread that owns them may call {@link #at}
     */
    public LinearBlendSkinning(RibCagePose pose, double[] rest, SkinningWeights.Weights bones, Workers workers) {
        this.pose = pose;
        this.workers = workers;
        this.rest = rest.clone();
        this.body = bones.body();
        this.weight = bones.weight();
    }

    private LinearBlendSkinning(LinearBlendSkinning like, RibCagePose pose) {
        this.pose = pose;
        workers = Workers.of(1);
        rest = like.rest;
        body = like.body;
        weight = like.weight;
    }

    /** The same motion of the same points after another pose, on the calling thread alone. */
    public LinearBlendSkinning after(RibCagePose other) {
        return new LinearBlendSkinning(this, other);
    }

    @Override
    public int pointCount() {
        return rest.length / 3;
    }

    @Override
    public void at(double time, double[] positions, double[] velocities) {
        pose.update(time);
        position = positions;
        velocity = velocities;
        workers.run((pointCount() + POINTS_PER_BLOCK - 1) / POINTS_PER_BLOCK, task);
    }

    private void skinBlock(int piece) {
        int most = SkinningWeights.MAX_BODIES;
        int end = Math.min(pointCount(), (piece + 1) * POINTS_PER_BLOCK);
        double[] given = rest;
        double[] moved = position;
        double[] speed = velocity;
        for (int n = piece * POINTS_PER_BLOCK; n < end; n++) {
            int i = 3 * n;
            double rx = given[i];
            double ry = given[i + 1];
            double rz = given[i + 2];
            double x = 0;
            double y = 0;
            double z = 0;
            double vx = 0;
            double vy = 0;
            double vz = 0;
            // Weights are in descending order: the first 0 ends them.
            for (int k = most * n; k < most * (n + 1) && weight[k] != 0; k++) {
                double w = weight[k];
                double[] t = pose.pose(body[k]);
                double[] s = pose.twist(body[k]);
                double bx = t[0] * rx + t[1] * ry + t[2] * rz + t[3];
                double by = t[4] * rx + t[5] * ry + t[6] * rz + t[7];
                double bz = t[8] * rx + t[9] * ry + t[10] * rz + t[11];
                x += w * bx;
                y += w * by;
                z += w * bz;
                vx += w * (s[1] * bz - s[2] * by + s[3]);
                vy += w * (s[2] * bx - s[0] * bz + s[4]);
                vz += w * (s[0] * by - s[1] * bx + s[5]);
            }
            moved[i] = x;
            moved[i + 1] = y;
            moved[i + 2] = z;
            speed[i] = vx;
            speed[i + 1] = vy;
            speed[i + 2] = vz;
        }
    }
}
