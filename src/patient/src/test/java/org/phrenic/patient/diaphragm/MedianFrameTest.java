package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** The virtual woman lies turned on the table and bent to her left. */
class MedianFrameTest {
    private static final Thorax WOMAN = VirtualThorax.ofPreset("adult-female", Resolution.LOW);

    /** A turn about the long axis, then one about the axis from back to front. */
    private static RigidMotion turn(double yawDeg, double rollDeg) {
        double a = Math.toRadians(yawDeg);
        double b = Math.toRadians(rollDeg);
        RigidMotion yaw = RigidMotion.of(
                new double[] {Math.cos(a), -Math.sin(a), 0, Math.sin(a), Math.cos(a), 0, 0, 0, 1}, new double[3]);
        RigidMotion roll = RigidMotion.of(
                new double[] {Math.cos(b), 0, Math.sin(b), 0, 1, 0, -Math.sin(b), 0, Math.cos(b)}, new double[3]);
        return roll.after(yaw);
    }

    private static TriangleMesh moved(TriangleMesh mesh, RigidMotion motion) {
        double[] p = mesh.positions().clone();
        motion.apply(p);
        return mesh.withPositions(p);
    }

    /** The woman without her diaphragm. */
    private static PatientBody woman(RigidMotion motion) {
        List<PatientStructure> structures = WOMAN.structures().stream()
                .filter(s -> s.kind() != StructureKind.DIAPHRAGM)
                .map(s -> s.withMesh(moved(s.mesh(), motion)))
                .map(s -> new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        return new PatientBody("woman", structures, List.of(), List.of());
    }

    private static TriangleMesh sheet(PatientBody body) {
        return DiaphragmCompletion.complete(body, false)
                .structure("diaphragm")
                .orElseThrow()
                .structure()
                .mesh();
    }

    @Test
    void aStraightBodyIsItsOwnFrame() {
        PatientBody straight = woman(turn(2, 1));
        assertThat(MedianFrame.of(straight.thorax()).isStraight()).isTrue();
    }

    @Test
    void theFrameTakesTheTurnBackAndReturnsToTheScan() {
        PatientBody turned = woman(turn(12, 8));
        MedianFrame frame = MedianFrame.of(turned.thorax());
        PatientBody upright = turned.withEach(frame::toFrame);
        TriangleMesh right =
                upright.structure("rib_07_R").orElseThrow().structure().mesh();
        TriangleMesh left =
                upright.structure("rib_07_L").orElseThrow().structure().mesh();
        assertThat(left.centre()[1] - right.centre()[1]).isBetween(-0.5, 0.5);
        assertThat(left.centre()[2] - right.centre()[2]).isBetween(-0.5, 0.5);
        TriangleMesh back = upright.withEach(frame::toScan)
                .structure("rib_07_R")
                .orElseThrow()
                .structure()
                .mesh();
        TriangleMesh before =
                turned.structure("rib_07_R").orElseThrow().structure().mesh();
        assertThat(SurfaceComparison.of(back, before).byArea().maximum()).isLessThan(1e-9);
    }

    /** Built along the axes of the scan, the two sheets are 0.7 mm apart on the mean. */
    @Test
    void theSheetOfATurnedBodyIsTheTurnedSheet() {
        RigidMotion turn = turn(12, 8);
        DistanceSummary off = SurfaceComparison.of(
                        moved(sheet(woman(RigidMotion.identity())), turn), sheet(woman(turn)))
                .byArea();
        assertThat(off.mean()).isLessThan(0.3);
        assertThat(off.percentile95()).isLessThan(1);
    }
}
