package org.phrenic.simulation.live;

import java.util.List;
import java.util.function.Function;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * The scenes that are loaded for a run, one at a time; a scene that is loaded replaces the running one. Thread-safe.
 */
final class SceneLoads {
    private final RequestedSettings settings;
    private final SimulationLoop loop;
    private final LiveRun.Listener listener;
    private SceneLoader loading;
    private long sceneCount;
    private boolean organs;
    private volatile long lastFailed = LiveRun.NO_SCENE;

    SceneLoads(RequestedSettings settings, SimulationLoop loop, LiveRun.Listener listener) {
        this.settings = settings;
        this.loop = loop;
        this.listener = listener;
    }

    /** Loads a scenario. Cancels a load in progress. */
    void load(Scenario scenario) {
        load(requested -> requested.beginLoading(scenario));
    }

    /**
     * Requests changes, and loads a scene with them unless all are live; no other load ends in between, after which the
     * settings would be those of the running scene again.
     *
     * @return whether a scene loads
     */
    synchronized boolean change(List<Assignment> assignments) {
        boolean loads = settings.request(assignments);
        if (loads) {
            loadCurrent();
        }
        return loads;
    }

    /** Loads the settings that are requested at this moment. */
    void loadCurrent() {
        load(RequestedSettings::beginLoading);
    }

    private synchronized void load(Function<RequestedSettings, Scenario> begin) {
        if (loop.closed) {
            return;
        }
        Scenario scenario = begin.apply(settings);
        SceneLoader before = loading;
        if (before != null) {
            before.cancel();
        }
        long id = ++sceneCount;
        loading = new SceneLoader(scenario, id, organs, listener, before, new SceneLoader.Outcome() {
            @Override
            public void loaded(RunningScene made) {
                if (!loop.commands.submit(() -> accept(made))) {
                    made.close();
                }
            }

            @Override
            public void failed(RuntimeException why) {
                loop.commands.submit(() -> fail(id, why));
            }
        });
        loading.start();
    }

    /** Loads this scene and later ones with the further organs of the body; false if the running one has them. */
    synchronized boolean showOrgans() {
        boolean isComing = organs && isLoading();
        organs = true;
        if (!hasOrgans() && !isComing) {
            loadCurrent();
        }
        return !hasOrgans();
    }

    boolean hasOrgans() {
        RunningScene running = loop.running;
        return running != null && running.organs;
    }

    /** Lets a loaded scene run, if it is still wanted; loading has not ended for others before it does. */
    private void accept(RunningScene made) {
        boolean wanted;
        RunningScene former = null;
        synchronized (this) {
            wanted = !loop.closed && isPending(made.scene.id());
            if (wanted) {
                former = loop.take(made);
                loading = null;
            }
        }
        if (wanted) {
            loop.beginScene(former);
        } else {
            made.close();
        }
    }

    private void fail(long id, RuntimeException why) {
        synchronized (this) {
            if (!isPending(id)) {
                return;
            }
            loading = null;
            settings.endLoading();
            lastFailed = id;
        }
        loop.reportFailure(why);
    }

    private boolean isPending(long id) {
        return loading != null && loading.id() == id && !loading.isCancelled();
    }

    synchronized long newestSceneId() {
        return sceneCount;
    }

    long lastFailedSceneId() {
        return lastFailed;
    }

    synchronized boolean isLoading() {
        return loading != null && !loading.isCancelled();
    }

    /** Cancels a load in progress beside a scene, and restores the settings of that; false if there is none. */
    boolean cancel() {
        synchronized (this) {
            if (!isLoading() || loop.running == null) {
                return false;
            }
            loading.cancel();
            settings.endLoading();
        }
        loop.commands.submit(() -> {
            loop.synchronizeSettings();
            loop.notifyListener();
        });
        return true;
    }

    /** Ends the run for new scenes, and waits until loading has ended. */
    void close() throws InterruptedException {
        SceneLoader last;
        synchronized (this) {
            loop.closed = true;
            last = loading;
            if (last != null) {
                last.cancel();
            }
        }
        loop.commands.wake();
        if (last != null) {
            last.join();
        }
    }
}
