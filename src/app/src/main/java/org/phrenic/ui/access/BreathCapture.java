package org.phrenic.ui.access;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.CycleRecorder;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.ui.session.Session;

/** Records one breath of the run, as fast as it can be simulated. Used on the event dispatch thread. */
final class BreathCapture {
    private final Session session;
    private Scenario recorded = Scenario.defaults();
    private List<BreathMoment> cycle = List.of();

    BreathCapture(Session session) {
        this.session = session;
    }

    void clear() {
        cycle = List.of();
    }

    /**
     * Records from the start of the run.
     *
     * @param frame of the run's scene
     * @param moments to record
     * @param wanted whether the record is still of use
     * @param progress gets the fraction of the breath that is recorded
     * @param done runs when the breath is recorded
     */
    void start(Frame frame, int moments, BooleanSupplier wanted, Consumer<Double> progress, Runnable done) {
        recorded = session.scenario();
        CycleRecorder recorder = new CycleRecorder(
                session.live(),
                frame,
                moments,
                fraction -> onEventThread(wanted, () -> progress.accept(fraction)),
                whole -> onEventThread(wanted, () -> {
                    cycle = whole;
                    done.run();
                }));
        session.live().setSpeed(Double.POSITIVE_INFINITY);
        session.restart(recorder, recorder);
    }

    private static void onEventThread(BooleanSupplier wanted, Runnable what) {
        SwingUtilities.invokeLater(() -> {
            if (wanted.getAsBoolean()) {
                what.run();
            }
        });
    }

    /** The recorded breath, from end-expiration on; empty before it is complete. */
    List<BreathMoment> cycle() {
        return cycle;
    }

    boolean matches(Scenario scenario) {
        return breatheAlike(recorded, scenario);
    }

    /** Whether two scenarios are the same but for a breath hold. */
    static boolean breatheAlike(Scenario one, Scenario other) {
        return withoutHold(one).equals(withoutHold(other));
    }

    private static Map<String, Object> withoutHold(Scenario scenario) {
        Map<String, Object> map = new LinkedHashMap<>(scenario.toMap());
        map.remove("hold");
        return map;
    }
}
