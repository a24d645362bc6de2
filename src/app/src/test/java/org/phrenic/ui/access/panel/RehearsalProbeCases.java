package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.awt.event.MouseEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Test;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.ProbeState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.mesh.Vectors;
import org.phrenic.scenario.Assignment;
import org.phrenic.scene.NeedleMarkers;
import org.phrenic.ui.access.AttemptHistory;
import org.phrenic.ui.access.PickMode;
import org.phrenic.ui.access.UltrasoundShot;
import org.phrenic.ui.view.RenderedFrame;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.window.WindowHarness;

/**
 * The probe in the hand, the needle aimed by hand, X-ray and what is hidden of the body, by keys and mouse. The window
 * is that of {@link RehearsalWindowTest}.
 */
abstract class RehearsalProbeCases extends RehearsalInputCases {
    private static final double SLIDE_MM = 2;
    /** Below the lower edge of the liver no rib stops a needle at 45 degrees, mm. */
    private static final double BELOW_MM = 10;
    /** The probe is 60 mm wide. */
    private static final double BESIDE_MM = 60;

    private static ProbeState probe() {
        return state().probe().orElseThrow();
    }

    private static void putProbe() throws Exception {
        putProbe(middleOfTheLiver());
    }

    /** Puts the probe on the skin that covers a point in the view. */
    private static void putProbe(double[] before) throws Exception {
        window.key("shift U");
        clinic.until("no probe", () -> state().probe().isEmpty());
        double[] onSkin = pixel(before);
        window.key("U");
        clinic.until("a click that is awaited", () -> rehearsal().pickMode().mode() == PickMode.Kind.PROBE);
        clickView(onSkin);
        clinic.until("what was clicked on", () -> rehearsal().pickMode().mode() == PickMode.Kind.NONE);
        clinic.until("a place", () -> rehearsal().probe().hold().isPresent());
        clinic.until(
                "a probe", () -> rehearsal().state().flatMap(NeedleState::probe).isPresent());
    }

    private static UltrasoundDock ultrasound() {
        return WindowHarness.onEdt(() -> descendant(window.window().frame().getRootPane(), UltrasoundDock.class));
    }

