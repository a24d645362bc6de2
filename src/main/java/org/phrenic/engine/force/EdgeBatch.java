package org.phrenic.engine.force;

/**
 * One thread's room for a few hundred edges, and the passes that are made over them: differences between the ends are gathered, what needs a root and a quotient is
 * done in plain loops over consecutive numbers (which the just-in-time compiler turns into vector instructions, eight edges at a time), and forces are given to the ends.
 *
 * <p>A star is three consecutive entries with the same first node, which is then read and written once for the three.
 */
final class EdgeBatch {
    /**
     * One pass over a batch. Passes are called through this interface from one place, so that the compiler does not inline them into one another: together they
     * want more registers than there are, and run a sixth slower.
     */
    @FunctionalInterface
    interface Pass {
        /**
         * @param batch room
         * @param from first entry of the batch among all entries
         * @param count entries in the batch
         */
        void run(EdgeBatch batch, int from, int count);
    }

    /** Edges a batch: a multiple of 3, so that stars are not cut, and small enough for all of it to stay in the first-level cache. */
    static final int SIZE = 480;

    /** Component c of entry i is at {@code i + c * SIZE}. */
    final double[] difference = new double[3 * SIZE];

    /** Likewise; its first component becomes the rate of stretching over the length. */
    final double[] rate = new double[3 * SIZE];
    /** 1/length. */
    final double[] inverse = new double[SIZE];

    final double[] rest = new double[SIZE];
    /** Force along the edge over its length; positive pulls the ends together. */
    final double[] tension = new double[SIZE];

    /** A constant of each edge, as the pass at hand needs it. */
    final double[] constant = new double[SIZE];

    /** Positions, velocities and forces of all nodes. */
    double[] x;

    double[] v;
    double[] force;

    /** Makes the passes over the entries {@code [from, to)}, batch by batch. */
    void run(Pass[] passes, int from, int to) {
        for (int at = from; at < to; at += SIZE) {
            int count = Math.min(SIZE, to - at);
            for (Pass pass : passes) {
                pass.run(this, at, count);
            }
        }
    }

    /** u(other) - u(own) of the entries from {@code from}, all of them in stars. */
    static void differencesInStars(int[] own, int[] other, double[] u, double[] out, int from, int count) {
        for (int i = 0; i < count; i += 3) {
            int a = own[from + i];
            double ux = u[a];
            double uy = u[a + 1];
            double uz = u[a + 2];
            int b = other[from + i];
            out[i] = u[b] - ux;
            out[i + SIZE] = u[b + 1] - uy;
            out[i + 2 * SIZE] = u[b + 2] - uz;
            b = other[from + i + 1];
            out[i + 1] = u[b] - ux;
            out[i + 1 + SIZE] = u[b + 1] - uy;
            out[i + 1 + 2 * SIZE] = u[b + 2] - uz;
            b = other[from + i + 2];
            out[i + 2] = u[b] - ux;
            out[i + 2 + SIZE] = u[b + 1] - uy;
            out[i + 2 + 2 * SIZE] = u[b + 2] - uz;
        }
    }

    /** u(other) - u(own) of any entries from {@code from}. */
    static void differences(int[] own, int[] other, double[] u, double[] out, int from, int count) {
        for (int i = 0; i < count; i++) {
            int a = own[from + i];
            int b = other[from + i];
            out[i] = u[b] - u[a];
            out[i + SIZE] = u[b + 1] - u[a + 1];
            out[i + 2 * SIZE] = u[b + 2] - u[a + 2];
        }
    }

