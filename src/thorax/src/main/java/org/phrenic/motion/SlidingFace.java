package org.phrenic.motion;

import java.util.Arrays;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/** A part of a surface along which soft tissue slides. */
final class SlidingFace {
    /** Square of the cosine to the normal of the nearest triangle, below which a place lies beside the face. */
    private static final double PAST_THE_END = 0.25;

    private final int surface;
    /** Vertices of the surface that the part uses. */
    private final int[] vertices;

    private final TriangleMesh rest;

    /**
     * @param surface number of the surface
     * @param whole the surface at rest
     * @param triangles corners of the triangles of the part
     */
    SlidingFace(int surface, TriangleMesh whole, int[] triangles) {
        this.surface = surface;
        vertices = Arrays.stream(triangles).distinct().sorted().toArray();
        int[] own = Arrays.stream(triangles)
                .map(corner -> Arrays.binarySearch(vertices, corner))
                .toArray();
        rest = new TriangleMesh(positions(whole.positions()), own);
    }

    int surface() {
        return surface;
    }

    /** The part as a mesh of its own. */
    TriangleMesh rest() {
        return rest;
    }

    private double[] positions(double[] whole) {
        double[] p = new double[3 * vertices.length];
        for (int v = 0; v < vertices.length; v++) {
            System.arraycopy(whole, 3 * vertices[v], p, 3 * v, 3);
        }
        return p;
    }

    /**
     * Adds the displacements that keep the tissue at the face: from each vertex at rest to the place on the moved face
     * that is nearest to where a field carries it. Tissue that the field carries past the end of the face, such as the
     * insertion of the diaphragm, goes there.
     *
     * @param now vertices of the whole surface now
     */
    void add(RegionField field, double[] now, DoubleList displacements) {
        TriangleMesh face = rest.withPositions(positions(now));
        TriangleTree tree = new TriangleTree(face);
        double[] normals = MeshMeasure.triangleNormals(face);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] u = new double[3];
        for (int v = 0; v < rest.vertexCount(); v++) {
            double x = rest.x(v);
            double y = rest.y(v);
            double z = rest.z(v);
            field.at(x, y, z, u);
            tree.closest(x + u[0], y + u[1], z + u[2], hit);
            double[] gap = {hit.x - x - u[0], hit.y - y - u[1], hit.z - z - u[2]};
            double across = 0;
            for (int axis = 0; axis < 3; axis++) {
                across += gap[axis] * normals[3 * hit.triangle + axis];
            }
            boolean past = across * across < PAST_THE_END * hit.distanceSquared;
            for (int axis = 0; axis < 3; axis++) {
                displacements.add(u[axis] + (past ? 0 : gap[axis]));
            }
        }
    }
}
