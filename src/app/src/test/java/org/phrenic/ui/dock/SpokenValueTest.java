package org.phrenic.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import javax.accessibility.Accessible;
import javax.swing.JComboBox;
import javax.swing.JSlider;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.MessageListener;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.window.WindowHarness;

/** What a screen reader says of controls whose own value is a position. */
class SpokenValueTest {
    private static final Scenario SMALL = Scenario.defaults().with("resolution=low", "threads=1");

    private static String description(Accessible control) {
        return control.getAccessibleContext().getAccessibleDescription();
    }

    @Test
    void theSliderOfAParameterIsReadWithItsValueAndUnit() {
        EventThread.run(() -> {
            try (Session session = new Session(SMALL)) {
                SliderRow row = new SliderRow(session, SheetSprings.MUSCLE_STIFFNESS);
                row.show(session.scenario());
                assertThat(description(row.slider()))
                        .isEqualTo(
                                NumberFormats.withUnit(session.scenario().get(SheetSprings.MUSCLE_STIFFNESS), "N/m"));
                row.slider().setValue(row.slider().getMaximum());
                assertThat(description(row.slider()))
                        .isEqualTo(NumberFormats.withUnit(SheetSprings.MUSCLE_STIFFNESS.maximum(), "N/m"));
            }
        });
    }

    @Test
    void thePlaceOfTheClipPlaneIsReadInMm() {
        EventThread.run(() -> {
            try (Session session = new Session(SMALL)) {
                DisplayDock dock = new DisplayDock(session, new AppearanceModel());
                find(dock, JComboBox.class, "Clip plane").setSelectedIndex(1);
                assertThat(description(find(dock, JSlider.class, "Place of the clip plane")))
                        .isEqualTo("0 mm");
            }
        });
    }

    @Test
    void aRangeOfColoursThatIsNoneIsRefusedInOneSentence() {
        List<String> refused = new ArrayList<>();
        EventThread.run(() -> {
            try (Session session = new Session(SMALL)) {
                session.addListener(new MessageListener(refused::add));
                DisplayDock dock = new DisplayDock(session, new AppearanceModel());
                JTextField least = find(dock, JTextField.class, "Least value of the colours");
                least.setText("30");
                least.postActionEvent();
                assertThat(refused)
                        .containsExactly("Range of the colours: found '30' to '20', expected two numbers, the smaller"
                                + " first; the former range stays.");
                assertThat(description(least)).isEqualTo(refused.get(0));
                least.setText("10");
                least.postActionEvent();
                assertThat(description(least)).isEqualTo(least.getToolTipText()).isNotEmpty();
                assertThat(refused).hasSize(1);
            }
        });
    }

    private static <C extends Component> C find(DisplayDock dock, Class<C> kind, String name) {
        return WindowHarness.find(dock, kind, name).orElseThrow();
    }
}
