package org.phrenic.study.speed;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.bare.BareScene;

/**
 * Bare workloads of any size from the virtual body's diaphragm. The sheet is remeshed coarsely and its triangles are
 * then split into four as often as necessary. The lowest nodes are fixed, the upper ones loaded.
 */
final class SheetWorkloads {
    /** Larger meshes are made by splitting, which is fast and keeps the valences. */
    private static final int MAX_REMESHED_VERTICES = 21_000;

    private static final double HELD_SHARE = 0.15;
    private static final double LOADED_SHARE = 0.7;

    private final TriangleMesh sheet;

    SheetWorkloads() {
        Thorax thorax = SimulationRun.loadThorax(Scenario.defaults().with("resolution=low"));
        TriangleMesh shells =
                thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
        sheet = Diaphragm.sheetAmong(shells).orElseThrow();
        if (sheet.vertexCount() < Resolution.LOW.diaphragmVertices() / 2) {
            throw new IllegalStateException(
                    "found a sheet of " + sheet.vertexCount() + " vertices, expected the whole");
        }
    }

    /** A scene of approximately this number of nodes. */
    BareScene ofSize(int nodes) {
        int coarse = nodes;
        int splits = 0;
        while (coarse > MAX_REMESHED_VERTICES) {
            // Each split turns V vertices into V + E = 4 V - 6.
            coarse = (coarse + 6) / 4;
            splits++;
        }
        TriangleMesh mesh = Remesher.toVertexCount(sheet, coarse);
        for (int i = 0; i < splits; i++) {
            mesh = split(mesh);
        }
        TriangleMesh made = mesh;
        double[] heights = IntStream.range(0, mesh.vertexCount())
                .mapToDouble(made::z)
                .sorted()
                .toArray();
        double held = heights[(int) (HELD_SHARE * heights.length)];
        double loaded = heights[(int) ((1 - LOADED_SHARE) * heights.length)];
        int[] fixed = IntStream.range(0, heights.length)
                .filter(i -> made.z(i) <= held)
                .toArray();
        int[] carrying = IntStream.range(0, heights.length)
                .filter(i -> made.z(i) >= loaded)
                .toArray();
        return new BareScene(mesh, fixed, carrying, new int[0]);
    }

    /** Splits each triangle into four at the midpoints of its edges. */
    private static TriangleMesh split(TriangleMesh mesh) {
        MeshTopology topology = new MeshTopology(mesh);
        int n = mesh.vertexCount();
        double[] positions = Arrays.copyOf(mesh.positions(), 3 * (n + topology.edgeCount()));
        int[] edges = topology.edges();
        for (int e = 0; e < topology.edgeCount(); e++) {
            for (int axis = 0; axis < 3; axis++) {
                positions[3 * (n + e) + axis] =
                        0.5 * (positions[3 * edges[2 * e] + axis] + positions[3 * edges[2 * e + 1] + axis]);
            }
        }
        int[] t = mesh.triangles();
        int[] middle = topology.edgeOfSide();
        int[] triangles = new int[4 * t.length];
        for (int i = 0; i < t.length; i += 3) {
            int ab = n + middle[i];
            int bc = n + middle[i + 1];
            int ca = n + middle[i + 2];
            int[] four = {t[i], ab, ca, ab, t[i + 1], bc, ca, bc, t[i + 2], ab, bc, ca};
            System.arraycopy(four, 0, triangles, 4 * i, 12);
        }
        return new TriangleMesh(positions, triangles);
    }
}
