package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.diaphragm.BreathLevel;

/** What the notes of a body say about its breath level. */
class RestingBodyTest {
    private static final PatientBody BODY = new PatientBody("patient", List.of(), List.of(), List.of("first"));

    private static List<String> notes(double share, boolean moved) {
        return notes(BODY, share, moved);
    }

    private static List<String> notes(PatientBody body, double share, boolean moved) {
        BreathLevel level = new BreathLevel(BreathLevel.Mark.DOMES, 6.1, 6.9, -2, share, -40, Optional.empty());
        return new RestingBody(body, Optional.of(level), moved, 0)
                .with(body)
                .body()
                .notes();
    }

    @Test
    void aBodyWithHighDomesOrLeftAtInspirationGetsANote() {
        assertThat(notes(-0.62, false))
                .containsExactly(
                        "first",
                        "the scan is one with high domes, the domes at T6.1 on the right and T6.9 on the left (T8 and"
                                + " T9 at end-expiration), and is left as it is: they stand so in pregnancy, obesity,"
                                + " ascites or a paresis, or fluid or collapse lifts the lungs, or ribs or vertebrae"
                                + " are numbered one too low");
        assertThat(notes(0.6, false))
                .hasSize(2)
                .last()
                .asString()
                .contains("is one at inspiration, ", "is left as it is");
    }

    /** Fluid between lung and diaphragm is seen where the scan shows an organ below, not where that is a template's. */
    @Test
    void highDomesAboveAnOrganOfTheScanAreNotLungsLiftedByFluid() {
        assertThat(notes(bodyWithLiver(PatientStructure.Source.SCAN), -0.62, false)
                        .get(1))
                .doesNotContain("fluid")
                .contains("or a paresis, or ribs or vertebrae are numbered");
        assertThat(notes(bodyWithLiver(PatientStructure.Source.VIRTUAL), -0.62, false)
                        .get(1))
                .contains("fluid");
    }

    private static PatientBody bodyWithLiver(PatientStructure.Source source) {
        Structure liver = new Structure("liver", StructureKind.LIVER, 0, Side.MIDLINE, Shapes.sphere(50, 2));
        return new PatientBody(
                "patient",
                List.of(new PatientStructure(liver, source, Optional.empty(), Optional.empty())),
                List.of(),
                List.of("first"));
    }

    @Test
    void aBodyAtRestOrBroughtThereGetsNone() {
        assertThat(notes(-0.2, false)).containsExactly("first");
        assertThat(notes(0.1, false)).containsExactly("first");
        assertThat(notes(0.6, true)).containsExactly("first");
    }

    private static List<String> notesOfSides(BreathLevel.Mark mark, double right, double left) {
        BreathLevel level = new BreathLevel(mark, right, left, 1, 0.3, 20, Optional.empty());
        return new RestingBody(BODY, Optional.of(level), true, 20)
                .with(BODY)
                .body()
                .notes();
    }

    /** Gas of the stomach under the label of the left lung ends three vertebrae below the right dome. */
    @Test
    void domesOfUnequalHeightGetANote() {
        assertThat(notesOfSides(BreathLevel.Mark.ORGANS, 8, 11.2))
                .hasSize(2)
                .last()
                .asString()
                .contains("the two sides of the scan differ", "T8.0 on the right and T11.2 on the left", "gas of");
        assertThat(notesOfSides(BreathLevel.Mark.DOMES, 9.5, 8)).hasSize(2);
        assertThat(notesOfSides(BreathLevel.Mark.DOMES, 11.5, 12)).containsExactly("first");
        assertThat(notesOfSides(BreathLevel.Mark.DOMES, 8, 10.5)).containsExactly("first");
        assertThat(notesOfSides(BreathLevel.Mark.DOMES, 8, Double.NaN)).containsExactly("first");
        assertThat(notesOfSides(BreathLevel.Mark.LOWER_BORDERS, 8, 12)).containsExactly("first");
    }

    private static PatientBody ofLungs(Side... sides) {
        List<PatientStructure> lungs = Stream.of(sides)
                .map(side -> new Structure("lung", StructureKind.LUNG, 0, side, Shapes.sphere(50, 2)))
                .map(lung ->
                        new PatientStructure(lung, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList();
        return new PatientBody("patient", lungs, List.of(), List.of());
    }

    /** The shape of two whole lungs is measured: where it is not clearly one at inspiration, it is one at rest. */
    @Test
    void aBodyOfUnknownLevelIsSaidToBeTakenForOneAtRest() {
        RestingBody unknown = new RestingBody(BODY, Optional.empty(), false, 0);
        assertThat(unknown.with(BODY).body().notes()).containsExactly("first");
        List<String> note =
                List.of("the scan does not tell how deep the breath is, and is taken for one at end-expiration");
        assertThat(unknown.notesOfUnknownLevel(BODY)).isEqualTo(note);
        assertThat(unknown.notesOfUnknownLevel(ofLungs(Side.LEFT))).isEqualTo(note);
        assertThat(unknown.notesOfUnknownLevel(ofLungs(Side.RIGHT, Side.LEFT))).isEmpty();
        BreathLevel level = new BreathLevel(BreathLevel.Mark.DOMES, 8, 9, 0, 0, 0, Optional.empty());
        assertThat(new RestingBody(BODY, Optional.of(level), false, 0).notesOfUnknownLevel(BODY))
                .isEmpty();
    }
}
