package org.phrenic.simulation;

import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.MeshRepair;
import org.phrenic.geometry.Remesher;
import org.phrenic.geometry.TriangleMesh;

/** Meshing several structures to a number of vertices in all, shared out by area. */
final class Remeshing {
    /** A structure is taken as it is if its mesh is this near to what it should have: so what was made for a resolution is not meshed twice. */
    private static final double NEAR_ENOUGH = 0.01;

    private static final int FEWEST = 24;
    private static final double WELD_MM = 0.25;

    private Remeshing() {}

    static List<Structure> toBudget(List<Structure> structures, int vertices) {
        int present = structures.stream().mapToInt(s -> s.mesh().vertexCount()).sum();
        if (Math.abs(present - vertices) <= NEAR_ENOUGH * vertices) {
            return structures;
        }
        double area =
                structures.stream().mapToDouble(s -> MeshMeasure.area(s.mesh())).sum();
        return structures.parallelStream()
                .map(s -> {
                    int share = (int) Math.round(vertices * MeshMeasure.area(s.mesh()) / area);
                    TriangleMesh meshed = Remesher.toVertexCount(s.mesh(), Math.max(FEWEST, share));
                    // Seams between patches leave vertices that coincide: one node, not two with a spring of no length.
                    return s.withMesh(MeshRepair.repair(meshed, WELD_MM).mesh());
                })
                .toList();
    }
}
