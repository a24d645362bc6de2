package org.phrenic.ui.access;

import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.scene.camera.PickResult;

/**
 * What is rehearsed and for which target: that of an exercise, or one of the user's own. Where a target lies is worked
 * out beside the window.
 */
final class TargetSelection {
    private static final double DEPTH_BELOW_SURFACE_MM = 35;
    private static final double DEFAULT_DIAMETER_MM = 20;
    private static final long SEED = 1;

    private double diameterMm = DEFAULT_DIAMETER_MM;
    private Optional<RehearsalPlan> exercise = Optional.empty();
    private Optional<RehearsalPlan> plan = Optional.empty();
    private Optional<TargetAccess> study = Optional.empty();

    /** The target of the exercise, the one at hand, or one at random. */
    Callable<TargetLesion> current(RehearsalBody body) {
        Optional<RehearsalPlan> asked = exercise;
        Optional<TargetLesion> before = study.map(TargetAccess::target);
        double size = diameterMm;
        return () -> asked.isPresent()
                ? asked.get().target(body.planningScene())
                : before.orElseGet(() -> TargetLesion.random(body.planningScene(), SEED, size));
    }

    /** A target behind a place of the liver. */
    Callable<TargetLesion> belowSurface(RehearsalBody body, PickResult pick) {
        double size = diameterMm;
        return () -> TargetLesion.behindSurface(
                body.planningScene(), pick.restPosition(), pick.rayDirection(), DEPTH_BELOW_SURFACE_MM, size);
    }

    /** The target at hand in the present size. */
    Callable<TargetLesion> resized(RehearsalBody body) {
        double[] at = study.orElseThrow().target().restMm();
        double size = diameterMm;
        return () -> TargetLesion.at(body.planningScene(), at, size);
    }

    /** Diameter of the next target of the user's own. */
    void setDiameterMm(double mm) {
        diameterMm = mm;
    }

    /** From now on an exercise, or none. */
    void setExercise(Optional<RehearsalPlan> other) {
        exercise = other;
    }

    /** A target was studied. */
    void setStudied(RehearsalBody.StudiedTarget made) {
        plan = Optional.of(made.plan());
        study = Optional.of(made.study());
    }

    /** The target at hand counts no more. */
    void clear() {
        study = Optional.empty();
    }

    Optional<RehearsalPlan> exercise() {
        return exercise;
    }

    /** What is rehearsed, exercise or practice. */
    Optional<RehearsalPlan> plan() {
        return plan;
    }

    Optional<TargetAccess> study() {
        return study;
    }
}
