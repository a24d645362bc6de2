package org.phrenic.patient.registration;

import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.TriangleMesh;

/** A transform of points in space. */
interface PointTransform {
    /** Transforms every point of the array (x, y, z in turn, mm) in place. */
    void apply(double[] points);

    /** The transformed mesh. */
    default TriangleMesh apply(TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        apply(p);
        return mesh.withPositions(p);
    }

    /** The transformed structure. */
    default Structure apply(Structure structure) {
        return structure.withMesh(apply(structure.mesh()));
    }
}
