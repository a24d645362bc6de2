package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class LevelClipTest {
    private static final double RADIUS = 30;

    private static double[] heights(TriangleMesh mesh, double level) {
        return IntStream.range(0, mesh.vertexCount())
                .mapToDouble(v -> mesh.positions()[3 * v + 2] - level)
                .toArray();
    }

    /** The area of a cap of height h is 2 pi r h (Archimedes). */
    @ParameterizedTest
    @ValueSource(doubles = {-17.3, -0.01, 0, 4.9, 21})
    void theCapOfASphereHasItsAreaAndABorderOnTheLevel(double level) {
        TriangleMesh sphere = Shapes.sphere(RADIUS, 4);

        TriangleMesh cap = LevelClip.positivePart(sphere, heights(sphere, level));

        double wanted = 2 * Math.PI * RADIUS * (RADIUS - level);
        assertThat(MeshMeasure.area(cap)).isCloseTo(wanted, within(0.012 * wanted));
        double[] height = heights(cap, level);
        for (int v = 0; v < cap.vertexCount(); v++) {
            assertThat(height[v]).as("height above the level").isGreaterThan(-1e-9);
        }
        assertThat(MeshQuality.of(cap).smallestAngleDeg()).as("smallest angle").isGreaterThan(8);
        double[] normals = MeshMeasure.triangleNormals(cap);
        for (int t = 0; t < cap.triangleCount(); t++) {
            double[] centroid = MeshMeasure.centroid(cap, t);
            double outward =
                    normals[3 * t] * centroid[0] + normals[3 * t + 1] * centroid[1] + normals[3 * t + 2] * centroid[2];
            assertThat(outward).as("triangle %s faces outward", t).isGreaterThan(RADIUS / 2);
        }
        List<int[]> borders = new MeshTopology(cap).boundaryLoops();
        assertThat(borders).hasSize(1);
        for (int v : borders.get(0)) {
            assertThat(height[v]).as("height of the border").isCloseTo(0, within(1e-9));
        }
    }

    @Test
    void whatLiesOnOneSideIsKeptWholeOrNotAtAll() {
        TriangleMesh sphere = Shapes.sphere(RADIUS, 2);

        assertThat(LevelClip.positivePart(sphere, heights(sphere, -31)).triangles())
                .isEqualTo(sphere.triangles());
        assertThat(LevelClip.positivePart(sphere, heights(sphere, 31)).triangleCount())
                .isZero();
    }
}
