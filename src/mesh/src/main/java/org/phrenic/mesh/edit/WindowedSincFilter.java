package org.phrenic.mesh.edit;

import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * Surface smoothing by a windowed-sinc low-pass filter (Taubin, Zhang and Golub 1996, Optimal Surface Smoothing as
 * Filter Design, doi 10.1007/BFb0015544), compatible with VTK's {@code vtkWindowedSincPolyDataFilter}. L is the
 * umbrella operator, x - mean of the neighbours, with eigenvalues k in 0 to 2. T are the Chebyshev polynomials.
 *
 * <pre>
 * x' = sum over n = 0..N of w_n c_n T_n(1 - L / 2) x
 * c_0 = t / pi,   c_n = 2 sin(n t) / (n pi),   t = arccos(1 - k_pb / 2) + sigma
 * </pre>
 *
 * Here k_pb is the pass band and w a {@link Window}. Newton's method chooses sigma so that the filter passes k_pb. The
 * filter removes detail at the scale of single edges without shrinking the surface.
 */
public final class WindowedSincFilter {
    private static final int MAX_NEWTON_STEPS = 500;
    /** Same value as in VTK. */
    private static final double NEWTON_TOLERANCE = 1e-3;
    /** Cosine of 15 degrees. A boundary vertex where the boundary turns by more does not move. */
    private static final double STRAIGHT = StrictMath.cos(Math.toRadians(15));

    private WindowedSincFilter() {}

    /**
     * Window function that truncates the series. Of the four, only Hamming's changes the overall size (by up to 1 %
     * after few iterations). It was the default of VTK until version 9.4.
     */
    public enum Window {
        NUTTALL(0.355768, 0.487396, 0.144232, 0.012604),
        BLACKMAN(0.42, 0.5, 0.08, 0),
        HANNING(0.5, 0.5, 0, 0),
        HAMMING(0.54, 0.46, 0, 0);

        private final double a0;
        private final double a1;
        private final double a2;
        private final double a3;

        Window(double a0, double a1, double a2, double a3) {
            this.a0 = a0;
            this.a1 = a1;
            this.a2 = a2;
            this.a3 = a3;
        }

        private double at(double angle) {
            return a0 + a1 * StrictMath.cos(angle) + a2 * StrictMath.cos(2 * angle) + a3 * StrictMath.cos(3 * angle);
        }
    }

    /** Smooths with Nuttall's window; see {@link #smooth(TriangleMesh, int, double, Window)}. */
    public static TriangleMesh smooth(TriangleMesh mesh, int iterations, double passBand) {
        return smooth(mesh, iterations, passBand, Window.NUTTALL);
    }

    /**
     * Smooths a mesh. A boundary vertex moves along the boundary where the boundary is straight and is fixed elsewhere.
     * A vertex on an edge with three or more triangles is fixed.
     *
     * @param iterations degree N of the filter, at least 1; a higher degree gives a sharper cut-off
     * @param passBand above 0 and below 2; a smaller value gives a smoother surface
     * @throws IllegalArgumentException if one of them is out of range
     */
    public static TriangleMesh smooth(TriangleMesh mesh, int iterations, double passBand, Window window) {
        double[] c = coefficients(iterations, passBand, window);
        MeshTopology topology = new MeshTopology(mesh);
        int n = mesh.vertexCount();
        int[] start = new int[n + 1];
        int[] neighbours = new int[2 * topology.edgeCount()];
        int[] own = new int[64];
        for (int v = 0; v < n; v++) {
            int from = topology.vertexEdgeStart()[v];
            int to = topology.vertexEdgeStart()[v + 1];
            own = own.length < to - from ? new int[2 * (to - from)] : own;
            int count = neighbours(mesh, topology, v, own);
            System.arraycopy(own, 0, neighbours, start[v], count);
            start[v + 1] = start[v] + count;
        }
        return mesh.withPositions(filter(mesh.positions(), start, neighbours, c));
    }

    /** Writes the neighbours of v used for smoothing; returns their number, 0 if v is fixed. */
    private static int neighbours(TriangleMesh mesh, MeshTopology topology, int v, int[] out) {
        int boundary = 0;
        int count = 0;
        for (int k = topology.vertexEdgeStart()[v]; k < topology.vertexEdgeStart()[v + 1]; k++) {
            int edge = topology.vertexEdges()[k];
            if (topology.faceCount(edge) > 2) {
                return 0;
            }
            int other = topology.otherVertex(edge, v);
            if (topology.faceCount(edge) == 1) {
                if (boundary == 0) {
                    count = 0;
                }
                boundary++;
                out[count++] = other;
            } else if (boundary == 0) {
                out[count++] = other;
            }
        }
        return boundary == 0 || (boundary == 2 && isStraight(mesh, out[0], v, out[1])) ? count : 0;
    }

