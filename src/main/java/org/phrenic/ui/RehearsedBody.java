package org.phrenic.ui;

import java.util.List;
import java.util.Optional;
import org.phrenic.engine.Workers;
import org.phrenic.rehearsal.BreathMoment;
import org.phrenic.rehearsal.MovingScene;
import org.phrenic.rehearsal.Needle;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.Target;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.scene.AccessField;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.LiveScene;

/**
 * A body on which liver access can be rehearsed.
 *
 * @param scene of the run
 * @param frame one of it
 * @param mapped the body as maps and paths are read off it, beside the window
 * @param lived the body as the needle meets it, on the simulation's thread
 */
record RehearsedBody(LiveScene scene, Frame frame, MovingScene mapped, MovingScene lived) {
    /** Builds what is needed; takes a while. */
    static RehearsedBody of(LiveScene scene) {
        Frame frame = scene.newFrame().get();
        MovingScene mapped = new MovingScene(scene.surfaces());
        MovingScene lived = new MovingScene(scene.surfaces());
        mapped.take(frame);
        return new RehearsedBody(scene, frame, mapped, lived);
    }

    /**
     * A target and from where it can be reached.
     *
     * @param plan what is rehearsed
     * @param study the target and its map
     * @param colours of the skin
     */
    record Studied(RehearsalPlan plan, TargetStudy study, AccessField colours) {}

    /** Works out from where a target can be reached; takes a while, and leaves a processor to the window. Without an exercise it is practice. */
    Studied study(Target target, List<BreathMoment> breath, Optional<RehearsalPlan> exercise, Scenario scenario) {
        RehearsalPlan meant = exercise.orElseGet(() -> RehearsalPlan.practice(scenario, target, Needle.usual()));
        try (Workers workers = Workers.of(Math.max(1, Runtime.getRuntime().availableProcessors() - 1))) {
            TargetStudy made = TargetStudy.of(mapped, breath, target, meant.needle(), meant.avoided(), workers);
            return new Studied(meant, made, new AccessField(scene.surfaces(), made.map()));
        }
    }
}
