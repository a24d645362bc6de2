package org.phrenic.fit;

import java.util.List;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.LungOutline;
import org.phrenic.patient.registration.DiaphragmaticSurface;

/**
 * The vertices of a lung's base. Of a lung of several lobes, which touch at fissures, they are those on the
 * {@link DiaphragmaticSurface} of the {@link LungOutline}.
 */
final class LungBaseVertices {
    /** Least share of a lobe in the area of all components; smaller ones are fragments. */
    private static final double LEAST_SHARE = 0.05;
    /** Greatest distance of a vertex from the outline on which it lies, mm; the outline is rounded at notches. */
    private static final double ON_OUTLINE_MM = 5;
    /** Least cosine between the normals of a vertex and the outline; fissures stand on the outline at an angle. */
    private static final double LEAST_COSINE = 0.5;

    private LungBaseVertices() {}

    /** Whether each vertex of the surface of one lung belongs to its base. */
    static boolean[] of(TriangleMesh lung) {
        List<TriangleMesh> lobes = lobes(lung);
        if (lobes.size() < 2) {
            return DiaphragmaticSurface.vertexMask(lung);
        }
        TriangleMesh outline = LungOutline.of(lobes).orElseThrow();
        boolean[] base = DiaphragmaticSurface.triangleMask(outline);
        TriangleTree tree = new TriangleTree(outline);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] normals = MeshMeasure.vertexNormals(lung);
        double outward = MeshMeasure.signedVolume(lung) < 0 ? -1 : 1;
        boolean[] mask = new boolean[lung.vertexCount()];
        for (int v = 0; v < mask.length; v++) {
            mask[v] = tree.closest(
                            lung.x(v),
                            lung.y(v),
                            lung.z(v),
                            ON_OUTLINE_MM,
                            outward * normals[3 * v],
                            outward * normals[3 * v + 1],
                            outward * normals[3 * v + 2],
                            LEAST_COSINE,
                            hit)
                    && base[hit.triangle];
        }
        return mask;
    }

    /** The components of a lung that are neither fragments nor walls of cavities. */
    private static List<TriangleMesh> lobes(TriangleMesh lung) {
        double least = LEAST_SHARE * MeshMeasure.area(lung);
        List<TriangleMesh> large = ConnectedComponents.of(lung).stream()
                .filter(component -> MeshMeasure.area(component) >= least)
                .toList();
        return large.stream()
                .filter(one -> large.stream().noneMatch(other -> isWithin(one, other)))
                .toList();
    }

    private static boolean isWithin(TriangleMesh inner, TriangleMesh outer) {
        double[] box = inner.bounds();
        double[] around = outer.bounds();
        return inner != outer
                && BoundingBoxes.squaredDistance(around, 0, box[0], box[1], box[2]) == 0
                && BoundingBoxes.squaredDistance(around, 0, box[3], box[4], box[5]) == 0
                && new TriangleTree(outer).isInside(inner.x(0), inner.y(0), inner.z(0));
    }
}
