package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/** The triangles of a simple polygon cover it once: none is turned over, and their areas add up to its area. */
class PolygonTriangulatorTest {
    private static final double ROUNDING = 1e-12;

    private static TriangleMesh cut(double[] outline) {
        int count = outline.length / 2;
        double[] positions = new double[3 * count];
        for (int i = 0; i < count; i++) {
            // A slanted plane, x + z = 0: areas are those of the outline times the square root of two.
            positions[3 * i] = outline[2 * i];
            positions[3 * i + 1] = outline[2 * i + 1];
            positions[3 * i + 2] = -outline[2 * i];
        }
        int[] triangles = new int[3 * (count - 2)];
        PolygonTriangulator.triangulate(positions, IntStream.range(0, count).toArray(), 0, count, triangles, 0);
        return new TriangleMesh(positions, triangles);
    }

    /**
     * The areas, and their vectors as well, add up to those of the outline, which runs anticlockwise about (1, 0, 1).
     */
    private static void assertCovered(double[] outline, double area) {
        TriangleMesh mesh = cut(outline);
        assertThat(MeshSamples.area(mesh)).isCloseTo(area * Math.sqrt(2), within(ROUNDING));
        double[] sum = new double[3];
        double[] cross = new double[3];
        for (int t = 0; t < mesh.triangleCount(); t++) {
            MeshMeasure.triangleCrossProduct(mesh, t, cross);
            for (int axis = 0; axis < 3; axis++) {
                sum[axis] += cross[axis] / 2;
            }
        }
        assertThat(sum).containsExactly(new double[] {area, 0, area}, within(ROUNDING));
    }

    @Test
    void aConvexPolygonIsAFanFromItsFirstCorner() {
        assertThat(cut(new double[] {0, 0, 1, 0, 1, 1, 0, 1}).triangles()).containsExactly(0, 1, 2, 0, 2, 3);
    }

    @Test
    void anArrowheadIsNotCutAcrossItsNotch() {
        // Notch at (1, 1): the triangle of area 4 without one of area 1.
        double[] arrow = {0, 0, 4, 1, 0, 2, 1, 1};
        assertCovered(arrow, 3);
        // The same outline beginning at a wing: there the fan would fold over.
        double[] turned = {4, 1, 0, 2, 1, 1, 0, 0};
        assertCovered(turned, 3);
        double[] wing = {0, 2, 1, 1, 0, 0, 4, 1};
        assertCovered(wing, 3);
    }

    @Test
    void aCombIsCoveredOnce() {
        // Three teeth of 1 by 2 on a bar of 5 by 1: area 5 + 6.
        double[] comb = {0, 0, 5, 0, 5, 3, 4, 3, 4, 1, 3, 1, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3};
        assertCovered(comb, 11);
    }

    @Test
    void aPolygonWithoutAreaStillGivesItsTriangles() {
        assertThat(cut(new double[] {0, 0, 1, 0, 2, 0, 1, 0, 3, 0}).triangleCount())
                .isEqualTo(3);
    }
}
