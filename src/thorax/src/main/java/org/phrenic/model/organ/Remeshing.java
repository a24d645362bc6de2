package org.phrenic.model.organ;

import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.edit.Remesher;

/** Remeshes several structures to a total number of vertices, distributed by area. */
public final class Remeshing {
    /** Meshes whose vertex count is within this share of the target are not remeshed. */
    private static final double VERTEX_COUNT_TOLERANCE = 0.01;

    /**
     * As {@link #VERTEX_COUNT_TOLERANCE}, for a sheet. Those that are generated for a number of vertices, of which each
     * has its partner on the other face, are kept: their rings meet it within 1.5 %. With faces meshed apart a coarse
     * sheet moves 4 % less.
     */
    private static final double SHEET_TOLERANCE = 0.02;

    /**
     * Smallest angle, degrees, that at most 1 % of a sheet's triangles may undercut. Meshes made for a resolution have
     * 27 to 40 degrees. A mesh warped to a body of which only the lungs are known has 7 to 9 degrees and edges of 0.5
     * to 50 mm; its slivers oscillate until the sheet diverges.
     */
    private static final double MIN_ANGLE_DEG = 15;

    private static final int MIN_VERTICES = 24;
    private static final double WELD_MM = 0.25;

    private Remeshing() {}

    /** Whether a sheet can be used without remeshing for a target number of vertices. */
    public static boolean isAdequate(TriangleMesh sheet, int vertices) {
        return Math.abs(sheet.vertexCount() - vertices) <= SHEET_TOLERANCE * vertices
                && MeshQuality.firstPercentileAngleDeg(sheet) >= MIN_ANGLE_DEG;
    }

    public static List<Structure> toBudget(List<Structure> structures, int vertices) {
        int present = structures.stream().mapToInt(s -> s.mesh().vertexCount()).sum();
        if (Math.abs(present - vertices) <= VERTEX_COUNT_TOLERANCE * vertices) {
            return structures;
        }
        double area =
                structures.stream().mapToDouble(s -> MeshMeasure.area(s.mesh())).sum();
        // Sequential, because the diaphragm is remeshed in parallel with these structures by the same code.
        return structures.stream()
                .map(s -> {
                    int share = (int) Math.round(vertices * MeshMeasure.area(s.mesh()) / area);
                    TriangleMesh meshed = Remesher.toVertexCount(s.mesh(), Math.max(MIN_VERTICES, share));
                    // Seams between patches leave coincident vertices. They are welded, because a spring needs a
                    // length above 0.
                    return s.withMesh(MeshRepair.repair(meshed, WELD_MM).mesh());
                })
                .toList();
    }
}
