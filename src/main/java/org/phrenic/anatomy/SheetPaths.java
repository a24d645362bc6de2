package org.phrenic.anatomy;

import java.util.Arrays;
import java.util.PriorityQueue;
import org.phrenic.geometry.*;

final class SheetPaths {
    static double[] distances(TriangleMesh m, MeshTopology t, boolean[] source) {
        int n = m.vertexCount();
        double[] d = new double[n];
        Arrays.fill(d, Double.POSITIVE_INFINITY);
        PriorityQueue<double[]> q = new PriorityQueue<>((a, b) -> Double.compare(a[0], b[0]));
        for (int i = 0; i < n; i++)
            if (source[i]) {
                d[i] = 0;
                q.add(new double[] {0, i});
            }
        while (!q.isEmpty()) {
            double[] top = q.poll();
            int v = (int) top[1];
            if (top[0] > d[v]) continue;
            for (int k = t.vertexEdgeStart()[v]; k < t.vertexEdgeStart()[v + 1]; k++) {
                int w = t.otherVertex(t.vertexEdges()[k], v);
                double l = Math.sqrt(
                        Math.pow(m.x(v) - m.x(w), 2) + Math.pow(m.y(v) - m.y(w), 2) + Math.pow(m.z(v) - m.z(w), 2));
                if (d[v] + l < d[w]) {
                    d[w] = d[v] + l;
                    q.add(new double[] {d[w], w});
                }
            }
        }
        return d;
    }

    static double[] harmonic(TriangleMesh m, MeshTopology t, boolean[] zero, boolean[] one) {
        int n = m.vertexCount();
        double[] u = new double[n];
        for (int i = 0; i < n; i++) u[i] = one[i] ? 1 : 0;
        for (int it = 0; it < 1500; it++) {
            for (int i = 0; i < n; i++) {
                if (zero[i] || one[i]) continue;
                double s = 0;
                int c = 0;
                for (int k = t.vertexEdgeStart()[i]; k < t.vertexEdgeStart()[i + 1]; k++) {
                    s += u[t.otherVertex(t.vertexEdges()[k], i)];
                    c++;
                }
                u[i] += 1.8 * (s / c - u[i]);
            }
        }
        return u;
    }
}
