package org.phrenic.mesh;

/**
 * An indexed triangle mesh. Vertex {@code i} is at {@code positions()[3i..3i+2]} (mm). Triangle {@code t} has the
 * corners {@code triangles()[3t..3t+2]}, anticlockwise seen from outside.
 *
 * <p>A mesh is an immutable value; the arrays are shared, not copied, and must not be modified. The constructor
 * validates indices but not coordinates, because file readers report a NaN with its line or byte.
 */
public final class TriangleMesh {
    private final double[] positions;
    private final int[] triangles;

    /**
     * @param positions x, y, z of each vertex, mm; length a multiple of 3
     * @param triangles three vertex indices per triangle; length a multiple of 3
     * @throws IllegalArgumentException if a length is not a multiple of 3 or an index is out of range
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

    /** Vertex coordinates, x y z in turn, mm; shared, must not be modified. */
    public double[] positions() {
        return positions;
    }

    /** Vertex indices, three per triangle; shared, must not be modified. */
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

    /** A mesh with the same triangles and other positions for the same number of vertices. */
    public TriangleMesh withPositions(double[] moved) {
        if (moved.length != positions.length) {
            throw new IllegalArgumentException("positions: " + moved.length + " numbers, expected " + positions.length);
        }
        return new TriangleMesh(moved, this);
    }

    /**
     * {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm. For an empty mesh the minima are +infinity and the maxima
     * -infinity.
     */
    public double[] bounds() {
        double[] box = new double[6];
        BoundingBoxes.around(positions, 0, positions.length, box, 0);
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
