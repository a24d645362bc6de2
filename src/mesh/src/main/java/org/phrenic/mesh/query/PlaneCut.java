package org.phrenic.mesh.query;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.Vectors;

/**
 * Intersection curves of a plane with a triangle mesh. A vertex in the plane counts as above it. Each intersected edge
 * therefore occurs once, and a closed mesh gives closed curves.
 */
public final class PlaneCut {
    private static final int EDGE_BITS = 32;

    private final double[] origin;
    private final double[] across;
    private final double[] upward;
    private final double[] normal;

    /**
     * @param origin of the plane's coordinates, mm
     * @param across unit vector of the first axis
     * @param upward unit vector of the second axis, orthogonal to the first
     */
    public PlaneCut(double[] origin, double[] across, double[] upward) {
        this.origin = origin.clone();
        this.across = across.clone();
        this.upward = upward.clone();
        normal = Vectors.cross(across, upward);
    }

    /** Projects a point onto the plane; returns its plane coordinates. */
    public double[] project(double[] point) {
        double[] d = Vectors.subtract(point, origin);
        return new double[] {Vectors.dot(d, across), Vectors.dot(d, upward)};
    }

    /** Distance of a point from the plane, mm; positive on the side of first x second axis. */
    public double signedDistance(double[] point) {
        return Vectors.dot(Vectors.subtract(point, origin), normal);
    }

    /**
     * Intersects a mesh.
     *
     * @param positions three numbers per vertex
     * @param triangles three vertex indices per triangle
     * @return curves as pairs of plane coordinates; a closed curve repeats its first point at the end
     */
    public List<double[]> intersect(double[] positions, int[] triangles) {
        int n = positions.length / 3;
        double[] height = new double[n];
        double offset = Vectors.dot(normal, origin);
        for (int i = 0; i < n; i++) {
            height[i] = normal[0] * positions[3 * i]
                    + normal[1] * positions[3 * i + 1]
                    + normal[2] * positions[3 * i + 2]
                    - offset;
        }
        // Maps the edge at which the plane enters a triangle to the edge at which it leaves.
        Map<Long, Long> next = new HashMap<>();
        List<Long> order = new ArrayList<>();
        for (int t = 0; t < triangles.length; t += 3) {
            long in = -1;
            long out = -1;
            for (int k = 0; k < 3; k++) {
                int a = triangles[t + k];
                int b = triangles[t + (k + 1) % 3];
                if (height[a] < 0 && height[b] >= 0) {
                    in = edge(a, b);
                } else if (height[a] >= 0 && height[b] < 0) {
                    out = edge(a, b);
                }
            }
            if (in >= 0) {
                next.put(in, out);
                order.add(in);
            }
        }
        return curves(next, order, positions, height);
    }

    private List<double[]> curves(Map<Long, Long> next, List<Long> order, double[] positions, double[] height) {
        List<double[]> curves = new ArrayList<>();
        Map<Long, Integer> arrivals = new HashMap<>();
        next.values().forEach(edge -> arrivals.merge(edge, 1, Integer::sum));
        // Open curves are traced first, from their start edges. The remaining curves are closed.
        for (boolean open : new boolean[] {true, false}) {
            for (long start : order) {
                if (next.containsKey(start) && (!open || !arrivals.containsKey(start))) {
                    curves.add(curve(start, next, positions, height));
                }
            }
        }
        return curves;
    }

    private double[] curve(long start, Map<Long, Long> next, double[] positions, double[] height) {
        DoubleList points = new DoubleList();
        for (Long edge = start; edge != null; edge = next.remove(edge)) {
            add(points, edge, positions, height);
        }
        return points.toArray();
    }

    private void add(DoubleList points, long edge, double[] positions, double[] height) {
        int a = (int) (edge >> EDGE_BITS);
        int b = (int) edge;
        double t = height[a] / (height[a] - height[b]);
        double[] p = new double[3];
        for (int i = 0; i < 3; i++) {
            p[i] = positions[3 * a + i] + t * (positions[3 * b + i] - positions[3 * a + i]);
        }
        double[] projected = project(p);
        points.add(projected[0]);
        points.add(projected[1]);
    }

    private static long edge(int a, int b) {
        return (long) Math.min(a, b) << EDGE_BITS | Math.max(a, b);
    }
}
