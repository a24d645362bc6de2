package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.mesh.query.SurfaceDistance;
import org.phrenic.mesh.voxel.CutPlane;

/**
 * The organ is a sphere with a radius of 50 mm about the origin, which a scan cuts off at a height of 10 mm. The
 * template is a sphere of 46 mm whose lower half is drawn down to -74 mm.
 */
class OrganExtensionTest {
    private static final double RADIUS_MM = 50;
    private static final double TEMPLATE_MM = 46;
    private static final double END_MM = 10;
    /** Depth below the end of the scan from which on the surface is the scan's alone, mm. */
    private static final double BAND_MM = 20;
    /** Half a cell of the grid, in which the surface is meshed. */
    private static final double HALF_CELL_MM = 1;

    private static final TriangleMesh SCAN = cutOff(Shapes.sphere(RADIUS_MM, 4));
    private static final TriangleMesh TEMPLATE = drawnDown(Shapes.sphere(TEMPLATE_MM, 4));

    private static TriangleMesh cutOff(TriangleMesh whole) {
        double[] p = whole.positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] = Math.min(p[i], END_MM);
        }
        return whole.withPositions(p);
    }

    private static TriangleMesh drawnDown(TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] *= p[i] < 0 ? 74 / TEMPLATE_MM : 1;
        }
        return mesh.withPositions(p);
    }

    private static TriangleMesh raised(TriangleMesh mesh, double mm) {
        double[] p = mesh.positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] += mm;
        }
        return mesh.withPositions(p);
    }

    /** The organ as the scan shows it, moved up since. */
    private static PatientStructure organ(List<CutPlane> ends, double raisedMm) {
        return organ(SCAN, ends, raisedMm);
    }

    private static PatientStructure organ(TriangleMesh scan, List<CutPlane> ends, double raisedMm) {
        MeshedSegment meshed = new MeshedSegment(scan, 0, 0, DistanceSummary.NONE, MeshQuality.of(scan), 0.2, 1, 0);
        return PatientStructure.ofScan(
                new Structure("lung_R", StructureKind.LUNG, 0, Side.RIGHT, raised(scan, raisedMm)),
                new PatientStructure.Scan(List.of(1), 1000, 1000, ends, meshed));
    }

    private static List<CutPlane> end() {
        return List.of(new CutPlane("S", 0, 0, 1, END_MM));
    }

    private static double radius(TriangleMesh mesh, int v) {
        return Math.sqrt(mesh.x(v) * mesh.x(v) + mesh.y(v) * mesh.y(v) + mesh.z(v) * mesh.z(v));
    }

    @Test
    void theSurfaceIsTheScansBelowTheEndOfTheScanAndTheTemplatesBeyond() {
        TriangleMesh whole = OrganExtension.extended(organ(end(), 0), TEMPLATE);
        MeshTopology topology = new MeshTopology(whole);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        SurfaceDistance scan = new SurfaceDistance(SCAN);
        for (int v = 0; v < whole.vertexCount(); v++) {
            double r = radius(whole, v);
            if (whole.z(v) < END_MM - BAND_MM) {
                double[] at = {whole.x(v), whole.y(v), whole.z(v)};
                assertThat(scan.unsignedDistance(at)[0]).isCloseTo(0, within(1e-9));
            } else if (whole.z(v) > END_MM) {
                assertThat(r).isCloseTo(TEMPLATE_MM, within(HALF_CELL_MM));
            } else {
                assertThat(r).isBetween(TEMPLATE_MM - HALF_CELL_MM, RADIUS_MM + HALF_CELL_MM);
            }
        }
        assertThat(whole.bounds()[2]).as("the lower end").isCloseTo(-RADIUS_MM, within(HALF_CELL_MM));
        assertThat(whole.bounds()[5]).as("the upper end").isCloseTo(TEMPLATE_MM, within(HALF_CELL_MM));
    }

    /** Between the two spheres the surface goes over from one to the other: at half the band it lies half way. */
    @Test
    void theSurfaceGoesOverFromTheScanToTheTemplateWithoutAStep() {
        TriangleMesh whole = OrganExtension.extended(organ(end(), 0), TEMPLATE);
        double sum = 0;
        int count = 0;
        for (int v = 0; v < whole.vertexCount(); v++) {
            if (Math.abs(whole.z(v) - END_MM + BAND_MM / 2) < 2) {
                sum += radius(whole, v);
                count++;
            }
        }
        assertThat(count).isGreaterThan(20);
        assertThat(sum / count).isCloseTo((RADIUS_MM + TEMPLATE_MM) / 2, within(0.7));
    }

    /** An organ that has been brought to end-expiration is cut off where the scan cut it. */
    @Test
    void theEndOfTheScanMovesWithTheOrgan() {
        TriangleMesh still = OrganExtension.extended(organ(end(), 0), TEMPLATE);
        TriangleMesh moved = OrganExtension.extended(organ(end(), 30), raised(TEMPLATE, 30));
        assertThat(SurfaceComparison.of(raised(moved, -30), still).byArea().maximum())
                .isLessThan(0.5);
    }

    /** A second piece, 30 mm below the one that is cut off; of the template a part lies apart beyond the end. */
    @Test
    void aPieceOfTheScanThatLiesApartIsKept() {
        for (double radius : new double[] {20, 60}) {
            TriangleMesh piece = raised(Shapes.sphere(radius, 4), -RADIUS_MM - 30 - radius);
            TriangleMesh beyond = raised(Shapes.sphere(20, 4), 80);
            TriangleMesh whole = OrganExtension.extended(
                    organ(MeshMerge.merge(List.of(piece, SCAN)), end(), 0), MeshMerge.merge(List.of(TEMPLATE, beyond)));
            assertThat(ConnectedComponents.of(whole)).hasSize(2);
            assertThat(whole.bounds()[2]).isCloseTo(-RADIUS_MM - 30 - 2 * radius, within(HALF_CELL_MM));
            assertThat(whole.bounds()[5]).isCloseTo(TEMPLATE_MM, within(HALF_CELL_MM));
        }
    }

    /** A sphere of 7 ml beside the template's 530 ml, as the end of a thin recess. */
    @Test
    void aSmallPartThatLiesApartIsLeftOut() {
        TriangleMesh part = raised(Shapes.sphere(12, 4), -RADIUS_MM - 30);
        TriangleMesh whole = OrganExtension.extended(organ(MeshMerge.merge(List.of(part, SCAN)), end(), 0), TEMPLATE);
        assertThat(ConnectedComponents.of(whole)).hasSize(1);
    }

    @Test
    void anOrganThatIsNotCutOffIsRefused() {
        assertThatThrownBy(() -> OrganExtension.extended(organ(List.of(), 0), TEMPLATE))
                .hasMessageContaining("lung_R is whole");
    }
}
