package org.phrenic.ui.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import javax.swing.undo.AbstractUndoableEdit;
import javax.swing.undo.UndoManager;
import javax.swing.undo.UndoableEdit;

/**
 * The changes made by hand, to undo and redo: a {@link UndoManager} with listeners. Changes of the same keys that
 * follow one another within {@link #COALESCE_NS}, as from a dragged slider, merge into one.
 */
public final class EditHistory {
    /** Changes of the same keys within this time merge. */
    static final long COALESCE_NS = 700_000_000L;

    static final int MAX_EDITS = 200;

    private final RetractingUndoManager edits = new RetractingUndoManager();
    private final List<Runnable> listeners = new ArrayList<>();
    private final LongSupplier clockNs;
    private boolean mergeable;
    private boolean undoneLast;
    private boolean recording;

    /** @param clockNs a clock such as {@link System#nanoTime} */
    EditHistory(LongSupplier clockNs) {
        this.clockNs = clockNs;
        edits.setLimit(MAX_EDITS);
    }

    /** {@code listener} runs after every change of what can be undone or redone. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /**
     * Adds a change that has been made.
     *
     * @param keys that it sets, in any order; changes without keys never merge
     * @param undo restores what was before
     * @param redo makes the change again
     * @return the change, or that with which it is merged
     */
    UndoableEdit add(EditName name, List<String> keys, Runnable undo, Runnable redo) {
        edits.addEdit(new ScenarioEdit(name, keys.stream().sorted().toList(), undo, redo));
        mergeable = true;
        undoneLast = false;
        fireChange();
        return edits.next().orElseThrow();
    }

    /** Forgets a change that could not be made after all. */
    void retract(UndoableEdit edit) {
        edits.retract(edit);
        mergeable = false;
        fireChange();
    }

    /** Forgets the change made last if the run has undone it: if it is of these keys alone. */
    void retractLast(Set<String> keys) {
        edits.next()
                .map(ScenarioEdit.class::cast)
                .filter(last -> !undoneLast && !last.keys.isEmpty() && keys.containsAll(last.keys))
                .ifPresent(this::retract);
    }

    /** Notes that a change which was undone or redone last stands as before: that could not be carried out. */
    void revert(UndoableEdit edit) {
        recording = true;
        edits.revert(edit);
        recording = false;
        mergeable = false;
        fireChange();
    }

    /** The next change does not merge with the last one, however soon it follows. */
    public void endMerging() {
        mergeable = false;
    }

    /** Undoes the last change; does nothing if there is none. */
    public void undo() {
        if (edits.canUndo()) {
            mergeable = false;
            undoneLast = true;
            edits.undo();
            fireChange();
        }
    }

    /** Redoes the change undone last; does nothing if there is none. */
    public void redo() {
        if (edits.canRedo()) {
            mergeable = false;
            undoneLast = false;
            edits.redo();
            fireChange();
        }
    }

    /** Text of the menu item: {@code Undo Muscle stiffness 300 -> 450 N/m}; empty if nothing can be undone. */
    public Optional<String> undoPresentationName() {
        return edits.canUndo() ? Optional.of(edits.getUndoPresentationName()) : Optional.empty();
    }

    /** Text of the menu item: {@code Redo Muscle stiffness 300 -> 450 N/m}; empty if nothing can be redone. */
    public Optional<String> redoPresentationName() {
        return edits.canRedo() ? Optional.of(edits.getRedoPresentationName()) : Optional.empty();
    }

    private void fireChange() {
        listeners.forEach(Runnable::run);
    }

    private static final class RetractingUndoManager extends UndoManager {
        Optional<UndoableEdit> next() {
            return Optional.ofNullable(editToBeUndone());
        }

        void retract(UndoableEdit edit) {
            int at = edits.indexOf(edit);
            if (at >= 0) {
                trimEdits(at, at);
            }
        }

        void revert(UndoableEdit edit) {
            if (edit.equals(editToBeRedone())) {
                redo();
            } else if (edit.equals(editToBeUndone())) {
                undo();
            }
        }
    }

    private final class ScenarioEdit extends AbstractUndoableEdit {
        private final transient List<String> keys;
        private final transient Runnable undo;
        private transient EditName name;
        private transient Runnable redo;
        private long timeNs = clockNs.getAsLong();

        ScenarioEdit(EditName name, List<String> keys, Runnable undo, Runnable redo) {
            this.name = name;
            this.keys = keys;
            this.undo = undo;
            this.redo = redo;
        }

        @Override
        public boolean addEdit(UndoableEdit next) {
            ScenarioEdit later = (ScenarioEdit) next;
            if (!mergeable || keys.isEmpty() || !keys.equals(later.keys) || later.timeNs - timeNs >= COALESCE_NS) {
                return false;
            }
            name = name.mergedWith(later.name);
            redo = later.redo;
            timeNs = later.timeNs;
            return true;
        }

        @Override
        public void undo() {
            super.undo();
            if (!recording) {
                undo.run();
            }
        }

        @Override
        public void redo() {
            super.redo();
            if (!recording) {
                redo.run();
            }
        }

        @Override
        public String getUndoPresentationName() {
            return "Undo " + name.text();
        }

        @Override
        public String getRedoPresentationName() {
            return "Redo " + name.text();
        }
    }
}
