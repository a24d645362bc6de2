package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.breathing.RespiratoryPhase;

/** The colour of a path at one moment. */
class EntrySelectionTest {
    private static final double[] ENTRY = {0, -100, 0};
    private static final double[] TIP = {0, -40, 0};
    private static final String PULLED = "the moving liver pulls the capsule 6 mm aside of the needle";

    private static PathAdvice.Level level(double marginMm, List<String> reasons, List<String> warnings) {
        return EntrySelection.presentLevel(new NeedleState(
                1,
                RespiratoryPhase.PAUSE,
                TIP,
                10,
                Optional.of(ENTRY),
                true,
                ENTRY,
                TIP,
                60,
                60,
                false,
                Optional.empty(),
                reasons,
                marginMm,
                "right lung",
                warnings,
                0,
                new NeedleAngles(0, 0),
                Optional.empty(),
                NeedleLoad.NONE));
    }

    @Test
    void aWarningCallsForCareAndDoesNotBar() {
        assertThat(level(20, List.of(), List.of())).isEqualTo(PathAdvice.Level.FREE);
        assertThat(level(20, List.of(), List.of(PULLED))).isEqualTo(PathAdvice.Level.CAREFUL);
        assertThat(level(1, List.of(), List.of())).isEqualTo(PathAdvice.Level.CAREFUL);
    }

    @Test
    void aReasonBarsWhateverIsWarnedOf() {
        assertThat(level(0, List.of("crosses lung"), List.of())).isEqualTo(PathAdvice.Level.BARRED);
        assertThat(level(0, List.of("crosses lung"), List.of(PULLED))).isEqualTo(PathAdvice.Level.BARRED);
    }
}
