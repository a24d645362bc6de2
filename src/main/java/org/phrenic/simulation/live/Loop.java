package org.phrenic.simulation.live;

import java.util.List;
import java.util.Locale;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Change;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/** The work of the simulation's thread: commands, changes, steps as they are due, frames. All but what is volatile is used by that thread alone. */
final class Loop implements Runnable {
    /** Wall time of steps after which commands are looked at again, ns. */
    private static final long TURN_NS = 4_000_000;

    /** Longest wait for news, ns. */
    private static final long IDLE_NS = 20_000_000;

    final Commands commands = new Commands();
    final Pacer pacer = new Pacer();
    volatile Running running;
    volatile boolean playing;
    volatile boolean closed;
    volatile boolean behind;
    volatile Status status = Status.NOTHING;
    private Watch watch;
    private Watch.When when;
    private final Settings settings;
    private final LiveRun.Listener listener;
    private Scenario followed;

    Loop(Settings settings, LiveRun.Listener listener) {
        this.settings = settings;
        this.listener = listener;
    }

    @Override
    public void run() {
        while (!closed) {
            doWhatIsAsked();
            makeChanges();
            Running now = running;
            long wait = now != null && playing ? pacer.waitNs(now.simulation.time()) : IDLE_NS;
            if (wait > 0) {
                Commands.await(Math.min(wait, IDLE_NS));
            } else {
                advance(now, Long.MAX_VALUE, System.nanoTime() + TURN_NS);
                pacer.measure(now.simulation.steps(), now.simulation.time());
            }
            if (now != null) {
                now.publishIfWanted();
                updateStatus();
                followChanges(now.simulation.settings());
            }
        }
        commands.end();
        if (running != null) {
            running.close();
        }
    }

    /** The scenario may change settings of its own while it runs; settings are immutable, so another object is another setting and comparing values, several times a turn, would be waste. */
    @SuppressWarnings("ReferenceEquality")
    private void followChanges(Scenario set) {
        if (set != followed) {
            settle();
            listener.changed();
        }
    }

    /** Steps until so many are done, the next is not yet due, or time is up. */
    void advance(Running now, long most, long untilNs) {
        try {
            for (long i = 0; i < most; i++) {
                now.step();
                show(now);
                if (System.nanoTime() >= untilNs || pacer.waitNs(now.simulation.time()) > 0) {
                    return;
                }
            }
        } catch (DivergenceException e) {
            playing = false;
            now.wentBack();
            List<Change> made = now.simulation.changes();
            String last = made.isEmpty()
                    ? ""
                    : "; the last change was "
                            + made.get(made.size() - 1).assignment().key();
            updateStatus();
            listener.diverged(e.getMessage() + last);
        } catch (RuntimeException e) {
            // A change that the scenario has for this step was refused.
            playing = false;
            refused(e);
        }
    }

    /** What cannot be done, such as a reset to a trace that is gone from the disk, is said; the run goes on, and what was asked after it is done next. */
    private void doWhatIsAsked() {
        try {
            commands.runAll();
        } catch (RuntimeException e) {
            refused(e);
        }
    }

    /** Makes the changes that wait. */
    void makeChanges() {
        if (running == null) {
            return;
        }
        List<Assignment> now = settings.take();
        if (now.isEmpty()) {
            return;
        }
        try {
            running.simulation.change(now);
        } catch (RuntimeException e) {
            refused(e);
        }
    }

    /** From the next step on the scene is shown to another watch; null for none. */
    void replace(Watch to, Watch.When at) {
        watch = to;
        when = at;
    }

    /** Shows the scene to a watch, now if this is one of its steps and at every one that comes; null for none. */
    void show(Watch to, Watch.When at) {
        replace(to, at);
        if (running != null) {
            show(running);
        }
    }

    /** Shows the step at hand to the watch if it is one of its steps, and makes the changes that it asks for. */
    void show(Running now) {
        if (watch != null && now.showTo(watch, when)) {
            makeChanges();
        }
    }

    /** Another scene runs from now on; the one before is closed. */
    void swap(Running made) {
        Running old = running;
        settings.started(made.simulation.settings());
        running = made;
        followed = made.simulation.settings();
        if (old != null) {
            old.close();
        }
        pacer.start(0, 0);
        updateStatus();
        listener.ready(made.scene);
        tell();
    }

    /** A change or a scene could not be: settings are again what runs. */
    void refused(RuntimeException why) {
        settle();
        listener.failed(why.getMessage() == null ? why.toString() : why.getMessage());
        tell();
    }

    /** Settings are what runs. */
    void settle() {
        if (running != null) {
            followed = running.simulation.settings();
            settings.follow(followed);
        }
    }

    /** Measures and paces from where the run is. */
    void startPacing() {
        if (running != null) {
            pacer.start(running.simulation.steps(), running.simulation.time());
        }
    }

    void tell() {
        updateStatus();
        listener.changed();
    }

    private void updateStatus() {
        if (running == null) {
            return;
        }
        Simulation simulation = running.simulation;
        behind = playing && pacer.isBehind();
        status = new Status(
                simulation.steps(),
                simulation.time(),
                simulation.stepper().dt(),
                simulation.stepper().substeps(),
                playing ? pacer.stepsPerS() : 0,
                playing ? pacer.realtimeFactor() : 0,
                playing,
                running.limitSentence(),
                simulation.breathLabel().name().toLowerCase(Locale.ROOT));
    }
}
