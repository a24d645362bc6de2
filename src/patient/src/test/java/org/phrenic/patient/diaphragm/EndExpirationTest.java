package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.LungAboveFluid;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SelfIntersections;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** The virtual man, and the same with lungs that reach farther down and a lower liver, as at inspiration. */
class EndExpirationTest {
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
    /** Heights of the lungs of the inspired body as a multiple of those at end-expiration. */
    private static final double TALLER = 1.3;

    static final PatientBody INSPIRED = body(true, s -> true);
    static final BreathLevel LEVEL = level(INSPIRED).orElseThrow();
    private static final RaisedBody RAISED = EndExpiration.of(INSPIRED, INSPIRED, LEVEL);
    private static final PatientBody RESTING = RAISED.body();

    private static PatientBody body(boolean inspired, Predicate<Structure> kept) {
        double apex = MAN.structuresOf(StructureKind.LUNG).stream()
                .mapToDouble(s -> s.mesh().bounds()[5])
                .max()
                .orElseThrow();
        List<PatientStructure> all = MAN.structures().stream()
                .filter(kept)
                .map(s -> inspired ? lowered(s, apex) : s)
                .map(s -> new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        return new PatientBody("patient", all, List.of(), List.of());
    }

    private static Structure lowered(Structure s, double apex) {
        if (s.kind() != StructureKind.LUNG && s.kind() != StructureKind.LIVER) {
            return s;
        }
        double[] p = s.mesh().positions().clone();
        double down = (TALLER - 1) * (apex - s.mesh().bounds()[5]);
        for (int i = 2; i < p.length; i += 3) {
            p[i] = s.kind() == StructureKind.LUNG ? apex - TALLER * (apex - p[i]) : p[i] - down;
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    private static Optional<BreathLevel> level(PatientBody body) {
        return BreathLevel.of(body, body);
    }

    private static TriangleMesh mesh(PatientBody body, String name) {
        return body.structure(name).orElseThrow().structure().mesh();
    }

    private static double lungMl(PatientBody body) {
        return (MeshMeasure.signedVolume(mesh(body, "lung_R")) + MeshMeasure.signedVolume(mesh(body, "lung_L"))) / 1000;
    }

    @Test
    void theVirtualManIsAtEndExpiration() {
        BreathLevel level = level(body(false, s -> true)).orElseThrow();
        assertThat(level.right()).isCloseTo(8, within(0.5));
        assertThat(level.left()).isCloseTo(9, within(0.6));
        assertThat(level.isInspired()).isFalse();
    }

    @Test
    void lowDomesTellAnInspiration() {
        assertThat(LEVEL.isInspired()).isTrue();
        assertThat(LEVEL.right()).isBetween(9.5, 11.0);
        assertThat(LEVEL.descentMm()).isBetween(35.0, 60.0);
        assertThat(LEVEL.stated())
                .matches(
                        "the domes at T\\d+\\.\\d on the right and T\\d+\\.\\d on the left \\(T8 and T9 at end-expiration\\)");
    }

    /** Of the lungs only the lower borders are in the scan. */
    private static PatientBody cutBelowTheDomes(PatientBody body) {
        List<PatientStructure> cut = body.structures().stream()
                .map(s -> s.structure().kind() == StructureKind.LUNG ? lowest(s) : s)
                .toList();
        return new PatientBody("patient", cut, List.of(), List.of());
    }

    private static PatientStructure lowest(PatientStructure lung) {
        TriangleMesh mesh = lung.structure().mesh();
        double[] p = mesh.positions().clone();
        double bottom = mesh.bounds()[2];
        for (int i = 2; i < p.length; i += 3) {
            p[i] = Math.min(p[i], bottom + 20);
        }
        return lung.withStructure(lung.structure().withMesh(mesh.withPositions(p)));
    }

    @Test
    void aScanThatEndsBelowTheDomesTellsItsLevelByTheLowerBordersOfTheLungs() {
        BreathLevel resting = BreathLevel.of(cutBelowTheDomes(body(false, s -> true)), body(false, s -> true))
                .orElseThrow();
        assertThat(resting.mark()).isEqualTo(BreathLevel.Mark.LOWER_BORDERS);
        assertThat(resting.isInspired()).isFalse();
        BreathLevel inspired =
                BreathLevel.of(cutBelowTheDomes(INSPIRED), INSPIRED).orElseThrow();
        assertThat(inspired.isInspired()).isTrue();
        assertThat(inspired.descentMm()).isBetween(25.0, 100.0);
        assertThat(inspired.stated()).startsWith("the lower borders of the lungs at ");
    }

    /** The lungs are cut off so far above their lower ends and flat there. */
    private static PatientBody cutOff(PatientBody body, double heightMm) {
        List<PatientStructure> cut = body.structures().stream()
                .map(s -> s.structure().kind() == StructureKind.LUNG ? cutOff(s.structure(), heightMm) : s)
                .toList();
        return new PatientBody("patient", cut, List.of(), List.of());
    }

    private static PatientStructure cutOff(Structure lung, double heightMm) {
        double[] p = lung.mesh().positions().clone();
        double bottom = lung.mesh().bounds()[2];
        for (int i = 2; i < p.length; i += 3) {
            p[i] = Math.max(p[i], bottom + heightMm);
        }
        var scan = new PatientStructure.Scan(
                List.of(1), 1, 1, List.of(new CutPlane("I", 0, 0, -1, -bottom - heightMm)), null);
        return new PatientStructure(
                lung.withMesh(lung.mesh().withPositions(p)),
                PatientStructure.Source.SCAN,
                Optional.of(scan),
                Optional.empty());
    }

    @Test
    void aScanThatEndsInTheRecessShowsTheDomesAndOneThatEndsAtThemDoesNot() {
        BreathLevel level = BreathLevel.of(cutOff(INSPIRED, 25), INSPIRED).orElseThrow();
        assertThat(level.mark()).isEqualTo(BreathLevel.Mark.DOMES);
        assertThat(level.right()).isCloseTo(LEVEL.right(), within(0.2));
        assertThat(level.left()).isCloseTo(LEVEL.left(), within(0.2));
        PatientBody noLiver = body(true, s -> s.kind() != StructureKind.LIVER);
        assertThat(BreathLevel.of(cutOff(noLiver, 95), noLiver)).isEmpty();
    }

    /** The top of the liver in the last slices of a scan that ends at the domes. */
    @Test
    void theLiverTellsTheRightDomeWhereTheScanCutsTheLungsOff() {
        BreathLevel level = BreathLevel.of(cutOff(INSPIRED, 95), INSPIRED).orElseThrow();
        assertThat(level.mark()).isEqualTo(BreathLevel.Mark.DOMES);
        assertThat(level.right()).isCloseTo(LEVEL.right(), within(0.6));
        assertThat(level.left()).isNaN();
        PatientBody resting = body(false, s -> true);
        assertThat(BreathLevel.of(cutOff(resting, 95), resting).filter(BreathLevel::isInspired))
                .isEmpty();
    }

    @Test
    void lungsThatAreCutOffBelowTheirLowerBorderAtRestTellAnInspirationWithoutDomes() {
        PatientBody low = new PatientBody(
                "patient",
                INSPIRED.structures().stream()
                        .filter(s -> s.structure().kind() != StructureKind.LIVER)
                        .map(s -> s.structure().kind() == StructureKind.LUNG
                                ? s.withStructure(moved(s.structure(), -40))
                                : s)
                        .toList(),
                List.of(),
                List.of());
        BreathLevel level = BreathLevel.of(cutOff(low, 60), low).orElseThrow();
        assertThat(level.mark()).isEqualTo(BreathLevel.Mark.LOWER_BORDERS);
        assertThat(level.isInspired()).isTrue();
        double cutZ = mesh(cutOff(low, 60), "lung_R").bounds()[2];
        TriangleMesh vertebra = mesh(low, String.format(Locale.ROOT, "vertebra_T%02d", Math.round(level.right())));
        assertThat(cutZ).isBetween(vertebra.bounds()[2], vertebra.bounds()[5]);
    }

    private static Structure moved(Structure s, double dz) {
        double[] p = s.mesh().positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] += dz;
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    /** A body of which the scan shows the lungs alone: the rest comes from a template. */
    private static PatientBody completed(boolean inspired) {
        List<PatientStructure> all = body(inspired, s -> true).structures().stream()
                .map(s -> s.structure().kind() == StructureKind.LUNG
                        ? s
                        : new PatientStructure(
                                s.structure(), PatientStructure.Source.VIRTUAL, Optional.empty(), Optional.empty()))
                .toList();
        return new PatientBody("patient", all, List.of(), List.of());
    }

    @Test
    void ofLungsAloneTheLevelIsToldByTheirShapeIfTheyAreInspired() {
        PatientBody lungs = body(true, s -> s.kind() == StructureKind.LUNG);
        BreathLevel level = BreathLevel.of(lungs, completed(true)).orElseThrow();
        assertThat(level.mark()).isEqualTo(BreathLevel.Mark.SHAPE);
        assertThat(level.share()).isCloseTo(LEVEL.share(), within(1e-9));
        assertThat(level.stated()).contains("by the shape of the lungs alone, at T");
        assertThat(BreathLevel.of(body(false, s -> s.kind() == StructureKind.LUNG), completed(false)))
                .isEmpty();
        PatientBody one = body(true, s -> s.name().equals("lung_R"));
        assertThat(BreathLevel.of(one, completed(true))).isEmpty();
        assertThat(BreathLevel.of(cutOff(lungs, 25), completed(true))).isEmpty();
    }

    /** The right lung of a body with fluid ends far above the liver, whose roof tells the dome. */
    @Test
    void aLevelThatIsReadOffTheOrgansBelowALungSaysSo() {
        PatientBody fluid = new PatientBody(
                "patient",
                LungAboveFluid.in(body(false, s -> true).thorax()).structures().stream()
                        .map(s -> new PatientStructure(
                                s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                        .toList(),
                List.of(),
                List.of());
        BreathLevel level = level(fluid).orElseThrow();
        assertThat(level.mark()).isEqualTo(BreathLevel.Mark.ORGANS);
        assertThat(level.right()).isCloseTo(8, within(0.7));
        assertThat(level.stated()).startsWith("the domes, by the organs below a lung that ends far above them, at T");
    }

    @Test
    void nothingIsSaidOfTheLevelWithoutBonesOrBasesOfLungsOrALiver() {
        assertThat(level(body(true, s -> s.kind() == StructureKind.LUNG))).isEmpty();
        assertThat(level(body(true, s -> s.kind() != StructureKind.LUNG && s.kind() != StructureKind.LIVER)))
                .isEmpty();
    }

    @Test
    void withoutLungsTheLiverTellsTheLevelAndRisesWithIt() {
        PatientBody scan = body(true, s -> s.kind() != StructureKind.LUNG);
        BreathLevel level = level(scan).orElseThrow();
        assertThat(level.mark()).isEqualTo(BreathLevel.Mark.LIVER);
        assertThat(level.share()).isCloseTo(LEVEL.share(), within(0.2));
        assertThat(level(body(false, s -> s.kind() != StructureKind.LUNG))
                        .orElseThrow()
                        .isInspired())
                .isFalse();
        RaisedBody raised = EndExpiration.of(scan, completed(true), level);
        assertThat(mesh(raised.body(), "liver").bounds()[5]
                        - mesh(scan, "liver").bounds()[5])
                .isCloseTo(level.descentMm(), within(12.0));
        assertThat(raised.body().notes().get(0))
                .contains("the top of the liver at T")
                .doesNotContain("deflated");
    }

    @Test
    void domesRiseToTheirLevelAndLungsDeflate() {
        BreathLevel level = level(RESTING).orElseThrow();
        assertThat(level.descentMm()).as("left of the descent, mm").isCloseTo(0, within(7.0));
        assertThat(lungMl(RESTING)).isBetween(0.5 * lungMl(INSPIRED), 0.8 * lungMl(INSPIRED));
        for (String lung : new String[] {"lung_R", "lung_L"}) {
            double apex = mesh(INSPIRED, lung).bounds()[5];
            assertThat(mesh(RESTING, lung).bounds()[5]).as("apex").isCloseTo(apex, within(3.0));
            assertThat(SelfIntersections.count(mesh(RESTING, lung))).isZero();
        }
    }

    /** Domes at the middle of the second lumbar vertebra, as flat ones of emphysema, would rise by more than 100 mm. */
    @Test
    void whatDomesThatStayBelowEndExpirationHaveRisenIsStated() {
        double perVertebra = LEVEL.descentMm() / LEVEL.descent();
        BreathLevel flat = new BreathLevel(BreathLevel.Mark.DOMES, 14, 14, 5.5, 1, 5.5 * perVertebra);
        RaisedBody raised = EndExpiration.of(INSPIRED, INSPIRED, flat);
        double left = level(raised.body()).orElseThrow().descentMm();
        assertThat(raised.domesMm()).isBetween(50.0, 100.0).isCloseTo(LEVEL.descentMm() - left, within(25.0));
        assertThat(raised.body().notes()).singleElement().satisfies(note -> assertThat(note)
                .contains(
                        String.format(Locale.ROOT, "the domes are raised by %.0f mm", raised.domesMm()),
                        String.format(Locale.ROOT, "stay %.0f mm below", flat.descentMm() - raised.domesMm())));
        assertThat(RAISED.domesMm()).isEqualTo(LEVEL.descentMm());
        assertThat(RESTING.notes()).noneMatch(note -> note.contains("below end-expiration"));
    }

    /** A small organ at a place. */
    private static PatientStructure marker(String name, double x, double y, double z) {
        double[] p = {x, y, z, x + 1, y, z, x, y + 1, z, x, y, z + 1};
        TriangleMesh mesh = new TriangleMesh(p, new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3});
        Structure organ = new Structure(name, StructureKind.ORGAN, 0, Side.MIDLINE, mesh);
        return new PatientStructure(organ, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty());
    }

    @Test
    void nothingBesideTheDomesStaysMoreThanAVertebraBehindThem() {
        double[] cage = mesh(INSPIRED, "lung_R").bounds();
        double middle = 0.5 * (cage[1] + cage[4]);
        double z = mesh(INSPIRED, "liver").bounds()[5];
        List<PatientStructure> marked = new ArrayList<>(INSPIRED.structures());
        marked.add(marker("dome", cage[0] + 0.3 * (cage[3] - cage[0]), cage[4] - 20, z));
        marked.add(marker("midline", 0, middle, z));
        marked.add(marker("front", 0, cage[1] + 10, z));
        double perVertebra = LEVEL.descentMm() / LEVEL.descent();
        BreathLevel full = new BreathLevel(BreathLevel.Mark.DOMES, 11.5, 12, 3.25, 1, 3.25 * perVertebra);
        PatientBody raised = EndExpiration.of(new PatientBody("patient", marked, List.of(), List.of()), INSPIRED, full)
                .body();
        double dome = mesh(raised, "dome").bounds()[2] - z;
        assertThat(dome).isGreaterThan(2 * perVertebra);
        for (String place : List.of("midline", "front")) {
            double lag = dome - (mesh(raised, place).bounds()[2] - z);
            assertThat(lag).as(place + " behind the domes, mm").isBetween(10.0, perVertebra);
        }
    }

    @Test
    void organsRiseWithTheDomesAndKeepTheirVolume() {
        TriangleMesh before = mesh(INSPIRED, "liver");
        TriangleMesh after = mesh(RESTING, "liver");
        assertThat(after.bounds()[5] - before.bounds()[5]).isBetween(0.7 * LEVEL.descentMm(), 1.5 * LEVEL.descentMm());
        assertThat(MeshMeasure.signedVolume(after))
                .isCloseTo(MeshMeasure.signedVolume(before), within(0.05 * MeshMeasure.signedVolume(before)));
        assertThat(SelfIntersections.count(after)).isZero();
    }

    @Test
    void ribsAndSternumGoDownAndBackAndTheSpineStays() {
        for (String rib : new String[] {"rib_03_R", "rib_07_L", "sternum_body"}) {
            double[] before = mesh(INSPIRED, rib).bounds();
            double[] after = mesh(RESTING, rib).bounds();
            assertThat(after[2] - before[2]).as(rib + " down, mm").isBetween(-35.0, -3.0);
            assertThat(after[1] - before[1]).as(rib + " back, mm").isBetween(0.5, 20.0);
        }
        assertThat(mesh(RESTING, "vertebra_T08").positions())
                .isEqualTo(mesh(INSPIRED, "vertebra_T08").positions());
        assertThat(RESTING.structures()).noneMatch(s -> s.structure().kind() == StructureKind.DIAPHRAGM);
        assertThat(RESTING.notes()).anyMatch(note -> note.startsWith("the scan is one at inspiration"));
    }
}
