package org.phrenic.ui.access;

import java.util.List;
import java.util.Optional;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.ScannedLesion;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.ultrasound.ScannedSkin;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.AccessMapField;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;

/**
 * A body on which liver access can be rehearsed.
 *
 * @param frame of the scene, at rest
 * @param skin on which probe and needle are put
 * @param planningScene the body for maps and paths, in the background
 * @param simulatedScene the body for the needle, on the simulation's thread
 * @param lesions lesions of the liver that the body shows, the largest first
 */
record RehearsalBody(
        LiveScene scene,
        Frame frame,
        ScannedSkin skin,
        MovingAnatomy planningScene,
        MovingAnatomy simulatedScene,
        List<ScannedLesion> lesions) {
    /** Builds the search structures; takes a while. */
    static RehearsalBody of(LiveScene scene) {
        Frame frame = scene.newFrame().get();
        MovingAnatomy planning = new MovingAnatomy(scene.surfaces());
        MovingAnatomy simulated = new MovingAnatomy(scene.surfaces());
        planning.update(frame);
        return new RehearsalBody(
                scene, frame, new ScannedSkin(scene.surfaces()), planning, simulated, ScannedLesion.of(planning));
    }

    /** Its surfaces, and what of them is not in its scan. */
    BodySurfaces surfaces() {
        return new BodySurfaces(scene.surfaces(), scene.body());
    }

    /** The body at the moments of the breathing, so many of each breath. */
    record Recorded(List<BreathMoment> moments, int phases) {
        static final Recorded NONE = new Recorded(List.of(), 0);
    }

    /** A target, its access map and the colours of the map on the skin. */
    record StudiedTarget(RehearsalPlan plan, TargetAccess study, AccessMapField colours) {}

    /** Computes the access map of a target; takes a while, and leaves a processor to the window. */
    StudiedTarget studyTarget(
            TargetLesion target, Recorded breath, Optional<RehearsalPlan> exercise, Scenario scenario) {
        RehearsalPlan meant =
                exercise.orElseGet(() -> RehearsalPlan.practice(scenario, target, Needle.standard(), breath.phases()));
        try (Workers workers = Workers.of(Math.max(1, Runtime.getRuntime().availableProcessors() - 1))) {
            TargetAccess study =
                    TargetAccess.of(planningScene, breath.moments(), target, meant.needle(), meant.avoided(), workers);
            return new StudiedTarget(meant, study, new AccessMapField(scene.surfaces(), study.map()));
        }
    }
}
