package org.phrenic.simulation.live;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

/**
 * What is set, as whoever tunes sees it at once, and which live changes the simulation has yet to make. Safe to use
 * from any thread.
 */
final class RequestedSettings {
    private final Map<Setting<?>, Assignment> pending = new LinkedHashMap<>();
    private Scenario current;
    private boolean loading;

    RequestedSettings(Scenario first) {
        current = first.withChanges(List.of());
    }

    synchronized Scenario current() {
        return current;
    }

    /**
     * Takes changes.
     *
     * @return whether all of them can be made while the scene runs; then they are waiting for the simulation
     * @throws org.phrenic.file.BadInputException if they cannot be; nothing has changed then
     */
    synchronized boolean request(List<Assignment> assignments) {
        current = current.with(assignments);
        if (!assignments.stream().allMatch(a -> a.setting().isLive())) {
            return false;
        }
        for (Assignment assignment : assignments) {
            pending.remove(assignment.setting());
            pending.put(assignment.setting(), assignment);
        }
        return true;
    }

    /** The changes that wait, each setting once with its last value; they wait no more. */
    synchronized List<Assignment> takePending() {
        if (pending.isEmpty()) {
            return List.of();
        }
        List<Assignment> taken = new ArrayList<>(pending.values());
        pending.clear();
        return taken;
    }

    /** Told that another scenario is being loaded. */
    synchronized void beginLoading(Scenario scenario) {
        current = scenario.withChanges(List.of());
        loading = true;
    }

    /** Told that a loaded scene runs: what was set since its loading began waits to be changed in it. */
    synchronized void sceneStarted(Scenario running) {
        loading = false;
        pending.clear();
        for (Setting<?> setting : Settings.all()) {
            if (setting.isLive() && !current.text(setting).equals(running.text(setting))) {
                pending.put(setting, new Assignment("change", setting, current.get(setting)));
            }
        }
    }

    /** Told that loading was called off or failed. */
    synchronized void endLoading() {
        loading = false;
    }

    /** Follows what the simulation has; changes that wait stay on top. */
    synchronized void followRunning(Scenario running) {
        if (!loading) {
            current = pending.isEmpty() ? running : running.with(new ArrayList<>(pending.values()));
        }
    }
}
