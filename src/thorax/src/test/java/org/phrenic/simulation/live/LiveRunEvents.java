package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** Keeps the events of a run, for a test that waits for them. */
abstract class LiveRunEvents implements LiveRun.Listener {
    static final long PATIENCE_S = 120;

    final BlockingQueue<LiveScene> scenes = new LinkedBlockingQueue<>();
    final BlockingQueue<String> failures = new LinkedBlockingQueue<>();
    final BlockingQueue<String> divergences = new LinkedBlockingQueue<>();
    final BlockingQueue<Set<String>> undone = new LinkedBlockingQueue<>();
    final List<String> stages = Collections.synchronizedList(new ArrayList<>());
    final BlockingQueue<LiveScene> bodies = new LinkedBlockingQueue<>();

    static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
        T found = queue.poll(PATIENCE_S, TimeUnit.SECONDS);
        assertThat(found).as("nothing came in %d s", PATIENCE_S).isNotNull();
        return found;
    }

    @Override
    public void loading(String what, double share) {
        stages.add(what);
    }

    @Override
    public void body(LiveScene atRest) {
        bodies.add(atRest);
    }

    @Override
    public void ready(LiveScene scene) {
        scenes.add(scene);
    }

    @Override
    public void failed(String sentence) {
        failures.add(sentence);
    }

    @Override
    public void diverged(String sentence) {
        divergences.add(sentence);
    }

    @Override
    public void restored(Set<String> keys) {
        undone.add(keys);
    }

    @Override
    public void changed() {
        // Nothing is shown.
    }
}
