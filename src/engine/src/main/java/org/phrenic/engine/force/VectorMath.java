package org.phrenic.engine.force;

import static org.phrenic.engine.force.EdgeBatch.SIZE;

import java.util.List;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The vector instructions of the processor by name (jdk.incubator.vector), as many edges at a time as it has lanes.
 * Loaded by name alone and only where the Java virtual machine was started with that module: {@link SpringKernel}.
 *
 * <p>A last vector that is not full is worked on whole: what its idle lanes hold is never given to a node.
 */
final class VectorMath implements EdgeMath {
    private static final VectorSpecies<Double> LANES = DoubleVector.SPECIES_PREFERRED;
    private static final int STRIDE = LANES.length();

    @Override
    public List<EdgeBatch.Pass> passes(SpringData c) {
        if (SIZE % STRIDE != 0) {
            throw new IllegalStateException("found vectors of " + STRIDE + " doubles, expected a divisor of " + SIZE);
        }
        if (c.damping != 0 && c.shortening == null) {
            return List.of((t, from, n) -> damped(t, c, from, n));
        }
        EdgeBatch.Pass tension = c.shortening == null
                ? (t, from, n) -> tensions(t, c, from, n)
                : (t, from, n) -> contracted(t, c, from, n);
        EdgeBatch.Pass force =
                c.damping == 0 ? (t, from, n) -> forces(t, n) : (t, from, n) -> dampedForces(t, c.damping, n);
        return List.of(tension, force);
    }

    /** All in one loop where there is one stiffness. */
    private static void damped(EdgeBatch t, SpringData c, int from, int count) {
        if (c.oneStiffness) {
            damped(t.difference, t.rate, c.rest, c.stiffness[from], c.damping, from, count);
        } else {
            tensions(t.difference, t.inverse, t.tension, c.rest, c.stiffness, from, count);
            dampedForces(t, c.damping, count);
        }
    }

    private static void damped(double[] d, double[] u, double[] rest, double k, double c, int from, int count) {
        DoubleVector one = DoubleVector.broadcast(LANES, 1);
        for (int i = 0; i < count; i += STRIDE) {
            DoubleVector dx = DoubleVector.fromArray(LANES, d, i);
            DoubleVector dy = DoubleVector.fromArray(LANES, d, i + SIZE);
            DoubleVector dz = DoubleVector.fromArray(LANES, d, i + 2 * SIZE);
            DoubleVector q = one.div(dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).lanewise(VectorOperators.SQRT));
            DoubleVector rate = DoubleVector.fromArray(LANES, u, i)
                    .mul(dx)
                    .add(DoubleVector.fromArray(LANES, u, i + SIZE).mul(dy))
                    .add(DoubleVector.fromArray(LANES, u, i + 2 * SIZE).mul(dz))
                    .mul(q.mul(q));
            DoubleVector t = one.sub(
                            DoubleVector.fromArray(LANES, rest, from + i).mul(q))
                    .mul(k)
                    .add(rate.mul(c));
            dx.mul(t).intoArray(d, i);
            dy.mul(t).intoArray(d, i + SIZE);
            dz.mul(t).intoArray(d, i + 2 * SIZE);
        }
    }

    private static DoubleVector inverseLength(double[] d, int i) {
        DoubleVector dx = DoubleVector.fromArray(LANES, d, i);
        DoubleVector dy = DoubleVector.fromArray(LANES, d, i + SIZE);
        DoubleVector dz = DoubleVector.fromArray(LANES, d, i + 2 * SIZE);
        return DoubleVector.broadcast(LANES, 1)
                .div(dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).lanewise(VectorOperators.SQRT));
    }

    private static void tensions(EdgeBatch t, SpringData c, int from, int count) {
        if (c.oneStiffness) {
            tensions(t.difference, t.inverse, t.tension, c.rest, c.stiffness[from], from, count);
        } else {
            tensions(t.difference, t.inverse, t.tension, c.rest, c.stiffness, from, count);
        }
    }

    private static void tensions(
            double[] d, double[] inverse, double[] tension, double[] rest, double k, int from, int count) {
        DoubleVector one = DoubleVector.broadcast(LANES, 1);
        for (int i = 0; i < count; i += STRIDE) {
            DoubleVector q = inverseLength(d, i);
            q.intoArray(inverse, i);
            one.sub(DoubleVector.fromArray(LANES, rest, from + i).mul(q)).mul(k).intoArray(tension, i);
        }
    }

    private static void tensions(
            double[] d, double[] inverse, double[] tension, double[] rest, double[] k, int from, int count) {
        DoubleVector one = DoubleVector.broadcast(LANES, 1);
        for (int i = 0; i < count; i += STRIDE) {
            DoubleVector q = inverseLength(d, i);
            q.intoArray(inverse, i);
            one.sub(DoubleVector.fromArray(LANES, rest, from + i).mul(q))
                    .mul(DoubleVector.fromArray(LANES, k, from + i))
                    .intoArray(tension, i);
        }
    }

    private static void contracted(EdgeBatch t, SpringData c, int from, int count) {
        double[] d = t.difference;
        double[] inverse = t.inverse;
        double[] tension = t.tension;
        double[] rest = c.rest;
        double[] shortening = c.shortening;
        double[] k = c.stiffness;
        double activation = c.activation;
        DoubleVector one = DoubleVector.broadcast(LANES, 1);
        for (int i = 0; i < count; i += STRIDE) {
            DoubleVector q = inverseLength(d, i);
            q.intoArray(inverse, i);
            DoubleVector length = DoubleVector.fromArray(LANES, rest, from + i)
                    .sub(DoubleVector.fromArray(LANES, shortening, from + i).mul(activation));
            one.sub(length.mul(q))
                    .mul(DoubleVector.fromArray(LANES, k, from + i))
                    .intoArray(tension, i);
        }
    }

    private static void dampedForces(EdgeBatch t, double c, int count) {
        double[] d = t.difference;
        double[] u = t.rate;
        double[] inverse = t.inverse;
        double[] tension = t.tension;
        for (int i = 0; i < count; i += STRIDE) {
            DoubleVector rate = stretchRate(d, u, inverse, i);
            scale(d, DoubleVector.fromArray(LANES, tension, i).add(rate.mul(c)), i);
        }
    }

    private static void forces(EdgeBatch t, int count) {
        double[] d = t.difference;
        double[] tension = t.tension;
        for (int i = 0; i < count; i += STRIDE) {
            scale(d, DoubleVector.fromArray(LANES, tension, i), i);
        }
    }

    private static DoubleVector stretchRate(double[] d, double[] u, double[] inverse, int i) {
        DoubleVector q = DoubleVector.fromArray(LANES, inverse, i);
        return DoubleVector.fromArray(LANES, u, i)
                .mul(DoubleVector.fromArray(LANES, d, i))
                .add(DoubleVector.fromArray(LANES, u, i + SIZE).mul(DoubleVector.fromArray(LANES, d, i + SIZE)))
                .add(DoubleVector.fromArray(LANES, u, i + 2 * SIZE).mul(DoubleVector.fromArray(LANES, d, i + 2 * SIZE)))
                .mul(q.mul(q));
    }

    private static void scale(double[] d, DoubleVector t, int i) {
        DoubleVector.fromArray(LANES, d, i).mul(t).intoArray(d, i);
        DoubleVector.fromArray(LANES, d, i + SIZE).mul(t).intoArray(d, i + SIZE);
        DoubleVector.fromArray(LANES, d, i + 2 * SIZE).mul(t).intoArray(d, i + 2 * SIZE);
    }
}
