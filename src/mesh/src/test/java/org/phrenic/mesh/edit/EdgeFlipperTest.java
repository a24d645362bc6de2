package org.phrenic.mesh.edit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class EdgeFlipperTest {
    /**
     * What is left out because nothing near has changed would have stayed: looking at every edge anew gives the same
     * surface.
     */
    @Test
    void edgesLeftOutWouldHaveStayed() {
        checkAgainstAll(Shapes.sphere(50, 3));
        checkAgainstAll(Shapes.tube(20, 60, 32, 20));
    }

    private static void checkAgainstAll(TriangleMesh surface) {
        HalfEdgeMesh sparing = new HalfEdgeMesh(surface);
        HalfEdgeMesh thorough = new HalfEdgeMesh(surface);
        int turned = 0;
        for (int round = 0; round < 6; round++) {
            for (HalfEdgeMesh mesh : new HalfEdgeMesh[] {sparing, thorough}) {
                change(mesh, round);
            }
            thorough.clearAllFlipChecked();
            turned += new EdgeFlipper(sparing).flipAll();
            new EdgeFlipper(thorough).flipAll();
            assertThat(sparing.toMesh().triangles()).isEqualTo(thorough.toMesh().triangles());
        }
        assertThat(turned).isGreaterThan(100);
    }

    /** Splits some edges beside their middle and collapses some others. */
    private static void change(HalfEdgeMesh mesh, int round) {
        int end = 3 * mesh.triangleEnd;
        for (int h = round; h < end; h += 17) {
            if (mesh.isAlive(h)) {
                double[] p = mesh.position;
                int a = 3 * mesh.start[h];
                int b = 3 * mesh.end(h);
                if (h % 2 == 0) {
                    mesh.split(
                            h,
                            0.7 * p[a] + 0.3 * p[b],
                            0.7 * p[a + 1] + 0.3 * p[b + 1],
                            0.7 * p[a + 2] + 0.3 * p[b + 2]);
                } else if (mesh.canCollapse(h)) {
                    mesh.collapse(h, p[b], p[b + 1], p[b + 2]);
                }
            }
        }
    }
}
