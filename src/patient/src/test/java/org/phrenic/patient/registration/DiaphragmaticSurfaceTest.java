package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceDistance;

class DiaphragmaticSurfaceTest {
    private static final Thorax MALE = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    @Test
    void itIsOnePieceThatLiesOnTheDiaphragm() {
        SurfaceDistance sheet = new SurfaceDistance(
                MALE.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh());
        for (Structure lung : MALE.structuresOf(StructureKind.LUNG)) {
            TriangleMesh base = DiaphragmaticSurface.of(lung.mesh());
            assertThat(new MeshTopology(base).componentCount()).isEqualTo(1);
            // A base is some 150 to 250 cm2 of a lung's 700 to 1000.
            double share = MeshMeasure.area(base) / MeshMeasure.area(lung.mesh());
            assertThat(share).isBetween(0.12, 0.35);
            double[] off = sheet.unsignedDistance(base.positions());
            java.util.Arrays.sort(off);
            assertThat(off[(int) (0.9 * off.length)]).as(lung.name()).isLessThan(12);
        }
    }

    @Test
    void proportionsDoNotMatter() {
        for (Structure lung : MALE.structuresOf(StructureKind.LUNG)) {
            double[] p = lung.mesh().positions().clone();
            for (int i = 0; i < p.length; i += 3) {
                p[i + 1] /= 1.4;
                p[i + 2] *= 1.4;
            }
            boolean[] plain = DiaphragmaticSurface.triangleMask(lung.mesh());
            boolean[] tall = DiaphragmaticSurface.triangleMask(lung.mesh().withPositions(p));
            Set<Integer> differ = new HashSet<>();
            int all = 0;
            for (int t = 0; t < plain.length; t++) {
                all += plain[t] ? 1 : 0;
                if (plain[t] != tall[t]) {
                    differ.add(t);
                }
            }
            assertThat(differ.size()).isLessThan(all / 8);
        }
    }

    @Test
    void facetAndRestAreTheWholeLung() {
        TriangleMesh lung = MALE.structuresOf(StructureKind.LUNG).get(0).mesh();
        assertThat(DiaphragmaticSurface.of(lung).triangleCount()
                        + DiaphragmaticSurface.complement(lung).triangleCount())
                .isEqualTo(lung.triangleCount());
    }

    @Test
    void itIsTheSameWhicheverWayTrianglesTurn() {
        TriangleMesh lung = MALE.structuresOf(StructureKind.LUNG).get(0).mesh();
        int[] turned = lung.triangles().clone();
        for (int i = 0; i < turned.length; i += 3) {
            int corner = turned[i];
            turned[i] = turned[i + 1];
            turned[i + 1] = corner;
        }
        assertThat(DiaphragmaticSurface.vertexMask(new TriangleMesh(lung.positions(), turned)))
                .containsExactly(DiaphragmaticSurface.vertexMask(lung));
    }

    @Test
    void verticesAreThoseOfTheFacet() {
        TriangleMesh lung = MALE.structuresOf(StructureKind.LUNG).get(0).mesh();
        int count = 0;
        for (boolean corner : DiaphragmaticSurface.vertexMask(lung)) {
            count += corner ? 1 : 0;
        }
        assertThat(count).isEqualTo(DiaphragmaticSurface.of(lung).vertexCount());
    }
}
