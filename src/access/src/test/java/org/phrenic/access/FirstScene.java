package org.phrenic.access;

import java.util.concurrent.CompletableFuture;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;

/** Hands on the first scene of a run, or why there is none. */
public record FirstScene(CompletableFuture<LiveScene> scene) implements LiveRun.Listener {
    @Override
    public void loading(String what, double share) {}

    @Override
    public void ready(LiveScene ready) {
        scene.complete(ready);
    }

    @Override
    public void failed(String sentence) {
        scene.completeExceptionally(new IllegalStateException(sentence));
    }

    @Override
    public void diverged(String sentence) {
        failed(sentence);
    }

    @Override
    public void changed() {}
}
