package org.phrenic.mesh.edit;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Which closed components of a surface bound cavities: those within an odd number of others. One is within another if
 * its box is, and if the other's winding number says so of a corner of its first, middle and last triangle.
 */
final class NestedShells {
    /** Between the winding number on a shell, 1/2, and the one within it, 1. */
    private static final double WITHIN = 0.75;

    private NestedShells() {}

    /**
     * The components that bound cavities.
     *
     * @param mesh in which each component is oriented outward
     * @param shells triangles of each closed component
     */
    static List<int[]> cavities(TriangleMesh mesh, List<int[]> shells) {
        double[] boxes = new double[6 * shells.size()];
        for (int shell = 0; shell < shells.size(); shell++) {
            BoundingBoxes.setEmpty(boxes, 6 * shell);
            for (int triangle : shells.get(shell)) {
                for (int corner = 0; corner < 3; corner++) {
                    BoundingBoxes.include(boxes, 6 * shell, mesh.positions(), point(mesh, triangle, corner));
                }
            }
        }
        int[] outside = new int[shells.size()];
        for (int outer = 0; outer < outside.length; outer++) {
            TriangleTree tree = null;
            for (int inner = 0; inner < outside.length; inner++) {
                if (isWithin(boxes, 6 * inner, 6 * outer)) {
                    tree = tree == null ? new TriangleTree(alone(mesh, shells.get(outer))) : tree;
                    outside[inner] += isWithin(mesh, shells.get(inner), tree) ? 1 : 0;
                }
            }
        }
        List<int[]> cavities = new ArrayList<>();
        for (int shell = 0; shell < outside.length; shell++) {
            if (outside[shell] % 2 == 1) {
                cavities.add(shells.get(shell));
            }
        }
        return cavities;
    }

    private static int point(TriangleMesh mesh, int triangle, int corner) {
        return 3 * mesh.triangles()[3 * triangle + corner];
    }

    private static boolean isWithin(double[] boxes, int inner, int outer) {
        for (int axis = 0; axis < 3; axis++) {
            if (boxes[inner + axis] <= boxes[outer + axis] || boxes[inner + 3 + axis] >= boxes[outer + 3 + axis]) {
                return false;
            }
        }
        return true;
    }

    private static boolean isWithin(TriangleMesh mesh, int[] shell, TriangleTree outer) {
        double[] p = mesh.positions();
        for (int triangle : new int[] {shell[0], shell[shell.length / 2], shell[shell.length - 1]}) {
            int at = point(mesh, triangle, 0);
            if (outer.windingNumber(p[at], p[at + 1], p[at + 2]) < WITHIN) {
                return false;
            }
        }
        return true;
    }

    private static TriangleMesh alone(TriangleMesh mesh, int[] shell) {
        int[] corners = new int[3 * shell.length];
        for (int i = 0; i < shell.length; i++) {
            System.arraycopy(mesh.triangles(), 3 * shell[i], corners, 3 * i, 3);
        }
        return new TriangleMesh(mesh.positions(), corners);
    }
}
