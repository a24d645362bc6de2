package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/** What a mesh file holds. Lengths are in the file's own unit, which a mesh file does not state. */
public final class MeshInfo {
    private MeshInfo() {}

    public static Map<String, Object> of(Path file) {
        TriangleMesh mesh = MeshFiles.read(file);
        MeshTopology topology = new MeshTopology(mesh);
        MeshMeasure.EdgeLengths edges = MeshMeasure.edgeLengthSummary(mesh, topology);
        long unused = unusedVertices(mesh);
        double[] bounds = mesh.bounds();
        Map<String, Object> info = new LinkedHashMap<>();
        info.put("file", file.toString());
        info.put("kind", "mesh");
        info.put("vertices", mesh.vertexCount());
        info.put("unused_vertices", unused);
        info.put("triangles", mesh.triangleCount());
        info.put("edges", topology.edgeCount());
        info.put("components", topology.componentCount() - unused);
        info.put("closed", topology.isClosed());
        info.put("manifold", topology.isManifold());
        info.put("boundary_loops", topology.boundaryLoops().size());
        info.put("euler_characteristic", topology.eulerCharacteristic());
        info.put("area", MeshMeasure.area(mesh));
        info.put("volume", topology.isClosed() ? MeshMeasure.signedVolume(mesh) : null);
        info.put("bounds_minimum", list(bounds, 0));
        info.put("bounds_maximum", list(bounds, 3));
        info.put("edge_length_minimum", edges.minimum());
        info.put("edge_length_mean", edges.mean());
        info.put("edge_length_maximum", edges.maximum());
        info.put(
                "smallest_angle_deg",
                Arrays.stream(MeshMeasure.smallestAngles(mesh)).min().orElse(0));
        return info;
    }

    private static long unusedVertices(TriangleMesh mesh) {
        boolean[] used = new boolean[mesh.vertexCount()];
        for (int v : mesh.triangles()) {
            used[v] = true;
        }
        long count = 0;
        for (boolean u : used) {
            count += u ? 0 : 1;
        }
        return count;
    }

    private static List<Double> list(double[] bounds, int from) {
        return List.of(bounds[from], bounds[from + 1], bounds[from + 2]);
    }
}
