package org.phrenic.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.TestFrames;

/** Whole breaths gathered from frames of a run that goes on; a breath takes four seconds. */
class CycleRecorderTest {
    private static final double BETWEEN_S = 0.1;

    private final CycleRecorder recorder = new CycleRecorder(8);

    private static Frame frame(double timeS) {
        return TestFrames.of(List.of(), timeS, Math.floor(timeS / 4 + 1e-9), 0);
    }

    private Optional<List<BreathMoment>> from(double startS, double endS) {
        Optional<List<BreathMoment>> last = Optional.empty();
        for (int i = 0; startS + 0.02 * i < endS; i++) {
            Optional<List<BreathMoment>> now = recorder.take(frame(startS + 0.02 * i), BreathLabel.INSPIRATION);
            last = now.isPresent() ? now : last;
        }
        return last;
    }

    @Test
    void aBreathFromTheStartIsWholeWhenTheNextBegins() {
        assertThat(from(0, 3.99)).isEmpty();
        List<BreathMoment> cycle = from(4, 4.01).orElseThrow();
        assertThat(cycle).hasSize(8);
        for (int i = 0; i < 8; i++) {
            assertThat(cycle.get(i).timeS()).isCloseTo(0.5 * i, within(BETWEEN_S));
        }
    }

    @Test
    void aBreathThatWasBegunBeforeIsNotCountedButTheNextIs() {
        assertThat(from(1.5, 5)).isEmpty();
        assertThat(from(5, 8.01).orElseThrow().get(0).timeS()).isCloseTo(4, within(BETWEEN_S));
    }

    @Test
    void afterGoingBackItBeginsAnew() {
        from(0, 6);
        assertThat(from(2, 4.5)).isEmpty();
    }
}
