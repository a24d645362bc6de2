package org.phrenic.patient;

import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * The surface mesh of a segment, with statistics of the meshing.
 *
 * @param mesh closed surface, LPS, mm
 * @param labelVertices number of vertices of the voxel surface
 * @param decimatedVertices number of vertices after decimation
 * @param distanceToLabel area-weighted symmetric distances to the voxel surface, mm
 * @param secondPassBand pass band of the second smoothing, widened for thin structures
 * @param components number of pieces of the segment
 * @param discardedMm3 volume of the pieces that are not meshed, mm^3
 */
public record MeshedSegment(
        TriangleMesh mesh,
        int labelVertices,
        int decimatedVertices,
        DistanceSummary distanceToLabel,
        MeshQuality quality,
        double secondPassBand,
        int components,
        double discardedMm3) {
    /** Returns a copy with another surface. */
    MeshedSegment withMesh(TriangleMesh other) {
        return new MeshedSegment(
                other,
                labelVertices,
                decimatedVertices,
                distanceToLabel,
                quality,
                secondPassBand,
                components,
                discardedMm3);
    }
}
