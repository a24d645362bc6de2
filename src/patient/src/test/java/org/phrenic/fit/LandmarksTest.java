package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.CsvTable;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Points inside two boxes that stand for lungs, 100 mm apart. */
class LandmarksTest {
    private static final double[] FROM = {-45, 3, 20, -58, -12, 41, 52, 9, -15, 40, -20, 30};

    /** A shift of the patient on the table, with a turn by a quarter about z: (x, y) to (-y, x). */
    private static final RigidMotion TABLE =
            RigidMotion.of(new double[] {0, -1, 0, 1, 0, 0, 0, 0, 1}, new double[] {4, -20, 7});

    private static final List<TriangleMesh> REST = List.of(box(-50), box(50));

    @TempDir
    Path folder;

    /** A closed box of 40 x 60 x 100 mm. */
    private static TriangleMesh box(double x) {
        double[] p = new double[24];
        for (int i = 0; i < 8; i++) {
            p[3 * i] = x + ((i & 1) == 0 ? -20 : 20);
            p[3 * i + 1] = (i & 2) == 0 ? -30 : 30;
            p[3 * i + 2] = (i & 4) == 0 ? -50 : 50;
        }
        int[] t = {
            0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5
        };
        return new TriangleMesh(p, t);
    }

    /** A breath that is affine in each lung: both grow downward and forward, the left one shears as well. */
    private static double[] breathed(double[] points) {
        double[] out = points.clone();
        for (int i = 0; i < out.length; i += 3) {
            double shear = out[i] > 0 ? 0.2 : 0;
            double z = points[i + 2];
            out[i + 1] = 1.1 * points[i + 1] - 6 + shear * z;
            out[i + 2] = z - 0.4 * (50 - z);
        }
        return out;
    }

    private static Landmarks.Errors errors(double[] scanned, RigidMotion motion) {
        List<TriangleMesh> now =
                REST.stream().map(m -> m.withPositions(breathed(m.positions()))).toList();
        return new Landmarks(FROM, scanned, motion).errors(REST, now);
    }

    @Test
    void affineMotionIsCarriedExactlyAndTheTableShiftIsToldApart() {
        double[] scanned = breathed(FROM);
        TABLE.inverse().apply(scanned);
        Landmarks.Errors e = errors(scanned, TABLE);
        assertThat(e.bySurface().attached().mean()).isCloseTo(0, offset(1e-9));
        assertThat(e.shifts().outside()).isZero();
        assertThat(e.rigid().mean())
                .isCloseTo(
                        errors(breathed(FROM), RigidMotion.identity()).rigid().mean(), offset(1e-9));
        assertThat(e.scanned().mean()).isGreaterThan(e.rigid().mean() + 10);
        double[] byTable = new double[3];
        for (int i = 0; i < scanned.length; i++) {
            byTable[i % 3] += (breathed(FROM)[i] - scanned[i]) / 4;
        }
        assertThat(e.shifts().byAlignment()).containsExactly(byTable, offset(1e-9));
        // The solid slides along the surface: it carries points near to theirs, not onto them.
        assertThat(e.fitted().mean()).isBetween(0.5, 0.6 * e.rigid().mean());
        // Up: 0.4 (z - 50) for z = 20, 41, -15, 30.
        assertThat(e.shifts().left()[2]).isCloseTo(0.4 * (76 / 4.0 - 50), offset(1e-9));
        // The nearest surface is not where the point is: shear and stretch differ there.
        assertThat(e.bySurface().nearest().mean()).isBetween(0.5, e.rigid().mean());
    }

    @Test
    void anErrorThatAllPointsShareIsToldApart() {
        double[] scanned = breathed(FROM);
        for (int i = 1; i < scanned.length; i += 3) {
            scanned[i] -= 18;
        }
        Landmarks.Errors e = errors(scanned, RigidMotion.identity());
        assertThat(e.bySurface().attached().mean()).isCloseTo(18, offset(1e-9));
        assertThat(e.fittedLessMean().mean()).isLessThan(e.fitted().mean());
        assertThat(e.rigidLessMean().mean()).isLessThan(e.rigid().mean());
    }

