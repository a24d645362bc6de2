package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.StepListener;
import org.phrenic.simulation.observe.Frame;

/**
 * Gathers the moments of a run's first breath while it is played: those of {@link BreathCycle#record}, bit for bit, so
 * that what is worked out of them is the same with and without a window. It sees the run from its start or from the
 * next time that it is reset.
 */
public final class CycleRecorder implements StepListener, StepListener.Trigger {
    private final LiveRun run;
    private final Frame ofScene;
    private final int phases;
    private final DoubleConsumer progress;
    private final Consumer<List<BreathMoment>> whole;
    private final List<BreathMoment> moments = new ArrayList<>();
    private double breathS;

    /**
     * @param run that is watched, with {@code run.watch(recorder, recorder)}
     * @param ofScene a frame of the scene that is meant; another scene is not looked at
     * @param phases how many moments are wanted
     * @param progress told how much of the breath was seen, 0 to 1; on the run's thread, as below
     * @param whole told the moments, once
     */
    public CycleRecorder(
            LiveRun run, Frame ofScene, int phases, DoubleConsumer progress, Consumer<List<BreathMoment>> whole) {
        this.run = run;
        this.ofScene = ofScene;
        this.phases = phases;
        this.progress = progress;
        this.whole = whole;
    }

    @Override
    public boolean isDue(long step, double timeS, double dtS) {
        if (step == 0) {
            return true;
        }
        int next = moments.size();
        return next > 0 && next < phases && BreathCycle.isDue(timeS, dtS, breathS, next, phases);
    }

    @Override
    public void onStep(Frame frame, RespiratoryPhase label) {
        if (!frame.isOfSceneOf(ofScene)) {
            return;
        }
        if (frame.step() == 0) {
            moments.clear();
            breathS = run.breathDurationS();
        }
        moments.add(new BreathMoment(frame.copy(), label));
        progress.accept((double) moments.size() / phases);
        if (moments.size() == phases) {
            whole.accept(List.copyOf(moments));
        }
    }
}
