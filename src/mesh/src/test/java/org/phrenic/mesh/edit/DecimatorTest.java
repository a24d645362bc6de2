package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.DoubleList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.LabelGridSamples;
import org.phrenic.mesh.voxel.SurfaceNet;

class DecimatorTest {
    private static final double NO_BOUND = Double.POSITIVE_INFINITY;

    @Test
    void halfTheVerticesOfALabelsSurfaceKeepItsTopologyAndLieNearIt() {
        double bound = 0.3;
        TriangleMesh ball = SurfaceNet.of(
                        LabelGridSamples.ellipsoid(
                                40, 40, 40, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, 17, 14, 12),
                        new int[] {0, 1})
                .smoothed(20, 0.2)
                .surface(1);
        TriangleMesh half = Decimator.toVertexCount(ball, ball.vertexCount() / 2, bound);
        assertThat(half.vertexCount()).isEqualTo(ball.vertexCount() / 2);
        MeshTopology topology = new MeshTopology(half);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isEqualTo(2);
        SurfaceComparison apart = SurfaceComparison.of(half, ball);
        assertThat(apart.aToB().perVertex().maximum()).isLessThanOrEqualTo(bound);
        assertThat(apart.byArea().mean()).isLessThan(0.05);
        double volume = MeshMeasure.signedVolume(ball);
        assertThat(MeshMeasure.signedVolume(half)).isCloseTo(volume, within(2e-3 * volume));
        assertNoFlips(half, ball);
    }

    /** Each triangle faces the way of the original's triangle nearest to its middle. */
    private static void assertNoFlips(TriangleMesh half, TriangleMesh original) {
        double[] normals = MeshMeasure.triangleNormals(half);
        double[] theirs = MeshMeasure.triangleNormals(original);
        TriangleTree tree = new TriangleTree(original);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int[] t = half.triangles();
        for (int i = 0; i < t.length; i += 3) {
            double[] m = new double[3];
            for (int k = 0; k < 3; k++) {
                m[0] += half.x(t[i + k]) / 3;
                m[1] += half.y(t[i + k]) / 3;
                m[2] += half.z(t[i + k]) / 3;
            }
            tree.closest(m[0], m[1], m[2], hit);
            int o = 3 * hit.triangle;
            assertThat(normals[i] * theirs[o] + normals[i + 1] * theirs[o + 1] + normals[i + 2] * theirs[o + 2])
                    .isPositive();
        }
    }

    @Test
    void aFlatSheetLosesItsInnerVerticesAndKeepsItsRim() {
        TriangleMesh sheet = Shapes.sheet(30, 20, 16, 11);
        TriangleMesh few = Decimator.toVertexCount(sheet, 30, 1e-6);
        assertThat(few.vertexCount()).isEqualTo(30);
        assertThat(MeshMeasure.area(few)).isCloseTo(600, within(1e-6));
        // A height of a fifth of the longest side leaves 11.3 degrees.
        assertThat(MeshQuality.of(few).smallestAngleDeg()).isGreaterThan(11.3);
        assertThat(few.bounds()).containsExactly(sheet.bounds(), within(1e-6));
    }

    @Test
    void theBoundStopsDecimation() {
        TriangleMesh sphere = Shapes.sphere(50, 4);
        TriangleMesh loose = Decimator.toVertexCount(sphere, 40, NO_BOUND);
        assertThat(loose.vertexCount()).isEqualTo(40);
        TriangleMesh bound = Decimator.toVertexCount(sphere, 40, 0.5);
        assertThat(bound.vertexCount()).isBetween(41, 1500);
        assertThat(SurfaceComparison.of(bound, sphere).aToB().perVertex().maximum())
                .isLessThanOrEqualTo(0.5);
        assertThat(farthestMiddle(bound, sphere)).isLessThanOrEqualTo(0.5 + 1e-9);
    }

    /** The greatest distance of the middle of an edge or a triangle from another surface, mm. */
    private static double farthestMiddle(TriangleMesh mesh, TriangleMesh other) {
        DoubleList middles = new DoubleList();
        int[] edges = new MeshTopology(mesh).edges();
        for (int e = 0; e < edges.length; e += 2) {
            int a = edges[e];
            int b = edges[e + 1];
            middles.add((mesh.x(a) + mesh.x(b)) / 2, (mesh.y(a) + mesh.y(b)) / 2, (mesh.z(a) + mesh.z(b)) / 2);
        }
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double[] centroid = MeshMeasure.centroid(mesh, t);
            middles.add(centroid[0], centroid[1], centroid[2]);
        }
        double[] apart = new TriangleTree(other).distances(middles.toArray());
        return Arrays.stream(apart).max().orElseThrow();
    }

    @Test
    void aTorusStaysATorusHoweverFewAreAskedFor() {
        TriangleMesh few = Decimator.toVertexCount(Shapes.torus(10, 3, 24, 12), 4, NO_BOUND);
        MeshTopology topology = new MeshTopology(few);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isZero();
        assertThat(few.vertexCount()).isLessThan(60);
    }

    @Test
    void theSameSurfaceGivesTheSameBits() {
        TriangleMesh sphere = Shapes.sphere(50, 3);
        assertThat(Decimator.toVertexCount(sphere, 200, 1).positions())
                .isEqualTo(Decimator.toVertexCount(
                                new TriangleMesh(
                                        sphere.positions().clone(),
                                        sphere.triangles().clone()),
                                200,
                                1)
                        .positions());
    }

    @Test
    void whatCannotBeMetIsRefused() {
        TriangleMesh box = Shapes.box(1, 1, 1);
        assertThatThrownBy(() -> Decimator.toVertexCount(box, 3, 1)).hasMessageContaining("at least 4");
        assertThatThrownBy(() -> Decimator.toVertexCount(box, 8, 0)).hasMessageContaining("more than 0 mm");
        assertThatThrownBy(() -> Remesher.toEdgeLength(box, 0)).hasMessageContaining("more than 0");
    }

    @Test
    void remeshingToAnEdgeLengthMakesTrianglesFitForSprings() {
        MeshQuality quality = MeshQuality.of(Remesher.toEdgeLength(Shapes.sphere(50, 4), 6));
        assertThat(quality.meanEdgeMm()).isCloseTo(6, within(0.3));
        assertThat(quality.smallestAngleDeg()).isGreaterThan(25);
        assertThat(quality.edgeRatio()).isLessThan(3);
    }
}
