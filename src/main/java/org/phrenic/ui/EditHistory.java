package org.phrenic.ui;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Scenario;

/**
 * What was changed, by name, so that it can be undone and done again. Changes of the same keys that follow one another quickly, as
 * from a slider that is dragged, count as one.
 */
final class EditHistory {
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

    private record Edit(String name, Step back, Step forth) {}

    /** Changes of the same keys within this time are one. */
    static final long COALESCE_NS = 700_000_000L;

    /** Changes that can be undone. */
    static final int MOST = 200;

    private final Deque<Edit> done = new ArrayDeque<>();
    private final Deque<Edit> undone = new ArrayDeque<>();
    private final List<Runnable> listeners = new ArrayList<>();
    private final Consumer<Step> apply;
    private final LongSupplier clockNs;
    private long lastNs;
    private boolean open;

    /**
     * @param apply carries out a step back or forth
     * @param clockNs a clock such as {@link System#nanoTime}
     */
    EditHistory(Consumer<Step> apply, LongSupplier clockNs) {
        this.apply = apply;
        this.clockNs = clockNs;
    }

    EditHistory(Consumer<Step> apply) {
        this(apply, System::nanoTime);
    }

    /** Told after every change of what can be undone or done again. */
    void onChange(Runnable listener) {
        listeners.add(listener);
    }

    /**
     * Remembers a change that was made.
     *
     * @param name what was changed, such as {@code Muscle stiffness 300 -> 450 N/m}
     * @param back what leads back, {@link #back(Scenario, List)} for assignments
     * @param forth what was done
     */
    void record(String name, Step back, Step forth) {
        long now = clockNs.getAsLong();
        Edit last = done.peek();
        if (open && last != null && now - lastNs < COALESCE_NS && continues(last, forth)) {
            done.pop();
            done.push(new Edit(joined(last.name, name), last.back, forth));
        } else {
            done.push(new Edit(name, back, forth));
            if (done.size() > MOST) {
                done.removeLast();
            }
        }
        undone.clear();
        lastNs = now;
        open = true;
        changed();
    }

    private static boolean continues(Edit last, Step forth) {
        return last.forth instanceof Step.Set before
                && forth instanceof Step.Set after
                && before.keys().equals(after.keys());
    }

    /** {@code Depth 1 -> 1.2} and {@code Depth 1.2 -> 1.4} are together {@code Depth 1 -> 1.4}. */
    private static String joined(String first, String second) {
        int from = first.indexOf(" -> ");
        int to = second.indexOf(" -> ");
        return from < 0 || to < 0 ? second : first.substring(0, from) + second.substring(to);
    }

    /** What comes next is a change of its own, however soon: a slider was let go. */
    void close() {
        open = false;
    }

    /** Takes back the last change; nothing if there is none. */
    void undo() {
        move(done, undone, true);
    }

    /** Does again what was taken back last; nothing if there is none. */
    void redo() {
        move(undone, done, false);
    }

    private void move(Deque<Edit> from, Deque<Edit> to, boolean back) {
        Edit edit = from.poll();
        if (edit == null) {
            return;
        }
        open = false;
        to.push(edit);
        apply.accept(back ? edit.back : edit.forth);
        changed();
    }

    /** Text of the menu: {@code Undo Muscle stiffness 300 -> 450 N/m}; empty if nothing can be undone. */
    Optional<String> undoName() {
        return Optional.ofNullable(done.peek()).map(edit -> "Undo " + edit.name);
    }

    /** Text of the menu: {@code Redo Muscle stiffness 300 -> 450 N/m}; empty if nothing can be done again. */
    Optional<String> redoName() {
        return Optional.ofNullable(undone.peek()).map(edit -> "Redo " + edit.name);
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }

    /** What leads back to {@code now} after {@code assignments}: the values of the same keys, or the whole scenario if it has no value for one of them. */
    static Step back(Scenario now, List<Assignment> assignments) {
        List<Assignment> before = new ArrayList<>();
        for (Assignment assignment : assignments) {
            Optional<String> value = Settings.text(now, assignment.key());
            if (value.isEmpty()) {
                return new Step.Load(now);
            }
            before.add(new Assignment("undo", assignment.key(), value.get()));
        }
        return new Step.Set(before);
    }
}
