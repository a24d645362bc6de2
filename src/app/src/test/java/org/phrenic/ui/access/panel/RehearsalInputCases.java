package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JSlider;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.PlanStep;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.window.WindowHarness;

/**
 * Keys, clicks, wheel and slider as a hand uses them, and what comes of them: the plan that is kept, its report, the
 * table of attempts. The window is that of {@link RehearsalWindowTest}.
 */
abstract class RehearsalInputCases {
    /** A pixel of the body at rest is 0.5 to 1 mm wide. */
    private static final double CLICKED_WITHIN_MM = 1;

    static RehearsalHarness clinic;
    static WindowHarness window;

    @TempDir
    Path folder;

    @BeforeAll
    static void open() throws Exception {
        WindowHarness.assumeDisplay();
        clinic = new RehearsalHarness("rehearsal");
        window = clinic.window();
    }

    @AfterAll
    static void close() throws Exception {
        if (clinic != null) {
            clinic.close();
        }
    }

    @BeforeEach
    void fromTheRight() throws Exception {
        clinic.ready();
        window.key("R");
        window.key("shift 3");
        clinic.ready();
    }

    static RehearsalController rehearsal() {
        return clinic.rehearsal();
    }

    static NeedleState state() {
        return clinic.state();
    }

    /** Where a place is in the view, pixels. */
    static double[] pixel(double[] at) {
        return WindowHarness.onEdt(() -> {
            double[] xy = new double[2];
            SceneViewport view = window.window().view();
            view.camera().project(at[0], at[1], at[2], view.getWidth(), view.getHeight(), xy);
            return xy;
        });
    }

    /** Distance of a place from the line of sight through a pixel, mm. */
    private static double besideMm(double[] at, double[] pixel) {
        double[] seen = pixel(at);
        SceneViewport view = window.window().view();
        return Math.hypot(seen[0] - pixel[0], seen[1] - pixel[1])
                * view.camera().mmPerPixel(view.getHeight());
    }

    static double lowestOfTheLiver() {
        return liver()[2];
    }

    /** Box of the liver at rest. */
    private static double[] liver() {
        return WindowHarness.onEdt(() -> window.session().scene().orElseThrow().surfaces().stream()
                .filter(surface -> surface.kind() == StructureKind.LIVER)
                .findFirst()
                .orElseThrow()
                .rest()
                .bounds());
    }

    static double[] middleOfTheLiver() {
        double[] box = liver();
        return new double[] {0.75 * box[0] + 0.25 * box[3], 0.5 * (box[1] + box[4]), 0.5 * (box[2] + box[5])};
    }

    static TargetLesion target() {
        return WindowHarness.onEdt(
                () -> rehearsal().study().map(TargetAccess::target).orElseThrow());
    }

    static void clickView(double[] pixel) {
        window.click(window.window().view(), pixel[0], pixel[1]);
    }

    @Test
    void theListsOfExercisesAndHelpAreGoneThroughBeforeOneIsChosen() {
        Object exercise = WindowHarness.onEdt(() -> rehearsal().exercise());
        Object aids = WindowHarness.onEdt(() -> rehearsal().pictures().aids());
        for (String name : new String[] {"Exercise", "Help"}) {
            JComboBox<?> box = window.control(JComboBox.class, name);
            for (String key : new String[] {"DOWN", "DOWN", "END", "ESCAPE"}) {
                WindowHarness.press(box, KeyStroke.getKeyStroke(key));
            }
            assertThat(WindowHarness.onEdt(box::isPopupVisible)).isFalse();
        }
        assertThat(WindowHarness.onEdt(() -> rehearsal().exercise())).isEqualTo(exercise);
        assertThat(WindowHarness.onEdt(() -> rehearsal().pictures().aids())).isEqualTo(aids);
    }

    /** Waits for the picture of the body at rest, in which places are where they are at rest; the run stands still. */
    private static void lookAtRest() throws InterruptedException {
        clinic.rest();
        // After the picture of this moment none of an earlier one is on its way.
        requirePicture(window.session().live().recordedScenario().steps());
        WindowHarness.doOnEdt(() -> window.session().live().reset());
        requirePicture(0);
    }

