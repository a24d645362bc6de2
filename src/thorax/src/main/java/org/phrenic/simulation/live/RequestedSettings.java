package org.phrenic.simulation.live;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.model.material.Materials;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

/** The requested settings, and the live changes that the simulation has not applied yet. Thread-safe. */
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
     * Requests changes. If all of them are live, they are pending for the simulation.
     *
     * @return whether the current settings are to be loaded instead, which are marked as loading
     * @throws org.phrenic.file.BadInputException if they are invalid; then nothing has changed
     */
    synchronized boolean request(List<Assignment> assignments) {
        current = current.changed(assignments);
        if (!assignments.stream().allMatch(a -> a.setting().isLive())) {
            loading = true;
            return true;
        }
        for (Assignment assignment : assignments) {
            pending.remove(assignment.setting());
            pending.put(assignment.setting(), assignment);
        }
        return false;
    }

    /**
     * Removes and returns the pending changes that the material of the running scene uses: each setting once, with its
     * last value. The others are for the scene that loads.
     */
    synchronized List<Assignment> takePending(Scenario running) {
        if (pending.isEmpty()) {
            return List.of();
        }
        List<Assignment> taken = pending.values().stream()
                .filter(change -> Materials.isUsed(change.setting(), running.material()))
                .toList();
        pending.values().removeAll(taken);
        return taken;
    }

    /** Marks that another scenario is loading; returns it. */
    synchronized Scenario beginLoading(Scenario scenario) {
        current = scenario.withChanges(List.of());
        loading = true;
        return scenario;
    }

    /** Marks that the scenario of the current settings is loading; returns it. */
    synchronized Scenario beginLoading() {
        loading = true;
        return current;
    }

    /** Marks that a loaded scene is running. Changes requested since its loading began become pending. */
    synchronized void sceneStarted(Scenario running) {
        loading = false;
        pending.clear();
        for (Setting<?> setting : Settings.all()) {
            if (setting.isLive() && !current.text(setting).equals(running.text(setting))) {
                pending.put(setting, new Assignment("change", setting, current.get(setting)));
            }
        }
    }

    /** Marks that loading was cancelled or has failed. */
    synchronized void endLoading() {
        loading = false;
    }

    /** Adopts the settings of the simulation; pending changes that its material uses stay applied on top. */
    synchronized void followRunning(Scenario running) {
        if (!loading) {
            pending.keySet().removeIf(setting -> !Materials.isUsed(setting, running.material()));
            current = pending.isEmpty() ? running : running.changed(new ArrayList<>(pending.values()));
        }
    }
}
