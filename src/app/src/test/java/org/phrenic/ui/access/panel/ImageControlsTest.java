package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.file.Numbers;
import org.phrenic.ui.access.FluoroscopyShot;
import org.phrenic.ui.access.IdleRehearsal;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.access.UltrasoundShot;
import org.phrenic.ui.window.WindowHarness;

/** What a screen reader says of the controls of ultrasound and X-ray, and what is said where there is no image. */
class ImageControlsTest {
    @Test
    void slidersAreReadWithTheValueBesideThem() {
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            UltrasoundDock ultrasound = new UltrasoundDock(session, rehearsal);
            assertThat(description(slider(ultrasound, "Depth")))
                    .isEqualTo(Numbers.format("%.0f mm", UltrasoundSettings.DEFAULT.depthMm()));
            JSlider oblique = slider(new FluoroscopyDock(session, rehearsal), "C-arm to the left");
            oblique.setValue(-30);
            assertThat(description(oblique)).isEqualTo("RAO 30\u00b0");
        });
    }

    /** An image of the former body would look like one of the body beside it. */
    @Test
    void noImageOfTheFormerBodyStaysWhileAnotherIsPrepared() {
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            UltrasoundDock ultrasound = new UltrasoundDock(session, rehearsal);
            FluoroscopyDock xray = new FluoroscopyDock(session, rehearsal);
            rehearsal.activate();
            ultrasound.onUltrasound(Optional.of(new UltrasoundShot(null, null, null)));
            xray.onFluoroscopy(new FluoroscopyShot(null, null, null));
            assertThat(rehearsal.stage()).isEqualTo(RehearsalStage.LOADING);
            ultrasound.onState();
            xray.onState();
            assertThat(ultrasound.view().shot()).isEmpty();
            assertThat(xray.shot()).isEmpty();
        });
    }

    /** What cannot be pressed, or is pressed already, is not asked for. */
    @Test
    void whereNoImageCanComeYetItIsSaidWhatIsWaitedFor() {
        IdleRehearsal.with((session, appearance, view, rehearsal) -> {
            UltrasoundDock ultrasound = new UltrasoundDock(session, rehearsal);
            FluoroscopyDock xray = new FluoroscopyDock(session, rehearsal);
            rehearsal.activate();
            ultrasound.onState();
            assertThat(ultrasound.view().hint()).startsWith("Images come once").doesNotContain("U");
            xray.onState();
            assertThat(xray.hint()).contains("Press X-ray on");
            WindowHarness.find(xray, JToggleButton.class, "X-ray on")
                    .orElseThrow()
                    .doClick();
            assertThat(xray.hint()).startsWith("Pictures come once").doesNotContain("Press");
            rehearsal.deactivate();
            xray.onState();
            assertThat(xray.hint()).as("no picture comes").isEmpty();
        });
    }

    private static JSlider slider(Component dock, String name) {
        return WindowHarness.find(dock, JSlider.class, name).orElseThrow();
    }

    private static String description(JSlider slider) {
        return slider.getAccessibleContext().getAccessibleDescription();
    }
}
