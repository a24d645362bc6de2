package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParametersReader;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.TriangleMesh;

/** The base of a lung, found by its shape. */
class LookingDownTest {
    @Test
    void theBaseOfALungLiesOnTheDiaphragmWhicheverWayItsTrianglesTurn() {
        TriangleMesh lung = VirtualThorax.generate(VirtualThoraxParametersReader.preset("adult-male"), Resolution.LOW)
                .find(StructureKind.LUNG, 0, Side.RIGHT)
                .orElseThrow()
                .mesh();
        boolean[] base = LookingDown.of(lung);
        int[] turned = lung.triangles().clone();
        for (int i = 0; i < turned.length; i += 3) {
            int corner = turned[i];
            turned[i] = turned[i + 1];
            turned[i + 1] = corner;
        }
        assertThat(LookingDown.of(new TriangleMesh(lung.positions(), turned))).containsExactly(base);
        double[] areas = MeshMeasure.vertexAreas(lung);
        double area = 0;
        double top = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < base.length; v++) {
            if (base[v]) {
                area += areas[v];
                top = Math.max(top, lung.z(v));
            }
        }
        // A half of the cage's section: 28 x 18 cm ellipse less spine and heart is some 350 cm2, domed by a third more.
        assertThat(area * 0.01).isBetween(120.0, 280.0);
        // The dome's top is at 115 mm (data/thorax/adult-male.yaml), the heart's side goes on above it.
        assertThat(top).isLessThan(135);
    }
}
