package org.phrenic.simulation.live;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;

/**
 * A simulation that runs on its own thread. Any thread can play, pause and tune it and copy frames without blocking it.
 * A new scene loads on another thread while the current scene continues.
 *
 * <p>No call waits for a scene. {@link #recordedScenario}, {@link #reproduction}, {@link #breathDurationS},
 * {@link #command} and {@link #commandHash} wait for the current step, and {@link #close} waits for the threads to end.
 * {@link #command} reproduces the run without a window.
 */
public final class LiveRun implements AutoCloseable {
    /** What to do where memory is full, as a part of a sentence. */
    public static final String FREE_MEMORY = "choose a lower resolution or start Java with a larger -Xmx";

    /** No scene has this {@link LiveScene#id}. */
    public static final long NO_SCENE = 0;

    /** Receives events on the thread that causes them: simulation, loader or caller. It should return quickly. */
    public interface Listener {
        /** Loading progress: the stage (body, scene, surfaces, done) and the completed share, 0 to 1. */
        void loading(String what, double share);

        /** The body of the scene that loads is there and can be shown at rest; the scene is still to settle. */
        default void body(LiveScene atRest) {}

        /** A new scene has started. */
        void ready(LiveScene scene);

        /** A scene could not be loaded or a change was refused, with the reason. The current run continues. */
        void failed(String sentence);

        /** The run has diverged and is paused at its last valid state. See {@link LiveRun#restoreLastGood}. */
        void diverged(String sentence);

        /** The changes of these keys were undone after a divergence. */
        default void restored(Set<String> keys) {}

        /** Settings or the play state have changed. */
        void changed();
    }

    private final Listener listener;
    private final RequestedSettings settings;
    private final SimulationLoop loop;
    private final Thread thread;
    private final SceneLoads loads;
    /** Whether the run was last asked to play. */
    private volatile boolean wanted;

    /** Loads a scenario. The run is paused until {@link #play}. */
    public LiveRun(Scenario first, Listener listener) {
        this.listener = listener;
        settings = new RequestedSettings(first);
        loop = new SimulationLoop(settings, listener);
        loads = new SceneLoads(settings, loop, listener);
        thread = new Thread(loop, "phrenic-simulation");
        thread.setDaemon(true);
        loop.commands.bindTo(thread);
        thread.start();
        load(first);
    }

    /** Starts or resumes the run. */
    public void play() {
        setPlaying(true);
    }

    /** Pauses after the current step. */
    public void pause() {
        setPlaying(false);
    }

    public boolean isPlaying() {
        return loop.playing;
    }

    private void setPlaying(boolean on) {
        wanted = on;
        loop.playing = on;
        loop.commands.submit(() -> {
            // An end of the run before this may have paused it since; what was asked for later counts.
            loop.playing = wanted;
            loop.playOrPause();
        });
    }

    /** Performs one step if the run is paused. */
    public void stepOnce() {
        loop.commands.submit(() -> {
            if (loop.running != null && !loop.playing) {
                loop.applyPendingChanges();
                loop.advance(loop.running, 1, Long.MAX_VALUE);
                loop.publish();
                loop.notifyListener();
            }
        });
    }

    /**
     * Restarts the run with the current settings. The scene is loaded again only if the settings require another
     * assembly.
     */
    public void reset() {
        loop.commands.submit(this::restart);
    }

    /**
     * As {@link #reset}, without a breath hold, and sets the step listener for the new run, replacing the previous one,
     * which may have held the breath at the last moment.
     */
    public void restart(StepListener.Trigger when, StepListener watch) {
        loop.commands.submit(() -> {
            loop.setStepListener(watch, when);
            if (settings.current().hold()) {
                settings.request(List.of(Assignment.of("restart", Breathing.HOLD, false)));
            }
            restart();
        });
    }

    private void restart() {
        loop.applyPendingChanges();
        if (loop.running != null && !isLoading() && loop.running.simulation.restart()) {
            loop.beginAgain();
        } else {
            loads.loadCurrent();
        }
    }

