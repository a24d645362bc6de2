package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.phrenic.simulation.live.RunStatus;

class StatusBarTest {
    private final StatusBar bar = new StatusBar();

    private String text(String name) {
        for (Component field : bar.getComponents()) {
            if (("status." + name).equals(field.getName())) {
                return ((JLabel) field).getText();
            }
        }
        throw new AssertionError("no field " + name);
    }

    private static RunStatus status(boolean playing) {
        return new RunStatus(800, 1, 0.00125, 1, 812, 1.015, playing, Optional.empty(), "inspiration", false);
    }

    @Test
    void aPlayingRunTellsItsSpeed() {
        bar.show(status(true));
        assertThat(text("realtime")).isEqualTo("1.02x real time");
        assertThat(text("steps")).isEqualTo("812 steps/s");
    }

    @Test
    void aPausedRunIsSaidToBePausedAndHasNoSpeed() {
        bar.show(status(true));
        bar.show(status(false));
        assertThat(text("realtime")).isEqualTo("paused");
        assertThat(text("steps")).isBlank();
        assertThat(text("time")).isEqualTo("t 1.00 s");
    }

    @Test
    void beforeTheFirstSceneNothingIsPaused() {
        bar.show(RunStatus.NOTHING);
        assertThat(text("realtime")).isBlank();
    }
}
