package org.phrenic.mesh.query;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class TriangleDiscsTest {
    /** To the last bit: what a search leaves out by its discs is not what a search of all triangles finds. */
    @Property(tries = 60, seed = "1")
    void theNearestTriangleIsTheOneThatASearchOfAllFinds(@ForAll @IntRange(min = 0, max = 100000) int seed) {
        Random random = new Random(seed);
        TriangleMesh mesh = TriangleTreeTest.soupWithDegenerates(random, 1 + random.nextInt(200));
        TriangleTree tree = new TriangleTree(mesh);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] p = mesh.positions();
        for (int i = 0; i < 40; i++) {
            double x = 30 * random.nextDouble() - 10;
            double y = 30 * random.nextDouble() - 10;
            double z = 30 * random.nextDouble() - 10;
            if (i % 4 == 0) {
                int corner = 3 * random.nextInt(p.length / 3);
                x = p[corner];
                y = p[corner + 1];
                z = p[corner + 2];
            }
            int nearest = -1;
            double least = Double.POSITIVE_INFINITY;
            for (int t = 0; t < mesh.triangleCount(); t++) {
                double square = tree.squaredDistance(t, x, y, z, hit);
                nearest = square < least ? t : nearest;
                least = Math.min(square, least);
            }
            tree.closest(x, y, z, 1000, random.nextInt(mesh.triangleCount()), null, hit);
            assertThat(hit.triangle).isEqualTo(nearest);
            assertThat(hit.distanceSquared).isEqualTo(least);
        }
    }

    @Property(tries = 60, seed = "1")
    void noTriangleIsFartherThanItIs(@ForAll @IntRange(min = 0, max = 100000) int seed) {
        Random random = new Random(seed);
        TriangleMesh mesh = TriangleTreeTest.soupWithDegenerates(random, 1 + random.nextInt(100));
        TriangleTree tree = new TriangleTree(mesh);
        tree.measure();
        for (int i = 0; i < 20; i++) {
            double[] q = {30 * random.nextDouble() - 10, 30 * random.nextDouble() - 10, 30 * random.nextDouble() - 10};
            for (int place = 0; place < mesh.triangleCount(); place++) {
                double distance = TriangleTreeTest.distanceByRefinement(mesh, tree.order[place], q);
                assertThat(tree.discs.isFarther(place, q[0], q[1], q[2], distance * distance))
                        .isFalse();
            }
        }
    }

    /** Of a sphere of 20 mm, whose triangles have sides of some 3 mm. */
    @Test
    void mostTrianglesAreKnownToBeFartherThanHalfTheirDistance() {
        TriangleMesh sphere = Shapes.sphere(20, 3);
        TriangleTree tree = new TriangleTree(sphere);
        tree.measure();
        int known = 0;
        for (int place = 0; place < sphere.triangleCount(); place++) {
            double distance = TriangleTreeTest.distanceByRefinement(sphere, tree.order[place], new double[] {0, 0, 25});
            known += tree.discs.isFarther(place, 0, 0, 25, 0.25 * distance * distance) ? 1 : 0;
        }
        assertThat(known).isEqualTo(sphere.triangleCount());
    }
}
