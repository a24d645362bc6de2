package org.phrenic.scene.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class CoarseTrianglesTest {
    /** Between fewer of its vertices a sphere loses little of its volume, stays closed and faces outward. */
    @Test
    void aSphereKeepsItsShapeWithAQuarterOfItsTriangles() {
        TriangleMesh sphere = Shapes.sphere(50, 4);
        int[] fewer = CoarseTriangles.of(sphere);
        assertThat(fewer.length).isBetween(sphere.triangles().length / 5, (int) (0.27 * sphere.triangles().length));
        TriangleMesh coarse = new TriangleMesh(sphere.positions(), fewer);
        EdgeTable edges = new EdgeTable(coarse);
        for (int e = 0; e < edges.edgeCount(); e++) {
            assertThat(edges.faceCount(e)).isEqualTo(2);
        }
        double volume = MeshMeasure.signedVolume(sphere);
        assertThat(volume).isPositive();
        assertThat(MeshMeasure.signedVolume(coarse) / volume).isCloseTo(1, within(0.02));
    }

    /** A window that shows a body in another scene does not compute again what both have. */
    @Test
    void anEqualSurfaceHasTheTrianglesOfTheFormerAndAnotherOneItsOwn() {
        TriangleMesh sphere = Shapes.sphere(50, 4);
        int[] fewer = CoarseTriangles.of(sphere);
        assertThat(CoarseTriangles.of(Shapes.sphere(50, 4))).isSameAs(fewer);
        double[] flat = sphere.positions().clone();
        for (int z = 2; z < flat.length; z += 3) {
            flat[z] /= 10;
        }
        assertThat(CoarseTriangles.of(sphere.withPositions(flat))).isNotEqualTo(fewer);
        int[] open = Arrays.copyOf(sphere.triangles(), sphere.triangles().length / 2);
        assertThat(CoarseTriangles.of(new TriangleMesh(sphere.positions(), open)))
                .hasSizeLessThan(fewer.length);
    }

    @Test
    void aSurfaceOfFewVerticesIsKept() {
        TriangleMesh small = Shapes.sphere(5, 1);
        assertThat(CoarseTriangles.of(small)).isEqualTo(small.triangles());
    }
}
