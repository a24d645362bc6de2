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
 * Records the first breath of a live run, or those of a pattern that repeats after several, counted from its start or
 * latest restart. The moments are bit-identical to those of {@link BreathCycle#record}.
 */
public final class CycleRecorder implements StepListener, StepListener.Trigger {
    private final LiveRun run;
    private final Frame ofScene;
    private final int phases;
    private final DoubleConsumer progress;
    private final Consumer<List<BreathMoment>> whole;
    private final List<BreathMoment> moments = new ArrayList<>();
    private double periodS;
    private int count;

    /**
     * @param run the run that the recorder is added to as listener and trigger
     * @param ofScene a frame of the scene; frames of other scenes are ignored
     * @param phases number of moments of a breath
     * @param progress receives the recorded fraction, 0 to 1, on the thread of the run
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
        return next > 0 && next < count && BreathCycle.isDue(timeS, dtS, BreathCycle.recordedS(periodS), next, count);
    }

    @Override
    public void onStep(Frame frame, RespiratoryPhase label) {
        if (!frame.isOfSceneOf(ofScene)) {
            return;
        }
        if (frame.step() == 0) {
            moments.clear();
            periodS = run.breathDurationS();
            double recordedS = BreathCycle.recordedS(periodS);
            count = BreathCycle.moments(phases, recordedS, run.shortestBreathS(recordedS));
        }
        moments.add(new BreathMoment(frame.copy(), label, periodS));
        progress.accept((double) moments.size() / count);
        if (moments.size() == count) {
            whole.accept(List.copyOf(moments));
        }
    }
}