    static <T> T descendant(java.awt.Container at, Class<T> kind) {
        for (java.awt.Component child : at.getComponents()) {
            T found = kind.isInstance(child)
                    ? kind.cast(child)
                    : child instanceof java.awt.Container deeper ? descendant(deeper, kind) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    private static double[] place() {
        return WindowHarness.onEdt(
                () -> rehearsal().probe().hold().orElseThrow().pointRest());
    }

    @Test
    void aProbeIsPutOnTheSkinByAClickAndMovedByKeys() throws Exception {
        putProbe();
        clinic.until("an image", () -> ultrasound().view().shot().isPresent());
        double[] first = place();
        double rotation = WindowHarness.onEdt(() -> rehearsal().probe().angles().rotationDeg());
        window.key("shift LEFT");
        clinic.until("slid", () -> Vectors.distance(probe().hold().pointRest(), first) > 0.5 * SLIDE_MM);
        assertThat(Vectors.distance(place(), first)).isCloseTo(SLIDE_MM, within(0.5));
        assertThat(place()[2])
                .as("at no rotation the marker is toward the head")
                .isGreaterThan(first[2]);
        window.key("COMMA");
        window.key("control UP");
        window.key("control LEFT");
        clinic.until("turned", () -> probe().hold().angles().rockDeg() == 2);
        assertThat(probe().hold().angles().rotationDeg()).isEqualTo(rotation + 5);
        assertThat(probe().hold().angles().tiltDeg()).isEqualTo(2);
        UltrasoundShot shot =
                WindowHarness.onEdt(() -> ultrasound().view().shot().orElseThrow());
        clinic.until(
                "an image of the moved probe",
                () -> ultrasound().view().shot().orElseThrow().state().timeS()
                        > shot.state().timeS());
        window.key("control DOWN");
        window.key("control RIGHT");
        window.key("PERIOD");
        window.key("shift U");
        clinic.until("lifted", () -> state().probe().isEmpty());
        clinic.until("no image", () -> ultrasound().view().shot().isEmpty());
    }

    /** The middle of the view, which keys turn and move, is chosen by the keyboard as a place is by a click. */
    @Test
    void theEnterKeyPutsTheProbeInTheMiddleOfTheViewAndNamesWhatIsThere() throws Exception {
        SceneViewport view = window.window().view();
        assumeThat(view.isUnavailable()).isFalse();
        window.key("shift U");
        clinic.until("no probe", () -> rehearsal().probe().hold().isEmpty());
        nameNothing(view);
        window.key("U");
        clinic.until("a pick that is awaited", () -> rehearsal().pickMode().mode() == PickMode.Kind.PROBE);
        window.key("ENTER");
        clinic.until("a place", () -> rehearsal().probe().hold().isPresent());
        assertThat(WindowHarness.onEdt(() -> rehearsal().pickMode().mode())).isEqualTo(PickMode.Kind.NONE);
        assertThat(WindowHarness.onEdt(view::picked)).isEmpty();
        window.key("ENTER");
        clinic.until("a name", () -> view.picked().isPresent());
        nameNothing(view);
        window.key("shift U");
    }

    /** A click beside the body, after which no structure is named or stands out. */
    private static void nameNothing(SceneViewport view) throws InterruptedException {
        clickView(new double[] {4, 60});
        clinic.until("no name", () -> view.picked().isEmpty());
    }

    @Test
    void draggingTheProbeSlidesItAndDraggingTheHubTurnsTheNeedle() throws Exception {
        putProbe();
        double[] first = place();
        SceneViewport view = window.window().view();
        double[] at = pixel(WindowHarness.onEdt(() -> probe().pose().face()));
        window.mouse(view, at[0], at[1], MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED);
        window.mouse(view, at[0] + 20, at[1] + 12, MouseEvent.MOUSE_DRAGGED);
        clinic.until("slid", () -> Vectors.distance(probe().hold().pointRest(), first) > 4);
        window.mouse(view, at[0] + 20, at[1] + 12, MouseEvent.MOUSE_RELEASED);
        assertThat(place()[2]).as("dragged down").isLessThan(first[2]);
        assertDraggedProbeEndsUnderTheMouse();

        window.key("K");
        clinic.until("an entry", () -> state().hasNeedle());
        window.key("shift U");
        clinic.until("lifted", () -> state().probe().isEmpty());
        NeedleState before = WindowHarness.onEdt(RehearsalInputCases::state);
        double[] hub = pixel(before.hub());
        window.mouse(view, hub[0], hub[1], MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED);
        window.mouse(view, hub[0], hub[1] + 25, MouseEvent.MOUSE_DRAGGED, MouseEvent.MOUSE_RELEASED);
        clinic.until(
                "turned to the head",
                () -> state().angles().cranialDeg() > before.angles().cranialDeg() + 3);
    }

    /** The mouse goes on and stops while the skin under it is still searched; then the probe is lifted meanwhile. */
    private static void assertDraggedProbeEndsUnderTheMouse() throws Exception {
        SceneViewport view = window.window().view();
        double[] at = pixel(WindowHarness.onEdt(() -> probe().pose().face()));
        double[] before = place();
        window.mouse(view, at[0], at[1], MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED);
        window.mouse(view, at[0] - 4, at[1], MouseEvent.MOUSE_DRAGGED);
        window.mouse(view, at[0] - 30, at[1] - 12, MouseEvent.MOUSE_DRAGGED, MouseEvent.MOUSE_RELEASED);
        clinic.until(
                "where the mouse has stopped",
                () -> Vectors.distance(probe().hold().pointRest(), before) > 10);
        double[] now = pixel(WindowHarness.onEdt(() -> probe().pose().face()));
        WindowHarness.doOnEdt(() -> {
            window.mouse(view, now[0], now[1], MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED);
            window.mouse(view, now[0] + 8, now[1], MouseEvent.MOUSE_DRAGGED);
            rehearsal().probe().lift();
            window.mouse(view, now[0] + 8, now[1], MouseEvent.MOUSE_RELEASED);
        });
        CompletableFuture<Boolean> searched = new CompletableFuture<>();
        WindowHarness.doOnEdt(() -> view.pick((int) now[0], (int) now[1], s -> 1, found -> searched.complete(true)));
        searched.get(60, TimeUnit.SECONDS);
        assertThat(WindowHarness.onEdt(() -> rehearsal().probe().hold())).isEmpty();
        putProbe();
    }

    @Test
    void aNeedleInTheImagePlaneIsSeenAndItsReportSaysSo() throws Exception {
        double[] belowTheRibs = middleOfTheLiver();
        belowTheRibs[2] = lowestOfTheLiver() - BELOW_MM;
        putProbe(belowTheRibs);
        window.key("K");
        clinic.until(
                "an entry beside the probe",
                () -> state().hasNeedle()
                        && Vectors.distance(
                                        state().entry().orElseThrow(),
                                        probe().pose().face())
                                < BESIDE_MM);
        double cranial = WindowHarness.onEdt(() -> state().angles().cranialDeg());
        window.key("UP");
        window.key("UP");
        clinic.until("turned", () -> Math.abs(state().angles().cranialDeg() - cranial - 2) < 1e-6);
        window.key("DOWN");
        window.key("DOWN");
        clinic.until("turned back", () -> Math.abs(state().angles().cranialDeg() - cranial) < 1e-6);
        window.key("H");
        clinic.until("a held breath", () -> window.session().scenario().hold());
        window.key("shift I");
        clinic.until("10 mm in", () -> clinic.isAt(10));
        window.key("shift I");
        clinic.until("20 mm in", () -> clinic.isAt(20) || (state().depthMm() > 10.5 && !state().moving()));
        window.key("X");
        clinic.until("a sample", () -> state().samples() == 1);
        clinic.until("a word of it", () -> window.window().banner().message().startsWith("Sample taken"));
        window.screenshot("rehearse-probe");
        Rehearsal attempt = clinic.ended();
        window.key("H");
        assertThat(attempt.plan().aimsByProgram()).isZero();
        assertThat(attempt.probe().probeS()).isGreaterThan(attempt.record().insideS());
        assertThat(attempt.probe().needleInBeamMm()).as("mm in the beam").isPositive();
        assertThat(WindowHarness.onEdt(() -> clinic.attempts().card().text())).contains("Aimed by hand", "Probe");
        assertHistoryKeeps(attempt);
    }

    /** Two sessions of one sample each. */
    private void assertHistoryKeeps(Rehearsal attempt) throws Exception {
        Path file = folder.resolve("attempts.csv");
        new AttemptHistory(file, "one").add(attempt);
        AttemptHistory later = new AttemptHistory(file, "other");
        later.add(attempt);
        double mm = attempt.record().samples().get(0).distanceMm();
        Matcher told = Pattern.compile("2 samples in 2 sessions, .* ([0-9.]+) \u00b1 0\\.0 mm off")
                .matcher(later.learningCurve(attempt.plan().title()));
        assertThat(told.find()).isTrue();
        // Rounded in the file, and again in the sentence.
        assertThat(Double.parseDouble(told.group(1))).isCloseTo(mm, within(0.056));
        later.export(folder.resolve("copy.csv"));
        List<String> lines = Files.readAllLines(folder.resolve("copy.csv"));
        assertThat(lines).hasSize(3).allMatch(line -> line.split(",", -1).length == 19);
        assertThat(lines.get(2)).startsWith("other,").contains(",see-through,");
    }

    /** Steps that show the liver with settings of their own, and then wait. */
    private static final String PROBE_PLAN =
            """
            title: Probe shown
            set: {preset: rapid-shallow, rate_per_min: 70, resolution: low, mesh_vertices: 2000, lungs: embedded,
              sternum: kinematic, threads: 1}
            target: {rest_mm: [%s], diameter_mm: 14}
            steps:
              - probe: {skin: right-subcostal, rotate_deg: 90, tilt_deg: 20, depth_mm: 280, gain_db: 10}
              - wait: 600
            """;

    @Test
    void ofAPlayedProbeTheDockTellsHowThatIsHeldAndTheNextTargetIsAsLargeAsIsShown() throws Exception {
        String middle = Arrays.stream(middleOfTheLiver())
                .mapToObj(mm -> String.format(Locale.ROOT, "%.1f", mm))
                .collect(Collectors.joining(", "));
        Path plan = Files.writeString(folder.resolve("probe.yaml"), String.format(Locale.ROOT, PROBE_PLAN, middle));
        WindowHarness.doOnEdt(() -> window.window().files().open(plan));
        clinic.until("the plan", () -> rehearsal().exercise().isPresent());
        clinic.ready();
        double byHand = WindowHarness.onEdt(() -> rehearsal().probe().settings().depthMm());
        WindowHarness.doOnEdt(() -> rehearsal().playExample());
        clinic.until(
                "the probe",
                () -> rehearsal().state().flatMap(NeedleState::probe).isPresent());
        JSlider depth = WindowHarness.onEdt(
                () -> WindowHarness.find(ultrasound(), JSlider.class, "Depth").orElseThrow());
        JLabel angles = WindowHarness.onEdt(() -> labelOf(ultrasound(), "Rotated"));
        clinic.until("the angles", () -> angles.getText().startsWith("Rotated 90\u00b0, tilted 20\u00b0"));
        assertThat(WindowHarness.onEdt(depth::getValue)).isEqualTo(280);
        window.screenshot("rehearse-played-probe");
        assertThat(WindowHarness.onEdt(() -> rehearsal().probe().settings().depthMm()))
                .as("what the hand has chosen stays")
                .isEqualTo(byHand);
        WindowHarness.doOnEdt(() -> rehearsal().retry());
        clinic.ready();
        clinic.until("the hand's depth", () -> depth.getValue() == (int) byHand);

        // With other breathing the target of the exercise stays, for practice.
        WindowHarness.doOnEdt(() -> window.session().change("Rate", Assignment.parse("rate_per_min=69")));
        clinic.until("practice", () -> rehearsal().exercise().isEmpty());
        clinic.ready();
        JSpinner size = window.control(JSpinner.class, "Diameter of the target");
        assertThat(WindowHarness.onEdt(size::getValue)).isEqualTo(14);
        TargetLesion before = target();
        double[] onLiver = pixel(middleOfTheLiver());
        window.key("T");
        clickView(onLiver);
        clinic.until("another target", () -> rehearsal()
                .study()
                .filter(study -> study.target() != before)
                .isPresent());
        clinic.ready();
        assertThat(target().diameterMm()).isEqualTo(14);
    }

    private static JLabel labelOf(java.awt.Container at, String beginning) {
        for (java.awt.Component child : at.getComponents()) {
            if (child instanceof JLabel label && label.getText().startsWith(beginning)) {
                return label;
            }
            JLabel found = child instanceof java.awt.Container deeper ? labelOf(deeper, beginning) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    private static boolean seesThrough() {
        return window.window()
                .view()
                .frame()
                .flatMap(RenderedFrame::needleMarks)
                .filter(NeedleMarkers::seeThrough)
                .isPresent();
    }

    @Test
    void picturesAloneHideTheInsideAndXrayShowsTheNeedle() throws Exception {
        clinic.begin();
        JComboBox<?> help = window.control(JComboBox.class, "Help");
        WindowHarness.doOnEdt(() -> help.setSelectedItem(Aids.PICTURES));
        clinic.until("a body seen from outside", () -> !seesThrough());
        assertThat(WindowHarness.onEdt(() -> descendant(window.window().frame().getRootPane(), NeedlePanel.class)
                        .isTold()))
                .as("the distance of the tip from the target is told")
                .isFalse();
        WindowHarness.doOnEdt(() -> help.setSelectedItem(Aids.SEE_THROUGH));
        clinic.until("a body seen through", RehearsalProbeCases::seesThrough);
        JToggleButton beam = window.control(JToggleButton.class, "X-ray on");
        WindowHarness.doOnEdt(beam::doClick);
        FluoroscopyDock xray =
                WindowHarness.onEdt(() -> descendant(window.window().frame().getRootPane(), FluoroscopyDock.class));
        clinic.until("a picture", () -> xray.shot().isPresent());
        WindowHarness.doOnEdt(beam::doClick);
        Optional<NeedleState> shown = WindowHarness.onEdt(() -> xray.shot().map(s -> s.state()));
        assertThat(shown).isPresent();
    }
}
