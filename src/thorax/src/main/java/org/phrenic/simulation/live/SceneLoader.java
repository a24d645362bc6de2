package org.phrenic.simulation.live;

import java.util.concurrent.CancellationException;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.UserCache;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** Loads one scene on its own thread. Loading can be cancelled between its stages. */
final class SceneLoader {
    /** Receives the result on the loader's thread. */
    interface Outcome {
        void loaded(RunningScene running);

        void failed(RuntimeException why);
    }

    private static final double BODY_SHARE = 0.3;
    private static final double SCENE_SHARE = 0.9;

    final Scenario scenario;
    private final long id;
    private final LiveRun.Listener listener;
    private final Outcome end;
    private final boolean organs;
    private final Thread thread;
    private volatile boolean cancelled;

    /**
     * @param organs whether the scene has the further organs of its body
     * @param after a loader that must finish before this one starts, or null
     */
    SceneLoader(Scenario scenario, long id, boolean organs, LiveRun.Listener listener, SceneLoader after, Outcome end) {
        this.organs = organs;
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

    /** Waits until loading has ended. */
    void join() throws InterruptedException {
        thread.join();
    }

    private void run(SceneLoader after) {
        try {
            if (after != null) {
                after.join();
            }
            end.loaded(load());
        } catch (CancellationException calledOff) {
            // A cancelled load is not reported.
            return;
        } catch (RuntimeException e) {
            end.failed(e);
        } catch (OutOfMemoryError full) {
            end.failed(new IllegalStateException("not enough memory for this scene; " + LiveRun.FREE_MEMORY, full));
        } catch (Error e) {
            end.failed(new IllegalStateException("this scene cannot be loaded (" + e + ")", e));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private RunningScene load() {
        enterStage("body", 0);
        Thorax thorax = SimulationRun.loadThorax(scenario);
        enterStage("scene", BODY_SHARE);
        listener.body(LiveScene.atRest(scenario, thorax));
        Simulation simulation = Simulation.of(scenario, thorax, UserCache.ofUser());
        try {
            enterStage("surfaces", SCENE_SHARE);
            SceneSurfaces surfaces = organs ? SceneSurfaces.withOrgans(simulation) : new SceneSurfaces(simulation);
            RunningScene running = new RunningScene(simulation, surfaces, thorax, id, organs);
            enterStage("done", 1);
            return running;
        } catch (RuntimeException | Error e) {
            simulation.close();
            throw e;
        }
    }

    private void enterStage(String what, double share) {
        if (cancelled) {
            throw new CancellationException();
        }
        listener.loading(what, share);
    }
}
