package org.phrenic.ui.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.RehearsalPlan;

/** The state of a rehearsal that panels show, and its listeners. Used on the event dispatch thread. */
public abstract class RehearsalState {
    private final List<RehearsalListener> listeners = new ArrayList<>();

    RehearsalStage stage = RehearsalStage.CLOSED;
    String unavailableReason = "";
    double recordedFraction;
    Optional<RehearsalBody> body = Optional.empty();
    Optional<RehearsalPlan> exercise = Optional.empty();
    Optional<RehearsalPlan> plan = Optional.empty();
    Optional<TargetAccess> study = Optional.empty();

    public final void addListener(RehearsalListener listener) {
        listeners.add(listener);
    }

    public final void removeListener(RehearsalListener listener) {
        listeners.remove(listener);
    }

    final void fire(Consumer<RehearsalListener> event) {
        listeners.forEach(event);
    }

    final void fireState() {
        fire(RehearsalListener::onState);
    }

    public final RehearsalStage stage() {
        return stage;
    }

    public final boolean isActive() {
        return stage != RehearsalStage.CLOSED;
    }

    public final String unavailableReason() {
        return unavailableReason;
    }

    public final double recordedFraction() {
        return recordedFraction;
    }

    /** The exercise; empty for practice. */
    public final Optional<RehearsalPlan> exercise() {
        return exercise;
    }

    /** What is rehearsed, exercise or practice. */
    public final Optional<RehearsalPlan> plan() {
        return plan;
    }

    /** The target and its access map; empty until it is computed. */
    public final Optional<TargetAccess> study() {
        return study;
    }
}
