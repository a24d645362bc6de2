package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class SurfaceDistanceTest {
    private static final double ROUNDING = 1e-9;

    @Property(tries = 40, seed = "1")
    void distancesAreThoseOfASearchThroughAllTrianglesOfAMeshWithDegenerates(
            @ForAll @IntRange(min = 0, max = 100000) int seed) {
        Random random = new Random(seed);
        TriangleMesh soup = TriangleTreeTest.soupWithDegenerates(random, 1 + random.nextInt(150));
        double[] points = points(random, 25, 10);
        double[] found = new SurfaceDistance(soup).unsignedDistance(points);
        for (int i = 0; i < found.length; i++) {
            assertThat(found[i]).isCloseTo(bruteForce(soup, points, i), within(ROUNDING));
        }
    }

    @Test
    void signsTellInsideFromOutsideAsTheWindingNumberDoes() {
        for (TriangleMesh mesh :
                new TriangleMesh[] {Shapes.torus(10, 3, 20, 9), Shapes.box(9, 5, 2), Shapes.sphere(8, 2)}) {
            SurfaceDistance distance = new SurfaceDistance(mesh);
            TriangleTree tree = new TriangleTree(mesh);
            double[] points = points(new Random(7), 400, 14);
            double[] signed = distance.signedDistance(points);
            double[] sizes = distance.unsignedDistance(points);
            for (int i = 0; i < signed.length; i++) {
                boolean inside = tree.isInside(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
                assertThat(signed[i]).isEqualTo(inside ? -sizes[i] : sizes[i]);
            }
        }
    }

    @Test
    void aPointThatIsNotANumberIsInfinitelyFarAsWithoutASign() {
        SurfaceDistance distance = new SurfaceDistance(Shapes.box(9, 5, 2));
        double[] points = {Double.NaN, 0, 0, 100, 0, 0};
        assertThat(distance.signedDistance(points)).containsExactly(distance.unsignedDistance(points));
        assertThat(distance.signedDistance(points)[0]).isInfinite();
    }

    @Test
    void sidesAreToldApartWhereTheSurfaceHasAHoleToo() {
        TriangleMesh whole = Shapes.sphere(8, 2);
        TriangleMesh open =
                new TriangleMesh(whole.positions(), Arrays.copyOf(whole.triangles(), whole.triangles().length - 3));
        double[] points = points(new Random(7), 400, 14);
        double[] signed = new SurfaceDistance(whole).signedDistance(points);
        double[] sided = new SurfaceDistance(open).sidedDistance(points);
        assertThat(new SurfaceDistance(whole).sidedDistance(points)).containsExactly(signed);
        for (int i = 0; i < signed.length; i++) {
            if (Math.abs(signed[i]) > 1) {
                assertThat(Math.signum(sided[i])).isEqualTo(Math.signum(signed[i]));
            }
        }
    }

    @Test
    void beyondAnEdgeOrACornerOfABoxTheSignIsThatOfTheOutsideWhicheverTriangleIsFound() {
        SurfaceDistance box = new SurfaceDistance(Shapes.box(10, 10, 10));
        double[] beyond = {11, 11, 5, 11, 11, 11, -1, -1, -1, 5, -1, 11, 9.9, 9.9, 9.9, 0.1, 5, 0.2};
        double[] signed = box.signedDistance(beyond);
        double root = Math.sqrt(2);
        assertThat(signed)
                .containsExactly(new double[] {root, Math.sqrt(3), Math.sqrt(3), root, -0.1, -0.1}, within(ROUNDING));
    }

    @Test
    void aSurfaceTurnedInsideOutHasTheSameOutside() {
        TriangleMesh sphere = Shapes.sphere(10, 3);
        int[] turned = sphere.triangles().clone();
        for (int i = 0; i < turned.length; i += 3) {
            int swap = turned[i];
            turned[i] = turned[i + 1];
            turned[i + 1] = swap;
        }
        SurfaceDistance inward = new SurfaceDistance(new TriangleMesh(sphere.positions(), turned));
        assertThat(inward.signedDistance(new double[] {0, 0, 0, 20, 0, 0}))
                .isEqualTo(new SurfaceDistance(sphere).signedDistance(new double[] {0, 0, 0, 20, 0, 0}));
    }

    @Test
    void anOpenOrInconsistentSurfaceHasNoSigns() {
        SurfaceDistance open = new SurfaceDistance(Shapes.tube(5, 10, 12, 3));
        assertThat(open.isSigned()).isFalse();
        assertThatThrownBy(() -> open.signedDistance(new double[3])).hasMessageContaining("expected a closed surface");
        int[] t = Shapes.box(1, 1, 1).triangles().clone();
        int swap = t[0];
        t[0] = t[1];
        t[1] = swap;
        assertThat(new SurfaceDistance(new TriangleMesh(Shapes.box(1, 1, 1).positions(), t)).isSigned())
                .isFalse();
    }

    @Test
    void afterTheReferenceMovedDistancesAreFromWhereItIs() {
        TriangleMesh sphere = Shapes.sphere(10, 3);
        TriangleMesh away = Shapes.moved(sphere, 30, 0, 0);
        SurfaceDistance distance = new SurfaceDistance(sphere);
        distance.refit(away.positions());
        double[] points = points(new Random(3), 50, 40);
        assertThat(distance.signedDistance(points)).isEqualTo(new SurfaceDistance(away).signedDistance(points));
    }

    private static double[] points(Random random, int count, double reach) {
        double[] points = new double[3 * count];
        for (int i = 0; i < points.length; i++) {
            points[i] = 2 * reach * random.nextDouble() - reach;
        }
        return points;
    }

    private static double bruteForce(TriangleMesh mesh, double[] points, int i) {
        double least = Double.POSITIVE_INFINITY;
        double[] q = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
        for (int t = 0; t < mesh.triangleCount(); t++) {
            least = Math.min(least, TriangleTreeTest.distanceByRefinement(mesh, t, q));
        }
        return least;
    }
}
