package org.phrenic.motion;

import java.util.Arrays;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Motion of points inside a lung of a supine body. Its surface slides in the pleura: only the shape of the moved
 * surface is taken from its vertices, not where along it they lie. The inside is a linearly elastic solid (Poisson's
 * ratio {@value #POISSON}) that finds its equilibrium:
 *
 * <pre>  minimise  1/2 integral (e(u) - g I)' C (e(u) - g I) dV
 *          + 1/2 sum a_i E ( k (n_i . (x_i + u(x_i) - q_i))^2 + c |u(x_i) - v_i|^2 )</pre>
 *
 * over the vertices i of the surface with area a_i and displacement v_i, q_i the nearest point of the moved surface and
 * n_i its normal, taken anew {@value #ROUNDS} times; k = {@value #NORMAL_PER_MM} / mm, c = {@value #TANGENTIAL_PER_MM}
 * / mm. Young's modulus E cancels. The free strain g makes the dependent tissue expand more than the rest: it is linear
 * from back to front (y in LPS), 0 in the middle, and its difference between them is {@value #BACK_OVER_FRONT} times
 * the mean strain of the body, the cube root of its change in volume less 1. C is that of trilinear hexahedra of
 * {@value #CELL_MM} mm, each weighted by the share of it that lies inside the body (finite cell method; Parvizian,
 * Duester and Rank 2007, doi 10.1007/s00466-007-0173-y).
 */
public final class SlidingElasticSolid {
    private static final double CELL_MM = 14;
    private static final double POISSON = 0.3;
    private static final double NORMAL_PER_MM = 1.4;
    /** Holds the body against turning within a round surface; it leaves the tissue free to slide. */
    private static final double TANGENTIAL_PER_MM = 0.004;
    /**
     * Difference of the free strain between back and front of the body, over its mean strain. From the air content of
     * supine lungs at end-expiration: 46.5 % at the back, 3.29 % more per cm toward the front, 66 % on average (E. A.
     * Hoffman 1985, doi 10.1152/jappl.1985.59.2.468; dogs), hence 86 % at the front; 87 % everywhere at full
     * inspiration is an assumption. Linear expansion is then 0.60 at the back, 0.03 at the front and 0.38 on average.
     */
    private static final double BACK_OVER_FRONT = 1.5;

    private static final int ROUNDS = 4;
    private static final int SAMPLES = 3;
    private static final double LEAST_SHARE = 0.05;
    private static final int MOST_POINTS = 2500;
    private static final int MOST_ITERATIONS = 600;
    private static final double TOLERANCE = 1e-4;

    private final HexahedralGrid grid;
    private final TriangleMesh rest;
    private final int[] points;
    private final double[] area;
    private final double[] expansion;
    private final double[] displacement;

    /**
     * @param rest surface that encloses a space ({@link MeshMeasure#hasInside}); it may have holes, as at airways
     * @param now the same surface, moved
     */
    public SlidingElasticSolid(TriangleMesh rest, TriangleMesh now) {
        this(rest, now, new HexahedralGrid(rest, CELL_MM, SAMPLES, LEAST_SHARE, POISSON));
    }

    private SlidingElasticSolid(TriangleMesh rest, TriangleMesh now, HexahedralGrid grid) {
        this.rest = rest;
        this.grid = grid;
        int stride = 1 + rest.vertexCount() / MOST_POINTS;
        points = new int[(rest.vertexCount() + stride - 1) / stride];
        Arrays.setAll(points, i -> i * stride);
        double[] all = MeshMeasure.vertexAreas(rest);
        area = Arrays.stream(points).mapToDouble(v -> all[v] * stride).toArray();
        displacement = new double[grid.length()];
        expansion = dependentExpansion(now);
        solve(now);
    }

    /** Forces of the free strain. Its mean is left out: the shape of the surface gives it. */
    private double[] dependentExpansion(TriangleMesh now) {
        double[] box = rest.bounds();
        double middle = (box[1] + box[4]) / 2;
        double depth = box[4] - box[1];
        double strain = StrictMath.cbrt(MeshMeasure.signedVolume(now) / MeshMeasure.signedVolume(rest)) - 1;
        return grid.expansion(place -> BACK_OVER_FRONT * strain * (place[1] - middle) / depth);
    }

    /** The same body with its surface moved otherwise; the hexahedra are shared. */
    SlidingElasticSolid withSurface(TriangleMesh now) {
        return new SlidingElasticSolid(rest, now, grid);
    }

    /** Where a point of the body at rest goes. */
    public double[] moved(double[] place) {
        double[] u = grid.interpolate(grid.locate(place), displacement);
        return new double[] {place[0] + u[0], place[1] + u[1], place[2] + u[2]};
    }

    private void solve(TriangleMesh now) {
        HexahedralGrid.Place[] places = new HexahedralGrid.Place[points.length];
        double[] normal = new double[3 * points.length];
        double[] toSurface = new double[points.length];
        double[] moved = new double[3 * points.length];
        double[] normals = MeshMeasure.vertexNormals(now);
        double[] faces = MeshMeasure.triangleNormals(now);
        for (int i = 0; i < points.length; i++) {
            int v = points[i];
            places[i] = grid.locate(new double[] {rest.x(v), rest.y(v), rest.z(v)});
            for (int axis = 0; axis < 3; axis++) {
                moved[3 * i + axis] = now.positions()[3 * v + axis] - rest.positions()[3 * v + axis];
                normal[3 * i + axis] = normals[3 * v + axis];
                toSurface[i] += moved[3 * i + axis] * normal[3 * i + axis];
            }
        }
        TriangleTree tree = new TriangleTree(now);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int round = 0; round < ROUNDS; round++) {
            if (round > 0) {
                for (int i = 0; i < points.length; i++) {
                    nearest(faces, tree, hit, i, grid.interpolate(places[i], displacement), normal, toSurface);
                }
            }
            new Equilibrium(places, normal, toSurface, moved).solve();
        }
    }

    /** Nearest point of the moved surface to a displaced vertex: its normal, and how far the vertex has to go. */
    private void nearest(
            double[] faces,
            TriangleTree tree,
            TriangleTree.Hit hit,
            int i,
            double[] u,
            double[] normal,
            double[] toSurface) {
        int v = points[i];
        tree.closest(rest.x(v) + u[0], rest.y(v) + u[1], rest.z(v) + u[2], hit);
        double[] n = Arrays.copyOfRange(faces, 3 * hit.triangle, 3 * hit.triangle + 3);
        System.arraycopy(n, 0, normal, 3 * i, 3);
        toSurface[i] = n[0] * (hit.x - rest.x(v)) + n[1] * (hit.y - rest.y(v)) + n[2] * (hit.z - rest.z(v));
    }

    /** The linear system of one round, solved by conjugate gradients from the displacement so far. */
    private final class Equilibrium {
        private final HexahedralGrid.Place[] places;
        private final double[] normal;
        private final double[] right;
        private final double[] diagonal;

        Equilibrium(HexahedralGrid.Place[] places, double[] normal, double[] toSurface, double[] moved) {
            this.places = places;
            this.normal = normal;
            right = expansion.clone();
            diagonal = grid.diagonal();
            for (int i = 0; i < places.length; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    double n = normal[3 * i + axis];
                    double pull = NORMAL_PER_MM * n * toSurface[i] + TANGENTIAL_PER_MM * moved[3 * i + axis];
                    double stiff = NORMAL_PER_MM * n * n + TANGENTIAL_PER_MM;
                    for (int c = 0; c < places[i].nodes().length; c++) {
                        double w = places[i].weights()[c];
                        int at = 3 * places[i].nodes()[c] + axis;
                        right[at] += area[i] * w * pull;
                        diagonal[at] += area[i] * w * w * stiff;
                    }
                }
            }
        }

        private void multiply(double[] x, double[] out) {
            grid.multiply(x, out);
            for (int i = 0; i < places.length; i++) {
                double[] u = grid.interpolate(places[i], x);
                double along = u[0] * normal[3 * i] + u[1] * normal[3 * i + 1] + u[2] * normal[3 * i + 2];
                for (int axis = 0; axis < 3; axis++) {
                    u[axis] = area[i] * (NORMAL_PER_MM * along * normal[3 * i + axis] + TANGENTIAL_PER_MM * u[axis]);
                }
                grid.scatter(places[i], u, out);
            }
        }

        void solve() {
            double[] x = displacement;
            double[] r = new double[x.length];
            double[] direction = new double[x.length];
            double[] product = new double[x.length];
            multiply(x, product);
            double goal = 0;
            double energy = 0;
            for (int k = 0; k < x.length; k++) {
                r[k] = right[k] - product[k];
                direction[k] = r[k] / diagonal[k];
                energy += r[k] * direction[k];
                goal += right[k] * right[k] / diagonal[k];
            }
            goal *= TOLERANCE * TOLERANCE;
            for (int iteration = 0; iteration < MOST_ITERATIONS && energy > goal; iteration++) {
                multiply(direction, product);
                double curvature = 0;
                for (int k = 0; k < x.length; k++) {
                    curvature += direction[k] * product[k];
                }
                double step = energy / curvature;
                double next = 0;
                for (int k = 0; k < x.length; k++) {
                    x[k] += step * direction[k];
                    r[k] -= step * product[k];
                    next += r[k] * r[k] / diagonal[k];
                }
                for (int k = 0; k < x.length; k++) {
                    direction[k] = r[k] / diagonal[k] + next / energy * direction[k];
                }
                energy = next;
            }
        }
    }
}
