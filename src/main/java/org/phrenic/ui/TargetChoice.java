package org.phrenic.ui;

import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.Target;
import org.phrenic.rehearsal.TargetStudy;
import org.phrenic.scene.Pick;

/** What is rehearsed and for which target: that of an exercise, or one of the user's own. Where a target lies is worked out beside the window. */
final class TargetChoice {
    private static final double BEHIND_MM = 35;
    private static final double USUAL_MM = 20;
    private static final long SEED = 1;

    private double diameterMm = USUAL_MM;
    private Optional<RehearsalPlan> exercise = Optional.empty();
    private Optional<RehearsalPlan> plan = Optional.empty();
    private Optional<TargetStudy> study = Optional.empty();

    /** The target of the exercise, the one at hand, or one at random. */
    Callable<Target> usual(RehearsedBody body) {
        Optional<RehearsalPlan> asked = exercise;
        Optional<Target> before = study.map(TargetStudy::target);
        double size = diameterMm;
        return () -> asked.isPresent()
                ? asked.get().target(body.mapped())
                : before.orElseGet(() -> Target.random(body.mapped(), SEED, size));
    }

    /** A target behind a place of the liver. */
    Callable<Target> behind(RehearsedBody body, Pick pick) {
        double size = diameterMm;
        return () -> Target.behind(body.mapped(), pick.rest(), pick.sight(), BEHIND_MM, size);
    }

    /** The target at hand in the present size. */
    Callable<Target> resized(RehearsedBody body) {
        double[] at = study.orElseThrow().target().restMm();
        double size = diameterMm;
        return () -> Target.at(body.mapped(), at, size);
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
    void take(RehearsedBody.Studied made) {
        plan = Optional.of(made.plan());
        study = Optional.of(made.study());
    }

    /** The target at hand counts no more. */
    void forget() {
        study = Optional.empty();
    }

    Optional<RehearsalPlan> exercise() {
        return exercise;
    }

    /** What is rehearsed, exercise or practice. */
    Optional<RehearsalPlan> plan() {
        return plan;
    }

    Optional<TargetStudy> study() {
        return study;
    }
}
