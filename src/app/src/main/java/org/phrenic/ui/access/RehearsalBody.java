package org.phrenic.ui.access;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.AccessMapField;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;

/**
 * A body on which liver access can be rehearsed.
 *
 * @param scene of the run
 * @param frame one of it
 * @param planningScene the body as maps and paths are read off it, beside the window
 * @param simulatedScene the body as the needle meets it, on the simulation's thread
 */
record RehearsalBody(LiveScene scene, Frame frame, MovingAnatomy planningScene, MovingAnatomy simulatedScene) {
    /** Builds what is needed; takes a while. */
    static RehearsalBody of(LiveScene scene) {
        Frame frame = scene.newFrame().get();
        MovingAnatomy mapped = new MovingAnatomy(scene.surfaces());
        MovingAnatomy lived = new MovingAnatomy(scene.surfaces());
        mapped.update(frame);
        return new RehearsalBody(scene, frame, mapped, lived);
    }

    /**
     * A target and from where it can be reached.
     *
     * @param plan what is rehearsed
     * @param study the target and its map
     * @param colours of the skin
     */
    record StudiedTarget(RehearsalPlan plan, TargetAccess study, AccessMapField colours) {}

    /**
     * Works out from where a target can be reached; takes a while, and leaves a processor to the window. Without an
     * exercise it is practice.
     */
    StudiedTarget studyTarget(
            TargetLesion target, List<BreathMoment> breath, Optional<RehearsalPlan> exercise, Scenario scenario) {
        RehearsalPlan meant = exercise.orElseGet(() -> RehearsalPlan.practice(scenario, target, Needle.standard()));
        try (Workers workers = Workers.of(Math.max(1, Runtime.getRuntime().availableProcessors() - 1))) {
            TargetAccess made =
                    TargetAccess.of(planningScene, breath, target, meant.needle(), meant.avoided(), workers);
            return new StudiedTarget(meant, made, new AccessMapField(scene.surfaces(), made.map()));
        }
    }
}
