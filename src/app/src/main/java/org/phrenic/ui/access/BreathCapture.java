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

/** One breath of the run as it breathes now, looked at as fast as the machine goes. On the event dispatch thread. */
final class BreathCapture {
    private final Session session;
    private final ObservedRun run;
    private Map<String, Object> breathing = Map.of();
    private List<BreathMoment> cycle = List.of();

    BreathCapture(Session session, ObservedRun run) {
        this.session = session;
        this.run = run;
    }

    /** Another body: nothing of it was looked at. */
    void clear() {
        cycle = List.of();
    }

    /**
     * Looks from the start of the run.
     *
     * @param ofScene a frame of the run's scene
     * @param phases moments of the breath
     * @param current whether anyone still waits for it
     * @param share told how much of the breath was seen
     * @param seen told when all of it was
     */
    void start(Frame ofScene, int phases, BooleanSupplier current, Consumer<Double> share, Runnable seen) {
        CycleRecorder recorder = new CycleRecorder(
                session.live(),
                ofScene,
                phases,
                done -> onEventThread(current, () -> share.accept(done)),
                whole -> onEventThread(current, () -> {
                    cycle = whole;
                    seen.run();
                }));
        run.restartFast(recorder, recorder);
    }

    private static void onEventThread(BooleanSupplier current, Runnable what) {
        SwingUtilities.invokeLater(() -> {
            if (current.getAsBoolean()) {
                what.run();
            }
        });
    }

    /** What was seen, from end-expiration on; empty before all of it was. */
    List<BreathMoment> cycle() {
        return cycle;
    }

    /** The breathing of now is the one that is looked at. */
    void markCurrentBreathing() {
        breathing = withoutHold(session.scenario());
    }

    /** Whether that is how it breathes now, held or not. */
    boolean matchesCurrent() {
        return matches(session.scenario());
    }

    /** Whether that is how this scenario breathes. */
    boolean matches(Scenario scenario) {
        return breathing.equals(withoutHold(scenario));
    }

    /** Whether a scenario is what breathes now, held or not. */
    boolean isCurrentBreathing(Scenario scenario) {
        return withoutHold(session.scenario()).equals(withoutHold(scenario));
    }

    private static Map<String, Object> withoutHold(Scenario scenario) {
        Map<String, Object> map = new LinkedHashMap<>(scenario.toMap());
        map.remove("hold");
        return map;
    }
}
