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
 * Records the first breath of a live run, counted from its start or latest restart. The moments are bit-identical to
 * those of {@link BreathCycle#record}.
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
     * @param run the run that the recorder is added to as listener and trigger
     * @param ofScene a frame of the scene; frames of other scenes are ignored
     * @param phases number of moments
     * @param progress receives the recorded fraction of the breath, 0 to 1, on the thread of the run
     * @param whole receives all moments once, on the thread of the run
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
