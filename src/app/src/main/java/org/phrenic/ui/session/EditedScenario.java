package org.phrenic.ui.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.undo.UndoableEdit;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveRun;

/** The scenario as it is changed by hand; each change can be undone. */
final class EditedScenario {
    private final LiveRun live;
    private final EditHistory edits;
    private final Supplier<Scenario> present;
    private final Runnable onHold;
    private Scenario requested;
    /** The scenario that was loaded last, with its scheduled changes. */
    private Scenario loaded;
    /** That of the scene that runs. */
    private Scenario running;
    /** Changes made, undone or redone whose scene loads, the oldest first. */
    private final Map<UndoableEdit, Pending> loading = new LinkedHashMap<>();
    /** The values before these. */
    private Scenario before;
    /** Changes made since that take effect without a scene of their own. */
    private final Map<UndoableEdit, List<Assignment>> whileLoading = new LinkedHashMap<>();

    /**
     * What is known of a change whose scene loads.
     *
     * @param previous the values before it
     * @param scenario what was loaded for it, with its scheduled changes
     * @param takeBack takes it back in the history
     * @param sceneId of the scene that was loaded for it
     */
    private record Pending(Scenario previous, Scenario scenario, Runnable takeBack, long sceneId) {}

    /**
     * @param present gives the present values
     * @param onHold is called when a change holds or releases the breath
     */
    EditedScenario(Scenario first, LiveRun live, EditHistory edits, Supplier<Scenario> present, Runnable onHold) {
        requested = first;
        loaded = first;
        running = first;
        before = first;
        this.live = live;
        this.edits = edits;
        this.present = present;
        this.onHold = onHold;
    }

    /** The values that were requested last. */
    Scenario requested() {
        return requested;
    }

    /** Whether the scenario that was loaded last schedules changes. */
    boolean isScheduled() {
        return !loaded.changes().isEmpty();
    }

    /**
     * Changes values; without any, there is nothing to undo.
     *
     * @throws IllegalArgumentException if one is wrong
     * @throws org.phrenic.file.BadInputException if one is wrong; nothing is changed by either
     */
    void change(EditName name, List<Assignment> assignments) {
        if (assignments.isEmpty()) {
            return;
        }
        Scenario now = present.get();
        requireBreathing(now.changed(assignments), assignments);
        setValues(assignments);
        List<Assignment> inverse = assignments.stream()
                .map(a -> new Assignment("undo", a.setting(), now.get(a.setting())))
                .toList();
        List<String> keys = assignments.stream().map(Assignment::key).toList();
        Runnable undo = () -> setValues(inverse);
        Runnable redo = () -> setValues(assignments);
        if (assignments.stream().allMatch(a -> a.setting().isLive())) {
            UndoableEdit edit = edits.add(name, keys, undo, redo);
            if (!loading.isEmpty()) {
                whileLoading.put(edit, assignments);
            }
        } else {
            addLoading(name, keys, now, undo, redo);
        }
    }

    /** Refuses what the simulation would refuse later. A recording has a rate of its own and is read elsewhere. */
    private static void requireBreathing(Scenario next, List<Assignment> assignments) {
        boolean breathes =
                assignments.stream().anyMatch(a -> a.setting().effect().isOfPattern());
        if (breathes && next.trace().isEmpty()) {
            Breathing.patternOf(next);
        }
    }

    private void setValues(List<Assignment> assignments) {
        Scenario now = present.get();
        Scenario next = now.changed(assignments);
        live.change(assignments);
        requested = next;
        if (!assignments.stream().allMatch(a -> a.setting().isLive())) {
            loaded = next;
        }
        if (next.hold() != now.hold()) {
            onHold.run();
        }
    }

    /** Loads another scenario, instead of one that still loads. */
    void open(EditName name, Scenario scenario) {
        Scenario previous = loading.isEmpty() ? present.get() : before;
        forgetLoading();
        load(scenario);
        addLoading(name, List.of(), previous, () -> load(previous), () -> load(scenario));
    }

    private void load(Scenario scenario) {
        requested = scenario;
        loaded = scenario;
        live.load(scenario);
    }

    private void addLoading(EditName name, List<String> keys, Scenario previous, Runnable undo, Runnable redo) {
        UndoableEdit[] edit = new UndoableEdit[1];
        edit[0] = edits.add(name, keys, () -> turn(edit[0], undo), () -> turn(edit[0], redo));
        awaitScene(edit[0], previous, () -> edits.retract(edit[0]));
    }

    private void awaitScene(UndoableEdit edit, Scenario previous, Runnable takeBack) {
        before = loading.isEmpty() ? previous : before;
        loading.putIfAbsent(edit, new Pending(previous, loaded, takeBack, live.newestSceneId()));
    }

    /** Undoes or redoes a change; where its own scene still loads, the scene that runs goes on. */
    private void turn(UndoableEdit edit, Runnable action) {
        boolean waits = loading.remove(edit) != null;
        if (waits && loading.isEmpty() && live.cancelLoading()) {
            requested = before;
            loaded = running;
            return;
        }
        Scenario previous = present.get();
        action.run();
        if (!waits) {
            awaitScene(edit, previous, () -> edits.revert(edit));
        }
    }

    /** A scene runs: of the changes, those for which it was loaded, and those before. The scene of others may load. */
    void endLoading(long sceneId) {
        for (Pending change : loading.values()) {
            running = change.sceneId <= sceneId ? change.scenario : running;
        }
        if (loading.values().removeIf(change -> change.sceneId <= sceneId)) {
            edits.endMerging();
            running = loading.isEmpty() ? loaded : running;
            if (loading.isEmpty()) {
                whileLoading.clear();
            }
            before =
                    loading.values().stream().findFirst().map(Pending::previous).orElse(before);
        }
    }

    /** Forgets the changes whose scene was to be loaded: it is not wanted any more. */
    void forgetLoading() {
        forgetLoading(Long.MAX_VALUE);
    }

    /** Forgets the changes for which a scene, or one before it, was to be loaded: that has failed. */
    void forgetLoading(long sceneId) {
        List<Pending> latestFirst = new ArrayList<>(loading.values());
        latestFirst.removeIf(change -> change.sceneId > sceneId);
        Collections.reverse(latestFirst);
        loading.values().removeAll(latestFirst);
        latestFirst.forEach(change -> change.takeBack.run());
        if (loading.isEmpty()) {
            loaded = running;
            forgetUnused();
        }
    }

    /** Forgets the changes of what the material that was to be loaded uses, and the one that runs does not. */
    private void forgetUnused() {
        whileLoading.forEach((edit, assignments) -> {
            if (!assignments.stream().allMatch(a -> Materials.isUsed(a.setting(), running.material()))) {
                edits.retract(edit);
            }
        });
        whileLoading.clear();
    }
}
