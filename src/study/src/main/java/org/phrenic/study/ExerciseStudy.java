package org.phrenic.study;

import java.util.Arrays;
import java.util.List;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RobotOperator;
import org.phrenic.document.OrderedValues;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.RunSettings;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** How hard exercises are: a {@link RobotOperator} does each many times, breathing freely and with a held breath. */
public final class ExerciseStudy {
    /** Moments of the recorded breath. */
    private static final int MOMENTS = 60;

    private ExerciseStudy() {}

    /**
     * What came of the attempts on one exercise.
     *
     * @param body the body of its scenario
     * @param targetMm diameter of the target, mm
     * @param hitShare share of attempts with a hit, 0 to 1
     * @param medianMm median distance of the sample from the middle of the target, mm
     */
    public record Result(
            String exercise,
            String body,
            double targetMm,
            boolean held,
            int attempts,
            double hitShare,
            double medianMm) {
        public OrderedValues toMap() {
            return new OrderedValues()
                    .with("exercise", exercise)
                    .with("body", body)
                    .with("target_mm", targetMm)
                    .with("breath", held ? "held" : "free")
                    .with("attempts", attempts)
                    .with("hit_share", hitShare)
                    .with("median_error_mm", medianMm);
        }
    }

    /**
     * Does an exercise.
     *
     * @param attempts number of attempts in either way of breathing, more than 0
     * @return the results in free and in held breath
     * @throws BadInputException if no path to its target is free at end-expiration
     */
    public static List<Result> of(
            RehearsalPlan plan, RobotOperator.Hand hand, int attempts, SimulationRun.Progress progress) {
        try (Simulation simulation = Simulation.of(plan.scenario(), SimulationRun.loadThorax(plan.scenario()));
                Workers workers = Workers.of(plan.scenario().threads())) {
            SceneSurfaces surfaces = SceneSurfaces.withOrgans(simulation);
            MovingAnatomy anatomy = new MovingAnatomy(surfaces.surfaces());
            anatomy.update(surfaces.newFrame());
            List<BreathMoment> cycle = BreathCycle.record(simulation, surfaces, MOMENTS);
            TargetAccess access =
                    TargetAccess.of(anatomy, cycle, plan.target(anatomy), plan.needle(), plan.avoided(), workers);
            AccessMap map = access.map();
            double[] entry = map.bestAt(0, AccessMap.SUFFICIENT_MARGIN_MM)
                    .map(map::pointAtRest)
                    .orElseThrow(() -> new BadInputException(
                            plan.file() + ": found no path to the target free at end-expiration, expected one"));
            progress.note(plan.title() + ": breath and access map are there.");
            return List.of(
                    run(new RobotOperator(plan, anatomy, access, entry, hand, false), plan, access, false, attempts),
                    run(new RobotOperator(plan, anatomy, access, entry, hand, true), plan, access, true, attempts));
        }
    }

    private static Result run(
            RobotOperator robot, RehearsalPlan plan, TargetAccess access, boolean held, int attempts) {
        double[] mm = new double[attempts];
        int hits = 0;
        for (int i = 0; i < attempts; i++) {
            AttemptRecord record = robot.attempt(i + 1);
            hits += record.hit() ? 1 : 0;
            mm[i] = record.samples().get(0).distanceMm();
        }
        Arrays.sort(mm);
        double median = 0.5 * (mm[(attempts - 1) / 2] + mm[attempts / 2]);
        return new Result(
                plan.title(),
                RunSettings.bodyLabel(plan.scenario().anatomy()),
                access.target().diameterMm(),
                held,
                attempts,
                (double) hits / attempts,
                median);
    }
}
