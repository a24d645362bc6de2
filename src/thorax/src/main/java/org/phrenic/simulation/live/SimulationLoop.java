package org.phrenic.simulation.live;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.Simulation;

/**
 * Main loop of the simulation's thread: commands, changes, steps and frames. Only the volatile fields are used by other
 * threads.
 */
final class SimulationLoop implements Runnable {
    /** Wall time of stepping between two checks for commands, ns. */
    private static final long STEPPING_SLICE_NS = 4_000_000;

    /** Longest idle wait, ns. */
    private static final long MAX_IDLE_NS = 20_000_000;

    final CommandQueue commands = new CommandQueue();
    final Pacer pacer = new Pacer();
    private final ThreadChooser threadChooser = new ThreadChooser();
    volatile RunningScene running;
    volatile boolean playing;
    volatile boolean closed;
    volatile boolean behindRealTime;
    volatile boolean flatOut;
    volatile RunStatus status = RunStatus.NOTHING;
    /** The changes made before a divergence from which the run has not gone on yet. */
    volatile Optional<List<ScheduledChange>> divergence = Optional.empty();

    private StepListener stepListener;
    private StepListener.Trigger trigger;
    private final RequestedSettings settings;
    private final LiveRun.Listener listener;
    private Scenario synchronizedSettings;
    private String frameFailure = "";
    /** What ended the last turn; null if it came to its end. */
    private Throwable brokenBy;
    /** What stopped the run and is still to be told; null if all is told. */
    private Throwable untold;

    SimulationLoop(RequestedSettings settings, LiveRun.Listener listener) {
        this.settings = settings;
        this.listener = listener;
    }

    @Override
    public void run() {
        try {
            while (!closed) {
                turnOrStop();
            }
        } finally {
            commands.close();
            if (running != null) {
                running.close();
            }
        }
    }

    /** Makes a turn. An error stops the run and is told; commands, changes and loads go on. */
    private void turnOrStop() {
        try {
            tellError();
            turn();
            brokenBy = null;
        } catch (RuntimeException | Error e) {
            // Memory may be full: nothing is allocated here. An error that comes in every turn is told once.
            boolean isKnown = !playing && brokenBy != null && brokenBy.getClass() == e.getClass();
            untold = isKnown ? untold : e;
            brokenBy = e;
            playing = false;
            CommandQueue.await(MAX_IDLE_NS);
        }
    }

    private void tellError() {
        if (untold != null) {
            String why = untold instanceof OutOfMemoryError
                    ? "there is not enough memory; " + LiveRun.FREE_MEMORY
                    : untold.toString();
            listener.failed("The simulation stopped: " + why);
            untold = null;
            notifyListener();
        }
    }

    private void turn() {
        runCommands();
        applyPendingChanges();
        RunningScene now = running;
        long wait = now != null && playing ? pacer.waitNs(now.simulation.time()) : MAX_IDLE_NS;
        if (wait > 0) {
            CommandQueue.await(Math.min(wait, MAX_IDLE_NS));
        } else {
            advance(now, Long.MAX_VALUE, System.nanoTime() + STEPPING_SLICE_NS);
        }
        if (now != null && playing && pacer.measure(now.simulation.steps(), now.simulation.time())) {
            chooseThreads(now);
        }
        if (now != null) {
            publishIfDue(now);
            updateStatus();
            synchronizeIfChanged(now.simulation.settings());
        }
    }

    /** Publishes a frame if due. A frame that failed stops the run; the same failure is reported once. */
    private void publishIfDue(RunningScene now) {
        try {
            now.publishIfDue();
        } catch (RuntimeException e) {
            playing = false;
            if (e.toString().equals(frameFailure)) {
                notifyListener();
            } else {
                frameFailure = e.toString();
                reportFailure(e);
            }
        }
    }

    private void chooseThreads(RunningScene now) {
        threadChooser.measured(pacer.realtimeFactor(), pacer.isBehind());
        now.simulation.system().workers().useCallerOnly(!threadChooser.allThreads());
    }

    /**
     * The scenario itself may change settings during the run. Settings are immutable, so comparing references suffices
     * and is cheaper than comparing values in every iteration.
     */
    @SuppressWarnings("ReferenceEquality")
    private void synchronizeIfChanged(Scenario set) {
        if (set != synchronizedSettings) {
            synchronizeSettings();
            listener.changed();
        }
    }

    /** Steps until a number of steps is done, the next step is not yet due, or the time is up. */
    void advance(RunningScene now, long most, long untilNs) {
        divergence.ifPresent(made -> now.simulation.goOn());
        divergence = Optional.empty();
        try {
            for (long i = 0; i < most; i++) {
                now.step();
                notifyStepListener(now);
                if (System.nanoTime() >= untilNs || pacer.waitNs(now.simulation.time()) > 0) {
                    return;
                }
            }
        } catch (DivergenceException e) {
            playing = false;
            now.rewound();
            divergence = Optional.of(now.simulation.changes());
            List<ScheduledChange> made = madeIn(now.simulation);
            String last = made.isEmpty()
                    ? ""
                    : "; the last change was "
                            + made.get(made.size() - 1).assignment().key();
            updateStatus();
            listener.diverged(e.getMessage() + last);
        } catch (RuntimeException e) {
            // A change that the scenario schedules for this step was refused.
            playing = false;
            reportFailure(e);
        }
    }

