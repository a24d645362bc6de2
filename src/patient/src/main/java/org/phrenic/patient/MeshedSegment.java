package org.phrenic.patient;

import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * The surface of a segment, and how it was made.
 *
 * @param mesh closed, LPS, mm
 * @param labelVertices vertices of the surface of its voxels
 * @param decimatedVertices vertices after decimation
 * @param distanceToLabel symmetric distances from the surface of its voxels, by area, mm
 * @param secondPassBand of the second smoothing, widened for thin structures
 * @param components connected components of its voxels; the largest is the mesh
 * @param discardedMm3 volume of the others, and of cavities
 */
public record MeshedSegment(
        TriangleMesh mesh,
        int labelVertices,
        int decimatedVertices,
        DistanceSummary distanceToLabel,
        MeshQuality quality,
        double secondPassBand,
        int components,
        double discardedMm3) {}
