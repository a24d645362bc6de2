package org.phrenic.anatomy;

import org.phrenic.mesh.TriangleMesh;

/**
 * A diaphragm in closed form: two half ellipsoids about the origin, one inside the other, joined at their rim in z = 0;
 * if asked for, with an opening at the top. Vertices of the outer (thoracic) face come first, those of the inner
 * (abdominal) one after, in the same order.
 */
public final class DomeSheet {
    private DomeSheet() {}

    /** A dome 260 mm wide, 180 deep and 110 high, 3 mm thick. */
    public static TriangleMesh adult(int rings) {
        return of(130, 90, 110, 3, rings, 0);
    }

    /**
     * Both faces and what joins them.
     *
     * @param a half width of the outer face, mm
     * @param b half depth, mm
     * @param c height, mm
     * @param thickness between the faces, mm
     * @param rings of triangles from top to rim; ring k has 6 k vertices
     * @param opening rings left out at the top, 0 for a whole dome
     */
    public static TriangleMesh of(double a, double b, double c, double thickness, int rings, int opening) {
        int skipped = opening == 0 ? 0 : index(opening, 0);
        int face = index(rings + 1, 0) - skipped;
        double[] p = new double[6 * face];
        for (int k = opening; k <= rings; k++) {
            for (int j = 0; j < Math.max(1, 6 * k); j++) {
                double turn = k == 0 ? 0 : Math.PI * j / (3 * k);
                double down = Math.PI / 2 * k / rings;
                int v = 3 * (index(k, j) - skipped);
                for (int inner = 0; inner < 2; inner++) {
                    int at = v + 3 * inner * face;
                    p[at] = (a - inner * thickness) * Math.sin(down) * Math.cos(turn);
                    p[at + 1] = (b - inner * thickness) * Math.sin(down) * Math.sin(turn);
                    p[at + 2] = k == rings ? 0 : (c - inner * thickness) * Math.cos(down);
                }
            }
        }
        Triangles t = new Triangles(face, skipped);
        for (int k = opening; k < rings; k++) {
            for (int sector = 0; sector < 6; sector++) {
                for (int i = 0; i <= k; i++) {
                    int here = index(k, sector * k + i);
                    int below = index(k + 1, sector * (k + 1) + i);
                    int belowNext = index(k + 1, sector * (k + 1) + i + 1);
                    t.onBothFaces(here, below, belowNext);
                    if (i < k) {
                        t.onBothFaces(here, belowNext, index(k, sector * k + i + 1));
                    }
                }
            }
        }
        for (int j = 0; j < 6 * rings; j++) {
            t.join(index(rings, j), index(rings, j + 1));
        }
        for (int j = 0; j < 6 * opening; j++) {
            t.join(index(opening, j + 1), index(opening, j));
        }
        return new TriangleMesh(p, t.corners());
    }

    private static int index(int ring, int j) {
        return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + j % (6 * ring);
    }

    private static final class Triangles {
        private final java.util.stream.IntStream.Builder corners = java.util.stream.IntStream.builder();
        private final int face;
        private final int skipped;

        Triangles(int face, int skipped) {
            this.face = face;
            this.skipped = skipped;
        }

        void onBothFaces(int u, int v, int w) {
            add(u, v, w);
            add(u + face, w + face, v + face);
        }

        /** Two triangles between the edge u-v of the outer face and that of the inner one. */
        void join(int u, int v) {
            add(u, u + face, v + face);
            add(u, v + face, v);
        }

        private void add(int u, int v, int w) {
            corners.add(u - skipped).add(v - skipped).add(w - skipped);
        }

        int[] corners() {
            return corners.build().toArray();
        }
    }
}
