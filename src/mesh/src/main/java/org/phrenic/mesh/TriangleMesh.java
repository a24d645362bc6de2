package org.phrenic.mesh;

/**
 * An indexed triangle surface: vertex {@code i} at {@code positions()[3i..3i+2]} (mm), triangle {@code t} with corners
 * {@code triangles()[3t..3t+2]}, anticlockwise seen from outside.
 *
 * <p>The arrays are shared, not copied, and must not be written to: a mesh is a value. Indices are checked once, on
 * construction; coordinates are not (a reader that meets a NaN says so with the line or byte it stood at).
 */
public final class TriangleMesh {
    private final double[] positions;
    private final int[] triangles;

    /**
     * @param positions x, y, z of each vertex, mm; length a multiple of 3
     * @param triangles three vertex indices a triangle; length a multiple of 3
     * @throws IllegalArgumentException if a length is no multiple of 3 or an index lies outside the vertices
     */
    public TriangleMesh(double[] positions, int[] triangles) {
        if (positions.length % 3 != 0) {
            throw new IllegalArgumentException("positions: " + positions.length + " numbers, expected a multiple of 3");
        }
        if (triangles.length % 3 != 0) {
            throw new IllegalArgumentException("triangles: " + triangles.length + " indices, expected a multiple of 3");
        }
        int count = positions.length / 3;
        for (int i = 0; i < triangles.length; i++) {
            if (triangles[i] < 0 || triangles[i] >= count) {
                throw new IllegalArgumentException(
                        "triangle " + i / 3 + " names vertex " + triangles[i] + ", expected 0 to " + (count - 1));
            }
        }
        this.positions = positions;
        this.triangles = triangles;
    }

    private TriangleMesh(double[] positions, TriangleMesh checked) {
        this.positions = positions;
        this.triangles = checked.triangles;
    }

    public int vertexCount() {
        return positions.length / 3;
    }

    public int triangleCount() {
        return triangles.length / 3;
    }

    /** Vertex coordinates in mm, x y z in turn; shared, read only. */
    public double[] positions() {
        return positions;
    }

    /** Corner indices, three a triangle; shared, read only. */
    public int[] triangles() {
        return triangles;
    }

    public double x(int vertex) {
        return positions[3 * vertex];
    }

    public double y(int vertex) {
        return positions[3 * vertex + 1];
    }

    public double z(int vertex) {
        return positions[3 * vertex + 2];
    }

    /** The same triangles over other positions (same vertex count). */
    public TriangleMesh withPositions(double[] moved) {
        if (moved.length != positions.length) {
            throw new IllegalArgumentException("positions: " + moved.length + " numbers, expected " + positions.length);
        }
        return new TriangleMesh(moved, this);
    }

    /** {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm; infinities (min above max) for a mesh without vertices. */
    public double[] bounds() {
        double[] box = new double[6];
        BoundingBoxes.setEmpty(box, 0);
        for (int i = 0; i < positions.length; i += 3) {
            BoundingBoxes.include(box, 0, positions, i);
        }
        return box;
    }

    /** Centre of the bounding box, mm; 0 for a mesh without vertices. */
    public double[] centre() {
        double[] box = positions.length == 0 ? new double[6] : bounds();
        return new double[] {(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2};
    }

    @Override
    public String toString() {
        return "TriangleMesh[" + vertexCount() + " vertices, " + triangleCount() + " triangles]";
    }
}
