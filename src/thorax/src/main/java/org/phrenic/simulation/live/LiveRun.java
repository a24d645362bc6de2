package org.phrenic.simulation.live;

import java.util.List;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;

/**
 * A simulation that runs on a thread of its own: it is played, paused and tuned from any thread, and whoever watches
 * takes frames without ever holding it up. Scenes are loaded on another thread while the one at hand goes on.
 *
 * <p>No call waits for a scene; {@link #recordedScenario}, {@link #command} and {@link #commandHash} wait for the step
 * at hand, {@link #close} for the threads to end. What was run can be run again without a window: {@link #command}.
 */
public final class LiveRun implements AutoCloseable {
    /** Told what happens; on the simulation's or the loader's thread, so it should hand on and return. */
    public interface Listener {
        /** How far loading is: body, scene, surfaces, done; share from 0 to 1. */
        void loading(String what, double share);

        /** Another scene runs from now on. */
        void ready(LiveScene scene);

        /** A scene could not be loaded or a change not be made, and why; what ran before goes on. */
        void failed(String sentence);

        /** The run left all bounds; it is paused at its last good state. See {@link LiveRun#restoreLastGood}. */
        void diverged(String sentence);

        /** Settings, playing or pausing changed. */
        void changed();
    }

    private final Listener listener;
    private final RequestedSettings settings;
    private final SimulationLoop loop;
    private final Thread thread;
    private SceneLoader loading;
    private long sceneCount;

    /** Loads a scenario; it is paused until {@link #play}. */
    public LiveRun(Scenario first, Listener listener) {
        this.listener = listener;
        settings = new RequestedSettings(first);
        loop = new SimulationLoop(settings, listener);
        thread = new Thread(loop, "phrenic-simulation");
        thread.setDaemon(true);
        loop.commands.bindTo(thread);
        thread.start();
        load(first);
    }

    /** Runs on. */
    public void play() {
        setPlaying(true);
    }

    /** Stops after the step at hand. */
    public void pause() {
        setPlaying(false);
    }

    public boolean isPlaying() {
        return loop.playing;
    }

    private void setPlaying(boolean on) {
        loop.playing = on;
        loop.commands.submit(() -> {
            loop.startPacing();
            if (loop.running != null) {
                loop.running.publish();
            }
            loop.notifyListener();
        });
    }

    /** One step, if it is paused. */
    public void stepOnce() {
        loop.commands.submit(() -> {
            if (loop.running != null && !loop.playing) {
                loop.applyPendingChanges();
                loop.advance(loop.running, 1, Long.MAX_VALUE);
                loop.running.publish();
                loop.notifyListener();
            }
        });
    }

    /**
     * Back to the start with what is set now: at once if the scene is assembled the same with it, else it is loaded
     * anew.
     */
    public void reset() {
        loop.commands.submit(this::restart);
    }

    /**
     * As {@link #reset}, and from the start on somebody sees the run at steps of a choice, in place of who did before.
     */
    public void restart(StepListener.Trigger when, StepListener watch) {
        loop.commands.submit(() -> {
            loop.setStepListener(watch, when);
            restart();
        });
    }

    private void restart() {
        loop.applyPendingChanges();
        if (loop.running != null && !isLoading() && loop.running.simulation.restart()) {
            loop.running.rewound();
            loop.notifyStepListener(loop.running);
            loop.synchronizeSettings();
            loop.startPacing();
            loop.notifyListener();
        } else {
            load(settings.current());
        }
    }