    private static void requirePicture(long step) throws InterruptedException {
        SceneViewport view = window.window().view();
        RehearsalHarness.untilWhileItRuns(
                "a picture of step " + step, () -> view.isUnavailable() || view.shownStep() == step);
    }

    @Test
    void targetAndEntryAreSetByKeyAndClickAndStandInThePlanThatIsKept() throws Exception {
        TargetLesion before = target();
        lookAtRest();
        double[] onLiver = pixel(middleOfTheLiver());
        window.key("T");
        assertThat(WindowHarness.onEdt(() -> rehearsal().pickMode().mode())).isEqualTo(PickMode.Kind.TARGET);
        clickView(onLiver);
        clinic.until("another target", () -> rehearsal()
                .study()
                .filter(study -> study.target() != before)
                .isPresent());
        clinic.ready();
        TargetLesion set = target();
        assertThat(besideMm(set.restMm(), onLiver)).isLessThan(CLICKED_WITHIN_MM);
        assertThat(WindowHarness.onEdt(() -> rehearsal().pickMode().mode())).isEqualTo(PickMode.Kind.NONE);

        lookAtRest();
        double[] onSkin = {onLiver[0] - 12, onLiver[1] + 9};
        window.key("E");
        assertThat(WindowHarness.onEdt(() -> rehearsal().pickMode().mode())).isEqualTo(PickMode.Kind.ENTRY);
        clickView(onSkin);
        clinic.until(
                "an entry",
                () -> rehearsal().state().filter(NeedleState::hasNeedle).isPresent());
        double[] entry =
                WindowHarness.onEdt(() -> rehearsal().entrySelection().entry().orElseThrow());
        assertThat(besideMm(entry, onSkin)).isLessThan(CLICKED_WITHIN_MM);
        assertThat(entry[0]).as("on the right of the target").isLessThan(set.restMm()[0]);
        clinic.until("advice", () -> rehearsal().entrySelection().advice().isPresent());

        window.key("I");
        clinic.until("2 mm in", () -> clinic.isAt(2));
        window.key("X");
        clinic.until("a sample", () -> state().samples() == 1);
        Rehearsal attempt = clinic.ended();
        assertThat(attempt.plan().targetSpec().restMm().orElseThrow()).containsExactly(set.restMm());
        List<PlanStep> done = attempt.plan().steps().stream()
                .filter(step -> !(step instanceof PlanStep.WaitSeconds))
                .toList();
        assertThat(done)
                .extracting(step -> step.getClass().getSimpleName())
                .containsExactly("Place", "Advance", "Sample", "Advance");
        assertThat(((PlanStep.Place) done.get(0)).entryRest().orElseThrow()).containsExactly(entry);
        assertThat(((PlanStep.Advance) done.get(1)).depthMm()).hasValue(2.0);
        assertThat(((PlanStep.Advance) done.get(3)).depthMm()).hasValue(0.0);
    }

    @Test
    void aClickBesideWhatIsSoughtSetsNothingAndSaysWhereToClick() throws Exception {
        TargetLesion before = target();
        window.key("T");
        clickView(new double[] {4, 60});
        clinic.until("the sentence", () -> window.window().banner().message().contains("Click on the liver"));
        window.key("E");
        clickView(new double[] {4, 60});
        clinic.until("the sentence", () -> window.window().banner().message().contains("Click on the skin"));
        assertThat(target()).isSameAs(before);
        window.key("E");
        window.key("E");
        assertThat(WindowHarness.onEdt(() -> rehearsal().pickMode().mode()))
                .as("pressed twice: chosen no more")
                .isEqualTo(PickMode.Kind.NONE);
    }

