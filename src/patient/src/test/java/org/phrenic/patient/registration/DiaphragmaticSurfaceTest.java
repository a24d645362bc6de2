package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
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
import org.phrenic.mesh.Shapes;
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
            Arrays.sort(off);
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
        assertThat(DiaphragmaticSurface.vertexMask(turned(lung)))
                .containsExactly(DiaphragmaticSurface.vertexMask(lung));
    }

    /** A mask of a lung has cavities, whose walls are pieces of their own. */
    @Test
    void wallsOfCavitiesAreNoPartOfIt() {
        for (Structure structure : MALE.structuresOf(StructureKind.LUNG)) {
            TriangleMesh lung = structure.mesh();
            double[] centre = lung.centre();
            TriangleMesh cavity = turned(Shapes.moved(Shapes.sphere(15, 2), centre[0], centre[1], centre[2]));
            boolean[] expected = DiaphragmaticSurface.triangleMask(lung);
            boolean[] mask = DiaphragmaticSurface.triangleMask(Shapes.join(lung, cavity));
            assertThat(Arrays.copyOf(mask, expected.length)).containsExactly(expected);
            assertThat(Arrays.copyOfRange(mask, expected.length, mask.length)).containsOnly(false);
        }
    }

    @Test
    void aTriangleWithTwoCornersInOnePlaceIsNoObstacle() {
        TriangleMesh lung = MALE.structuresOf(StructureKind.LUNG).get(0).mesh();
        int apex = 0;
        for (int t = 1; t < lung.triangleCount(); t++) {
            apex = MeshMeasure.centroid(lung, t)[2] > MeshMeasure.centroid(lung, apex)[2] ? t : apex;
        }
        int last = lung.triangles().length;
        int[] triangles = Arrays.copyOf(lung.triangles(), last + 3);
        triangles[last] = triangles[3 * apex];
        triangles[last + 1] = triangles[3 * apex];
        triangles[last + 2] = triangles[3 * apex + 1];
        assertThat(DiaphragmaticSurface.vertexMask(new TriangleMesh(lung.positions(), triangles)))
                .containsExactly(DiaphragmaticSurface.vertexMask(lung));
    }

    private static TriangleMesh turned(TriangleMesh mesh) {
        int[] turned = mesh.triangles().clone();
        for (int i = 0; i < turned.length; i += 3) {
            int corner = turned[i];
            turned[i] = turned[i + 1];
            turned[i + 1] = corner;
        }
        return new TriangleMesh(mesh.positions(), turned);
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