    /**
     * Sets the maximum speed of simulated time.
     *
     * @param factor simulated over wall time: 1 for real time, {@link Double#POSITIVE_INFINITY} for no limit
     * @throws IllegalArgumentException if it is not above 0
     */
    public void setSpeed(double factor) {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("speed: found " + factor + ", expected more than 0");
        }
        loop.flatOut = Double.isInfinite(factor);
        loop.commands.submit(() -> {
            loop.pacer.setSpeed(factor, loop.running == null ? 0 : loop.running.simulation.time());
            // The mean rate shown is one of the speed asked for.
            loop.startPacing();
        });
    }

    /**
     * Changes settings. Live keys ramp in from the next step. Any other key loads a new scene with all changes while
     * the current scene continues.
     *
     * @throws org.phrenic.file.BadInputException with one sentence, if a key is unknown or a value is invalid; then
     *     nothing has changed
     */
    public void change(List<Assignment> assignments) {
        if (!loads.change(assignments)) {
            loop.commands.wake();
        }
        listener.changed();
    }

    /** Loads this scene and later ones with the further organs of the body; false if the running one has them. */
    public boolean showOrgans() {
        return loads.showOrgans();
    }

    /** Whether the running scene has the further organs of its body. */
    public boolean hasOrgans() {
        return loads.hasOrgans();
    }

    /** Loads another scene while the current one continues. Cancels a load in progress. */
    public void load(Scenario scenario) {
        loads.load(scenario);
    }

    /** {@link LiveScene#id} of the scene whose load began last. */
    public long newestSceneId() {
        return loads.newestSceneId();
    }

    /** {@link LiveScene#id} of the scene that could not be loaded last; {@link #NO_SCENE} if all could. */
    public long lastFailedSceneId() {
        return loads.lastFailedSceneId();
    }

    /** Whether a scene is being loaded. */
    public boolean isLoading() {
        return loads.isLoading();
    }

    /**
     * Whether a scene is on its way to who shows one: it is being loaded, or runs, and that is still to be told.
     *
     * @param shown the scene that is shown
     */
    public boolean isSceneComing(Optional<LiveScene> shown) {
        boolean loading = isLoading();
        RunningScene now = loop.running;
        return loading
                || (now == null ? NO_SCENE : now.scene.id())
                        != shown.map(LiveScene::id).orElse(NO_SCENE);
    }

    /** Cancels a load in progress beside a scene, and restores the settings of that; false if there is none. */
    public boolean cancelLoading() {
        return loads.cancel();
    }

    /** Whether the run has diverged and has neither gone on nor begun again since. */
    public boolean isDiverged() {
        return loop.divergence.isPresent();
    }

    /** While {@link #isDiverged}, continues from the last valid state without the last change, if none came since. */
    public void restoreLastGood() {
        loop.commands.submit(loop::restoreLastGood);
    }

    /** Current settings with all changes applied; {@link Scenario#changes} is empty. */
    public Scenario scenario() {
        return settings.current();
    }

    /**
     * Scenario that reproduces the run so far bit for bit: the initial settings, the changes since and the number of
     * steps. Before the first scene, the requested scenario.
     */
    public Scenario recordedScenario() {
        return loop.commands.submitAndWait(
                () -> loop.running == null ? settings.current() : loop.running.recordedScenario());
    }

    /** Command line that reproduces the run so far without a window. */
    public String command() {
        return reproduction().command();
    }

    /** Hash of the current state; empty before the first scene. */
    public String commandHash() {
        return reproduction().stateHash();
    }

    /** Command line and hash of one and the same state. */
    public ReachedState reproduction() {
        return loop.commands.submitAndWait(() -> ReachedState.of(loop.running, settings.current()));
    }

    /** Whether the run is slower than {@link #setSpeed} asks for. Always true without a speed limit. */
    public boolean isBehindRealTime() {
        return loop.behindRealTime;
    }

    /** Whether the run has no speed limit. */
    public boolean isFlatOut() {
        return loop.flatOut;
    }

    public RunStatus status() {
        return loop.status;
    }

    /** Copies the newest frame, without a wait, if it is newer than {@code into} and of the same scene. */
    public boolean copyNewestFrame(Frame into) {
        RunningScene now = loop.running;
        return now != null && now.pipe.copyNewest(into);
    }

    /** History of the running scene; null before the first scene. */
    public RunHistory history() {
        RunningScene now = loop.running;
        return now == null ? null : now.history;
    }

    /** Simulated time that covers the complete current breathing pattern, s; 0 before the first scene. */
    public double breathDurationS() {
        return loop.commands.submitAndWait(() -> loop.running == null ? 0 : loop.running.simulation.breathDurationS());
    }

    /**
     * Duration of the shortest breath that ends within a time from the start on, with the breathing as it is; that time
     * if none does, or before a scene, s.
     */
    public double shortestBreathS(double withinS) {
        return loop.commands.submitAndWait(() -> loop.running == null
                ? withinS
                : loop.running.simulation.scene().drive().pattern().shortestBreathS(0, withinS));
    }

    /**
     * Sets the step listener and what triggers its calls, rounded to whole steps, also after a reset and in later
     * scenes. Replaces the previous listener. {@link StepListener} says on which thread it is called.
     */
    public void listenToSteps(StepListener.Trigger when, StepListener watch) {
        loop.commands.submit(() -> loop.notifyStepListener(watch, when));
    }

    /** Removes the step listener. */
    public void stopListening() {
        loop.commands.submit(() -> loop.notifyStepListener(null, null));
    }

    /** Ends all threads. */
    @Override
    public void close() {
        try {
            loads.close();
            if (Thread.currentThread() != thread) {
                thread.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
