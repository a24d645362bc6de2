package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import javax.swing.JLabel;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.widget.Theme;

/** Messages are read whole in views of all widths. */
class MessageBannerTest {
    private static final Session.Message LONG = new Session.Message(
            Session.Message.Kind.DIVERGED,
            "the simulation diverged at node 4711 after 2.35 s and was restored; the last change was muscle_force_mn");

    @ParameterizedTest
    @ValueSource(ints = {800, 500, 270})
    void aMessageWrapsToTheWidthThatThereIs(int width) {
        EventThread.run(() -> {
            Theme.install(false);
            MessageBanner banner = new MessageBanner();
            banner.show(LONG, Optional.of("Back to the last good state"), () -> {});
            banner.fit(width);
            banner.setSize(width, banner.getPreferredSize().height);
            banner.doLayout();
            JLabel text = WindowHarness.find(banner, JLabel.class, "Message").orElseThrow();
            assertThat(text.getWidth()).isGreaterThanOrEqualTo(text.getPreferredSize().width);
            assertThat(text.getHeight()).isGreaterThanOrEqualTo(text.getPreferredSize().height);
        });
    }
}
