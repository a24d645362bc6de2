package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.EnumSet;
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
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.AbsentStructures;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.ScanFragments;

/** A scan of the virtual woman's abdomen, or of her whole trunk, and fragments under names of whole structures. */
class ScanFragmentsTest {
    private static final Thorax WOMAN = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
    private static final Thorax MAN = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
    private static final Set<StructureKind> SHOWN =
            EnumSet.of(StructureKind.RIB, StructureKind.VERTEBRA, StructureKind.LUNG, StructureKind.LIVER);

    private static PatientBody body(List<PatientStructure> shown) {
        return new PatientBody("patient", shown, ExpectedStructures.missing(shown), List.of());
    }

    /** A structure made smaller about a place, mm. */
    private static Structure shrunk(Structure s, double factor, double... place) {
        double[] p = s.mesh().positions().clone();
        double[] centre = s.mesh().centre();
        for (int i = 0; i < p.length; i++) {
            p[i] = place[i % 3] + factor * (p[i] - centre[i % 3]);
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    private static Structure smaller(Structure s, double factor) {
        double[] p = s.mesh().positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] *= factor;
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    /** All of her at a size, with a left lung that has collapsed to 0.15 of its volume. */
    private static List<PatientStructure> collapsed(double size) {
        List<PatientStructure> shown = new ArrayList<>();
        for (Structure s : WOMAN.structures()) {
            if (SHOWN.contains(s.kind())) {
                boolean small = s.name().equals("lung_L");
                Structure whole =
                        small ? shrunk(s, StrictMath.cbrt(0.15), s.mesh().centre()) : s;
                shown.add(BodyCompletionTest.scanned(smaller(whole, size), ""));
            }
        }
        return shown;
    }

    private static List<PatientStructure> abdomen() {
        List<PatientStructure> shown = new ArrayList<>();
        for (Structure s : WOMAN.structures()) {
            boolean rib = s.kind() == StructureKind.RIB && s.level() >= 9;
            boolean vertebra = s.kind() == StructureKind.VERTEBRA && s.level() >= 9;
            if (rib || vertebra || s.kind() == StructureKind.LIVER) {
                shown.add(BodyCompletionTest.scanned(s, ""));
            }
        }
        return shown;
    }

    @Test
    void aSpeckOfARibAndGasWithTheLabelOfALungDoNotDeformTheTemplate() {
        List<PatientStructure> shown = abdomen();
        PatientBody clean = body(shown);
        double[] low = WOMAN.find("liver").orElseThrow().mesh().centre();
        shown.add(BodyCompletionTest.scanned(shrunk(WOMAN.find("rib_01_L").orElseThrow(), 0.2, low), ""));
        shown.add(BodyCompletionTest.scanned(shrunk(WOMAN.find("lung_L").orElseThrow(), 0.13, low), ""));
        shown.add(BodyCompletionTest.scanned(shrunk(WOMAN.find("vertebra_T02").orElseThrow(), 0.4, low), ""));
        PatientBody rest = ScanFragments.leftOut(body(shown), MAN);
        assertThat(rest.structures()).isEqualTo(clean.structures());
        assertThat(rest.missing()).contains("rib_01_L", "lung_L", "vertebra_T02");
        assertThat(rest.notes())
                .singleElement()
                .asString()
                .startsWith(
                        "left out, too small for what their labels name though the scan does not cut them: rib_01_L")
                .contains("lung_L (", "vertebra_T02 (");
        PatientBody completed = BodyCompletion.complete(rest, MAN);
        assertThat(completed.structure("rib_01_L").orElseThrow().source()).isEqualTo(PatientStructure.Source.VIRTUAL);
        assertThat(completed
                        .structure("rib_01_L")
                        .orElseThrow()
                        .structure()
                        .mesh()
                        .centre()[2])
                .isGreaterThan(low[2] + 150);
    }

    /** The size of the body is that of most of its structures: a third of a man is left whole to be refused. */
    @Test
    void lungsThatHaveCollapsedAndSmallBodiesCount() {
        for (double size : new double[] {1, 0.55, 1 / 3.0}) {
            PatientBody body = body(collapsed(size));
            assertThat(ScanFragments.leftOut(body, MAN)).isSameAs(body);
        }
    }

    @Test
    void aSmallPieceThatTheScanCutsCounts() {
        List<PatientStructure> shown = abdomen();
        Structure rib = WOMAN.find("rib_06_R").orElseThrow();
        shown.add(BodyCompletionTest.scanned(shrunk(rib, 0.25, rib.mesh().centre()), "S"));
        PatientBody body = body(shown);
        assertThat(ScanFragments.leftOut(body, MAN)).isSameAs(body);
    }

    /** The abdomen of the woman, or of a child of 0.6 of her height, with the lower ends of the lungs, 0.1 of them. */
    @Test
    void theCutEndOfALungTellsAsMuchInASmallBody() {
        for (double size : new double[] {1, 0.6}) {
            List<PatientStructure> shown = new ArrayList<>();
            abdomen().forEach(s -> shown.add(BodyCompletionTest.scanned(smaller(s.structure(), size), "")));
            Structure right = WOMAN.find("lung_R").orElseThrow();
            double[] box = right.mesh().bounds();
            Structure end = BodyCompletionTest.lobe(right, "lung_R", box[2], 0.75 * box[2] + 0.25 * box[5]);
            assertThat(MeshMeasure.signedVolume(end.mesh()) / MeshMeasure.signedVolume(right.mesh()))
                    .isBetween(0.06, 0.14);
            shown.add(BodyCompletionTest.scanned(smaller(end, size), "S"));
            PatientBody completed = BodyCompletion.complete(body(shown), MAN);
            assertThat(completed.structure("lung_R").orElseThrow().source())
                    .as("right lung of a body of " + size)
                    .isEqualTo(PatientStructure.Source.EXTENDED);
        }
    }

    /** The woman with her left lung and last ribs from a template, and a heart that fills an eighth of that lung. */
    private static PatientBody withoutLeftLung() {
        Structure lung = WOMAN.find("lung_L").orElseThrow();
        List<PatientStructure> shown = new ArrayList<>();
        for (Structure s : WOMAN.structures()) {
            boolean absent = s.isSameAs(lung) || (s.kind() == StructureKind.RIB && s.level() == 12);
            if (SHOWN.contains(s.kind())) {
                shown.add(
                        absent
                                ? new PatientStructure(
                                        s, PatientStructure.Source.VIRTUAL, Optional.empty(), Optional.empty())
                                : BodyCompletionTest.scanned(s, ""));
            }
        }
        Structure heart = new Structure(
                "heart",
                StructureKind.ORGAN,
                0,
                Side.MIDLINE,
                shrunk(lung, 0.5, lung.mesh().centre()).mesh());
        shown.add(BodyCompletionTest.scanned(heart, ""));
        return body(shown);
    }

    /** The field of view of a scan up to a place on the left, mm, in voxels of 10 mm. */
    private static LabelGrid view(double leftEnd) {
        return view(leftEnd, 0);
    }

    /** The same with labels from a slice on. */
    private static LabelGrid view(double leftEnd, int first) {
        int columns = (int) ((leftEnd + 300) / 10);
        double[] toMm = {10, 0, 0, -300, 0, 10, 0, -300, 0, 0, 10, -500};
        byte[] labels = new byte[columns * 60 * 100];
        labels[columns * 60 * first] = 1;
        labels[labels.length - 1] = 1;
        return LabelGrid.of(columns, 60, 100, labels, toMm);
    }

    @Test
    void aLungAndRibsThatTheScanWouldShowAreNamed() {
        PatientBody body = withoutLeftLung();
        List<String> notes = AbsentStructures.notes(body, view(300));
        double overlap = MeshMeasure.signedVolumeMl(
                body.structure("heart").orElseThrow().structure().mesh());
        assertThat(notes).hasSize(2);
        assertThat(notes.get(0))
                .contains("the left side of the chest and no left lung", "heart by ")
                .satisfies(note -> {
                    double stated = Double.parseDouble(note.replaceAll(".*heart by (\\d+) ml.*", "$1"));
                    assertThat(stated).isCloseTo(overlap, withinPercentage(4));
                });
        assertThat(notes.get(1)).endsWith("virtual ones lie there: rib_12_R, rib_12_L");
        // The end of the field of view passes through the left lung and ribs.
        assertThat(AbsentStructures.notes(body, view(40)))
                .singleElement()
                .asString()
                .endsWith("there: rib_12_R");
        // Slices without a label at the height of the twelfth ribs are beyond the end of the scan.
        double[] rib =
                body.structure("rib_12_R").orElseThrow().structure().mesh().centre();
        assertThat(AbsentStructures.notes(body, view(300, (int) ((rib[2] + 500) / 10))))
                .noneMatch(note -> note.contains("rib_12"));
        List<PatientStructure> lungs = body.structures().stream()
                .filter(s -> s.structure().kind() == StructureKind.LUNG)
                .toList();
        assertThat(AbsentStructures.notes(body(lungs), view(300))).isEmpty();
    }
}