    @Test
    void bestPathByKeyThenKeysWheelAndSliderInsertAndWithdraw() throws Exception {
        window.key("B");
        clinic.until(
                "an entry",
                () -> rehearsal().state().filter(NeedleState::hasNeedle).isPresent());
        double[] best = WindowHarness.onEdt(() -> {
            var map = rehearsal().study().orElseThrow().map();
            return map.pointAtRest(map.best(AccessMap.SUFFICIENT_MARGIN_MM).orElseThrow());
        });
        assertThat(WindowHarness.onEdt(
                        () -> rehearsal().entrySelection().entry().orElseThrow()))
                .containsExactly(best);
        window.key("A");
        clinic.until("aimed by the program", () -> RehearsalHarness.pointsAtTarget(state()));
        window.key("I");
        clinic.until("2 mm in", () -> clinic.isAt(2));
        window.key("shift I");
        clinic.until("12 mm in", () -> clinic.isAt(12));
        window.wheel(window.window().view(), -3);
        clinic.until("18 mm in", () -> clinic.isAt(18));
        window.wheel(window.window().view(), -1, InputEvent.SHIFT_DOWN_MASK);
        clinic.until("28 mm in", () -> clinic.isAt(28));
        window.wheel(window.window().view(), 1, InputEvent.SHIFT_DOWN_MASK);
        clinic.until("18 mm in again", () -> clinic.isAt(18));
        window.key("W");
        clinic.until("16 mm in", () -> clinic.isAt(16));
        JSlider depth = window.control(JSlider.class, "Depth of the tip");
        dragTo(depth, 30);
        clinic.until("near 30 mm in", () -> !state().moving() && state().depthMm() > 24 && state().depthMm() < 36);
        double deep = WindowHarness.onEdt(() -> state().depthMm());
        window.key("shift W");
        clinic.until("10 mm back", () -> clinic.isAt(deep - 10));
        window.key("O");
        clinic.until("out", () -> !state().placed());
    }

    /** Takes the slider's knob and pulls it to a value. */
    private static void dragTo(JSlider slider, int value) {
        int length = slider.getWidth();
        double perMm = (length - 16.0) / slider.getMaximum();
        double from = 8 + perMm * WindowHarness.onEdt(slider::getValue);
        double to = 8 + perMm * value;
        double y = slider.getHeight() / 2.0;
        window.mouse(slider, from, y, MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED);
        window.mouse(slider, 0.5 * (from + to), y, MouseEvent.MOUSE_DRAGGED);
        window.mouse(slider, to, y, MouseEvent.MOUSE_DRAGGED, MouseEvent.MOUSE_RELEASED);
    }

    @Test
    void theViewLooksAlongTheNeedleAndTheSectionsHoldIt() throws Exception {
        window.key("B");
        clinic.until(
                "an entry",
                () -> rehearsal().state().filter(NeedleState::hasNeedle).isPresent());
        window.key("shift I");
        clinic.until("10 mm in", () -> clinic.isAt(10));
        window.key("N");
        Camera camera = WindowHarness.onEdt(() -> window.window().view().camera());
        NeedleState now = WindowHarness.onEdt(() -> state());
        double[] along = Vectors.normalize(Vectors.subtract(now.tip(), now.hub()));
        Vector3d viewer = camera.towardsViewer();
        assertThat(viewer.dot(along[0], along[1], along[2]))
                .as("the viewer is behind the hub")
                .isLessThan(-0.999);
        window.key("1");
        assertThat(WindowHarness.onEdt(() -> window.window().view().camera().azimuthDeg()))
                .isCloseTo(AnatomicalView.ANTERIOR.azimuthDeg(), within(1e-9));
        SectionDock sections =
                WindowHarness.onEdt(() -> find(window.window().frame().getRootPane()));
        clinic.until("a section along the needle", () -> sections.along().section() != null);
        clinic.until("a section across it", () -> sections.across().section() != null);
        window.screenshot("rehearse-along");
    }

