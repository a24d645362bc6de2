package org.phrenic.ui.session;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * What was changed, by name, so that it can be undone and done again. Changes of the same keys that follow one another
 * quickly, as from a slider that is dragged, count as one.
 */
public final class EditHistory {
    /** One way to get to other settings. */
    sealed interface Step {
        /** Values for some keys. */
        record Set(List<Assignment> assignments) implements Step {
            public Set {
                assignments = List.copyOf(assignments);
            }

            List<String> keys() {
                return assignments.stream().map(Assignment::key).sorted().toList();
            }
        }

        /** A whole scenario. */
        record Load(Scenario scenario) implements Step {}
    }

    private record Edit(String name, Step undo, Step redo) {}

    /** Changes of the same keys within this time are one. */
    static final long COALESCE_NS = 700_000_000L;

    /** Changes that can be undone. */
    static final int MAX_EDITS = 200;

    private final Deque<Edit> undoable = new ArrayDeque<>();
    private final Deque<Edit> redoable = new ArrayDeque<>();
    private final List<Runnable> listeners = new ArrayList<>();
    private final Consumer<Step> applyStep;
    private final LongSupplier clockNs;
    private long lastEditNs;
    private boolean mergeable;

    /**
     * @param apply carries out a step back or forth
     * @param clockNs a clock such as {@link System#nanoTime}
     */
    EditHistory(Consumer<Step> apply, LongSupplier clockNs) {
        this.applyStep = apply;
        this.clockNs = clockNs;
    }

    EditHistory(Consumer<Step> apply) {
        this(apply, System::nanoTime);
    }

    /** Told after every change of what can be undone or done again. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /**
     * Remembers a change that was made.
     *
     * @param name what was changed, such as {@code Muscle stiffness 300 -> 450 N/m}
     * @param back what leads back, {@link #inverse(Scenario, List)} for assignments
     * @param forth what was done
     */
    void add(String name, Step back, Step forth) {
        long now = clockNs.getAsLong();
        Edit last = undoable.peek();
        if (mergeable && last != null && now - lastEditNs < COALESCE_NS && canMerge(last, forth)) {
            undoable.pop();
            undoable.push(new Edit(mergedName(last.name, name), last.undo, forth));
        } else {
            undoable.push(new Edit(name, back, forth));
            if (undoable.size() > MAX_EDITS) {
                undoable.removeLast();
            }
        }
        redoable.clear();
        lastEditNs = now;
        mergeable = true;
        fireChange();
    }

    private static boolean canMerge(Edit last, Step forth) {
        return last.redo instanceof Step.Set before
                && forth instanceof Step.Set after
                && before.keys().equals(after.keys());
    }

    /** {@code Depth 1 -> 1.2} and {@code Depth 1.2 -> 1.4} are together {@code Depth 1 -> 1.4}. */
    private static String mergedName(String first, String second) {
        int from = first.indexOf(" -> ");
        int to = second.indexOf(" -> ");
        return from < 0 || to < 0 ? second : first.substring(0, from) + second.substring(to);
    }

    /** What comes next is a change of its own, however soon: a slider was let go. */
    public void endMerging() {
        mergeable = false;
    }

    /** Takes back the last change; nothing if there is none. */
    public void undo() {
        moveEdit(undoable, redoable, true);
    }

    /** Does again what was taken back last; nothing if there is none. */
    public void redo() {
        moveEdit(redoable, undoable, false);
    }

    private void moveEdit(Deque<Edit> from, Deque<Edit> to, boolean back) {
        Edit edit = from.poll();
        if (edit == null) {
            return;
        }
        mergeable = false;
        to.push(edit);
        applyStep.accept(back ? edit.undo : edit.redo);
        fireChange();
    }

    /** Text of the menu: {@code Undo Muscle stiffness 300 -> 450 N/m}; empty if nothing can be undone. */
    public Optional<String> undoPresentationName() {
        return Optional.ofNullable(undoable.peek()).map(edit -> "Undo " + edit.name);
    }

    /** Text of the menu: {@code Redo Muscle stiffness 300 -> 450 N/m}; empty if nothing can be done again. */
    public Optional<String> redoPresentationName() {
        return Optional.ofNullable(redoable.peek()).map(edit -> "Redo " + edit.name);
    }

    private void fireChange() {
        listeners.forEach(Runnable::run);
    }

    /**
     * What leads back to {@code now} after {@code assignments}: the values of the same keys, or the whole scenario if
     * it has no value for one of them.
     */
    static Step inverse(Scenario now, List<Assignment> assignments) {
        List<Assignment> before = new ArrayList<>();
        for (Assignment assignment : assignments) {
            Optional<String> value = ScenarioValues.text(now, assignment.key());
            if (value.isEmpty()) {
                return new Step.Load(now);
            }
            before.add(new Assignment("undo", assignment.key(), value.get()));
        }
        return new Step.Set(before);
    }
}
