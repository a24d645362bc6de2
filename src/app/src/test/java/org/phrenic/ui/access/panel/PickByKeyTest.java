package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import org.junit.jupiter.api.Test;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.window.WindowHarness;

/** What a click chooses in the view is chosen by the keyboard too: the middle of the view, which keys turn and move. */
class PickByKeyTest {
    @Test
    void theEnterKeyPutsTheProbeInTheMiddleOfTheViewAndNamesWhatIsThere() throws Exception {
        WindowHarness.assumeDisplay();
        RehearsalHarness clinic = new RehearsalHarness("pick-by-key");
        try {
            SceneViewport view = clinic.window().window().view();
            assumeThat(view.isUnavailable()).isFalse();
            clinic.window().key("U");
            clinic.until(
                    "a pick that is awaited",
                    () -> clinic.rehearsal().pickMode().mode() == PickMode.Kind.PROBE);
            clinic.window().key("ENTER");
            clinic.until("a place", () -> clinic.rehearsal().probe().hold().isPresent());
            assertThat(WindowHarness.onEdt(() -> clinic.rehearsal().pickMode().mode()))
                    .isEqualTo(PickMode.Kind.NONE);
            clinic.window().key("ENTER");
            clinic.until("a name", () -> view.picked().isPresent());
        } finally {
            clinic.close();
        }
    }
}
