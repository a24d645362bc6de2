package org.phrenic.rehearsal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.format.Json;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;

/** An attempt on a run that is played on a thread of its own, as a window does it. */
class LiveAttemptTest {
    private static final long PATIENCE_S = 120;
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    @TempDir
    Path folder;

    @Test
    void theSameAttemptGivesTheSameRecordLiveAndHeadless() throws Exception {
        RehearsalPlan plan = plan();
        Rehearsal headless = Rehearsal.play(plan, (at, total, perS) -> {});
        CompletableFuture<AttemptRecord> live = new CompletableFuture<>();
        CompletableFuture<LiveScene> loaded = new CompletableFuture<>();
        try (LiveRun run = new LiveRun(plan.scenario(), new Listener(loaded))) {
            MovingScene scene =
                    new MovingScene(loaded.get(PATIENCE_S, TimeUnit.SECONDS).surfaces());
            NeedleSession needle = new NeedleSession(scene, headless.target(), plan.needle(), plan.avoided());
            PlanPlayer player = new PlanPlayer(plan, needle, headless.map(), (held, origin) -> {});
            run.watch(Rehearsal.LOOK_EVERY_S, (frame, label) -> {
                if (!live.isDone()) {
                    needle.take(frame, label);
                    if (player.look(label, 1 + (int) frame.values()[BREATH])) {
                        live.complete(needle.record());
                    }
                }
            });
            run.setSpeed(Double.POSITIVE_INFINITY);
            run.play();
            assertThat(Json.format(live.get(PATIENCE_S, TimeUnit.SECONDS).toMap()))
                    .isEqualTo(Json.format(headless.record().toMap()));
        }
        assertThat(headless.record().events()).isNotEmpty();
    }

    private RehearsalPlan plan() throws IOException {
        return RehearsalPlan.read(
                Files.writeString(
                        folder.resolve("plan.yaml"),
                        "set: {preset: rapid-shallow, resolution: low, lungs: embedded, sternum: kinematic}\nphases: 2\n"
                                + "target: {rest_mm: [-90, 0, 50], diameter_mm: 20}\n"
                                + "steps:\n  - wait: end-inspiration of breath 1\n"
                                + "  - place: {entry: [-38.9, -121.2, 26.6], aim: target}\n"
                                + "  - advance: {speed_mm_per_s: 120}\n  - sample: now\n  - withdraw: {speed_mm_per_s: 300}\n"));
    }

    /** Hands on the first scene and that it failed. */
    private record Listener(CompletableFuture<LiveScene> scene) implements LiveRun.Listener {
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
}
