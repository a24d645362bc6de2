package org.phrenic.ui.session;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.undo.UndoableEdit;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveRun;

/** The scenario as it is changed by hand; each change can be undone. */
final class EditedScenario {
    /** A change that loads a scene, and the values before it. */
    private record Loading(UndoableEdit edit, Scenario before) {}

    private final LiveRun live;
    private final EditHistory edits;
    private final Supplier<Scenario> present;
    private Scenario requested;
    private Optional<Loading> loading = Optional.empty();

    /** @param present gives the present values */
    EditedScenario(Scenario first, LiveRun live, EditHistory edits, Supplier<Scenario> present) {
        requested = first;
        this.live = live;
        this.edits = edits;
        this.present = present;
    }

    /** The values that were requested last. */
    Scenario requested() {
        return requested;
    }

    /**
     * Changes values.
     *
     * @throws IllegalArgumentException if one is wrong; then nothing is changed
     */
    void change(EditName name, List<Assignment> assignments) {
        Scenario before = present.get();
        setValues(assignments);
        List<Assignment> inverse = assignments.stream()
                .map(a -> new Assignment("undo", a.setting(), before.get(a.setting())))
                .toList();
        List<String> keys = assignments.stream().map(Assignment::key).toList();
        UndoableEdit edit = edits.add(name, keys, () -> setValues(inverse), () -> setValues(assignments));
        if (!assignments.stream().allMatch(a -> a.setting().isLive())) {
            loading = Optional.of(new Loading(edit, before));
        }
    }

    private void setValues(List<Assignment> assignments) {
        Scenario next = present.get().with(assignments);
        live.change(assignments);
        requested = next;
    }

    /** Loads another scenario, instead of one that still loads. */
    void open(EditName name, Scenario scenario) {
        Scenario before = loading.map(Loading::before).orElseGet(present);
        forgetLoading();
        load(scenario);
        UndoableEdit edit = edits.add(name, List.of(), () -> load(before), () -> load(scenario));
        loading = Optional.of(new Loading(edit, before));
    }

    private void load(Scenario scenario) {
        requested = scenario;
        live.load(scenario);
    }

    /** The scene of the last change runs. */
    void endLoading() {
        loading = Optional.empty();
    }

    /** Forgets the change whose scene was to be loaded: that has failed, or is not wanted any more. */
    void forgetLoading() {
        loading.ifPresent(change -> edits.retract(change.edit()));
        loading = Optional.empty();
    }
}
