package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.PatientStructure.Source;

/** The virtual woman with an organ that has no room between its neighbours. */
class DiaphragmCompletionTest {
    /** A third of those that an import gives the sheet. */
    private static final int VERTICES = 4000;

    private static final String LIVER = "liver";
    private static final String LUNG = "lung_R";
    private static final List<Structure> WOMAN =
            VirtualThorax.ofPreset("adult-female", Resolution.LOW).structures().stream()
                    .filter(s -> s.kind() != StructureKind.DIAPHRAGM)
                    .toList();

    /** The woman with one organ changed, which is from the given source; all else is from the scan. */
    private static PatientBody with(String organ, Source source, UnaryOperator<double[]> change) {
        List<PatientStructure> structures = WOMAN.stream()
                .map(s -> s.name().equals(organ)
                        ? new PatientStructure(changed(s, change), source, Optional.empty(), Optional.empty())
                        : new PatientStructure(s, Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        return new PatientBody("woman", structures, List.of(), List.of());
    }

    private static Structure changed(Structure s, UnaryOperator<double[]> change) {
        double[] p = s.mesh().positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            System.arraycopy(change.apply(new double[] {p[i], p[i + 1], p[i + 2]}), 0, p, i, 3);
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    private static PatientBody complete(PatientBody body, boolean moved) {
        return DiaphragmCompletion.complete(body, moved, Optional.empty(), VERTICES);
    }

    private static TriangleMesh mesh(PatientBody body, String name) {
        return body.structure(name).orElseThrow().structure().mesh();
    }

    private static double throughMm(PatientBody body) {
        return SheetQuality.of(body.thorax()).orElseThrow().value("organs_through_maximum_mm");
    }

    /** A liver that reaches 12 mm farther to the right stands in the ribs. */
    private static PatientBody broadLiver(Source source) {
        return with(LIVER, source, p -> new double[] {p[0] - 12, p[1], p[2]});
    }

    @Test
    void anOrganOfTheScanStaysWhereTheScanShowsIt() {
        PatientBody body = broadLiver(Source.SCAN);
        PatientBody whole = complete(body, false);
        assertThat(mesh(whole, LIVER)).isSameAs(mesh(body, LIVER));
        assertThat(throughMm(whole)).isGreaterThan(3);
    }

    @Test
    void anOrganOfATemplateAndOneThatWasMovedYieldToTheSheet() {
        for (PatientBody whole :
                List.of(complete(broadLiver(Source.VIRTUAL), false), complete(broadLiver(Source.SCAN), true))) {
            assertThat(throughMm(whole)).isLessThan(2.5);
            double[] before = mesh(broadLiver(Source.VIRTUAL), LIVER).positions();
            double[] after = mesh(whole, LIVER).positions();
            int still = 0;
            for (int i = 0; i < before.length; i += 3) {
                double dx = after[i] - before[i];
                double dy = after[i + 1] - before[i + 1];
                double dz = after[i + 2] - before[i + 2];
                assertThat(Math.sqrt(dx * dx + dy * dy + dz * dz)).isLessThan(20);
                still += dx == 0 && dy == 0 && dz == 0 ? 1 : 0;
            }
            assertThat(3.0 * still / before.length).isBetween(0.3, 0.95);
        }
    }

    /** A lung that reaches 10 mm into the liver: the sheet lies on the one that the scan shows. */
    @Test
    void whereOrgansOverlapTheOneInTheScanSaysWhereTheSheetLies() {
        UnaryOperator<double[]> lower = p -> new double[] {p[0], p[1], p[2] - 10};
        PatientBody ofTemplate = complete(with(LUNG, Source.VIRTUAL, lower), false);
        PatientBody ofScan = complete(with(LUNG, Source.SCAN, lower), false);
        assertThat(mesh(ofTemplate, LIVER)).isSameAs(mesh(ofScan, LIVER));

        assertThat(throughMm(ofTemplate)).isLessThan(1.5);
        assertThat(throughMm(ofScan)).isGreaterThan(3);
    }

    @Test
    void aDiaphragmThatWasBuiltStaysInTheBodyThatIsCompletedAgain() {
        PatientBody whole = complete(with(LIVER, Source.SCAN, p -> p), false);
        assertThat(complete(whole, false)).isSameAs(whole);
    }

    private static final String HERNIA = OrganNames.STOMACH_IN_CHEST;
    /** The sheet of the turned woman without a stomach. */
    private static final class TurnedSheet {
        static final TriangleMesh MESH = mesh(complete(turnedWoman(), false), "diaphragm");
    }

    /** The woman, turned by 15 degrees. */
    private static PatientBody turnedWoman() {
        double cos = Math.cos(Math.toRadians(15));
        double sin = Math.sin(Math.toRadians(15));
        return with(LIVER, Source.SCAN, p -> p)
                .withEach(s -> changed(s, p -> new double[] {cos * p[0] - sin * p[1], sin * p[0] + cos * p[1], p[2]}));
    }

    /**
     * An upright spindle of 116 ml, 140 mm high, before the spine.
     *
     * @param aboveRoof height of its middle above the sheet, mm
     */
    private static PatientBody withStomach(TriangleMesh sheet, double aboveRoof, Source source) {
        PatientBody woman = turnedWoman();
        double[] spine = mesh(woman, "vertebra_T10").bounds();
        double x = 0.5 * (spine[0] + spine[3]) + 8;
        double y = spine[1] - 25;
        TriangleTree.Hit roof = new TriangleTree.Hit();
        assertThat(new TriangleTree(sheet).nearestAlongRay(x, y, spine[5] + 200, 0, 0, -1, roof))
                .isTrue();
        TriangleMesh ball = Shapes.sphere(1, 4);
        double[] p = ball.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] = x + 22 * p[i];
            p[i + 1] = y + 18 * p[i + 1];
            p[i + 2] = roof.z + aboveRoof + 70 * p[i + 2];
        }
        Structure stomach =
                new Structure(HiatalHernia.STOMACH, StructureKind.ORGAN, 0, Side.MIDLINE, ball.withPositions(p));
        List<PatientStructure> structures = new ArrayList<>(woman.structures());
        structures.add(new PatientStructure(stomach, source, Optional.empty(), Optional.empty()));
        return new PatientBody("woman", structures, List.of(), List.of());
    }

    private static double volume(PatientBody body, String organ) {
        return MeshMeasure.signedVolumeMl(mesh(body, organ));
    }

    /** A stomach half of which lies behind the heart would draw the roof up over it, by 70 mm. */
    @Test
    void thePartOfAStomachInTheChestIsAnOrganAboveTheSheet() {
        TriangleMesh sheet = TurnedSheet.MESH;
        PatientBody body = complete(withStomach(sheet, 0, Source.SCAN), false);
        assertThat(body.notes()).anyMatch(note -> note.contains("ml of the stomach lie in the chest"));
        assertThat(mesh(body, "diaphragm").bounds()[5]).isCloseTo(sheet.bounds()[5], within(2.0));
        assertThat(throughMm(body)).isLessThan(2.5);
        // The slab between is some 6 mm high where the spindle is 22 x 18 mm wide.
        assertThat(volume(body, HERNIA) + volume(body, HiatalHernia.STOMACH)).isBetween(116 - 11.0, 116 - 3.0);
        assertThat(volume(body, HERNIA)).isBetween(40.0, 62.0);
        TriangleTree built = new TriangleTree(mesh(body, "diaphragm"));
        for (String part : List.of(HERNIA, HiatalHernia.STOMACH)) {
            MeshTopology topology = new MeshTopology(mesh(body, part));
            assertThat(topology.boundaryLoops()).isEmpty();
            assertThat(topology.componentCount()).isOne();
            // The rim of the part below lies 0.3 mm below the sheet, whose triangles are 8 mm wide here.
            assertThat(depthInside(built, mesh(body, part))).isLessThan(part.equals(HERNIA) ? 0.1 : 1);
        }
    }

    /** Greatest depth of a vertex between the faces of a sheet, mm. */
    private static double depthInside(TriangleTree sheet, TriangleMesh mesh) {
        double[] distances = sheet.distances(mesh.positions());
        return IntStream.range(0, distances.length)
                .filter(v -> sheet.isInside(mesh.x(v), mesh.y(v), mesh.z(v)))
                .mapToDouble(v -> distances[v])
                .max()
                .orElse(0);
    }

    /** Volume of a hernia of the stomach, ml; 0 for none. */
    private static double herniaMl(PatientBody body) {
        Thorax straight = MedianFrame.of(body.thorax()).toFrame(body.thorax());
        return HiatalHernia.of(straight, new CageEnvelope(straight))
                .map(hernia -> MeshMeasure.signedVolumeMl(hernia.above().mesh()))
                .orElse(0.0);
    }

    @Test
    void whatStandsLittleAboveTheRoofOrIsOfATemplateIsNoHernia() {
        assertThat(herniaMl(withStomach(TurnedSheet.MESH, -25, Source.SCAN))).isBetween(15.0, 35.0);
        // A cap of 10 mm, 2 ml, stands 15 mm above the roof.
        assertThat(herniaMl(withStomach(TurnedSheet.MESH, -45, Source.SCAN))).isZero();
        assertThat(herniaMl(withStomach(TurnedSheet.MESH, 0, Source.VIRTUAL))).isZero();
    }

    /** Without lungs nothing tells where the domes stand. */
    @Test
    void whereNoDiaphragmCanBeBuiltThatOfATemplateIsNotLeftInItsPlace() {
        List<PatientStructure> structures = VirtualThorax.ofPreset("adult-female", Resolution.LOW).structures().stream()
                .filter(s -> s.kind() != StructureKind.LUNG)
                .map(s -> new PatientStructure(
                        s,
                        s.kind() == StructureKind.DIAPHRAGM ? Source.VIRTUAL : Source.SCAN,
                        Optional.empty(),
                        Optional.empty()))
                .toList();
        PatientBody body = complete(new PatientBody("woman", structures, List.of(), List.of()), false);
        assertThat(body.notes()).singleElement().asString().startsWith("no diaphragm is built");
        assertThat(body.structure("diaphragm")).isEmpty();
        assertThat(body.missing()).contains("diaphragm");
        assertThat(body.canBreathe()).isFalse();
    }
}
