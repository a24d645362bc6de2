package org.phrenic.patient;

import org.phrenic.geometry.DistanceSummary;
import org.phrenic.geometry.MeshQuality;
import org.phrenic.geometry.TriangleMesh;

/**
 * The surface of one part of a volume, and what became of it on the way.
 *
 * @param mesh closed, LPS, mm
 * @param labelNodes vertices of the surface of its voxels
 * @param decimatedNodes vertices after decimation
 * @param offLabel distances between the surface of its voxels and the mesh, both ways, by area, mm
 * @param quality of the triangles
 * @param lastPassBand of the second smoothing, wider than asked for where the structure is thin
 * @param shells pieces that the voxels made; the largest is the mesh
 * @param leftOutMm3 volume of the others, cavities as well
 */
public record MeshedPart(
        TriangleMesh mesh,
        int labelNodes,
        int decimatedNodes,
        DistanceSummary offLabel,
        MeshQuality quality,
        double lastPassBand,
        int shells,
        double leftOutMm3) {}
