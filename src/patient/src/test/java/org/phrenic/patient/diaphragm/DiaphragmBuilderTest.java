package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.LungAboveFluid;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.SelfIntersections;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.mesh.query.TriangleTree;

/** The virtual adult female without her diaphragm: what is built from the rest is held against it. */
class DiaphragmBuilderTest {
    private static final Thorax FEMALE = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
    private static final TriangleMesh TRUE_SHEET =
            FEMALE.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
    private static final CageEnvelope CAGE = new CageEnvelope(FEMALE);
    private static final TriangleMesh BUILT = DiaphragmBuilder.build(without(StructureKind.DIAPHRAGM), 4000);

    private static Thorax without(StructureKind kind) {
        return new Thorax(
                "patient",
                FEMALE.structures().stream().filter(s -> s.kind() != kind).toList(),
                List.of());
    }

    private static SheetQuality quality(TriangleMesh sheet) {
        List<Structure> all = new ArrayList<>(without(StructureKind.DIAPHRAGM).structures());
        all.add(new Structure("diaphragm", StructureKind.DIAPHRAGM, 0, Side.MIDLINE, sheet));
        return SheetQuality.of(new Thorax("patient", all, List.of()), CAGE);
    }

    @Test
    void theSheetOfOneBodyLiesNearItsTrueSheet() {
        SurfaceComparison off = SurfaceComparison.of(BUILT, TRUE_SHEET);
        assertThat(off.byArea().mean()).as("mean, mm").isLessThan(2.5);
        assertThat(off.byArea().percentile95()).as("95 %%, mm").isLessThan(10);
    }

    @Test
    void theSheetIsClosedAndWithoutHandles() {
        MeshTopology topology = new MeshTopology(BUILT);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isEqualTo(2);
    }

    @Test
    void itLiesInsideTheCageWithEvenTrianglesAndNoIntersection() {
        SheetQuality built = quality(BUILT);
        assertThat(built.refusal()).isEmpty();
        assertThat(built.value("outside_cage_maximum_mm")).isLessThan(0.5);
        assertThat(built.value("self_intersections")).isZero();
        assertThat(built.value("first_percentile_angle_deg")).isGreaterThan(18);
        assertThat(built.value("edge_ratio")).isLessThan(6);
    }

    @Test
    void theBorderLiesOnTheCostalMarginAndTheArcuateLigaments() {
        SheetQuality built = quality(BUILT);
        assertThat(built.value("insertion_to_margin_percentile_95_mm")).isLessThan(8);
        assertThat(built.value("insertion_to_margin_mean_mm")).isLessThan(4);
        double[] lifted = BUILT.positions().clone();
        for (int i = 2; i < lifted.length; i += 3) {
            lifted[i] += 25;
        }
        assertThat(quality(BUILT.withPositions(lifted)).value("insertion_to_margin_percentile_95_mm"))
                .isGreaterThan(10);
    }

