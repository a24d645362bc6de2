package org.phrenic.model.organ;

import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The thoracic face of a diaphragm at rest, on which the base of the lungs lies: finds its nearest point. May be asked
 * from several threads, each with a hit of its own.
 */
public final class ThoracicFace {
    final Diaphragm diaphragm;
    /** Triangles of the sheet that make up the face. */
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

    /** Finds the nearest point of the face; false if it is farther than {@code reach}, mm. */
    boolean closest(double x, double y, double z, double reach, TriangleTree.Hit hit) {
        return tree.closest(x, y, z, reach, hit);
    }

    /** The triangle of the sheet that was hit. */
    int triangle(TriangleTree.Hit hit) {
        return triangle[hit.triangle];
    }

    /** A corner, 0 to 2, of the triangle that was hit, as a vertex of the sheet. */
    int vertex(TriangleTree.Hit hit, int corner) {
        return diaphragm.sheet().triangles()[3 * triangle(hit) + corner];
    }

    /** The corner next to the point that was hit, as a vertex of the sheet. */
    int nearestVertex(TriangleTree.Hit hit) {
        boolean second = hit.weightB > hit.weightA;
        return vertex(hit, hit.weightC > Math.max(hit.weightA, hit.weightB) ? 2 : second ? 1 : 0);
    }
}
