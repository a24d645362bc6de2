package org.phrenic.simulation.live;

import java.util.List;
import java.util.Locale;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.Simulation;

/**
 * The work of the simulation's thread: commands, changes, steps as they are due, frames. All but what is volatile is
 * used by that thread alone.
 */
final class SimulationLoop implements Runnable {
    /** Wall time of steps after which commands are looked at again, ns. */
    private static final long STEPPING_SLICE_NS = 4_000_000;

    /** Longest wait for news, ns. */
    private static final long MAX_IDLE_NS = 20_000_000;

    final CommandQueue commands = new CommandQueue();
    final Pacer pacer = new Pacer();
    volatile RunningScene running;
    volatile boolean playing;
    volatile boolean closed;
    volatile boolean behindRealTime;
    volatile RunStatus status = RunStatus.NOTHING;
    private StepListener stepListener;
    private StepListener.Trigger trigger;
    private final RequestedSettings settings;
    private final LiveRun.Listener listener;
    private Scenario synchronizedSettings;

    SimulationLoop(RequestedSettings settings, LiveRun.Listener listener) {
        this.settings = settings;
        this.listener = listener;
    }

    @Override
    public void run() {
        while (!closed) {
            runCommands();
            applyPendingChanges();
            RunningScene now = running;
            long wait = now != null && playing ? pacer.waitNs(now.simulation.time()) : MAX_IDLE_NS;
            if (wait > 0) {
                CommandQueue.await(Math.min(wait, MAX_IDLE_NS));
            } else {
                advance(now, Long.MAX_VALUE, System.nanoTime() + STEPPING_SLICE_NS);
                pacer.measure(now.simulation.steps(), now.simulation.time());
            }
            if (now != null) {
                now.publishIfDue();
                updateStatus();
                synchronizeIfChanged(now.simulation.settings());
            }
        }
        commands.close();
        if (running != null) {
            running.close();
        }
    }

    /**
     * The scenario may change settings of its own while it runs; settings are immutable, so another object is another
     * setting and comparing values, several times a turn, would be waste.
     */
    @SuppressWarnings("ReferenceEquality")
    private void synchronizeIfChanged(Scenario set) {
        if (set != synchronizedSettings) {
            synchronizeSettings();
            listener.changed();
        }
    }

    /** Steps until so many are done, the next is not yet due, or time is up. */
    void advance(RunningScene now, long most, long untilNs) {
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
            List<ScheduledChange> made = now.simulation.changes();
            String last = made.isEmpty()
                    ? ""
                    : "; the last change was "
                            + made.get(made.size() - 1).assignment().key();
            updateStatus();
            listener.diverged(e.getMessage() + last);
        } catch (RuntimeException e) {
            // A change that the scenario has for this step was refused.
            playing = false;
            reportFailure(e);
        }
    }

    /**
     * What cannot be done, such as a reset to a trace that is gone from the disk, is said; the run goes on, and what
     * was asked after it is done next.
     */
    private void runCommands() {
        try {
            commands.drain();
        } catch (RuntimeException e) {
            reportFailure(e);
        }
    }

    /** Makes the changes that wait. */
    void applyPendingChanges() {
        if (running == null) {
            return;
        }
        List<Assignment> now = settings.takePending();
        if (now.isEmpty()) {
            return;
        }
        try {
            running.simulation.change(now);
        } catch (RuntimeException e) {
            reportFailure(e);
        }
    }

    /** From the next step on the scene is shown to another watch; null for none. */
    void setStepListener(StepListener to, StepListener.Trigger at) {
        stepListener = to;
        trigger = at;
    }

    /** Shows the scene to a watch, now if this is one of its steps and at every one that comes; null for none. */
    void notifyStepListener(StepListener to, StepListener.Trigger at) {
        setStepListener(to, at);
        if (running != null) {
            notifyStepListener(running);
        }
    }

    /** Shows the step at hand to the watch if it is one of its steps, and makes the changes that it asks for. */
    void notifyStepListener(RunningScene now) {
        if (stepListener != null && now.notifyStepListener(stepListener, trigger)) {
            applyPendingChanges();
        }
    }

    /** Another scene runs from now on; the one before is closed. */
    void replaceScene(RunningScene made) {
        RunningScene old = running;
        settings.sceneStarted(made.simulation.settings());
        running = made;
        synchronizedSettings = made.simulation.settings();
        if (old != null) {
            old.close();
        }
        pacer.start(0, 0);
        updateStatus();
        listener.ready(made.scene);
        notifyListener();
    }

    /** A change or a scene could not be: settings are again what runs. */
    void reportFailure(RuntimeException why) {
        synchronizeSettings();
        listener.failed(why.getMessage() == null ? why.toString() : why.getMessage());
        notifyListener();
    }

    /** Settings are what runs. */
    void synchronizeSettings() {
        if (running != null) {
            synchronizedSettings = running.simulation.settings();
            settings.followRunning(synchronizedSettings);
        }
    }

    /** Measures and paces from where the run is. */
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
        behindRealTime = playing && pacer.isBehind();
        status = new RunStatus(
                simulation.steps(),
                simulation.time(),
                simulation.stepper().dt(),
                simulation.stepper().substeps(),
                playing ? pacer.stepsPerS() : 0,
                playing ? pacer.realtimeFactor() : 0,
                playing,
                running.substepReason(),
                simulation.breathLabel().name().toLowerCase(Locale.ROOT));
    }
}
