package org.phrenic.ui.access.panel;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import javax.swing.JButton;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.mesh.Vectors;
import org.phrenic.scenario.Scenario;
import org.phrenic.ui.access.AttemptReportWriter;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.window.WindowHarness;

/** A window under test whose clinician's rehearsal is open, on the virtual body at low resolution, breathing fast. */
final class RehearsalHarness {
    /** Width and height of the pictures of a report, pixels. */
    private static final int PICTURE_SIZE = 100;

    private static final double ROUNDING_MM = 1e-6;
    /** Simulated time over real time: flat out, the run would take the processor from what a test waits for. */
    private static final double SPEED = 4;

    /** Four times that of a hand: while the needle moves, the surfaces of the body are computed every 0.02 s. */
    private static final double NEEDLE_MM_PER_S = 200;

    private final WindowHarness window;

    /** @param more settings of the scenario, each {@code key=value} */
    RehearsalHarness(String name, String... more) throws Exception {
        Scenario fast = Scenario.defaults()
                .with(
                        "preset=rapid-shallow",
                        "rate_per_min=70",
                        "resolution=low",
                        "mesh_vertices=2000",
                        "lungs=embedded",
                        "sternum=kinematic",
                        "threads=1");
        window = new WindowHarness(name, fast.with(more));
        WindowHarness.doOnEdt(() -> {
            window.control(JButton.class, "Rehearse liver access").doClick();
            window.session().setSpeed(SPEED);
        });
        ready();
        WindowHarness.doOnEdt(() -> rehearsal().needle().setSpeedMmPerS(NEEDLE_MM_PER_S));
    }

    WindowHarness window() {
        return window;
    }

    RehearsalController rehearsal() {
        return window.window().docks().rehearsalController();
    }

    AttemptsDock attempts() {
        return window.window().docks().attempts();
    }

    /**
     * Waits until something holds. The run stands still while a body is loaded or a map worked out, for which it is not
     * needed; it plays again when a breath is recorded or an attempt begins.
     */
    void until(String what, BooleanSupplier holds) throws InterruptedException {
        WindowHarness.await(
                what,
                () -> WindowHarness.onEdt(() -> {
                    RehearsalStage stage = rehearsal().stage();
                    boolean needed = stage != RehearsalStage.LOADING && stage != RehearsalStage.MAPPING;
                    if (!needed && window.session().live().isPlaying()) {
                        rest();
                    }
                    return holds.getAsBoolean();
                }));
    }

    /** Waits until something holds, and lets the run go on meanwhile in any stage. */
    static void untilWhileItRuns(String what, BooleanSupplier holds) throws InterruptedException {
        WindowHarness.await(what, () -> WindowHarness.onEdt(holds::getAsBoolean));
    }

    void ready() throws InterruptedException {
        until("the needle", this::isReady);
    }

    boolean isReady() {
        return rehearsal().stage() == RehearsalStage.READY
                && rehearsal().state().isPresent();
    }

    NeedleState state() {
        return rehearsal().state().orElseThrow();
    }

    /** Says whether the tip rests within half a millimetre of a depth. */
    boolean isAt(double depthMm) {
        Optional<NeedleState> now = rehearsal().state();
        return now.isPresent() && !now.get().moving() && Math.abs(now.get().depthMm() - depthMm) < 0.5;
    }

    /** Says whether the line of the needle meets the centre of the target. */
    static boolean pointsAtTarget(NeedleState now) {
        double[] along = Vectors.normalize(Vectors.subtract(now.tip(), now.hub()));
        return Vectors.distanceToLine(now.target(), now.tip(), along) < ROUNDING_MM;
    }

    /** Writes reports whose pictures take a fraction of the time of those that a user saves. */
    AttemptReportWriter smallPictures() {
        return new AttemptReportWriter(window.window().view(), PICTURE_SIZE);
    }

    /** A new attempt from the best entry. */
    void begin() throws InterruptedException {
        WindowHarness.doOnEdt(() -> {
            rehearsal().retry();
            rehearsal().entrySelection().selectBest(false);
        });
        until(
                "an entry",
                () -> rehearsal().state().filter(NeedleState::hasNeedle).isPresent());
        rest();
        until("advice", () -> rehearsal().entrySelection().advice().isPresent());
        goOn();
    }

    /** Takes the needle out; the attempt that ends with that. */
    Rehearsal ended() throws InterruptedException {
        int before = WindowHarness.onEdt(() -> attempts().attempts().size());
        window.key("O");
        until("a report", () -> attempts().attempts().size() > before);
        return WindowHarness.onEdt(
                () -> attempts().attempts().get(before).whole().orElseThrow());
    }

    /** Lets the run stand still, which would take the processor from what works on advice or a finished attempt. */
    void rest() {
        WindowHarness.doOnEdt(() -> window.session().live().pause());
    }

    /** Lets the run go on after a rest. */
    void goOn() {
        WindowHarness.doOnEdt(() -> window.session().live().play());
    }

    void close() throws Exception {
        window.close();
    }
}
