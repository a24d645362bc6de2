package org.phrenic.patient.registration;

import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.TriangleMesh;

/** A transform of points in 3D space. */
interface PointTransform {
    /** Transforms all points of an array in place. The array contains x, y, z triples, mm. */
    void apply(double[] points);

    /** Returns the transformed mesh. */
    default TriangleMesh apply(TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        apply(p);
        return mesh.withPositions(p);
    }

    /** Returns the transformed structure. */
    default Structure apply(Structure structure) {
        return structure.withMesh(apply(structure.mesh()));
    }
}
