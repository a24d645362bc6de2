package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import javax.swing.JButton;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** Buttons are read whole in docks of windows of 1280 and of 800 pixels. */
class ButtonRowsTest {
    @ParameterizedTest
    @CsvSource({"360, 4", "230, 2"})
    void noTextIsCut(int width, int columns) {
        EventThread.run(() -> {
            Theme.install(false);
            JButton[] buttons = Stream.of("Quiet", "Deep", "Hold at exp.", "Hold at insp.")
                    .map(text -> AccessPanel.button(text, text, () -> {}))
                    .toArray(JButton[]::new);
            ButtonRows rows = new ButtonRows(buttons);
            rows.setSize(width, 1);
            rows.setSize(width, rows.getPreferredSize().height);
            rows.doLayout();
            assertThat(rows.columns()).isEqualTo(columns);
            assertThat(buttons)
                    .allSatisfy(button ->
                            assertThat(button.getWidth()).isGreaterThanOrEqualTo(button.getPreferredSize().width))
                    .allSatisfy(button ->
                            assertThat(button.getY() + button.getHeight()).isLessThanOrEqualTo(rows.getHeight()));
        });
    }
}