    private static SectionDock find(java.awt.Container at) {
        for (java.awt.Component child : at.getComponents()) {
            if (child instanceof SectionDock dock) {
                return dock;
            }
            SectionDock found = child instanceof java.awt.Container container ? find(container) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    @Test
    void attemptsStandInTheTableAndRetryAndSaveDoWhatTheySay() throws Exception {
        AttemptsDock dock = WindowHarness.onEdt(() -> new AttemptsDock(
                window.session(), rehearsal(), clinic.smallPictures(), () -> Optional.of(folder.resolve("kept"))));
        try {
            attempt(8);
            Rehearsal missed =
                    WindowHarness.onEdt(() -> dock.attempts().get(0).whole().orElseThrow());
            JTable table = table();
            int rows = WindowHarness.onEdt(table::getRowCount);
            assertThat(cell(table, rows - 1, 2)).isEqualTo("missed");
            assertThat(WindowHarness.onEdt(() -> clinic.attempts().card().text()))
                    .startsWith("Missed");
            double[] entry = WindowHarness.onEdt(
                    () -> rehearsal().entrySelection().entry().orElseThrow());

            window.click(window.control(JButton.class, "Retry"));
            clinic.until("a new attempt", () -> rehearsal()
                    .state()
                    .filter(s -> s.samples() == 0 && s.hasNeedle())
                    .isPresent());
            assertThat(WindowHarness.onEdt(
                            () -> rehearsal().entrySelection().entry().orElseThrow()))
                    .containsExactly(entry);
            assertThat(target().restMm()).containsExactly(missed.target().restMm());
            double aimed = Vectors.distance(entry, target().restMm());
            attempt(aimed);
            assertThat(WindowHarness.onEdt(table::getRowCount)).isEqualTo(rows + 1);
            assertThat(Double.parseDouble(cell(table, rows, 3)))
                    .as("mm off, nearer than before")
                    .isLessThan(Double.parseDouble(cell(table, rows - 1, 3)));
            WindowHarness.doOnEdt(() -> table.setRowSelectionInterval(rows - 1, rows - 1));
            assertThat(WindowHarness.onEdt(() -> clinic.attempts().card().text()))
                    .as("the chosen attempt's card")
                    .startsWith("Missed");

            JButton save = WindowHarness.onEdt(
                    () -> WindowHarness.find(dock, JButton.class, "Save report").orElseThrow());
            clinic.rest();
            WindowHarness.doOnEdt(save::doClick);
            clinic.until("the report", () -> save.isEnabled());
            clinic.goOn();
            for (String file : new String[] {"report.html", "report.json", "plan.yaml", "scenario.yaml"}) {
                assertThat(folder.resolve("kept").resolve(file)).isNotEmptyFile();
            }
            if (!window.window().view().isUnavailable()) {
                assertThat(folder.resolve("kept"))
                        .isDirectoryContaining("glob:**sample*.png")
                        .isDirectoryContaining("glob:**access*.png");
            }
            assertThat(folder.resolve("kept/report.html"))
                    .content()
                    .contains("<img", "Not for clinical use", "not validated", "Date: 20", "Body: virtual/adult-male")
                    .contains("Help: ");
        } finally {
            WindowHarness.doOnEdt(() -> rehearsal().removeListener(dock));
        }
    }

    private static void attempt(double depthMm) throws Exception {
        if (WindowHarness.onEdt(() -> rehearsal().entrySelection().entry().isEmpty())) {
            window.key("B");
        }
        clinic.until(
                "an entry",
                () -> rehearsal().state().filter(NeedleState::hasNeedle).isPresent());
        window.key("A");
        clinic.until("a needle that points at the target", () -> RehearsalHarness.pointsAtTarget(state()));
        WindowHarness.doOnEdt(() -> rehearsal().needle().moveTo(depthMm));
        clinic.until("in", () -> state().placed() && state().depthMm() > 0.9 * depthMm && !state().moving());
        window.key("X");
        clinic.until("a sample", () -> state().samples() == 1);
        clinic.ended();
    }

    private static JTable table() {
        return window.control(JTable.class, "Attempts of this session");
    }

    private static String cell(JTable table, int row, int column) {
        return WindowHarness.onEdt(() -> String.valueOf(table.getValueAt(row, column)));
    }
}
