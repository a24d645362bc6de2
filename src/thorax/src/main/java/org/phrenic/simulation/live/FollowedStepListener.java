package org.phrenic.simulation.live;

import java.util.function.BiConsumer;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;

/** A listener and what is done after it at each state that it is given. */
record FollowedStepListener(StepListener first, BiConsumer<Frame, RespiratoryPhase> after) implements StepListener {
    @Override
    public void onStep(Frame frame, RespiratoryPhase label) {
        first.onStep(frame, label);
        after.accept(frame, label);
    }

    @Override
    public void onPause(Frame present, RespiratoryPhase label) {
        first.onPause(present, label);
    }

    @Override
    public boolean needsFrame() {
        return first.needsFrame();
    }

    @Override
    public boolean maySeeFrameLater() {
        return first.maySeeFrameLater();
    }

    @Override
    public void onStepWithoutFrame(double timeS, RespiratoryPhase label, int breath) {
        first.onStepWithoutFrame(timeS, label, breath);
    }

    @Override
    public boolean passes(double timeS, RespiratoryPhase label, int breath) {
        return first.passes(timeS, label, breath);
    }
}
