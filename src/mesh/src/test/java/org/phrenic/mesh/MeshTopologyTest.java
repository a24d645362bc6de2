package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MeshTopologyTest {
    @Test
    void aBoxHasEulersEighteenEdges() {
        MeshTopology topology = new MeshTopology(Shapes.box(1, 2, 3));
        assertThat(topology.edgeCount()).isEqualTo(18);
        assertThat(topology.isClosed()).isTrue();
        assertThat(topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isEqualTo(2);
        assertThat(topology.boundaryLoops()).isEmpty();
        assertThat(topology.componentCount()).isEqualTo(1);
    }

    @Test
    void edgesAreSortedPairsAndEveryListNamesItsOwner() {
        TriangleMesh mesh = Shapes.sphere(1, 2);
        MeshTopology topology = new MeshTopology(mesh);
        int[] edges = topology.edges();
        for (int e = 0; e < topology.edgeCount(); e++) {
            assertThat(edges[2 * e]).isLessThan(edges[2 * e + 1]);
            if (e > 0) {
                assertThat((long) edges[2 * e] << 32 | edges[2 * e + 1])
                        .isGreaterThan((long) edges[2 * e - 2] << 32 | edges[2 * e - 1]);
            }
        }
        for (int v = 0; v < mesh.vertexCount(); v++) {
            for (int k = topology.vertexEdgeStart()[v]; k < topology.vertexEdgeStart()[v + 1]; k++) {
                int e = topology.vertexEdges()[k];
                assertThat(v).isIn(edges[2 * e], edges[2 * e + 1]);
            }
            for (int k = topology.vertexTriangleStart()[v]; k < topology.vertexTriangleStart()[v + 1]; k++) {
                int t = 3 * topology.vertexTriangles()[k];
                assertThat(v).isIn(mesh.triangles()[t], mesh.triangles()[t + 1], mesh.triangles()[t + 2]);
            }
        }
        assertThat(topology.vertexEdges()).hasSize(2 * topology.edgeCount());
        assertThat(topology.vertexTriangles()).hasSize(3 * mesh.triangleCount());
    }

    @Test
    void aTorusHasEulerCharacteristicZero() {
        assertThat(new MeshTopology(Shapes.torus(5, 1, 24, 12)).eulerCharacteristic())
                .isZero();
    }

    @Test
    void aTubeHasItsTwoRimsAsLoopsThatRunWithItsTriangles() {
        TriangleMesh tube = Shapes.tube(2, 5, 12, 4);
        MeshTopology topology = new MeshTopology(tube);
        assertThat(topology.isClosed()).isFalse();
        assertThat(topology.isManifold()).isTrue();
        assertThat(topology.boundaryLoops()).hasSize(2).allSatisfy(loop -> {
            assertThat(loop).hasSize(12);
            boolean found = false;
            for (int side = 0; side < tube.triangles().length; side++) {
                found |= tube.triangles()[side] == loop[0] && tube.triangles()[EdgeTable.next(side, 3)] == loop[1];
            }
            assertThat(found).isTrue();
        });
    }

    @Test
    void twoBoxesAreTwoComponents() {
        MeshTopology topology =
                new MeshTopology(Shapes.join(Shapes.box(1, 1, 1), Shapes.moved(Shapes.box(1, 1, 1), 3, 0, 0)));
        assertThat(topology.componentCount()).isEqualTo(2);
    }

    @Test
    void threeTrianglesAtOneEdgeAreNotManifold() {
        TriangleMesh fin = new TriangleMesh(
                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, new int[] {0, 1, 2, 1, 0, 3, 0, 1, 4});
        MeshTopology topology = new MeshTopology(fin);
        assertThat(topology.isManifold()).isFalse();
        assertThat(topology.faceCount(0)).isEqualTo(3);
    }

    @Test
    void twoFansThatMeetInOneVertexAreNotManifoldAndKeepTwoLoops() {
        TriangleMesh bowTie = new TriangleMesh(
                new double[] {0, 0, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, -1, -1, 0}, new int[] {0, 2, 1, 0, 3, 4});
        MeshTopology topology = new MeshTopology(bowTie);
        assertThat(topology.isManifold()).isFalse();
        assertThat(topology.componentCount()).isEqualTo(1);
        assertThat(topology.boundaryLoops()).hasSize(2).allSatisfy(loop -> assertThat(loop)
                .hasSize(3));
    }

    @Test
    void aDegenerateTriangleAddsNoEdgeToItself() {
        MeshTopology topology =
                new MeshTopology(new TriangleMesh(new double[] {0, 0, 0, 1, 0, 0}, new int[] {0, 0, 1}));
        assertThat(topology.edgeCount()).isEqualTo(1);
        assertThat(topology.vertexTriangles()).containsExactly(0, 0);
    }

    @Test
    void aTriangleOfOneVertexThatNoOtherUsesIsNotManifold() {
        TriangleMesh box = Shapes.box(1, 1, 1);
        TriangleMesh point = new TriangleMesh(new double[] {5, 5, 5}, new int[] {0, 0, 0});
        MeshTopology topology = new MeshTopology(Shapes.join(box, point));
        assertThat(topology.isManifold()).isFalse();
        assertThat(topology.edgeCount()).isEqualTo(new MeshTopology(box).edgeCount());
    }

    @Test
    void anEmptyMeshIsNotClosed() {
        MeshTopology topology = new MeshTopology(new TriangleMesh(new double[0], new int[0]));
        assertThat(topology.isClosed()).isFalse();
        assertThat(topology.boundaryLoops()).isEmpty();
    }
}
