package org.phrenic.scene.surface;

import com.jogamp.common.nio.Buffers;
import java.nio.IntBuffer;
import java.util.Arrays;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/**
 * What a vertex keeps for good: how open it lies, how much tendon it is, and how much is left of it near an open
 * border, where skin that a scan cut off fades out. A byte each.
 */
public final class VertexAttributes {
    private static final int BYTE = 0xff;
    private static final int SMOOTHING_ROUNDS = 3;

    /** Skin fades in over this distance from its border, mm. */
    private static final double FADE_END_MM = 45;

    private static final double FADE_START_MM = 6;

    private final Surface surface;
    private final int[] edges;

    public VertexAttributes(Surface surface) {
        this.surface = surface;
        edges = MeshEdges.of(surface.rest().triangles());
    }

    /** One number a vertex: openness in the lowest byte, then tendon, then what is left. */
    public IntBuffer packed(float[] openness) {
        int n = openness.length;
        float[] tendon = smoothedTendon(n);
        double[] border = distanceToBorder();
        IntBuffer traits = Buffers.newDirectIntBuffer(n);
        for (int i = 0; i < n; i++) {
            double inside = Math.max(0, Math.min(1, (border[i] - FADE_START_MM) / (FADE_END_MM - FADE_START_MM)));
            int left = (int) Math.round(BYTE * inside * inside * (3 - 2 * inside));
            traits.put(i, Math.round(BYTE * openness[i]) | (Math.round(BYTE * tendon[i]) << 8) | (left << 16));
        }
        return traits;
    }

    /** 1 in tendon, 0 in muscle, evened out over a few rings of neighbours, so that the seam is no staircase. */
    private float[] smoothedTendon(int n) {
        float[] share = new float[n];
        if (surface.tendon().length != n) {
            return share;
        }
        for (int i = 0; i < n; i++) {
            share[i] = surface.tendon()[i] ? 1 : 0;
        }
        float[] sum = new float[n];
        float[] count = new float[n];
        for (int round = 0; round < SMOOTHING_ROUNDS; round++) {
            System.arraycopy(share, 0, sum, 0, n);
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
     * Length of the shortest way along edges to an edge that has one triangle only, mm; infinite if there is none, and
     * for all but skin: lobes of lungs are open where they touch.
     */
    private double[] distanceToBorder() {
        TriangleMesh mesh = surface.rest();
        double[] distance = new double[mesh.vertexCount()];
        Arrays.fill(distance, Double.POSITIVE_INFINITY);
        if (surface.kind() != StructureKind.SKIN) {
            return distance;
        }
        int[] used = MeshEdges.triangleCounts(mesh.triangles());
        for (int e = 0; e < used.length; e++) {
            if (used[e] == 1) {
                distance[edges[2 * e]] = 0;
                distance[edges[2 * e + 1]] = 0;
            }
        }
        for (boolean changed = true; changed; ) {
            changed = false;
            for (int e = 0; e < edges.length; e += 2) {
                int a = edges[e];
                int b = edges[e + 1];
                double length = Math.sqrt(squared(mesh.x(a) - mesh.x(b))
                        + squared(mesh.y(a) - mesh.y(b))
                        + squared(mesh.z(a) - mesh.z(b)));
                if (distance[a] < FADE_END_MM && distance[a] + length < distance[b]) {
                    distance[b] = distance[a] + length;
                    changed = true;
                }
                if (distance[b] < FADE_END_MM && distance[b] + length < distance[a]) {
                    distance[a] = distance[b] + length;
                    changed = true;
                }
            }
        }
        return distance;
    }

    private static double squared(double x) {
        return x * x;
    }
}
