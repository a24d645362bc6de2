package org.phrenic.engine.force;

import static org.phrenic.engine.force.EdgeLoops.give;
import static org.phrenic.engine.force.EdgeLoops.inverseLength;
import static org.phrenic.engine.force.EdgeLoops.take;

import org.phrenic.engine.parallel.BlockedEdges;

/** Springs of constant rest length without dashpots. The formula is that of {@link EdgeLoops}. */
final class ElasticKernel {
    private ElasticKernel() {}

    /**
     * Entries of which three in a row have the same first node, which is read and written once for the three; both
     * ends.
     */
    static void stars(EdgeBatch batch, BlockedEdges edges, SpringData c, int from, int to) {
        int[] own = edges.own;
        int[] other = edges.other;
        double[] rest = c.rest;
        double[] k = c.stiffness;
        double[] x = batch.x;
        double[] force = batch.force;
        for (int i = from; i < to; i += 3) {
            int a = own[i];
            double ax = x[a];
            double ay = x[a + 1];
            double az = x[a + 2];

            int b = other[i];
            double dx = x[b] - ax;
            double dy = x[b + 1] - ay;
            double dz = x[b + 2] - az;
            double q = inverseLength(dx, dy, dz);
            double t = k[i] * (1 - rest[i] * q);
            double sx = dx * t;
            double sy = dy * t;
            double sz = dz * t;
            take(force, b, sx, sy, sz);

            b = other[i + 1];
            dx = x[b] - ax;
            dy = x[b + 1] - ay;
            dz = x[b + 2] - az;
            q = inverseLength(dx, dy, dz);
            t = k[i + 1] * (1 - rest[i + 1] * q);
            double fx = dx * t;
            double fy = dy * t;
            double fz = dz * t;
            take(force, b, fx, fy, fz);
            sx += fx;
            sy += fy;
            sz += fz;

            b = other[i + 2];
            dx = x[b] - ax;
            dy = x[b + 1] - ay;
            dz = x[b + 2] - az;
            q = inverseLength(dx, dy, dz);
            t = k[i + 2] * (1 - rest[i + 2] * q);
            fx = dx * t;
            fy = dy * t;
            fz = dz * t;
            take(force, b, fx, fy, fz);
            give(force, a, sx + fx, sy + fy, sz + fz);
        }
    }

    /** Any entries, both ends. */
    static void both(EdgeBatch batch, BlockedEdges edges, SpringData c, int from, int to) {
        int[] own = edges.own;
        int[] other = edges.other;
        double[] rest = c.rest;
        double[] k = c.stiffness;
        double[] x = batch.x;
        double[] force = batch.force;
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double q = inverseLength(dx, dy, dz);
            double t = k[i] * (1 - rest[i] * q);
            double fx = dx * t;
            double fy = dy * t;
            double fz = dz * t;
            give(force, a, fx, fy, fz);
            take(force, b, fx, fy, fz);
        }
    }

    /** Any entries, first ends alone. */
    static void first(EdgeBatch batch, BlockedEdges edges, SpringData c, int from, int to) {
        int[] own = edges.own;
        int[] other = edges.other;
        double[] rest = c.rest;
        double[] k = c.stiffness;
        double[] x = batch.x;
        double[] force = batch.force;
        for (int i = from; i < to; i++) {
            int a = own[i];
            int b = other[i];
            double dx = x[b] - x[a];
            double dy = x[b + 1] - x[a + 1];
            double dz = x[b + 2] - x[a + 2];
            double q = inverseLength(dx, dy, dz);
            double t = k[i] * (1 - rest[i] * q);
            give(force, a, dx * t, dy * t, dz * t);
        }
    }
}
