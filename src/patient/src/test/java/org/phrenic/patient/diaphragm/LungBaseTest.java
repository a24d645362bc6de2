package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;

class LungBaseTest {
    private static final List<Structure> LUNGS =
            VirtualThorax.ofPreset("adult-male", Resolution.LOW).structuresOf(StructureKind.LUNG);

    /** Right and left. */
    private static List<LungBase> bases(List<Structure> lungs) {
        return LungBase.of(new Thorax("lungs", lungs, List.of()));
    }

    /** What lies below a height is so many times as far below it. */
    private static Structure stretched(Structure lung, double height, double times) {
        double[] p = lung.mesh().positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] = p[i] < height ? height + times * (p[i] - height) : p[i];
        }
        return lung.withMesh(lung.mesh().withPositions(p));
    }

    /** At end-expiration the base is level: its dome is its top. */
    @Test
    void theDomeOfALevelBaseIsItsTop() {
        assertThat(bases(LUNGS)).hasSize(2).allSatisfy(base -> assertThat(base.dome())
                .isCloseTo(base.top(), within(5.0)));
    }

    /** Lungs that reach twice as far down around their domes, as at inspiration, have the same domes. */
    @Test
    void theDomeDoesNotFollowTheLowerBorder() {
        for (int side = 0; side < 2; side++) {
            double dome = bases(LUNGS).get(side).dome();
            List<Structure> steep =
                    LUNGS.stream().map(s -> stretched(s, dome, 2)).toList();
            assertThat(bases(steep).get(side).dome()).isCloseTo(dome, within(3.0));
        }
    }

    /** A lung whose points lie so many times as far below its apex. */
    private static Structure shortened(Structure lung, double times) {
        return stretched(lung, lung.mesh().bounds()[5], times);
    }

    private static Thorax body(Side side, double times) {
        return new Thorax(
                "lungs",
                LUNGS.stream()
                        .map(s -> s.side() == side ? shortened(s, times) : s)
                        .toList(),
                List.of());
    }

    /** A third of a lung is fluid or has no label, and no organ below tells that the diaphragm is lower. */
    @Test
    void aBaseFarAboveThatOfTheOtherLungDoesNotLieOnTheDiaphragm() {
        List<LungBase> whole = bases(LUNGS);
        for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
            Thorax fluid = body(side, 0.65);
            assertThat(UnequalBases.parted(fluid, LungBase.of(fluid))).contains(side);
            List<LungBase> parted = UnequalBases.of(fluid, Optional.of(side));
            int at = side == Side.RIGHT ? 0 : 1;
            assertThat(parted.get(at).liesOnDiaphragm()).isFalse();
            assertThat(parted.get(at).dome())
                    .as("dome beside the other one, mm")
                    .isCloseTo(whole.get(at).dome(), within(10.0));
            assertThat(parted.get(at).note()).hasValueSatisfying(note -> assertThat(note)
                    .contains(at == 0 ? "the right lung" : "the left lung", "beside the other", "paresis"));
            assertThat(parted.get(1 - at).note()).isEmpty();
            assertThat(parted.get(1 - at).dome()).isEqualTo(whole.get(1 - at).dome());
        }
    }

    @Test
    void domesThatDifferAsThoseOfPeopleLieOnTheDiaphragm() {
        assertThat(UnequalBases.parted(body(Side.LEFT, 1), bases(LUNGS))).isEmpty();
        for (Side side : new Side[] {Side.RIGHT, Side.LEFT}) {
            Thorax raised = body(side, 0.9);
            assertThat(UnequalBases.parted(raised, LungBase.of(raised))).isEmpty();
        }
    }

    /** A stomach below the left lung, which has risen with half of the diaphragm. */
    @Test
    void aBaseFarAboveThatOfTheOtherLungLiesOnTheDiaphragmIfAnOrganIsBelow() {
        Thorax high = body(Side.LEFT, 0.65);
        List<Structure> all = new ArrayList<>(high.structures());
        all.add(below(high, Side.LEFT, StructureKind.ORGAN, "stomach", 5));
        Thorax risen = new Thorax("stomach", all, List.of());
        assertThat(UnequalBases.parted(risen, LungBase.of(risen))).isEmpty();
    }

    /** A ball as broad as a lung, so far below its dome. */
    private static Structure below(Thorax body, Side side, StructureKind kind, String name, double gapMm) {
        double[] box = body.structures().stream()
                .filter(s -> s.side() == side)
                .findFirst()
                .orElseThrow()
                .mesh()
                .bounds();
        double radius = 0.5 * (box[3] - box[0]);
        double dome = LungBase.of(body).get(side == Side.RIGHT ? 0 : 1).dome();
        TriangleMesh ball =
                Shapes.moved(Shapes.sphere(radius, 4), box[0] + radius, 0.5 * (box[1] + box[4]), dome - radius - gapMm);
        return new Structure(name, kind, 0, Side.MIDLINE, ball);
    }

    /** The lungs with organs so far below their domes. */
    private static List<Structure> above(Structure... organs) {
        List<Structure> all = new ArrayList<>(LUNGS);
        all.addAll(List.of(organs));
        return all;
    }

    /** The bases of a template's lungs above organs of a scan. */
    private static List<LungBase> ofTemplate(Structure... organs) {
        Thorax body = new Thorax("completed", above(organs), List.of(), Set.of("lung_R", "lung_L"));
        return UnequalBases.of(body, Optional.empty());
    }

    private static Structure liver(double gapMm) {
        return below(new Thorax("lungs", LUNGS, List.of()), Side.RIGHT, StructureKind.LIVER, "liver", gapMm);
    }

    private static Structure stomach(Side side, double gapMm) {
        return below(new Thorax("lungs", LUNGS, List.of()), side, StructureKind.ORGAN, "stomach", gapMm);
    }

    /** A ball below a small part of the left base. */
    private static Structure spleen() {
        double[] box = LUNGS.stream()
                .filter(s -> s.side() == Side.LEFT)
                .findFirst()
                .orElseThrow()
                .mesh()
                .bounds();
        double radius = 0.15 * (box[3] - box[0]);
        TriangleMesh ball = Shapes.moved(
                Shapes.sphere(radius, 4),
                0.5 * (box[0] + box[3]),
                0.5 * (box[1] + box[4]),
                bases(LUNGS).get(1).dome() - radius - 5);
        return new Structure("spleen", StructureKind.ORGAN, 0, Side.MIDLINE, ball);
    }

    /** The halves of the diaphragm stay together: their domes differ as those of the template. */
    @Test
    void aTemplatesLeftDomeGoesDownWithTheRightOneOntoTheLiver() {
        List<LungBase> own = bases(LUNGS);
        double difference = own.get(0).top() - own.get(1).top();
        for (List<LungBase> lowered : List.of(
                ofTemplate(liver(60), stomach(Side.LEFT, 60)),
                ofTemplate(liver(60), stomach(Side.LEFT, 100)),
                ofTemplate(liver(60)))) {
            double right = lowered.get(0).dome();
            assertThat(right).isCloseTo(own.get(0).dome() - 60, within(8.0));
            assertThat(lowered.get(1).top()).isCloseTo(lowered.get(0).top() - difference, within(0.01));
            assertThat(lowered.get(1).liesOnDiaphragm()).isTrue();
            assertThat(lowered.get(0).note()).hasValueSatisfying(note -> assertThat(note)
                    .contains("which the scan does not show", "above the liver")
                    .doesNotContain("fluid"));
            assertThat(lowered.get(1).note()).isEmpty();
        }
    }

    @Test
    void aTemplatesLeftDomeStaysUpOnItsOrgansOrBesideARightOneThatStays() {
        double own = bases(LUNGS).get(1).dome();
        assertThat(ofTemplate(liver(60), stomach(Side.LEFT, 5)).get(1).dome()).isEqualTo(own);
        assertThat(ofTemplate(liver(60), spleen()).get(1).dome()).isEqualTo(own);
        assertThat(ofTemplate(liver(5), stomach(Side.LEFT, 60)).get(1).dome()).isEqualTo(own);
        assertThat(ofTemplate(stomach(Side.LEFT, 60)).get(1).dome()).isEqualTo(own);
    }

    /** Fat and bowel may lie above a stomach, on the right side too; the liver alone fills the dome. */
    @Test
    void aTemplatesRightDomeIsToldByTheLiverAlone() {
        double own = bases(LUNGS).get(0).dome();
        assertThat(ofTemplate(stomach(Side.RIGHT, 60)).get(0).dome()).isEqualTo(own);
        assertThat(ofTemplate(liver(60)).get(0).dome()).isLessThan(own - 50);
    }

    /** Lungs of the scan are each judged by the organs below. */
    @Test
    void lungsOfTheScanFarAboveOrgansDoNotLieOnTheDiaphragm() {
        List<LungBase> shown = bases(above(liver(60), stomach(Side.LEFT, 60)));
        assertThat(shown).noneMatch(LungBase::liesOnDiaphragm).allMatch(base -> base.note()
                .filter(note -> note.contains("fluid"))
                .isPresent());
    }

    /** A gap as of air or fluid is noted of a lung that the scan shows alone. */
    @Test
    void aGapBelowALungThatTheScanDoesNotShowIsNotNoted() {
        assertThat(bases(above(liver(25))).get(0).note())
                .hasValueSatisfying(note -> assertThat(note).contains("three quarters of the base of the right lung"));
        assertThat(ofTemplate(liver(25)).get(0).note()).isEmpty();
    }

    /**
     * A surface of revolution with a cone of 50 degrees below, from 0 down to -72 mm, and a level rim around it: the
     * only level faces are those of the rim, a third of the base.
     */
    @Test
    void aRimThatIsLevelIsNotTheTopOfTheBase() {
        double[][] profile = {
            {0, 0}, {20, -24}, {40, -48}, {60, -72}, {68, -72}, {75, -72}, {75, 50}, {40, 120}, {0, 150}
        };
        LungBase base = bases(List.of(revolved(profile))).get(0);
        assertThat(base.top()).isBetween(-50.0, -15.0);
        assertThat(base.dome()).isEqualTo(base.top());
    }

    /**
     * A cone of 50 degrees below, and 60 mm above it an overhang, the only level face, as where a template continues a
     * lung below the end of a scan: it takes two fifths of the underside.
     */
    @Test
    void anOverhangFarAboveTheBaseIsNotItsTop() {
        double[][] profile = {{0, 0}, {15, -18}, {30, -36}, {45, -54}, {46, 60}, {53, 60}, {60, 60}, {60, 120}, {0, 150}
        };
        LungBase base = bases(List.of(revolved(profile))).get(0);
        assertThat(base.top()).isBetween(-35.0, 0.0);
    }

    /** A right lung of the profile (radius, height) from the bottom to the top, mm. */
    private static Structure revolved(double[]... profile) {
        int around = 48;
        List<double[]> points = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (double[] ring : profile) {
            for (int i = 0; i < around; i++) {
                double angle = 2 * Math.PI * i / around;
                points.add(new double[] {ring[0] * Math.cos(angle) - 80, ring[0] * Math.sin(angle), ring[1]});
            }
        }
        for (int ring = 0; ring + 1 < profile.length; ring++) {
            for (int i = 0; i < around; i++) {
                int a = ring * around + i;
                int b = ring * around + (i + 1) % around;
                faces.add(new int[] {a, b, b + around});
                faces.add(new int[] {a, b + around, a + around});
            }
        }
        TriangleMesh mesh = new TriangleMesh(
                points.stream().flatMapToDouble(Arrays::stream).toArray(),
                faces.stream().flatMapToInt(Arrays::stream).toArray());
        return new Structure("lung_R", StructureKind.LUNG, 0, Side.RIGHT, mesh);
    }
}
