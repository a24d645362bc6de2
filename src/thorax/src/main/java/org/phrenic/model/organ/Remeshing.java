package org.phrenic.model.organ;

import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.edit.Remesher;

/** Meshing several structures to a number of vertices in all, shared out by area. */
public final class Remeshing {
    /**
     * A structure is taken as it is if its mesh is this near to what it should have: so what was made for a resolution
     * is not meshed twice.
     */
    private static final double NEAR_ENOUGH = 0.01;

    /**
     * One triangle in a hundred of a sheet may have a smaller angle than this, degrees. Meshes made for a resolution
     * have 27 to 40; one that was warped to another body of which only the lungs are known has 7 to 9 and edges of 0.5
     * to 50 mm, and its slivers chatter until it comes apart.
     */
    private static final double LEAST_ANGLE_DEG = 15;

    private static final int FEWEST = 24;
    private static final double WELD_MM = 0.25;

    private Remeshing() {}

    /** Whether a sheet can be taken as it is where so many vertices are wanted. */
    public static boolean isAdequate(TriangleMesh sheet, int vertices) {
        return Math.abs(sheet.vertexCount() - vertices) <= NEAR_ENOUGH * vertices
                && MeshQuality.firstPercentileAngleDeg(sheet) >= LEAST_ANGLE_DEG;
    }

    public static List<Structure> toBudget(List<Structure> structures, int vertices) {
        int present = structures.stream().mapToInt(s -> s.mesh().vertexCount()).sum();
        if (Math.abs(present - vertices) <= NEAR_ENOUGH * vertices) {
            return structures;
        }
        double area =
                structures.stream().mapToDouble(s -> MeshMeasure.area(s.mesh())).sum();
        // One after the other: the diaphragm is meshed beside them, by the same code.
        return structures.stream()
                .map(s -> {
                    int share = (int) Math.round(vertices * MeshMeasure.area(s.mesh()) / area);
                    TriangleMesh meshed = Remesher.toVertexCount(s.mesh(), Math.max(FEWEST, share));
                    // Seams between patches leave vertices that coincide: one node, not two with a spring of no length.
                    return s.withMesh(MeshRepair.repair(meshed, WELD_MM).mesh());
                })
                .toList();
    }
}
