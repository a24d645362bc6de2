package org.phrenic.anatomy.contact;

import org.phrenic.anatomy.Diaphragm;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.query.TriangleTree;

/** The two faces of the diaphragm by its triangles, and their border: the triangles with corners on both. */
final class SheetFaces {
    /** Weight of the corners off a side or a corner of a triangle below which a point lies on that side or corner. */
    private static final double ON_SIDE = 1e-3;

    private final int[] triangles;
    private final boolean[] thoracic;
    private final boolean[] abdominal;
    /** Whether a vertex is a corner of a triangle between the faces. */
    private final boolean[] borderVertex;
    /** Whether a triangle between the faces lies across a side of a triangle; the side from each corner to the next. */
    private final boolean[] borderSide;

    SheetFaces(Diaphragm diaphragm, MeshTopology topology) {
        triangles = diaphragm.sheet().triangles();
        thoracic = new boolean[triangles.length / 3];
        abdominal = new boolean[triangles.length / 3];
        for (int i = 0; i < triangles.length; i += 3) {
            boolean a = diaphragm.isThoracic(triangles[i]);
            boolean b = diaphragm.isThoracic(triangles[i + 1]);
            boolean c = diaphragm.isThoracic(triangles[i + 2]);
            thoracic[i / 3] = a && b && c;
            abdominal[i / 3] = !(a || b || c);
        }
        borderVertex = new boolean[diaphragm.sheet().vertexCount()];
        borderSide = new boolean[triangles.length];
        for (int side = 0; side < triangles.length; side++) {
            borderVertex[triangles[side]] |= isBetween(side / 3);
            int edge = topology.edgeOfSide()[side];
            int across = edge == MeshTopology.NONE ? edge : topology.otherFace(edge, side / 3);
            borderSide[side] = across != MeshTopology.NONE && isBetween(across);
        }
    }

    private boolean isBetween(int triangle) {
        return !thoracic[triangle] && !abdominal[triangle];
    }

    /** The triangles all of whose corners lie on the thoracic face, or else on the abdominal one. */
    boolean[] face(boolean above) {
        return above ? thoracic : abdominal;
    }

    /**
     * Whether a point of the sheet lies on its border: on a triangle between the faces, or on a side or a corner of
     * one. A side between two triangles of one face is not on the border, though both of its ends may be.
     */
    boolean isOnBorder(TriangleTree.Hit hit) {
        int k = 3 * hit.triangle;
        return isBetween(hit.triangle)
                || (borderSide[k] && hit.weightC < ON_SIDE)
                || (borderSide[k + 1] && hit.weightA < ON_SIDE)
                || (borderSide[k + 2] && hit.weightB < ON_SIDE)
                || (borderVertex[triangles[k]] && 1 - hit.weightA < ON_SIDE)
                || (borderVertex[triangles[k + 1]] && 1 - hit.weightB < ON_SIDE)
                || (borderVertex[triangles[k + 2]] && 1 - hit.weightC < ON_SIDE);
    }
}
