package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Theme;
import org.phrenic.ui.window.WindowHarness;

/** Where the controls of the needle are in the dock of a window of 1280 x 800. */
class RehearsalDockTest {
    private static final int WIDTH = 363;
    private static final int HEIGHT = 615;
    private static final String LONG = "Now barred: the way runs through a rib, a lung and a vessel. ".repeat(4);

    private static Session session;
    private static SceneViewport view;
    private static RehearsalController rehearsal;
    private static RehearsalDock dock;

    @BeforeAll
    static void open() {
        EventThread.run(() -> {
            Theme.install(false);
            AppearanceModel appearance = new AppearanceModel();
            session = new Session(Scenario.defaults().with("resolution=low"));
            view = new SceneViewport(session, appearance);
            rehearsal = new RehearsalController(session, appearance, view);
            dock = new RehearsalDock(session, rehearsal, preset -> {});
        });
    }

    @AfterAll
    static void close() {
        EventThread.run(() -> {
            rehearsal.shutdown();
            view.close();
            session.close();
        });
    }

    private static boolean isLit(String preset) {
        return WindowHarness.find(dock, JToggleButton.class, preset)
                .orElseThrow()
                .isSelected();
    }

    @Test
    void aRecordedBreathIsNeitherQuietNorDeep(@TempDir Path folder) throws IOException {
        Path trace = Files.writeString(
                folder.resolve("breath.csv"),
                "time_s,amplitude\n0,0\n0.5,0.3\n1,0.8\n1.5,1\n2,0.9\n2.5,0.4\n3,0.1\n3.5,0\n4,0\n");
        EventThread.run(() -> session.change("Deep", Assignment.parse("preset=deep")));
        EventThread.until("the preset", () -> isLit("Breathe deeply"));
        EventThread.run(() -> session.change("Trace", Assignment.read("test", "trace", trace.toString())));
        EventThread.until("the trace", () -> !isLit("Breathe deeply"));
        assertThat(EventThread.get(() -> session.scenario().trace())).isPresent();
        assertThat(EventThread.get(() -> isLit("Breathe quietly"))).isFalse();
    }

    private static List<JComponent> needleControls() {
        List<JComponent> controls = new ArrayList<>();
        Stream.of("Insert", "Withdraw", "Go to target", "Aim for me", "Take sample", "Take out")
                .map(name -> WindowHarness.find(dock, JButton.class, name).orElseThrow())
                .forEach(controls::add);
        controls.add(WindowHarness.find(dock, JSlider.class, "Depth of the tip").orElseThrow());
        return controls;
    }

    private static List<Rectangle> places(String said, String label) {
        WrappingLabel text =
                WindowHarness.find(dock, WrappingLabel.class, label).orElseThrow();
        text.setText(said);
        dock.setSize(WIDTH, HEIGHT);
        // Twice: the height of a text that wraps is known once its width is.
        for (int i = 0; i < 2; i++) {
            layOut(dock);
        }
        return needleControls().stream()
                .map(control -> SwingUtilities.convertRectangle(control, new Rectangle(control.getSize()), dock))
                .toList();
    }

    private static void layOut(Container part) {
        part.invalidate();
        part.doLayout();
        Stream.of(part.getComponents()).filter(Container.class::isInstance).forEach(child -> layOut((Container) child));
    }

    @Test
    void nothingThatIsSaidMovesTheControlsOfTheNeedle() {
        EventThread.run(() -> {
            List<Rectangle> usual = places("", "About the exercise");
            assertThat(places(LONG, "About the exercise")).isEqualTo(usual);
            assertThat(places(LONG, "Tip to target")).isEqualTo(usual);
            places("Tip to target: -", "Tip to target");
        });
    }

    /** A scroll bar that came and went would break the texts into other lines. */
    @Test
    void theListOfExercisesStaysWhereItIsWhenMoreIsSaid() {
        EventThread.run(() -> {
            JComboBox<?> list =
                    WindowHarness.find(dock, JComboBox.class, "Exercise").orElseThrow();
            places("", "About the exercise");
            Rectangle usual = list.getBounds();
            places(LONG.repeat(9), "About the exercise");
            assertThat(list.getBounds()).isEqualTo(usual);
        });
    }

    @Test
    void thePresentStandsAboveTheBreath() {
        EventThread.run(() -> {
            AdvicePanel now = WindowHarness.find(dock, AdvicePanel.class, "Path at present")
                    .orElseThrow();
            AdvicePanel breath = WindowHarness.find(dock, AdvicePanel.class, "Path over the breath")
                    .orElseThrow();
            assertThat(now.getParent().getComponentZOrder(now))
                    .isLessThan(now.getParent().getComponentZOrder(breath));
        });
    }

    @Test
    void theControlsOfTheNeedleAreWholeHoweverMuchIsSaidAboveThem() {
        EventThread.run(() -> {
            places(LONG.repeat(3), "About the exercise");
            for (JComponent control : needleControls()) {
                assertThat(control.getVisibleRect()).as(control.getName()).isEqualTo(new Rectangle(control.getSize()));
            }
        });
    }
}
