package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class EdgePathsTest {
    private static final double ROUNDING = 1e-9;

    @Test
    void alongAGridLineTheDistanceIsTheStraightOne() {
        TriangleMesh sheet = Shapes.sheet(10, 5, 11, 6);
        double[] distance = EdgePaths.distances(sheet, new MeshTopology(sheet), 0);
        for (int i = 0; i <= 10; i++) {
            assertThat(distance[6 * i]).isCloseTo(i, within(ROUNDING));
        }
        // The diagonals of the cells run the same way: five of them, then five sides.
        assertThat(distance[6 * 10 + 5]).isCloseTo(5 * Math.sqrt(2) + 5, within(ROUNDING));
    }

    @Test
    void fromAPoleOfASphereDistancesAreArcsWithinTheBoundForEdgePaths() {
        double r = 10;
        TriangleMesh sphere = Shapes.sphere(r, 4);
        double[] distance = EdgePaths.distances(sphere, new MeshTopology(sphere), 0);
        for (int v = 1; v < sphere.vertexCount(); v++) {
            double cosine =
                    (sphere.x(0) * sphere.x(v) + sphere.y(0) * sphere.y(v) + sphere.z(0) * sphere.z(v)) / (r * r);
            double arc = r * Math.acos(Math.max(-1, Math.min(1, cosine)));
            // Chords are shorter than arcs by 1e-3 here. At the twelve corners of the icosahedron five edges meet at 72
            // degrees:
            // between two of them a path along edges is longer by up to 1 / cos 36 = 1.236.
            assertThat(distance[v]).isBetween(arc * 0.998, arc * 1.24);
        }
    }

    @Test
    void everyVertexBelongsToItsNearestSourceAndOtherPiecesAreOutOfReach() {
        TriangleMesh sheet = Shapes.sheet(10, 1, 11, 2);
        TriangleMesh both = Shapes.join(sheet, Shapes.moved(sheet, 0, 0, 5));
        double[] distance = EdgePaths.distances(both, new MeshTopology(both), 0, 20);
        assertThat(distance[2 * 3]).isCloseTo(3, within(ROUNDING));
        assertThat(distance[2 * 8]).isCloseTo(2, within(ROUNDING));
        assertThat(distance[22]).isInfinite();
    }

    @Test
    void aSourceThatIsNoVertexIsRefused() {
        TriangleMesh box = Shapes.box(1, 1, 1);
        assertThatThrownBy(() -> EdgePaths.distances(box, new MeshTopology(box), 8))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("source of paths: found vertex 8, expected a vertex from 0 to 7");
    }
}
