package org.phrenic.simulation.live;

import java.util.concurrent.CancellationException;
import org.phrenic.anatomy.Thorax;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** One scene being loaded, on a thread of its own; can be called off between its stages. */
final class Loading {
    /** Told how loading ends; on the loader's thread. */
    interface End {
        void loaded(Running running);

        void failed(RuntimeException why);
    }

    private static final double BODY_SHARE = 0.3;
    private static final double SCENE_SHARE = 0.9;

    final Scenario scenario;
    private final long id;
    private final LiveRun.Listener listener;
    private final End end;
    private final Thread thread;
    private volatile boolean cancelled;

    /**
     * @param after another one that is to be over before this begins, null for none
     */
    Loading(Scenario scenario, long id, LiveRun.Listener listener, Loading after, End end) {
        this.scenario = scenario;
        this.id = id;
        this.listener = listener;
        this.end = end;
        thread = new Thread(() -> run(after), "phrenic-loader");
        thread.setDaemon(true);
    }

    long id() {
        return id;
    }

    void start() {
        thread.start();
    }

    void cancel() {
        cancelled = true;
    }

    boolean isCancelled() {
        return cancelled;
    }

    /** Waits until it is over. */
    void join() throws InterruptedException {
        thread.join();
    }

    private void run(Loading after) {
        try {
            if (after != null) {
                after.join();
            }
            end.loaded(load());
        } catch (CancellationException calledOff) {
            // Whoever called it off knows.
            return;
        } catch (RuntimeException e) {
            end.failed(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private Running load() {
        stage("body", 0);
        Thorax thorax = SimulationRun.thorax(scenario);
        stage("scene", BODY_SHARE);
        Simulation simulation = Simulation.of(scenario, thorax);
        try {
            stage("surfaces", SCENE_SHARE);
            SceneSurfaces surfaces = new SceneSurfaces(simulation);
            Running running = new Running(simulation, surfaces, thorax.notes(), id);
            stage("done", 1);
            return running;
        } catch (RuntimeException e) {
            simulation.close();
            throw e;
        }
    }

    private void stage(String what, double share) {
        if (cancelled) {
            throw new CancellationException();
        }
        listener.loading(what, share);
    }
}
