package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.TriangleMesh;

/** The virtual adult male in two scans: in the second he has breathed in and lies elsewhere. */
class ScanAlignmentTest {
    private static final double DESCENT_MM = 45;
    private static final double FORWARD_MM = 12;
    /** Vertebrae of two short scans. */
    private static final int FIRST_SHOWN = 4;

    private static final int SHOWN_VERTEBRAE = 6;
    private static Thorax male;

    @BeforeAll
    static void generate() {
        male = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
    }

    private static Thorax only(StructureKind kind) {
        return new Thorax("scan", male.structuresOf(kind), List.of());
    }

    /** Base down, front forward, sides outward; apex and what lies on the spine stay. */
    private static TriangleMesh inspired(TriangleMesh lung, double[] box) {
        double[] p = lung.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            double down = (box[5] - p[i + 2]) / (box[5] - box[2]);
            double front = (box[4] - p[i + 1]) / (box[4] - box[1]);
            double share = Math.max(0, (down - 0.4) / 0.6);
            p[i + 2] -= DESCENT_MM * share * share;
            p[i + 1] -= FORWARD_MM * front * front * down;
            p[i] += 0.05 * (p[i] - (box[0] + box[3]) / 2) * front;
        }
        return lung.withPositions(p);
    }

    private static RigidMotion elsewhere() {
        double angle = Math.toRadians(4);
        return RigidMotion.of(
                new double[] {1, 0, 0, 0, Math.cos(angle), -Math.sin(angle), 0, Math.sin(angle), Math.cos(angle)},
                new double[] {14, -22, 31});
    }

    private static Structure moved(Structure s, TriangleMesh mesh) {
        double[] p = mesh.positions().clone();
        elsewhere().apply(p);
        return s.withMesh(mesh.withPositions(p));
    }

    private static Thorax aligned(Thorax second, ScanAlignment alignment) {
        PointTransform motion = alignment.motion()::apply;
        return new Thorax(
                second.name(),
                second.structures().stream().map(s -> motion.apply(s)).toList(),
                second.notes());
    }

    @Test
    void ofLungsApexAndBackAreLaidTogetherWhateverTheBaseDoes() {
        Thorax first = only(StructureKind.LUNG);
        double[] box = LungDistances.lung(first, org.phrenic.anatomy.Side.RIGHT)
                .orElseThrow()
                .bounds();
        Thorax second = new Thorax(
                "scan",
                first.structures().stream()
                        .map(s -> moved(s, inspired(s.mesh(), box)))
                        .toList(),
                List.of());
        ScanAlignment alignment = ScanAlignment.of(first, second);
        assertThat(alignment.fixedPart()).isEqualTo(ScanAlignment.FixedPart.LUNGS);
        RigidMotion left = alignment.motion().after(elsewhere());
        // What is left to do, at the middle of the lungs: a millimetre and a degree, of 45 mm that the base went.
        double[] middle = {(box[0] + box[3]) / 2, (box[1] + box[4]) / 2, (box[2] + box[5]) / 2};
        double[] to = left.apply(middle[0], middle[1], middle[2]);
        assertThat(Math.hypot(Math.hypot(to[0] - middle[0], to[1] - middle[1]), to[2] - middle[2]))
                .isLessThan(1.5);
        assertThat(Math.toDegrees(HelicalAxis.of(left).angle())).isLessThan(1);
        assertThat(alignment.inlierResidual().rms()).isLessThan(0.7);
        Thorax breathed = new Thorax(
                "breathed",
                first.structures().stream()
                        .map(s -> s.withMesh(inspired(s.mesh(), box)))
                        .toList(),
                List.of());
        LungDistances found =
                LungDistances.between(first, aligned(second, alignment)).get("both");
        LungDistances truth = LungDistances.between(first, breathed).get("both");
        assertThat(found.base().mean()).isCloseTo(truth.base().mean(), within(1.0));
        assertThat(found.whole().mean()).isCloseTo(truth.whole().mean(), within(0.5));
    }

    @Test
    void whereBothScansHaveASpineItAloneCounts() {
        List<Structure> spine =
                male.structuresOf(StructureKind.VERTEBRA).subList(FIRST_SHOWN, FIRST_SHOWN + SHOWN_VERTEBRAE);
        Thorax first = new Thorax("scan", spine, List.of());
        Thorax second =
                new Thorax("scan", spine.stream().map(s -> moved(s, s.mesh())).toList(), List.of());
        ScanAlignment alignment = ScanAlignment.of(first, second);
        assertThat(alignment.fixedPart()).isEqualTo(ScanAlignment.FixedPart.SPINE);
        assertThat(alignment.residual().maximum()).isLessThan(0.01);
        assertThat(alignment.rotationDeg()).isCloseTo(4, within(0.01));
    }

    @Test
    void scansThatShareNothingFixedAreRefused() {
        assertThatThrownBy(() -> ScanAlignment.of(only(StructureKind.LUNG), only(StructureKind.LIVER)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("neither two vertebrae nor a lung");
    }

    /** The first body was completed from its lungs: its spine is a template's, 20 mm in front of the patient's. */
    @Test
    void aSpineThatTheFirstScanDoesNotShowIsNotAlignedTo() {
        List<Structure> completed = new ArrayList<>(male.structuresOf(StructureKind.LUNG));
        Set<String> virtual = new HashSet<>();
        for (Structure vertebra : male.structuresOf(StructureKind.VERTEBRA)) {
            double[] p = vertebra.mesh().positions().clone();
            for (int i = 1; i < p.length; i += 3) {
                p[i] -= 20;
            }
            completed.add(vertebra.withMesh(vertebra.mesh().withPositions(p)));
            virtual.add(vertebra.name());
        }
        Thorax first = new Thorax("first", completed, List.of(), virtual);
        List<Structure> seen =
                male.structures().stream().map(s -> moved(s, s.mesh())).toList();
        ScanAlignment alignment = ScanAlignment.of(first, new Thorax("second", seen, List.of()));
        assertThat(alignment.sentence("first")).doesNotContain("spine");
        double[] p = {0, 0, 0};
        elsewhere().apply(p);
        alignment.motion().apply(p);
        assertThat(p).containsExactly(new double[3], within(0.5));
    }
}
