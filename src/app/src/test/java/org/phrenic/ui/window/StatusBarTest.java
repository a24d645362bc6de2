package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.simulation.live.RunStatus;

class StatusBarTest {
    private final StatusBar bar = new StatusBar();

    private String text(String name) {
        return field(name).getText();
    }

    private JLabel field(String name) {
        for (Component field : bar.getComponents()) {
            if (("status." + name).equals(field.getName())) {
                return (JLabel) field;
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
    void beforeTheFirstSceneNothingIsSaidOfItsResolution() {
        bar.showResolution(0.7);
        assertThat(text("quality")).isBlank();
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
    void aRecordedMomentIsNotThePresent() {
        bar.show(status(true));
        bar.showRecorded(0.12);
        assertThat(text("time")).isEqualTo("t 0.12 s");
        assertThat(text("phase")).isEqualTo("recorded");
        assertThat(text("realtime")).isEqualTo("paused");
        assertThat(text("step")).isBlank();
        bar.show(status(true));
        assertThat(text("time")).isEqualTo("t 1.00 s");
    }

    /** Their names say what the fields are; a reader of the screen says name and description. */
    @Test
    void aScreenReaderIsToldWhatTheFieldsShow() {
        bar.show(status(true));
        assertThat(description("time")).isEqualTo("t 1.00 s");
        bar.showRecorded(0.12);
        assertThat(description("time")).isEqualTo("t 0.12 s");
        assertThat(description("steps")).isEqualTo(field("steps").getToolTipText());
    }

    /** The colour of the real-time factor alone says it to who sees. */
    @Test
    void aScreenReaderIsToldThatTheBreathIsSlow() {
        bar.show(status(true));
        String pace = description("realtime");
        assertThat(pace).endsWith("x real time");
        bar.showPace(true);
        assertThat(description("realtime")).startsWith(pace + ". Slower than it should be");
        bar.showPace(false);
        assertThat(description("realtime")).isEqualTo(pace);
    }

    private String description(String name) {
        return field(name).getAccessibleContext().getAccessibleDescription();
    }

    @ParameterizedTest
    @ValueSource(ints = {500, 800, 1100, 1400})
    void noFieldIsPrintedOverAnother(int width) {
        bar.show(status(true));
        bar.setBounds(0, 0, width, 24);
        bar.doLayout();
        int right = 0;
        for (Component field : bar.getComponents()) {
            if (field.isVisible()) {
                assertThat(field.getX()).isGreaterThanOrEqualTo(right);
                right = field.getX() + field.getWidth();
            }
        }
        assertThat(right).isLessThanOrEqualTo(width);
    }

    @Test
    void thePhaseStaysLongestAndNodesGoFirst() {
        bar.setBounds(0, 0, 500, 24);
        assertThat(field("phase").isVisible()).isTrue();
        assertThat(field("nodes").isVisible()).isFalse();
        bar.setBounds(0, 0, 2000, 24);
        assertThat(field("nodes").isVisible()).isTrue();
        bar.setNumericsVisible(false);
        assertThat(field("nodes").isVisible()).isFalse();
    }

    @Test
    void beforeTheFirstSceneNothingIsPaused() {
        bar.show(RunStatus.NOTHING);
        assertThat(text("realtime")).isBlank();
    }
}
