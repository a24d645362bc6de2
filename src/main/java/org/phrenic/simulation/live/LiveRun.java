package org.phrenic.simulation.live;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Change;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;

/**
 * A simulation that runs on a thread of its own: it is played, paused and tuned from any thread, and whoever watches takes frames without ever holding it up. Scenes are loaded on another
 * thread while the one at hand goes on.
 *
 * <p>No call waits for a step or a scene but {@link #commandHash} and {@link #close}. What was run can be run again without a window: {@link #command}.
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

    /** Wall time of steps after which commands are looked at again, ns. */
    private static final long TURN_NS = 4_000_000;

    /** Longest wait for news, ns. */
    private static final long IDLE_NS = 20_000_000;

    private final Listener listener;
    private final ReentrantLock lock = new ReentrantLock();
    private final Queue<Runnable> commands = new ArrayDeque<>();
    private final Map<String, Assignment> pending = new LinkedHashMap<>();
    private final Pacer pacer = new Pacer();
    private final Thread thread;
    private Loading loading;
    private boolean ended;
    private long scenes;
    private volatile Scenario settings;
    private volatile Running running;
    private volatile boolean playing;
    private volatile boolean closed;
    private volatile boolean behind;
    private volatile Status status = Status.NOTHING;

    /** Loads a scenario; it is paused until {@link #play}. */
    public LiveRun(Scenario first, Listener listener) {
        this.listener = listener;
        settings = first;
        thread = new Thread(this::loop, "phrenic-simulation");
        thread.setDaemon(true);
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
        return playing;
    }

    private void setPlaying(boolean on) {
        playing = on;
        submit(() -> {
            Running now = running;
            if (now != null) {
                pacer.start(now.simulation.steps(), now.simulation.time());
                now.publish();
            }
            tell();
        });
    }

    /** One step, if it is paused. */
    public void stepOnce() {
        submit(() -> {
            if (running != null && !playing) {
                applyPending();
                advance(running, 1, Long.MAX_VALUE);
                running.publish();
                tell();
            }
        });
    }

    /** Back to the start with what is set now. */
    public void reset() {
        submit(() -> {
            applyPending();
            if (running != null && running.simulation.restart()) {
                running.wentBack();
                pacer.start(0, 0);
                tell();
            } else {
                load(settings);
            }
        });
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
        submit(() -> pacer.setSpeed(factor, running == null ? 0 : running.simulation.time()));
    }

    /**
     * Changes settings: live keys ramp in at the next step; with any other key the scene starts anew with all of them, while the present one goes on.
     *
     * @throws org.phrenic.format.BadInputException with one sentence, if a key is unknown or a value cannot be; nothing has changed then
     */
    public void change(List<Assignment> assignments) {
        lock.lock();
        try {
            Scenario wanted = settings.with(assignments);
            settings = wanted;
            if (assignments.stream().allMatch(a -> Simulation.isLive(a.key()))) {
                for (Assignment assignment : assignments) {
                    pending.remove(assignment.key());
                    pending.put(assignment.key(), assignment);
                }
                LockSupport.unpark(thread);
            } else {
                load(wanted);
            }
        } finally {
            lock.unlock();
        }
        listener.changed();
    }

    /** Loads another scene while the present one goes on; a scene that is being loaded is called off. */
    public void load(Scenario scenario) {
        lock.lock();
        try {
            if (closed) {
                return;
            }
            settings = scenario.changes().isEmpty() ? scenario : scenario.afterChanges();
            Loading before = loading;
            if (before != null) {
                before.cancel();
            }
            Loading next = new Loading(scenario, ++scenes, listener, before, new Loading.End() {
                @Override
                public void loaded(Running made) {
                    if (!submit(() -> swap(made))) {
                        made.close();
                    }
                }

                @Override
                public void failed(RuntimeException why) {
                    submit(() -> refused(why));
                }
            });
            loading = next;
            next.start();
        } finally {
            lock.unlock();
        }
    }

    /** Calls off the scene that is being loaded; settings are again those of the scene that runs. */
    public void cancelLoading() {
        lock.lock();
        try {
            if (loading != null && running != null) {
                loading.cancel();
            }
        } finally {
            lock.unlock();
        }
        submit(() -> {
            settle();
            tell();
        });
    }

    /** After a divergence: goes on from the last good state with the last change undone. */
    public void restoreLastGood() {
        submit(() -> {
            if (running != null) {
                running.simulation.undoLastChange();
                running.wentBack();
                settle();
                playing = true;
                pacer.start(running.simulation.steps(), running.simulation.time());
                tell();
            }
        });
    }

    /** What is set now: every change made so far is in it, and {@link Scenario#changes} is empty. */
    public Scenario scenario() {
        return settings;
    }

    /** What was run so far, as a scenario that gives the same bits again: as it was started, with the changes since and the steps done. Before the first scene, the one asked for. */
    public Scenario recorded() {
        Running now = running;
        return now == null ? settings : ask(now::recorded);
    }

    /** The line that runs again what was run so far, without a window. */
    public String command() {
        return RunCommandText.of(recorded());
    }

    /** Hash of the state as it stands: what {@link #command} prints as {@code state_sha256}. Empty before the first scene. */
    public String commandHash() {
        Running now = running;
        return now == null ? "" : ask(now.simulation::stateHash);
    }

    /** Whether it plays slower than {@link #setSpeed} asks for, as it does wherever that is as fast as it goes. */
    public boolean isBehind() {
        return behind;
    }

    public Status status() {
        return status;
    }

    /** Copies the newest frame, if it is newer than {@code into} and of the same scene. Never holds up the simulation. */
    public boolean takeFrame(Frame into) {
        Running now = running;
        return now != null && now.pipe.take(into);
    }

    /** What was seen of the scene that runs; null before the first. */
    public History history() {
        Running now = running;
        return now == null ? null : now.history;
    }

    /** Ends all threads. */
    @Override
    public void close() {
        Loading last;
        lock.lock();
        try {
            closed = true;
            last = loading;
            if (last != null) {
                last.cancel();
            }
            LockSupport.unpark(thread);
        } finally {
            lock.unlock();
        }
        try {
            if (last != null) {
                last.join();
            }
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void loop() {
        while (!closed) {
            runCommands();
            applyPending();
            Running now = running;
            long wait = now != null && playing ? pacer.waitNs(now.simulation.time()) : Long.MAX_VALUE;
            if (wait <= 0) {
                advance(now, Long.MAX_VALUE, System.nanoTime() + TURN_NS);
                pacer.measure(now.simulation.steps(), now.simulation.time());
            } else {
                await(wait);
            }
            if (now != null) {
                now.publishIfWanted();
                updateStatus(now);
            }
        }
        end();
    }

    private void advance(Running now, long most, long untilNs) {
        try {
            for (long i = 0; i < most; i++) {
                now.step();
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
            listener.diverged(e.getMessage() + last);
        }
    }

    private void applyPending() {
        List<Assignment> now;
        lock.lock();
        try {
            if (pending.isEmpty() || running == null) {
                return;
            }
            now = new ArrayList<>(pending.values());
            pending.clear();
        } finally {
            lock.unlock();
        }
        try {
            running.simulation.change(now);
        } catch (RuntimeException e) {
            refused(e);
        }
    }

    private void swap(Running made) {
        Running old = running;
        lock.lock();
        try {
            if (closed || loading == null || loading.isCancelled() || loading.id() != made.scene.id()) {
                made.close();
                return;
            }
            loading = null;
            running = made;
            // What was changed while it was loaded.
            Map<String, Object> wanted = settings.toMap();
            Map<String, Object> has = made.simulation.settings().toMap();
            pending.clear();
            wanted.forEach((key, value) -> {
                if (Simulation.isLive(key) && !value.equals(has.get(key))) {
                    pending.put(key, new Assignment("change", key, String.valueOf(value)));
                }
            });
        } finally {
            lock.unlock();
        }
        if (old != null) {
            old.close();
        }
        pacer.start(0, 0);
        updateStatus(made);
        listener.ready(made.scene);
        tell();
    }

    /** A change or a scene could not be: settings are again what runs. */
    private void refused(RuntimeException why) {
        lock.lock();
        try {
            if (loading != null && !loading.isCancelled()) {
                loading.cancel();
            }
        } finally {
            lock.unlock();
        }
        settle();
        listener.failed(why.getMessage() == null ? why.toString() : why.getMessage());
        tell();
    }

    private void settle() {
        if (running != null) {
            settings = running.simulation.settings();
        }
    }

    private void tell() {
        if (running != null) {
            updateStatus(running);
        }
        listener.changed();
    }

    private void updateStatus(Running now) {
        Simulation simulation = now.simulation;
        behind = playing && pacer.isBehind();
        status = new Status(
                simulation.steps(),
                simulation.time(),
                simulation.stepper().dt(),
                simulation.stepper().substeps(),
                playing ? pacer.stepsPerS() : 0,
                playing ? pacer.realtimeFactor() : 0,
                playing,
                simulation.limitSentence(),
                simulation.breathLabel().name().toLowerCase(Locale.ROOT));
    }

    private void runCommands() {
        while (true) {
            Runnable command;
            lock.lock();
            try {
                command = commands.poll();
            } finally {
                lock.unlock();
            }
            if (command == null) {
                return;
            }
            try {
                command.run();
            } catch (RuntimeException e) {
                // Such as a trace that is gone from the disk: what was asked for is not done, and the run goes on.
                refused(e);
            }
        }
    }

    /** Waits for news or so long; news that came meanwhile end it at once. */
    private static void await(long ns) {
        LockSupport.parkNanos(Math.min(ns, IDLE_NS));
    }

    private boolean submit(Runnable command) {
        lock.lock();
        try {
            if (ended) {
                return false;
            }
            commands.add(command);
            LockSupport.unpark(thread);
            return true;
        } finally {
            lock.unlock();
        }
    }

    /** Asks on the simulation's thread, between two steps. */
    private <T> T ask(Supplier<T> question) {
        if (Thread.currentThread() == thread) {
            return question.get();
        }
        CompletableFuture<T> answer = new CompletableFuture<>();
        boolean asked = submit(() -> {
            try {
                answer.complete(question.get());
            } catch (RuntimeException e) {
                answer.completeExceptionally(e);
            }
        });
        return asked ? answer.join() : question.get();
    }

    private void end() {
        lock.lock();
        try {
            ended = true;
        } finally {
            lock.unlock();
        }
        runCommands();
        if (running != null) {
            running.close();
        }
    }
}
