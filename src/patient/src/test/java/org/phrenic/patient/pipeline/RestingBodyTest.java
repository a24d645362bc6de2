package org.phrenic.patient.pipeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.diaphragm.BreathLevel;

/** What the notes of a body say about its breath level. */
class RestingBodyTest {
    private static final PatientBody BODY = new PatientBody("patient", List.of(), List.of(), List.of("first"));

    private static List<String> notes(double share, boolean moved) {
        BreathLevel level = new BreathLevel(BreathLevel.Mark.DOMES, 6.1, 6.9, -2, share, -40, Optional.empty());
        return new RestingBody(BODY, Optional.of(level), moved, 0)
                .with(BODY)
                .body()
                .notes();
    }

    @Test
    void aBodyWithHighDomesOrLeftAtInspirationGetsANote() {
        assertThat(notes(-0.62, false))
                .containsExactly(
                        "first",
                        "the scan is one with high domes, the domes at T6.1 on the right and T6.9 on the left (T8 and T9 at"
                                + " end-expiration), and is left as it is: they stand so in pregnancy, obesity, ascites or"
                                + " a paresis, or the vertebrae are numbered one too low");
        assertThat(notes(0.6, false))
                .hasSize(2)
                .last()
                .asString()
                .contains("is one at inspiration, ", "is left as it is");
    }

    @Test
    void aBodyAtRestOrBroughtThereGetsNone() {
        assertThat(notes(-0.2, false)).containsExactly("first");
        assertThat(notes(0.1, false)).containsExactly("first");
        assertThat(notes(0.6, true)).containsExactly("first");
        assertThat(new RestingBody(BODY, Optional.empty(), false, 0)
                        .with(BODY)
                        .body()
                        .notes())
                .containsExactly("first");
    }
}
