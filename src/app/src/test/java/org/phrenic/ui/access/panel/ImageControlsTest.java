package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import javax.swing.JSlider;
import org.junit.jupiter.api.Test;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.file.Numbers;
import org.phrenic.ui.access.IdleRehearsal;
import org.phrenic.ui.window.WindowHarness;

/** What a screen reader says of the controls of ultrasound and X-ray. */
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

    private static JSlider slider(Component dock, String name) {
        return WindowHarness.find(dock, JSlider.class, name).orElseThrow();
    }

    private static String description(JSlider slider) {
        return slider.getAccessibleContext().getAccessibleDescription();
    }
}