    /**
     * How fast simulated time may go.
     *
     * @param factor 1 for real time, 2 for twice as fast, {@link Double#POSITIVE_INFINITY} for as fast as it goes
     * @throws IllegalArgumentException if it is not more than 0
     */
    public void setSpeed(double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("speed: found " + factor + ", expected more than 0");
        }
        loop.commands.submit(
                () -> loop.pacer.setSpeed(factor, loop.running == null ? 0 : loop.running.simulation.time()));
    }

    /**
     * Changes settings: live keys ramp in at the next step; with any other key the scene starts anew with all of them,
     * while the present one goes on.
     *
     * @throws org.phrenic.format.BadInputException with one sentence, if a key is unknown or a value cannot be; nothing
     *     has changed then
     */
    public void change(List<Assignment> assignments) {
        if (settings.request(assignments)) {
            loop.commands.wake();
        } else {
            load(settings.current());
        }
        listener.changed();
    }

    /** Loads another scene while the present one goes on; a scene that is being loaded is called off. */
    public synchronized void load(Scenario scenario) {
        if (loop.closed) {
            return;
        }
        settings.beginLoading(scenario);
        SceneLoader before = loading;
        if (before != null) {
            before.cancel();
        }
        long id = ++sceneCount;
        loading = new SceneLoader(scenario, id, listener, before, new SceneLoader.Outcome() {
            @Override
            public void loaded(RunningScene made) {
                if (!loop.commands.submit(() -> acceptLoaded(made))) {
                    made.close();
                }
            }

            @Override
            public void failed(RuntimeException why) {
                loop.commands.submit(() -> {
                    if (endLoading(id)) {
                        loop.reportFailure(why);
                    }
                });
            }
        });
        loading.start();
    }

    private void acceptLoaded(RunningScene made) {
        if (endLoading(made.scene.id()) && !loop.closed) {
            loop.replaceScene(made);
        } else {
            made.close();
        }
    }

    /** Whether this scene is the one that is waited for; then it is so no more. */
    private synchronized boolean endLoading(long id) {
        boolean wanted = loading != null && loading.id() == id && !loading.isCancelled();
        if (wanted) {
            loading = null;
            settings.endLoading();
        }
        return wanted;
    }

    private synchronized boolean isLoading() {
        return loading != null && !loading.isCancelled();
    }

    /**
     * Calls off the scene that is being loaded; settings are again those of the scene that runs. Nothing is called off
     * before the first scene runs.
     */
    public void cancelLoading() {
        synchronized (this) {
            if (!isLoading() || loop.running == null) {
                return;
            }
            loading.cancel();
            settings.endLoading();
        }
        loop.commands.submit(() -> {
            loop.synchronizeSettings();
            loop.notifyListener();
        });
    }

    /** After a divergence: goes on from the last good state with the last change undone. */
    public void restoreLastGood() {
        loop.commands.submit(() -> {
            if (loop.running != null) {
                loop.running.simulation.undoLastChange();
                loop.synchronizeSettings();
                loop.playing = true;
                loop.startPacing();
                loop.notifyListener();
            }
        });
    }

    /** What is set now: every change made so far is in it, and {@link Scenario#changes} is empty. */
    public Scenario scenario() {
        return settings.current();
    }

    /**
     * What was run so far, as a scenario that gives the same bits again: as it was started, with the changes since and
     * the steps done. Before the first scene, the one asked for.
     */
    public Scenario recordedScenario() {
        return loop.commands.submitAndWait(
                () -> loop.running == null ? settings.current() : loop.running.recordedScenario());
    }

    /** The line that runs again what was run so far, without a window. */
    public String command() {
        return RunCommandLine.of(recordedScenario());
    }

    /**
     * Hash of the state as it stands: what {@link #command} prints as {@code state_sha256}. Empty before the first
     * scene.
     */
    public String commandHash() {
        return loop.commands.submitAndWait(() -> loop.running == null ? "" : loop.running.simulation.stateHash());
    }

    /** Whether it plays slower than {@link #setSpeed} asks for, as it does wherever that is as fast as it goes. */
    public boolean isBehindRealTime() {
        return loop.behindRealTime;
    }

    public RunStatus status() {
        return loop.status;
    }

    /**
     * Copies the newest frame, if it is newer than {@code into} and of the same scene. Never holds up the simulation.
     */
    public boolean copyNewestFrame(Frame into) {
        RunningScene now = loop.running;
        return now != null && now.pipe.copyNewest(into);
    }

    /** What was seen of the scene that runs; null before the first. */
    public RunHistory history() {
        RunningScene now = loop.running;
        return now == null ? null : now.history;
    }

    /**
     * How long it takes to see all of what is breathed now, s; see {@link org.phrenic.simulation.Simulation#breathS}. 0
     * before the first scene.
     */
    public double breathDurationS() {
        return loop.commands.submitAndWait(() -> loop.running == null ? 0 : loop.running.simulation.breathDurationS());
    }

    /**
     * From now on somebody sees the run at the steps that are whole multiples of an interval of simulated time, in
     * place of who did before; also after a reset and in another scene.
     *
     * @param everyS s; as many steps as are nearest to it
     * @param watch who sees it, on the simulation's thread
     */
    public void listenToSteps(double everyS, StepListener watch) {
        listenToSteps(StepListener.Trigger.every(everyS), watch);
    }

    /** As {@link #listenToSteps(double, Watch)}, at steps of another choice. */
    public void listenToSteps(StepListener.Trigger when, StepListener watch) {
        loop.commands.submit(() -> loop.notifyStepListener(watch, when));
    }

    /** Nobody sees the run between its steps any more. */
    public void stopListening() {
        loop.commands.submit(() -> loop.notifyStepListener(null, null));
    }

    /** Ends all threads. */
    @Override
    public void close() {
        SceneLoader last;
        synchronized (this) {
            loop.closed = true;
            last = loading;
            if (last != null) {
                last.cancel();
            }
        }
        loop.commands.wake();
        try {
            if (last != null) {
                last.join();
            }
            if (Thread.currentThread() != thread) {
                thread.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
