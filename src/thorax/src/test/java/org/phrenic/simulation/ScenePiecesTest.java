package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.NearestVertex;
import org.phrenic.model.organ.Remeshing;
import org.phrenic.model.organ.SpringList;
import org.phrenic.model.organ.TieSprings;
import org.phrenic.model.organ.TissueLaw;

/** The pieces a scene is put together from. */
class ScenePiecesTest {
    private static Structure structure(String name, TriangleMesh mesh) {
        return new Structure(name, StructureKind.LUNG, 0, Side.MIDLINE, mesh);
    }

    private static TriangleMesh moved(TriangleMesh mesh, double dz) {
        double[] p = mesh.positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] += dz;
        }
        return mesh.withPositions(p);
    }

    @Test
    void theNearestVertexIsFoundInsideAndFarOutside() {
        TriangleMesh mesh = DomeSheet.adult(9);
        NearestVertex nearest = new NearestVertex(mesh, v -> v % 3 != 0);
        for (int probe = 0; probe < 300; probe++) {
            double x = 400 * Math.sin(1.3 * probe);
            double y = 300 * Math.sin(2.7 * probe + 1);
            double z = 200 * Math.sin(0.9 * probe + 2);
            int best = -1;
            double least = Double.POSITIVE_INFINITY;
            for (int v = 0; v < mesh.vertexCount(); v++) {
                double d =
                        Math.sqrt(Math.pow(mesh.x(v) - x, 2) + Math.pow(mesh.y(v) - y, 2) + Math.pow(mesh.z(v) - z, 2));
                if (v % 3 != 0 && d < least) {
                    least = d;
                    best = v;
                }
            }
            assertThat(nearest.find(x, y, z)).isEqualTo(best);
            assertThat(nearest.distance()).isCloseTo(least, within(1e-9));
        }
        assertThat(new NearestVertex(mesh, v -> false).find(0, 0, 0)).isEqualTo(-1);
    }

    @Test
    void aSheetOfTheRightSizeIsMeshedAnewWhereAWarpLeftSlivers() {
        TriangleMesh even = Remesher.toVertexCount(DomeSheet.adult(9), 600);
        double[] p = even.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            // A quarter is drawn out to eight times its length, as where a patient's body has more room than the
            // template.
            p[i] += 7 * Math.max(0, p[i] - 60);
        }
        TriangleMesh warped = even.withPositions(p);
        assertThat(Remeshing.isAdequate(even, 600)).isTrue();
        assertThat(Remeshing.isAdequate(even, 620)).isFalse();
        assertThat(Remeshing.isAdequate(warped, 600)).isFalse();
        assertThat(Remeshing.isAdequate(Remesher.toVertexCount(warped, 600), 600))
                .isTrue();
    }

    @Test
    void aSpringListKeepsWhatWasAddedBeyondItsFirstSize() {
        SpringList list = new SpringList();
        for (int i = 0; i < 3000; i++) {
            list.add(i, i + 1, 2 * i, 3 * i, i == 2999 ? 0.5 : 0);
        }
        list.setRest(7, 1);
        assertThat(list.count()).isEqualTo(3000);
        assertThat(list.nodeB()).hasSize(3000).endsWith(3000);
        assertThat(list.stiffness()[2500]).isEqualTo(5000);
        assertThat(list.rest()[7]).isEqualTo(1);
        assertThat(list.contractileShare()[2999]).isEqualTo(0.5);
        assertThat(Arrays.stream(list.contractileShare())).anyMatch(share -> share != 0);
    }

    @Test
    void nodesOfPartsFollowEachOther() {
        MassSpringBuilder parts = new MassSpringBuilder();
        TriangleMesh a = DomeSheet.adult(3);
        TriangleMesh b = moved(a, 50);
        int n = a.vertexCount();
        assertThat(parts.addNodes(a, new double[n])).isZero();
        assertThat(parts.addNodes(b, TissueLaw.uniform(1, 2).masses(b, 1))).isEqualTo(n);
        parts.attachToBone(n + 3, 12);
        assertThat(parts.nodeCount()).isEqualTo(2 * n);
        assertThat(parts.masses()[n - 1]).isZero();
        assertThat(parts.masses()[n]).isEqualTo(2);
        assertThat(parts.positions()[3 * n + 2]).isEqualTo(b.z(0));
        assertThat(parts.attachedNodes()).containsExactly(n + 3);
        assertThat(parts.attachedStiffnesses()).containsExactly(12);
    }

    @Test
    void surfacesThatTouchAreTiedAndThoseApartAreNot() {
        TriangleMesh one = DomeSheet.adult(6);
        int n = one.vertexCount();
        for (double gap : new double[] {4, 300}) {
            MassSpringBuilder parts = new MassSpringBuilder();
            TriangleMesh other = moved(one, gap);
            int first = parts.addNodes(one, new double[n]);
            int second = parts.addNodes(other, new double[n]);
            TieSprings.connect(parts, List.of(structure("a", one), structure("b", other)), List.of(first, second), 9);
            assertThat(parts.passiveSprings.count()).isEqualTo(gap < 10 ? n : 0);
            for (int e = 0; e < parts.passiveSprings.count(); e++) {
                assertThat(parts.passiveSprings.nodeA()[e]).isGreaterThanOrEqualTo(n);
                assertThat(parts.passiveSprings.nodeB()[e]).isLessThan(n);
                assertThat(parts.passiveSprings.rest()[e]).isBetween(0.5, 6.0);
            }
        }
    }

    @Test
    void structuresAreMeshedToABudgetSharedByArea() {
        Structure large = structure("large", DomeSheet.of(100, 100, 100, 10, 14, 0));
        Structure small = structure("small", DomeSheet.of(50, 50, 50, 10, 14, 0));
        List<Structure> meshed = Remeshing.toBudget(List.of(large, small), 1000);
        int a = meshed.get(0).mesh().vertexCount();
        int b = meshed.get(1).mesh().vertexCount();
        assertThat(a + b).isBetween(900, 1100);
        double areas = MeshMeasure.area(large.mesh()) / MeshMeasure.area(small.mesh());
        assertThat(a / (double) b).isBetween(0.8 * areas, 1.25 * areas);
        assertThat(Remeshing.toBudget(meshed, a + b)).as("already right").isSameAs(meshed);
    }
}
