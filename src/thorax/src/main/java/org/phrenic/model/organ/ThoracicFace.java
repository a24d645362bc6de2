package org.phrenic.model.organ;

import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The thoracic face of a diaphragm at rest, on which the base of the lungs lies: closest-point queries. Thread-safe if
 * each thread uses its own hit.
 */
public final class ThoracicFace {
    final Diaphragm diaphragm;
    /** Triangles of the sheet that form the face. */
    private final int[] triangle;

    private final TriangleTree tree;

    public ThoracicFace(Diaphragm diaphragm) {
        this.diaphragm = diaphragm;
        TriangleMesh sheet = diaphragm.sheet();
        triangle = IntStream.range(0, sheet.triangleCount())
                .filter(diaphragm::isThoracicTriangle)
                .toArray();
        int[] all = sheet.triangles();
        int[] corners = new int[3 * triangle.length];
        for (int i = 0; i < triangle.length; i++) {
            System.arraycopy(all, 3 * triangle[i], corners, 3 * i, 3);
        }
        tree = new TriangleTree(new TriangleMesh(sheet.positions(), corners));
    }

    /** Finds the closest point of the face; false if it is farther than {@code reach}, mm. */
    boolean closest(double x, double y, double z, double reach, TriangleTree.Hit hit) {
        return tree.closest(x, y, z, reach, hit);
    }

    /** Triangle of the sheet that contains the closest point. */
    int triangle(TriangleTree.Hit hit) {
        return triangle[hit.triangle];
    }

    /** Corner 0 to 2 of that triangle, as a vertex of the sheet. */
    int vertex(TriangleTree.Hit hit, int corner) {
        return diaphragm.sheet().triangles()[3 * triangle(hit) + corner];
    }

    /** Corner nearest to the closest point, as a vertex of the sheet. */
    int nearestVertex(TriangleTree.Hit hit) {
        boolean second = hit.weightB > hit.weightA;
        return vertex(hit, hit.weightC > Math.max(hit.weightA, hit.weightB) ? 2 : second ? 1 : 0);
    }
}
