package org.phrenic.access.live;

import org.phrenic.access.plan.PlanPlayer;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Frame;

/** A plan that is played in a live run until its end, or until a step that cannot be executed, which is told. */
final class PlayedPlan {
    private final PlanPlayer player;
    private final AttemptListener listener;
    private boolean stopped;

    PlayedPlan(PlanPlayer player, AttemptListener listener) {
        this.player = player;
        this.listener = listener;
    }

    /** Executes the steps that are due at a frame; returns whether the last one has been. */
    boolean update(Frame frame, RespiratoryPhase phase, int breath) {
        if (stopped) {
            return false;
        }
        try {
            return player.update(frame, phase, breath);
        } catch (BadInputException bad) {
            stopped = true;
            listener.refused(bad.getMessage());
            listener.stopped();
            return false;
        }
    }
}