    /** A triangle of a lung's lower end is left out, as at an airway. */
    @Test
    void pointsAreInsideALungWithAHoleAndCarriedByIt() {
        List<TriangleMesh> rest = REST.stream()
                .map(m -> new TriangleMesh(m.positions(), Arrays.copyOf(m.triangles(), m.triangles().length - 3)))
                .toList();
        List<TriangleMesh> now =
                rest.stream().map(m -> m.withPositions(breathed(m.positions()))).toList();
        Landmarks landmarks = new Landmarks(FROM, breathed(FROM), RigidMotion.identity());
        Landmarks.Errors e = landmarks.errors(rest, now);
        Landmarks.Errors closed = errors(breathed(FROM), RigidMotion.identity());
        assertThat(e.shifts().outside()).isZero();
        assertThat(e.bySurface().attached().mean()).isCloseTo(0, offset(1e-9));
        assertThat(e.fitted().mean()).isCloseTo(closed.fitted().mean(), offset(0.5));
        Landmarks.requireLungs(List.of(lung(rest.get(0)), lung(rest.get(1))));
    }

    @Test
    void aBodyWithoutLungsThatEnclosePointsIsRefused() {
        TriangleMesh front = new TriangleMesh(
                REST.get(0).positions(), Arrays.copyOf(REST.get(0).triangles(), 18));
        assertThatThrownBy(() -> Landmarks.requireLungs(List.of(lung(REST.get(1)), lung(front))))
                .isInstanceOf(BadInputException.class)
                .hasMessage("--landmarks: found an open surface for lung_R, expected lungs that enclose the points");
        assertThatThrownBy(() -> Landmarks.requireLungs(List.of()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found no lung in the body");
    }

    private static Surface lung(TriangleMesh mesh) {
        return new Surface("lung_R", StructureKind.LUNG, 0, Side.RIGHT, mesh, Surface.Motion.DEFORMING, new boolean[0]);
    }

    @Test
    void pairsAreWrittenInTheAxesOfTheBodyWithTheirLungs() {
        double[] scanned = FROM.clone();
        TABLE.inverse().apply(scanned);
        Path file = folder.resolve("landmarks.csv");
        List<Structure> lungs = List.of(
                new Structure("lung_R", StructureKind.LUNG, 0, Side.RIGHT, REST.get(0)),
                new Structure("lung_L", StructureKind.LUNG, 0, Side.LEFT, REST.get(1)));
        new Landmarks(FROM, scanned, TABLE).write(file, lungs);
        CsvTable table = CsvTable.read(file);
        assertThat(table.texts("structure")).containsExactly("lung_R", "lung_R", "lung_L", "lung_L");
        assertThat(FitTarget.points(table, FitTarget.FROM)).containsExactly(FROM);
        assertThat(FitTarget.points(table, FitTarget.TO)).containsExactly(FROM, offset(1e-9));
    }

    @Test
    void theAlignmentIsReadBesideTheTargets() throws IOException {
        Path target = folder.resolve("lung_R.vtp");
        assertThat(TargetAlignment.beside(List.of(target))).isSameAs(TargetAlignment.NONE);
        Files.writeString(
                folder.resolve("import.json"),
                """
                {"alignment": {"fixed_part": "the spine", "turn_deg": 90.0, "rotation": [0, -1, 0, 1, 0, 0, 0, 0, 1],
                "translation_mm": [4, -20, 7], "residual_rms_mm": 1.5, "inlier_residual_rms_mm": 0.5}}
                """);
        TargetAlignment read = TargetAlignment.beside(List.of(target, folder.resolve("lung_L.vtp")));
        assertThat(read.sentence())
                .contains("by the spine, turned by 90.00 deg")
                .contains("0.50 mm");
        assertThat(read.motion().apply(1, 2, 3)).containsExactly(TABLE.apply(1, 2, 3));
        Path elsewhere = folder.resolve("other/lung_L.vtp");
        assertThatThrownBy(() -> TargetAlignment.beside(List.of(target, elsewhere)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("aligned in different ways");
    }
}
