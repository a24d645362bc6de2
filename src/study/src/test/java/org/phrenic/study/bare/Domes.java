package org.phrenic.study.bare;

import java.util.stream.IntStream;
import org.phrenic.mesh.TriangleMesh;

/**
 * Closed double-layered domes of any resolution: two square grids bent to half spheres a little apart and sewn together
 * at the rim.
 */
public final class Domes {
    private static final double RADIUS_MM = 100;
    private static final double THICKNESS_MM = 3;
    /** Share of the height, from the rim up, that is held still. */
    private static final double HELD = 0.1;
    /** Share of the height from which up the dome carries the load. */
    private static final double LOADED = 0.35;
    /** Every so many vertices of a face, one is linked to the other face. */
    private static final int LINK_EVERY = 5;

    private Domes() {}

    /**
     * @param side vertices along a side of each grid: the dome has 2 side² vertices and 6 side² - 6 edges
     * @param linked whether the faces are joined by rigid links
     */
    public static BareScene scene(int side, boolean linked) {
        TriangleMesh mesh = mesh(side);
        int face = side * side;
        int[] fixed = IntStream.range(0, 2 * face)
                .filter(i -> mesh.z(i) <= HELD * RADIUS_MM)
                .toArray();
        int[] loaded = IntStream.range(0, 2 * face)
                .filter(i -> mesh.z(i) >= LOADED * RADIUS_MM)
                .toArray();
        int[] links = IntStream.range(0, linked ? face : 0)
                .filter(i -> i % LINK_EVERY == 0)
                .flatMap(i -> IntStream.of(i, face + i))
                .toArray();
        return new BareScene(mesh, fixed, loaded, links);
    }

    private static TriangleMesh mesh(int side) {
        int face = side * side;
        double[] positions = new double[6 * face];
        for (int layer = 0; layer < 2; layer++) {
            double radius = RADIUS_MM - layer * THICKNESS_MM;
            for (int i = 0; i < face; i++) {
                double s = 2.0 * (i % side) / (side - 1) - 1;
                double t = 2.0 * (i / side) / (side - 1) - 1;
                // The square to the disc, then up onto the sphere.
                double x = s * Math.sqrt(1 - t * t / 2);
                double y = t * Math.sqrt(1 - s * s / 2);
                int at = 3 * (layer * face + i);
                positions[at] = radius * x;
                positions[at + 1] = radius * y;
                positions[at + 2] = radius * Math.sqrt(Math.max(0, 1 - x * x - y * y));
            }
        }
        int[] rim = rim(side);
        int[] triangles = new int[3 * (4 * (side - 1) * (side - 1) + 2 * rim.length)];
        int k = 0;
        for (int row = 0; row + 1 < side; row++) {
            for (int column = 0; column + 1 < side; column++) {
                int a = row * side + column;
                int[] upper = {a, a + 1, a + side + 1, a, a + side + 1, a + side};
                for (int c = 0; c < 6; c++) {
                    triangles[k + c] = upper[c];
                    triangles[k + 11 - c] = face + upper[c];
                }
                k += 12;
            }
        }
        for (int i = 0; i < rim.length; i++) {
            int a = rim[i];
            int b = rim[(i + 1) % rim.length];
            int[] wall = {a, face + a, b, b, face + a, face + b};
            System.arraycopy(wall, 0, triangles, k, 6);
            k += 6;
        }
        return new TriangleMesh(positions, triangles);
    }

    /** The grid's outer vertices, once around. */
    private static int[] rim(int side) {
        int last = side - 1;
        return IntStream.range(0, 4 * last)
                .map(i -> {
                    int along = i % last;
                    return switch (i / last) {
                        case 0 -> along;
                        case 1 -> along * side + last;
                        case 2 -> last * side + last - along;
                        default -> (last - along) * side;
                    };
                })
                .toArray();
    }
}
