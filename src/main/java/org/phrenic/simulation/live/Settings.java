package org.phrenic.simulation.live;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/** What is set now, as whoever tunes sees it at once, and which live changes the simulation has yet to make. Safe to use from any thread. */
final class Settings {
    private final Map<String, Assignment> pending = new LinkedHashMap<>();
    private Scenario now;
    private boolean loading;

    Settings(Scenario first) {
        now = first.withChanges(List.of());
    }

    synchronized Scenario now() {
        return now;
    }

    /**
     * Takes changes.
     *
     * @return whether all of them can be made while the scene runs; then they are waiting for the simulation
     * @throws org.phrenic.format.BadInputException if they cannot be; nothing has changed then
     */
    synchronized boolean change(List<Assignment> assignments) {
        now = now.with(assignments);
        if (!assignments.stream().allMatch(a -> Simulation.isLive(a.key()))) {
            return false;
        }
        for (Assignment assignment : assignments) {
            pending.remove(assignment.key());
            pending.put(assignment.key(), assignment);
        }
        return true;
    }

    /** The changes that wait, each key once with its last value; they wait no more. */
    synchronized List<Assignment> take() {
        if (pending.isEmpty()) {
            return List.of();
        }
        List<Assignment> taken = new ArrayList<>(pending.values());
        pending.clear();
        return taken;
    }

    /** Told that another scenario is being loaded. */
    synchronized void load(Scenario scenario) {
        now = scenario.withChanges(List.of());
        loading = true;
    }

    /** Told that a loaded scene runs: what was set since its loading began waits to be changed in it. */
    synchronized void started(Scenario running) {
        loading = false;
        pending.clear();
        Map<String, Object> has = running.toMap();
        now.toMap().forEach((key, value) -> {
            if (Simulation.isLive(key) && !value.equals(has.get(key))) {
                pending.put(key, new Assignment("change", key, String.valueOf(value)));
            }
        });
    }

    /** Told that loading was called off or failed. */
    synchronized void notLoading() {
        loading = false;
    }

    /** Follows what the simulation has; changes that wait stay on top. */
    synchronized void follow(Scenario running) {
        if (!loading) {
            now = pending.isEmpty() ? running : running.with(new ArrayList<>(pending.values()));
        }
    }
}
