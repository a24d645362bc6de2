package org.phrenic.scene.surface;

import com.jogamp.common.nio.Buffers;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.EdgePaths;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/**
 * Constant vertex attributes, one byte each: visibility of ambient light, tendon fraction, and opacity. Opacity falls
 * to zero at the open border of skin, where the scan ends.
 */
public record VertexAttributes(Surface surface, EdgeTable table) {
    private static final int BYTE = 0xff;
    private static final int SMOOTHING_ROUNDS = 3;
    /** Distance from the border beyond which skin is opaque, mm. */
    private static final double FADE_END_MM = 45;

    private static final double FADE_START_MM = 6;

    /** One integer per vertex: visibility in the lowest byte, then tendon fraction, then opacity. */
    public IntBuffer packed(float[] visibility) {
        int n = visibility.length;
        float[] tendon = smoothedTendon(n);
        double[] border = distanceToBorder();
        IntBuffer attributes = Buffers.newDirectIntBuffer(n);
        for (int i = 0; i < n; i++) {
            double inside = Math.max(0, Math.min(1, (border[i] - FADE_START_MM) / (FADE_END_MM - FADE_START_MM)));
            int opacity = (int) Math.round(BYTE * inside * inside * (3 - 2 * inside));
            attributes.put(i, Math.round(BYTE * visibility[i]) | (Math.round(BYTE * tendon[i]) << 8) | (opacity << 16));
        }
        return attributes;
    }

    /** Tendon fraction: 1 in tendon, 0 in muscle, smoothed by repeated averaging over neighbouring vertices. */
    private float[] smoothedTendon(int n) {
        float[] share = new float[n];
        if (surface.tendon().length != n) {
            return share;
        }
        for (int i = 0; i < n; i++) {
            share[i] = surface.tendon()[i] ? 1 : 0;
        }
        int[] edges = table.edges();
        float[] count = new float[n];
        for (int round = 0; round < SMOOTHING_ROUNDS; round++) {
            float[] sum = share.clone();
            Arrays.fill(count, 1);
            for (int e = 0; e < edges.length; e += 2) {
                sum[edges[e]] += share[edges[e + 1]];
                sum[edges[e + 1]] += share[edges[e]];
                count[edges[e]]++;
                count[edges[e + 1]]++;
            }
            for (int i = 0; i < n; i++) {
                share[i] = sum[i] / count[i];
            }
        }
        return share;
    }

    /**
     * Distance of each skin vertex from the border along edges, mm. Infinite for other structures, because lung lobes
     * are open where they touch and must not fade.
     */
    private double[] distanceToBorder() {
        TriangleMesh mesh = surface.rest();
        int[] border = IntStream.range(0, surface.kind() == StructureKind.SKIN ? table.edgeCount() : 0)
                .filter(e -> table.faceCount(e) == 1)
                .flatMap(e -> IntStream.of(table.edges()[2 * e], table.edges()[2 * e + 1]))
                .toArray();
        if (border.length == 0) {
            double[] none = new double[mesh.vertexCount()];
            Arrays.fill(none, Double.POSITIVE_INFINITY);
            return none;
        }
        return EdgePaths.distances(mesh, new MeshTopology(mesh), border);
    }
}
