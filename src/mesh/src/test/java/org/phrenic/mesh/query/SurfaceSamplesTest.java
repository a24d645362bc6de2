package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class SurfaceSamplesTest {
    private static final double SPACING_MM = 2.5;

    @Test
    void everyPlaceOnASurfaceHasASampleNearby() {
        Random random = new Random(5);
        for (int round = 0; round < 20; round++) {
            double[] corners = random.doubles(9, -30, 30).toArray();
            TriangleMesh mesh = new TriangleMesh(corners, new int[] {0, 1, 2});
            SurfaceSamples samples = new SurfaceSamples(SPACING_MM);
            samples.add(mesh);
            double[] p = samples.points();
            TriangleTree tree = new TriangleTree(mesh);
            TriangleTree.Hit hit = new TriangleTree.Hit();
            for (int i = 0; i < p.length; i += 3) {
                tree.closest(p[i], p[i + 1], p[i + 2], hit);
                assertThat(hit.distanceSquared).isCloseTo(0, within(1e-20));
            }
            for (int k = 0; k < 50; k++) {
                double u = random.nextDouble();
                double v = (1 - u) * random.nextDouble();
                double nearest = Double.POSITIVE_INFINITY;
                for (int i = 0; i < p.length; i += 3) {
                    double squared = 0;
                    for (int axis = 0; axis < 3; axis++) {
                        double at = (1 - u - v) * corners[axis] + u * corners[3 + axis] + v * corners[6 + axis];
                        squared += (at - p[i + axis]) * (at - p[i + axis]);
                    }
                    nearest = Math.min(nearest, squared);
                }
                assertThat(Math.sqrt(nearest)).isLessThan(SPACING_MM);
            }
        }
    }

    /** The longest side, 10.37 mm, has five steps of at most 2.5 mm, whichever it is: 6 + 5 + 4 + 3 + 2 + 1 points. */
    @Test
    void theLongestSideSetsTheStepsOfATriangle() {
        double[] corners = {0, 0, 0, 8, 0, 0, 0, 6.6, 0};
        for (int[] order : new int[][] {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
            SurfaceSamples samples = new SurfaceSamples(SPACING_MM);
            samples.add(new TriangleMesh(corners, order));
            assertThat(samples.points()).hasSize(3 * 21);
        }
    }

    @Test
    void aWholeSurfaceIsAllItsTriangles() {
        TriangleMesh sphere = Shapes.sphere(20, 2);
        SurfaceSamples whole = new SurfaceSamples(SPACING_MM);
        whole.add(sphere);
        SurfaceSamples single = new SurfaceSamples(SPACING_MM);
        for (int t = 0; t < sphere.triangleCount(); t++) {
            single.add(sphere, t);
        }
        assertThat(whole.points()).isEqualTo(single.points());
    }

    @Test
    void spacingMustBePositive() {
        assertThatThrownBy(() -> new SurfaceSamples(0)).hasMessage("spacing: found 0.0 mm, expected more than 0");
        assertThatThrownBy(() -> new SurfaceSamples(Double.NaN)).isInstanceOf(IllegalArgumentException.class);
    }
}
