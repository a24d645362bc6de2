package org.phrenic.patient.diaphragm;

import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/** Organ vertices that lie beyond the middle of the diaphragm, on the side where they do not belong. */
final class OrganSides {
    /** Vertices farther beyond are counted, mm. */
    static final double THROUGH_MM = 3;

    private final Diaphragm diaphragm;
    private final double[] normals;
    private final TriangleTree tree;
    private final TriangleTree otherFace;
    private final TriangleTree.Hit opposite = new TriangleTree.Hit();
    private int vertices;
    private int count;
    private double greatest;

    /** @param thoracic whether the organs belong above the thoracic face; else below the abdominal face */
    OrganSides(Diaphragm diaphragm, boolean thoracic, List<Structure> organs) {
        this.diaphragm = diaphragm;
        TriangleMesh face = face(thoracic);
        normals = MeshMeasure.vertexNormals(face);
        tree = new TriangleTree(face);
        otherFace = new TriangleTree(face(!thoracic));
        organs.forEach(organ -> measure(organ.mesh()));
    }

    private TriangleMesh face(boolean thoracic) {
        TriangleMesh sheet = diaphragm.sheet();
        int[] corners = IntStream.range(0, sheet.triangleCount())
                .filter(t -> diaphragm.isThoracicTriangle(t) == thoracic)
                .flatMap(t -> IntStream.range(3 * t, 3 * t + 3))
                .map(c -> sheet.triangles()[c])
                .toArray();
        return new TriangleMesh(sheet.positions(), corners);
    }

    /** Share of the vertices of an organ beyond; {@link #count} and the rest stay as they are. */
    double share(TriangleMesh organ) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        long beyond = IntStream.range(0, organ.vertexCount())
                .filter(v -> depth(organ.x(v), organ.y(v), organ.z(v), hit) > THROUGH_MM)
                .count();
        return (double) beyond / organ.vertexCount();
    }

    private void measure(TriangleMesh organ) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        vertices += organ.vertexCount();
        for (int v = 0; v < organ.vertexCount(); v++) {
            double depth = depth(organ.x(v), organ.y(v), organ.z(v), hit);
            count += depth > THROUGH_MM ? 1 : 0;
            greatest = Math.max(greatest, depth);
        }
    }

    /**
     * Distance by which a point lies beyond the face, mm; 0 before it, and where the nearest point is at the border.
     */
    private double depth(double x, double y, double z, TriangleTree.Hit hit) {
        if (!tree.closest(x, y, z, hit)) {
            return 0;
        }
        double[] weights = {hit.weightA, hit.weightB, hit.weightC};
        double out = 0;
        for (int c = 0; c < 3; c++) {
            int v = tree.mesh().triangles()[3 * hit.triangle + c];
            if (diaphragm.isInserted(v)) {
                return 0;
            }
            out += weights[c]
                    * (normals[3 * v] * (x - hit.x)
                            + normals[3 * v + 1] * (y - hit.y)
                            + normals[3 * v + 2] * (z - hit.z));
        }
        if (out >= 0 || !otherFace.closest(hit.x, hit.y, hit.z, opposite)) {
            return 0;
        }
        return Math.max(0, Math.sqrt(hit.distanceSquared) - 0.5 * Math.sqrt(opposite.distanceSquared));
    }

    int vertices() {
        return vertices;
    }

    int count() {
        return count;
    }

    double greatestMm() {
        return greatest;
    }
}
