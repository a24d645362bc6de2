package org.phrenic.engine.force;

/**
 * One thread's room for a few hundred edges, and the passes that are made over them: {@link EdgeLoops} in one go, or
 * differences between the ends are gathered, an {@link EdgeMath} turns them into forces, and forces are given to the
 * ends.
 *
 * <p>A star is three consecutive entries with the same first node, which is then read and written once for the three.
 */
final class EdgeBatch {
    /**
     * One pass over a batch. Passes are called through this interface from one place, so that the compiler does not
     * inline them into one another: together they want more registers than there are, and run a sixth slower.
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

    /**
     * Edges a batch: a multiple of 3, so that stars are not cut, and small enough for all of it to stay in the
     * first-level cache.
     */
    static final int SIZE = 480;

    /** Component c of entry i is at {@code i + c * SIZE}. */
    final double[] difference = new double[3 * SIZE];

    /** Likewise for velocities; its first component may become the rate of stretching over the length. */
    final double[] rate = new double[3 * SIZE];
    /** 1/length. */
    final double[] inverse = new double[SIZE];

    /** Force along the edge over its length; positive pulls the ends together. */
    final double[] tension = new double[SIZE];

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
}
