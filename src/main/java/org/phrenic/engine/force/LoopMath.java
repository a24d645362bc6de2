package org.phrenic.engine.force;

import static org.phrenic.engine.force.EdgeBatch.SIZE;

import java.util.ArrayList;
import java.util.List;

/** Short plain loops over consecutive numbers, which the just-in-time compiler turns into vector instructions, up to eight edges at a time. */
final class LoopMath implements EdgeMath {

    @Override
    public List<EdgeBatch.Pass> passes(EdgeConstants c) {
        List<EdgeBatch.Pass> passes = new ArrayList<>();
        passes.add((t, from, n) -> inverseLengths(t.difference, t.inverse, n));
        passes.add((t, from, n) -> System.arraycopy(c.rest, from, t.rest, 0, n));
        if (c.shortening != null) {
            passes.add((t, from, n) -> contract(t, c, from, n));
        }
        passes.add((t, from, n) -> tension(t, c, from, n));
        if (c.damping != 0) {
            passes.add((t, from, n) -> stretchRates(t.rate, t.difference, t.inverse, n));
            passes.add((t, from, n) -> dampen(t.tension, c.damping, t.rate, n));
        }
        passes.add((t, from, n) -> forces(t.difference, t.tension, n));
        return passes;
    }

    private static void contract(EdgeBatch t, EdgeConstants c, int from, int count) {
        System.arraycopy(c.shortening, from, t.constant, 0, count);
        contract(t.rest, t.constant, c.activation, count);
    }

    private static void tension(EdgeBatch t, EdgeConstants c, int from, int count) {
        if (c.oneStiffness) {
            tensions(t.tension, c.stiffness[from], t.rest, t.inverse, count);
            return;
        }
        System.arraycopy(c.stiffness, from, t.constant, 0, count);
        tensions(t.tension, t.constant, t.rest, t.inverse, count);
    }

    /** inverse = 1 / |d|. Two loops: the compiler turns only short ones into vector instructions. */
    private static void inverseLengths(double[] d, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            inverse[i] = d[i] * d[i] + d[i + SIZE] * d[i + SIZE] + d[i + 2 * SIZE] * d[i + 2 * SIZE];
        }
        for (int i = 0; i < count; i++) {
            inverse[i] = 1 / Math.sqrt(inverse[i]);
        }
    }

    /** rest -= activation share. */
    private static void contract(double[] rest, double[] share, double activation, int count) {
        for (int i = 0; i < count; i++) {
            rest[i] -= activation * share[i];
        }
    }

    /** tension = k (1 - rest / length) with one k for all. */
    private static void tensions(double[] tension, double k, double[] rest, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] = k * (1 - rest[i] * inverse[i]);
        }
    }

    /** tension = k (1 - rest / length) with a k each. */
    private static void tensions(double[] tension, double[] k, double[] rest, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] = k[i] * (1 - rest[i] * inverse[i]);
        }
    }

    /** The first component of u becomes (u·d) / |d|²: the rate of stretching over the length. */
    private static void stretchRates(double[] u, double[] d, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            u[i] = u[i] * d[i] + u[i + SIZE] * d[i + SIZE] + u[i + 2 * SIZE] * d[i + 2 * SIZE];
        }
        for (int i = 0; i < count; i++) {
            u[i] *= inverse[i] * inverse[i];
        }
    }

    /** tension += c rate. */
    private static void dampen(double[] tension, double c, double[] rate, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] += c * rate[i];
        }
    }

    /** d becomes tension d, the force on the first end. */
    private static void forces(double[] d, double[] tension, int count) {
        for (int i = 0; i < count; i++) {
            double t = tension[i];
            d[i] *= t;
            d[i + SIZE] *= t;
            d[i + 2 * SIZE] *= t;
        }
    }
}
