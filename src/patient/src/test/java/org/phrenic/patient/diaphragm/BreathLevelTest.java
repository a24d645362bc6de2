package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.MeshedSegment;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

class BreathLevelTest {
    private static final Set<StructureKind> SHOWN =
            EnumSet.of(StructureKind.LUNG, StructureKind.RIB, StructureKind.VERTEBRA);

    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    /** Lungs, ribs and vertebrae of the virtual man, with a left lung so many times as tall. */
    private static Optional<BreathLevel> level(double leftLung) {
        return level(MAN, 1, leftLung);
    }

    private static Optional<BreathLevel> level(Thorax person, double rightLung, double leftLung) {
        List<PatientStructure> shown = person.structures().stream()
                .filter(s -> SHOWN.contains(s.kind()))
                .map(s -> s.kind() == StructureKind.LUNG ? tall(s, s.side() == Side.LEFT ? leftLung : rightLung) : s)
                .map(s -> new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        PatientBody body = new PatientBody("patient", shown, List.of(), List.of());
        return BreathLevel.of(body, body);
    }

    private static Structure tall(Structure lung, double times) {
        double[] p = lung.mesh().positions().clone();
        double apex = lung.mesh().bounds()[5];
        for (int i = 2; i < p.length; i += 3) {
            p[i] = apex - times * (apex - p[i]);
        }
        return lung.withMesh(lung.mesh().withPositions(p));
    }

    /** The base of a left lung above fluid, in a scan that labels no organ below. */
    @Test
    void aBaseFarAboveThatOfTheOtherLungDoesNotTellTheLevel() {
        BreathLevel whole = level(1).orElseThrow();
        BreathLevel fluid = level(0.65).orElseThrow();
        assertThat(fluid.mark()).isEqualTo(BreathLevel.Mark.DOMES);
        assertThat(fluid.right()).isEqualTo(whole.right());
        assertThat(fluid.left()).isNaN();
        assertThat(fluid.parted()).contains(Side.LEFT);
        assertThat(fluid.descent()).isCloseTo(whole.descent(), within(0.5));
        assertThat(fluid.stated()).doesNotContain("on the left");
        assertThat(level(0.9).orElseThrow().left())
                .as("less than two centimetres")
                .isBetween(whole.left() - 1, whole.left());
    }

    @Test
    void domesStandHighBeyondTheDifferencesBetweenPeople() {
        for (String preset : List.of("adult-male", "adult-female")) {
            Thorax person = VirtualThorax.ofPreset(preset, Resolution.LOW);
            assertThat(level(person, 1, 1).orElseThrow().standsHigh())
                    .as(preset)
                    .isFalse();
            BreathLevel high = level(person, 0.8, 0.8).orElseThrow();
            assertThat(high.standsHigh()).as(preset + " " + high.share()).isTrue();
            assertThat(high.isInspired()).isFalse();
        }
        assertThat(new BreathLevel(BreathLevel.Mark.ORGANS, 7, 8, -1, -0.29, -20).standsHigh())
                .isFalse();
        assertThat(new BreathLevel(BreathLevel.Mark.LOWER_BORDERS, 10, 10, -1, -0.5, -20).standsHigh())
                .as("fluid lifts lower borders")
                .isFalse();
    }

    private static Optional<BreathLevel> levelOfLiver(Thorax person, double lowerMm, CutPlane... ends) {
        return levelOfLiver(person, lowerMm, 1, ends);
    }

    /** Ribs, vertebrae and a liver of another size whose top stands lower, which the scan cuts off at some ends. */
    private static Optional<BreathLevel> levelOfLiver(Thorax person, double lowerMm, double size, CutPlane... ends) {
        List<PatientStructure> all = person.structures().stream()
                .map(s -> new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        TriangleMesh liver = person.structuresOf(StructureKind.LIVER).get(0).mesh();
        double[] p = liver.positions().clone();
        for (int i = 0; i < p.length; i++) {
            double top = liver.bounds()[3 + i % 3];
            p[i] = top + size * (p[i] - top) - (i % 3 == 2 ? lowerMm : 0);
        }
        Structure lower = person.structuresOf(StructureKind.LIVER).get(0).withMesh(liver.withPositions(p));
        MeshedSegment meshed =
                new MeshedSegment(lower.mesh(), 0, 0, DistanceSummary.NONE, MeshQuality.of(lower.mesh()), 0.2, 1, 0);
        List<PatientStructure> shown = Stream.concat(
                        all.stream()
                                .filter(s -> SHOWN.contains(s.structure().kind())
                                        && s.structure().kind() != StructureKind.LUNG),
                        Stream.of(PatientStructure.ofScan(
                                lower, new PatientStructure.Scan(List.of(1), 1000, 1000, List.of(ends), meshed))))
                .toList();
        return BreathLevel.of(
                new PatientBody("patient", shown, List.of(), List.of()),
                new PatientBody("patient", all, List.of(), List.of()));
    }

    /** Vertebrae at the level of the domes are 25 mm apart: 3.5 of them are a full inspiration. */
    @Test
    void withoutARightLungTheTopOfTheLiverTellsTheLevel() {
        for (String preset : List.of("adult-male", "adult-female")) {
            Thorax person = VirtualThorax.ofPreset(preset, Resolution.LOW);
            BreathLevel rest = levelOfLiver(person, 0).orElseThrow();
            assertThat(rest.mark()).isEqualTo(BreathLevel.Mark.LIVER);
            assertThat(rest.left()).isNaN();
            assertThat(rest.right())
                    .as(preset)
                    .isCloseTo(level(person, 1, 1).orElseThrow().right(), within(0.6));
            assertThat(rest.isInspired()).isFalse();
            assertThat(rest.standsHigh()).isFalse();
            BreathLevel inspired = levelOfLiver(person, 50).orElseThrow();
            assertThat(inspired.descentMm() - rest.descentMm()).isCloseTo(50, within(1e-6));
            assertThat(inspired.share()).isBetween(0.4, 0.7);
            assertThat(inspired.isInspired()).isTrue();
            assertThat(inspired.stated()).matches("the top of the liver at T(9|10)\\.\\d \\(T8 at end-expiration\\)");
        }
        assertThat(levelOfLiver(MAN, 80)).as("at full inspiration").isNotEmpty();
        assertThat(levelOfLiver(MAN, 110))
                .as("below that of a full inspiration")
                .isEmpty();
        assertThat(levelOfLiver(MAN, 50, 0.85)).as("0.61 of the volume").isNotEmpty();
        assertThat(levelOfLiver(MAN, 50, 0.7))
                .as("a remnant, or drawn about a target")
                .isEmpty();
        assertThat(levelOfLiver(MAN, 50, new CutPlane("S", 0, 0, 1, 0)))
                .as("a liver at the upper end of the scan goes on above it")
                .isEmpty();
        assertThat(levelOfLiver(MAN, 50, new CutPlane("I", 0, 0, -1, 0))).isPresent();
    }

    /** There is no T13: the vertebra below T12 is L1. */
    @Test
    void aLevelThatRoundsToTheVertebraBelowT12IsNamedAsThat() {
        assertThat(new BreathLevel(BreathLevel.Mark.DOMES, 12.97, 12.94, 0, 0, 0).stated())
                .isEqualTo("the domes at L1.0 on the right and T12.9 on the left (T8 and T9 at end-expiration)");
        assertThat(new BreathLevel(BreathLevel.Mark.DOMES, 9.37, 13.5, 0, 0, 0).stated())
                .contains("T9.4 on the right", "L1.5 on the left");
    }
}