    private static boolean isStraight(TriangleMesh mesh, int a, int v, int b) {
        double dot = (mesh.x(v) - mesh.x(a)) * (mesh.x(b) - mesh.x(v))
                + (mesh.y(v) - mesh.y(a)) * (mesh.y(b) - mesh.y(v))
                + (mesh.z(v) - mesh.z(a)) * (mesh.z(b) - mesh.z(v));
        return dot >= STRAIGHT * MeshMeasure.distance(mesh, a, v) * MeshMeasure.distance(mesh, v, b);
    }

    /** Window-weighted coefficients of T_0 to T_N. */
    public static double[] coefficients(int iterations, double passBand, Window window) {
        if (iterations < 1 || !(passBand > 0 && passBand < 2)) {
            throw new IllegalArgumentException("smoothing with " + iterations + " iterations and a pass band of "
                    + passBand + ", expected at least 1 and above 0 to below 2");
        }
        double angle = StrictMath.acos(1 - passBand / 2);
        double sigma = 0;
        for (int step = 0; step < MAX_NEWTON_STEPS; step++) {
            double[] c = windowed(iterations, angle + sigma, window);
            double value = 0;
            for (int n = 0; n <= iterations; n++) {
                value += c[n] * StrictMath.cos(n * angle);
            }
            if (iterations == 1 || Math.abs(value - 1) < NEWTON_TOLERANCE) {
                return c;
            }
            sigma -= (value - 1) / slope(c, angle);
        }
        return windowed(iterations, angle + sigma, window);
    }

    private static double[] windowed(int iterations, double angle, Window window) {
        double[] c = new double[iterations + 1];
        c[0] = window.at(0) * angle / Math.PI;
        for (int n = 1; n <= iterations; n++) {
            c[n] = 2 * window.at(n * Math.PI / (iterations + 1)) * StrictMath.sin(n * angle) / (n * Math.PI);
        }
        return c;
    }

    /** Derivative of the Chebyshev series with respect to its argument, at cos(angle). */
    private static double slope(double[] c, double angle) {
        int last = c.length - 1;
        double[] d = new double[c.length];
        double sum = 0;
        for (int n = last - 1; n >= 0; n--) {
            double above = n + 2 <= last ? d[n + 2] : 0;
            // VTK omits the highest term of the derivative, and sigma depends on it.
            d[n] = n == last - 1 ? 0 : above + 2.0 * (n + 1) * c[n + 1];
            sum += d[n] * StrictMath.cos(n * angle);
        }
        return sum;
    }

    /**
     * Applies the filter with a given neighbourhood.
     *
     * @param start neighbours of vertex v are at start[v] to start[v + 1] - 1; a vertex without neighbours is fixed
     */
    public static double[] filter(double[] positions, int[] start, int[] neighbours, double[] c) {
        double[] centre = new TriangleMesh(positions, new int[0]).centre();
        double[] before = new double[positions.length];
        for (int i = 0; i < positions.length; i++) {
            // Positions are relative to the centre, so coefficients that do not sum to exactly 1 do not translate the
            // mesh.
            before[i] = positions[i] - centre[i % 3];
        }
        double[] now = new double[positions.length];
        umbrella(before, start, neighbours, now);
        double[] sum = new double[positions.length];
        for (int i = 0; i < now.length; i++) {
            now[i] = before[i] - now[i] / 2;
            sum[i] = c[0] * before[i] + c[1] * now[i];
        }
        double[] next = new double[positions.length];
        for (int n = 2; n < c.length; n++) {
            // T_n = 2 (now - L now / 2) - before
            umbrella(now, start, neighbours, next);
            for (int i = 0; i < next.length; i++) {
                next[i] = 2 * now[i] - next[i] - before[i];
                sum[i] += c[n] * next[i];
            }
            double[] swap = before;
            before = now;
            now = next;
            next = swap;
        }
        for (int v = 0; v + 1 < start.length; v++) {
            for (int k = 3 * v; k < 3 * v + 3; k++) {
                sum[k] = start[v] == start[v + 1] ? positions[k] : sum[k] + centre[k % 3];
            }
        }
        return sum;
    }

    private static void umbrella(double[] p, int[] start, int[] neighbours, double[] out) {
        for (int v = 0; v + 1 < start.length; v++) {
            double x = 0;
            double y = 0;
            double z = 0;
            int count = start[v + 1] - start[v];
            for (int k = start[v]; k < start[v + 1]; k++) {
                int o = 3 * neighbours[k];
                x += p[o];
                y += p[o + 1];
                z += p[o + 2];
            }
            out[3 * v] = count == 0 ? 0 : p[3 * v] - x / count;
            out[3 * v + 1] = count == 0 ? 0 : p[3 * v + 1] - y / count;
            out[3 * v + 2] = count == 0 ? 0 : p[3 * v + 2] - z / count;
        }
    }
}
