package org.phrenic.patient;

import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * The surface of one part of a volume, and what became of it on the way.
 *
 * @param mesh closed, LPS, mm
 * @param labelVertices vertices of the surface of its voxels
 * @param decimatedVertices vertices after decimation
 * @param distanceToLabel distances between the surface of its voxels and the mesh, both ways, by area, mm
 * @param quality of the triangles
 * @param secondPassBand of the second smoothing, wider than asked for where the structure is thin
 * @param components pieces that the voxels made; the largest is the mesh
 * @param discardedMm3 volume of the others, cavities as well
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
