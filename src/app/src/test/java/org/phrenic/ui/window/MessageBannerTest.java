package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.text.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.SessionMessage;
import org.phrenic.ui.widget.Theme;

/** Messages are read whole in views of all widths. */
class MessageBannerTest {
    private static final SessionMessage LONG = new SessionMessage(
            SessionMessage.Kind.DIVERGED,
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

    /** A path is one word, and longer than a line of a narrow view. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "Copied: phrenic run --set 'name=/home/someone/a-folder-of-scans/and-a-long-name-of-a-scenario.yaml'",
                "Found 4f1d2a3b4c5d6e7f8091a2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e6f7, expected another"
            })
    void aLongWordIsBroken(String sentence) {
        EventThread.run(() -> {
            Theme.install(false);
            MessageBanner banner = new MessageBanner();
            banner.show(new SessionMessage(SessionMessage.Kind.NOTE, sentence));
            banner.fit(270);
            banner.setSize(270, banner.getPreferredSize().height);
            banner.doLayout();
            JLabel text = WindowHarness.find(banner, JLabel.class, "Message").orElseThrow();
            View lines = (View) text.getClientProperty(BasicHTML.propertyKey);
            assertThat(lines.getMinimumSpan(View.X_AXIS)).isLessThanOrEqualTo(text.getWidth());
            assertThat(text.getWidth()).isGreaterThanOrEqualTo(text.getPreferredSize().width);
            assertThat(text.getHeight()).isGreaterThanOrEqualTo(text.getPreferredSize().height);
            assertThat(banner.message()).isEqualTo(sentence);
        });
    }

    private static boolean hasButton(MessageBanner banner) {
        return Arrays.stream(banner.getComponents())
                .anyMatch(part -> "banner.help".equals(part.getName()) && part.isVisible());
    }

    @Test
    void whatIsSaidAfterADivergenceWaitsUntilThatIsOver() {
        EventThread.run(() -> {
            Theme.install(false);
            MessageBanner banner = new MessageBanner();
            banner.show(LONG, Optional.of("Back to the last good state"), () -> {});
            banner.show(new SessionMessage(SessionMessage.Kind.NOTE, "Saved a.png."));
            banner.show(new SessionMessage(SessionMessage.Kind.REFUSED, "found 3, expected 1"));
            assertThat(banner.message()).isEqualTo(LONG.text());
            assertThat(hasButton(banner)).isTrue();
            banner.endDivergence();
            assertThat(banner.message()).isEqualTo("Saved a.png.");
            assertThat(hasButton(banner)).isFalse();
            banner.endDivergence();
            assertThat(banner.message()).as("a note is no divergence").isEqualTo("Saved a.png.");
            WindowHarness.find(banner, JButton.class, "Close this message")
                    .orElseThrow()
                    .doClick();
            assertThat(banner.message()).isEqualTo("found 3, expected 1");
        });
    }

    @Test
    void theButtonOfADivergenceDoesWhatItOffersOnce() {
        EventThread.run(() -> {
            Theme.install(false);
            int[] pressed = new int[1];
            MessageBanner banner = new MessageBanner();
            banner.show(LONG, Optional.of("Back to the last good state"), () -> pressed[0]++);
            banner.show(new SessionMessage(SessionMessage.Kind.NOTE, "Saved a.png."));
            Arrays.stream(banner.getComponents())
                    .filter(part -> "banner.help".equals(part.getName()))
                    .forEach(part -> ((JButton) part).doClick());
            assertThat(pressed[0]).isEqualTo(1);
            assertThat(banner.message()).isEqualTo("Saved a.png.");
        });
    }
}