    private static List<ScheduledChange> madeIn(Simulation simulation) {
        return simulation.changes().stream().filter(c -> !c.isOnlyGoingOn()).toList();
    }

    /**
     * Executes the submitted commands. A command that fails, such as a reset to a deleted recording, is reported; the
     * run and the later commands continue.
     */
    private void runCommands() {
        try {
            commands.drain();
        } catch (RuntimeException e) {
            reportFailure(e);
        }
    }

    /** Applies the pending changes. */
    void applyPendingChanges() {
        if (running == null) {
            return;
        }
        List<Assignment> now = settings.takePending(running.simulation.settings());
        if (now.isEmpty()) {
            return;
        }
        try {
            running.simulation.change(now);
        } catch (RuntimeException e) {
            reportFailure(e);
        }
    }

    /** Sets the step listener from the next step on; null for none. */
    void setStepListener(StepListener to, StepListener.Trigger at) {
        stepListener = to;
        trigger = at;
    }

    /** Sets the step listener and calls it for the current step if due; null for none. */
    void notifyStepListener(StepListener to, StepListener.Trigger at) {
        setStepListener(to, at);
        if (running != null) {
            notifyStepListener(running);
        }
    }

    /** Calls the step listener if the current step is due, and applies the changes that it requests. */
    void notifyStepListener(RunningScene now) {
        if (stepListener != null && now.notifyStepListener(stepListener, trigger)) {
            applyPendingChanges();
        }
    }

    /** Takes up the pace where the run was paused, or shows the state at which it is paused. */
    void playOrPause() {
        startPacing();
        if (running != null) {
            publish();
        }
        notifyListener();
    }

    /** Publishes the current state, which the step listener is given too where the run stands still. */
    void publish() {
        if (playing || stepListener == null) {
            running.publish();
        } else {
            running.publishAtPause(stepListener);
        }
    }

    /** Makes a scene the running one; returns the former, null if there is none, for {@link #beginScene}. */
    RunningScene take(RunningScene made) {
        RunningScene old = running;
        settings.sceneStarted(made.simulation.settings());
        running = made;
        divergence = Optional.empty();
        frameFailure = "";
        synchronizedSettings = made.simulation.settings();
        return old;
    }

    /** Begins with the running scene, and closes the former one; what ended its last frame is thrown at the end. */
    void beginScene(RunningScene old) {
        try {
            if (old != null) {
                old.close();
            }
        } finally {
            pacer.start(0, 0);
            threadChooser.reset();
            running.simulation.system().workers().useCallerOnly(true);
            updateStatus();
            listener.ready(running.scene);
            notifyListener();
        }
    }

    /** Goes on after the simulation was put back to its start. */
    void beginAgain() {
        running.rewound();
        divergence = Optional.empty();
        notifyStepListener(running);
        synchronizeSettings();
        startPacing();
        notifyListener();
    }

    /** See {@link LiveRun#restoreLastGood}. */
    void restoreLastGood() {
        applyPendingChanges();
        if (divergence.isEmpty()) {
            return;
        }
        Simulation simulation = running.simulation;
        if (simulation.changes().equals(divergence.get()) && simulation.undoLastChange()) {
            List<ScheduledChange> made = madeIn(simulation);
            long undone = made.get(made.size() - 1).step();
            listener.restored(made.stream()
                    .filter(change -> change.step() == undone)
                    .map(change -> change.assignment().key())
                    .collect(Collectors.toSet()));
        }
        synchronizeSettings();
        playing = true;
        startPacing();
        notifyListener();
    }

    /** Reports a refused change or scene, and resets the settings to those of the simulation. */
    void reportFailure(RuntimeException why) {
        synchronizeSettings();
        listener.failed(why.getMessage() == null ? why.toString() : why.getMessage());
        notifyListener();
    }

    /** Resets the settings to those of the simulation. */
    void synchronizeSettings() {
        if (running != null) {
            synchronizedSettings = running.simulation.settings();
            settings.followRunning(synchronizedSettings);
        }
    }

    /** Restarts measuring and pacing at the current state. */
    void startPacing() {
        if (running != null) {
            pacer.start(running.simulation.steps(), running.simulation.time());
        }
    }

    void notifyListener() {
        updateStatus();
        listener.changed();
    }

    private void updateStatus() {
        if (running == null) {
            return;
        }
        Simulation simulation = running.simulation;
        behindRealTime = playing && pacer.isSlow();
        status = new RunStatus(
                simulation.steps(),
                simulation.time(),
                simulation.stepper().dt(),
                simulation.stepper().substeps(),
                playing ? pacer.stepsPerS() : 0,
                playing ? pacer.realtimeFactor() : 0,
                playing,
                running.substepReason(),
                simulation.breathLabel().name().toLowerCase(Locale.ROOT),
                simulation.isRepeating());
    }
}