    /** A ball of 12 mm radius beside the spine that touches a rib: the wall has to turn sharply to go around it. */
    @Test
    void theWallGoesAroundAnOrganInTheCornerBetweenRibsAndSpine() {
        TriangleTree bones = new TriangleTree(MeshMerge.merge(FEMALE.structures().stream()
                .filter(s -> s.kind() == StructureKind.RIB || s.kind() == StructureKind.VERTEBRA)
                .map(Structure::mesh)
                .toList()));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double z = FEMALE.find(StructureKind.VERTEBRA, 12, Side.MIDLINE)
                .orElseThrow()
                .mesh()
                .centre()[2];
        double r = 0;
        double[] centre = CAGE.point(Math.toRadians(25), r, z);
        while (!bones.isWithin(centre[0], centre[1], centre[2], 12.5, hit)) {
            r += 0.5;
            centre = CAGE.point(Math.toRadians(25), r, z);
        }
        TriangleMesh ball = Shapes.moved(Shapes.sphere(12, 4), centre[0], centre[1], centre[2]);
        List<Structure> all = new ArrayList<>(FEMALE.structures());
        all.add(new Structure("spleen", StructureKind.ORGAN, 0, Side.LEFT, ball));
        CageEnvelope around = new CageEnvelope(new Thorax("patient", all, List.of()));
        double farthest = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < ball.vertexCount(); v++) {
            farthest = Math.max(farthest, around.at(ball.x(v), ball.y(v), ball.z(v)));
        }
        assertThat(farthest).as("mm outside the wall").isLessThan(1.5);
    }

    /**
     * Cartilages from the fifth or sixth to the seventh under one label, as where they are fused in a scan: the margin
     * in front is theirs, and so is what the insertion is measured to.
     */
    @ParameterizedTest
    @ValueSource(ints = {5, 6})
    void theMarginIsTheLowerBorderOfFusedCartilages(int first) {
        InsertionSites sites = new InsertionSites(FEMALE, CAGE);
        double sternum = sites.xiphoid().orElseThrow() + InsertionSites.ABOVE_XIPHOID_MM;
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            InsertionSites fused = new InsertionSites(withFusedCartilages(first, side), CAGE);
            TriangleTree measured = fused.tree();
            TriangleTree.Hit hit = new TriangleTree.Hit();
            double lowest = cartilage(7, side).mesh().bounds()[2];
            List<double[]> expected = sites.margin(side).stream()
                    .filter(p -> p[2] > lowest && p[2] < sternum && sites.azimuth(p, side) > 2)
                    .toList();
            assertThat(expected).hasSizeGreaterThan(8);
            assertThat(fused.margin(side)).containsAll(expected);
            assertThat(expected).allSatisfy(p -> assertThat(measured.isWithin(p[0], p[1], p[2], 3, hit))
                    .as("%s", side)
                    .isTrue());
        }
    }

    private static Thorax withFusedCartilages(int first, Side side) {
        List<TriangleMesh> pieces = new ArrayList<>();
        for (int level = first; level <= 7; level++) {
            pieces.add(cartilage(level, side).mesh());
        }
        List<Structure> fused = new ArrayList<>();
        for (Structure s : FEMALE.structures()) {
            boolean piece = s.kind() == StructureKind.COSTAL_CARTILAGE
                    && s.side() == side
                    && s.level() >= first
                    && s.level() <= 7;
            if (!piece) {
                fused.add(s);
            } else if (s.level() == first) {
                fused.add(s.withMesh(MeshMerge.merge(pieces)));
            }
        }
        return new Thorax("fused", fused, List.of());
    }

    private static Structure cartilage(int level, Side side) {
        return FEMALE.find(StructureKind.COSTAL_CARTILAGE, level, side).orElseThrow();
    }

    /** Lungs whose bases reach down in spurs beside the spine, in front of which a ray meets them first. */
    private static Structure withSpurs(Structure s) {
        if (s.kind() != StructureKind.LUNG) {
            return s;
        }
        double[] p = s.mesh().positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            double beside = (Math.abs(p[i]) - 25) / 12;
            double below = Math.max(0, Math.min(1, (s.mesh().centre()[2] - p[i + 2]) / 40));
            p[i + 2] -= 90 * below * Math.exp(-beside * beside);
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    @Test
    void theSheetBelowSpursOfTheLungsDoesNotPassThroughItself() {
        Thorax spurred = new Thorax(
                "patient",
                without(StructureKind.DIAPHRAGM).structures().stream()
                        .map(DiaphragmBuilderTest::withSpurs)
                        .toList(),
                List.of());
        assertThat(SelfIntersections.count(DiaphragmBuilder.build(spurred, 4000)))
                .isZero();
    }

    /** The x of the first vertex of the sheet that is chosen, where it is the number of the try; NaN without one. */
    private static double chosen(IntPredicate isCrossed, IntPredicate liesOnWall, IntToDoubleFunction excess) {
        int[] tries = {0};
        return DiaphragmBuilder.choose(
                        shape -> {
                            double x = ++tries[0];
                            // A triangle, and one that passes through it or lies beside it.
                            double beside = isCrossed.test(tries[0]) ? 0 : 50;
                            return new TriangleMesh(
                                    new double[] {
                                        x,
                                        0,
                                        0,
                                        x + 20,
                                        0,
                                        0,
                                        x,
                                        20,
                                        0,
                                        x + 5 + beside,
                                        5,
                                        -5,
                                        x + 5 + beside,
                                        5,
                                        5,
                                        x + 9 + beside,
                                        9,
                                        0
                                    },
                                    new int[] {0, 1, 2, 3, 4, 5});
                        },
                        Optional.empty(),
                        sheet -> liesOnWall.test((int) sheet.x(0)),
                        sheet -> excess.applyAsDouble((int) sheet.x(0)))
                .map(sheet -> sheet.x(0))
                .orElse(Double.NaN);
    }

    @Test
    void theSheetIsTheFirstOnTheWallElseThatOfLeastExcessOfTheLittleSmoothed() {
        assertThat(chosen(k -> false, k -> k == 1, k -> 7 - k)).isEqualTo(1);
        assertThat(chosen(k -> k == 1, k -> k >= 1, k -> 0)).isEqualTo(2);
        assertThat(chosen(k -> false, k -> k == 4, k -> k == 4 ? 0 : 1)).isEqualTo(4);
        // A sheet on the wall that cuts far through organs of the scan.
        assertThat(chosen(k -> false, k -> k == 4, k -> k == 4 ? 3 : 1)).isEqualTo(1);
        // Two pivots of the smoothing lengths 5, 7 and 10 mm are compared, and no later ones.
        assertThat(chosen(k -> false, k -> k >= 7, k -> Math.abs(k - 6.1))).isEqualTo(6);
        assertThat(chosen(k -> false, k -> false, k -> k == 3 ? 0.2 : 0.3)).isEqualTo(3);
        assertThat(chosen(k -> k < 9, k -> false, k -> 1)).isEqualTo(9);
        assertThat(chosen(k -> true, k -> true, k -> 0)).isNaN();
    }

    @Test
    void theExcessOfASheetIsThatOfItsMeasuresBeyondTheirLimits() {
        Structure out = new Structure("diaphragm", StructureKind.DIAPHRAGM, 0, Side.MIDLINE, BUILT);
        assertThat(SheetQuality.liesOnWall(FEMALE, CAGE, BUILT)).isTrue();
        assertThat(SheetQuality.of(FEMALE, CAGE, BUILT, organ -> true).excess()).isZero();
        double[] lower = BUILT.positions().clone();
        for (int i = 2; i < lower.length; i += 3) {
            lower[i] -= 20;
        }
        TriangleMesh moved = out.mesh().withPositions(lower);
        assertThat(SheetQuality.liesOnWall(FEMALE, CAGE, moved)).isFalse();
        SheetQuality quality = SheetQuality.of(FEMALE, CAGE, moved, organ -> true);
        double expected = 0;
        for (SheetQuality.Measure m : quality.measures()) {
            expected += m.atMost() && m.limit() > 0 ? Math.max(0, m.value() / m.limit() - 1) : 0;
        }
        assertThat(quality.excess()).isEqualTo(expected, within(1e-9)).isGreaterThan(1);
        SheetQuality yielding = SheetQuality.of(FEMALE, CAGE, moved, organ -> organ.kind() == StructureKind.LUNG);
        assertThat(yielding.value("organs_through_maximum_mm"))
                .as("organs that yield")
                .isLessThan(3);
        double ofOrgans = quality.value("organs_through_maximum_mm") / 3 - 1;
        assertThat(ofOrgans).isGreaterThan(1);
        assertThat(yielding.excess()).isEqualTo(expected - ofOrgans, within(1e-9));
    }

    /** One limit twice exceeded, an angle of half its least, one kept, and a limit of 0. */
    @Test
    void theExcessCountsUpperAndLowerLimitsAndNoneOfZero() {
        List<SheetQuality.Measure> measures = List.of(
                new SheetQuality.Measure("a", "a", 6, "mm", 3, true),
                new SheetQuality.Measure("b", "b", 2.5, "degrees", 5, false),
                new SheetQuality.Measure("c", "c", 6, "degrees", 5, false),
                new SheetQuality.Measure("d", "d", 7, "%", 0, true));
        assertThat(new SheetQuality(measures, Optional.empty()).excess()).isEqualTo(2, within(1e-12));
    }

    @Test
    void underALungThatEndsFarAboveTheLiverTheSheetLiesOnTheLiver() {
        Thorax parted = LungAboveFluid.in(without(StructureKind.DIAPHRAGM));
        List<LungBase> bases = LungBase.of(parted);
        assertThat(bases.get(0).liesOnDiaphragm()).isFalse();
        assertThat(bases.get(0).note())
                .hasValueSatisfying(note -> assertThat(note).contains("base of the right lung", "above the organs"));
        assertThat(bases.get(1).liesOnDiaphragm()).isTrue();
        assertThat(LungBase.of(FEMALE)).allMatch(LungBase::liesOnDiaphragm);
        SurfaceComparison off = SurfaceComparison.of(DiaphragmBuilder.build(parted, 4000), TRUE_SHEET);
        assertThat(off.byArea().mean()).as("mean, mm").isLessThan(2.5);
        assertThat(off.byArea().percentile95()).as("95 %%, mm").isLessThan(10);
    }

    /** A gap too thick for a diaphragm and too thin to tell that the lung does not lie on it. */
    @Test
    void aLungThatEndsAFewCentimetresAboveTheLiverIsNoted() {
        List<Structure> low = without(StructureKind.DIAPHRAGM).structures().stream()
                .map(s -> s.kind() == StructureKind.LIVER ? s.withMesh(Shapes.moved(s.mesh(), 0, 0, -20)) : s)
                .toList();
        LungBase base = LungBase.of(new Thorax("gap", low, List.of())).get(0);
        assertThat(base.liesOnDiaphragm()).isTrue();
        assertThat(base.note())
                .hasValueSatisfying(note -> assertThat(note).contains("base of the right lung", "air or fluid"));
        assertThat(LungBase.of(FEMALE)).allMatch(own -> own.note().isEmpty());
    }

    /** The scan labels no organ: the liver is a template's. */
    @Test
    void underALungThatEndsFarAboveTheOtherOneTheSheetLiesAtTheLevelOfThat() {
        Thorax fluid = LungAboveFluid.in(without(StructureKind.DIAPHRAGM));
        Thorax shown = new Thorax("fluid", fluid.structures(), List.of(), Set.of("liver"));
        Optional<Side> parted = UnequalBases.parted(shown, LungBase.of(shown));
        assertThat(parted).contains(Side.RIGHT);
        SurfaceComparison off = SurfaceComparison.of(DiaphragmBuilder.build(shown, parted, 4000), TRUE_SHEET);
        assertThat(off.byArea().mean()).as("mean, mm").isLessThan(2.5);
        assertThat(off.byArea().percentile95()).as("95 %%, mm").isLessThan(10);
    }

    /** Ascites or bowel between the diaphragm and a liver that lies 60 mm lower. */
    @ParameterizedTest
    @ValueSource(strings = {"other_ascites", "colon"})
    void aLungOnAscitesOrBowelFarAboveTheLiverLiesOnTheDiaphragm(String between) {
        List<Structure> low = new ArrayList<>();
        for (Structure s : without(StructureKind.DIAPHRAGM).structures()) {
            low.add(s.kind() == StructureKind.LIVER ? s.withMesh(Shapes.moved(s.mesh(), 0, 0, -60)) : s);
            if (s.kind() == StructureKind.LIVER) {
                low.add(new Structure(between, StructureKind.OTHER, 0, Side.MIDLINE, s.mesh()));
            }
        }
        List<Structure> unlabelled =
                low.stream().filter(s -> !s.name().equals(between)).toList();
        LungBase parted = LungBase.of(new Thorax("gap", unlabelled, List.of())).get(0);
        assertThat(parted.liesOnDiaphragm()).isFalse();
        assertThat(parted.note())
                .hasValueSatisfying(note -> assertThat(note).contains("fluid in the chest", "ascites", "resection"));
        LungBase base = LungBase.of(new Thorax("ascites", low, List.of())).get(0);
        assertThat(base.liesOnDiaphragm()).isTrue();
        assertThat(base.top()).isEqualTo(LungBase.of(FEMALE).get(0).top());
    }

    @Test
    void aSheetBesideItsPlaceIsToldApart() {
        double[] shifted = TRUE_SHEET.positions().clone();
        for (int i = 2; i < shifted.length; i += 3) {
            shifted[i] += 25;
        }
        SheetQuality high = quality(TRUE_SHEET.withPositions(shifted));
        assertThat(quality(TRUE_SHEET).value("organ_vertices_through_percent")).isZero();
        assertThat(high.value("organ_vertices_through_percent")).isGreaterThan(4);
        assertThat(high.value("organs_through_maximum_mm")).isBetween(15.0, 27.0);
        assertThat(high.warning()).isPresent();
        double[] wide = TRUE_SHEET.positions().clone();
        for (int i = 0; i < wide.length; i += 3) {
            wide[i] *= 1.2;
        }
        SheetQuality outside = quality(TRUE_SHEET.withPositions(wide));
        assertThat(outside.value("outside_cage_maximum_mm")).isBetween(12.0, 30.0);
        assertThat(outside.refusal()).isPresent();
    }

    @Test
    void withoutLungsOrRibsThereIsNoDiaphragm() {
        assertThatThrownBy(() -> DiaphragmBuilder.build(without(StructureKind.LUNG)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("lungs");
        assertThatThrownBy(() -> DiaphragmBuilder.build(without(StructureKind.RIB)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ribs");
    }
}