    /** inverse = 1 / |d|. Two loops: the compiler turns only short ones into vector instructions. */
    static void inverseLengths(double[] d, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            inverse[i] = d[i] * d[i] + d[i + SIZE] * d[i + SIZE] + d[i + 2 * SIZE] * d[i + 2 * SIZE];
        }
        for (int i = 0; i < count; i++) {
            inverse[i] = 1 / Math.sqrt(inverse[i]);
        }
    }

    /** rest -= activation share. */
    static void contract(double[] rest, double[] share, double activation, int count) {
        for (int i = 0; i < count; i++) {
            rest[i] -= activation * share[i];
        }
    }

    /** tension = k (1 - rest / length) with one k for all. */
    static void tensions(double[] tension, double k, double[] rest, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] = k * (1 - rest[i] * inverse[i]);
        }
    }

    /** tension = k (1 - rest / length) with a k each. */
    static void tensions(double[] tension, double[] k, double[] rest, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] = k[i] * (1 - rest[i] * inverse[i]);
        }
    }

    /** The first component of u becomes (u·d) / |d|²: the rate of stretching over the length. */
    static void stretchRates(double[] u, double[] d, double[] inverse, int count) {
        for (int i = 0; i < count; i++) {
            u[i] = u[i] * d[i] + u[i + SIZE] * d[i + SIZE] + u[i + 2 * SIZE] * d[i + 2 * SIZE];
        }
        for (int i = 0; i < count; i++) {
            u[i] *= inverse[i] * inverse[i];
        }
    }

    /** tension += c rate with one c for all. */
    static void dampen(double[] tension, double c, double[] rate, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] += c * rate[i];
        }
    }

    /** tension += c rate with a c each. */
    static void dampen(double[] tension, double[] c, double[] rate, int count) {
        for (int i = 0; i < count; i++) {
            tension[i] += c[i] * rate[i];
        }
    }

    /** d becomes tension d, the force on the first end. */
    static void forces(double[] d, double[] tension, int count) {
        for (int i = 0; i < count; i++) {
            double t = tension[i];
            d[i] *= t;
            d[i + SIZE] *= t;
            d[i + 2 * SIZE] *= t;
        }
    }

    /** Gives forces to both ends of the entries from {@code from}, all of them in stars. */
    static void giveInStars(int[] own, int[] other, double[] f, double[] force, int from, int count) {
        for (int i = 0; i < count; i += 3) {
            int a = own[from + i];
            int b = other[from + i];
            int c = other[from + i + 1];
            int d = other[from + i + 2];
            double fb = f[i];
            double fc = f[i + 1];
            double fd = f[i + 2];
            force[a] += fb + fc + fd;
            force[b] -= fb;
            force[c] -= fc;
            force[d] -= fd;
            fb = f[i + SIZE];
            fc = f[i + 1 + SIZE];
            fd = f[i + 2 + SIZE];
            force[a + 1] += fb + fc + fd;
            force[b + 1] -= fb;
            force[c + 1] -= fc;
            force[d + 1] -= fd;
            fb = f[i + 2 * SIZE];
            fc = f[i + 1 + 2 * SIZE];
            fd = f[i + 2 + 2 * SIZE];
            force[a + 2] += fb + fc + fd;
            force[b + 2] -= fb;
            force[c + 2] -= fc;
            force[d + 2] -= fd;
        }
    }

    /** Gives forces to both ends. */
    static void giveToBoth(int[] own, int[] other, double[] f, double[] force, int from, int count) {
        for (int i = 0; i < count; i++) {
            int a = own[from + i];
            int b = other[from + i];
            double fx = f[i];
            double fy = f[i + SIZE];
            double fz = f[i + 2 * SIZE];
            force[a] += fx;
            force[a + 1] += fy;
            force[a + 2] += fz;
            force[b] -= fx;
            force[b + 1] -= fy;
            force[b + 2] -= fz;
        }
    }

    /** Gives forces to the first end alone. */
    static void giveToOwn(int[] own, double[] f, double[] force, int from, int count) {
        for (int i = 0; i < count; i++) {
            int a = own[from + i];
            force[a] += f[i];
            force[a + 1] += f[i + SIZE];
            force[a + 2] += f[i + 2 * SIZE];
        }
    }
}
