package org.phrenic.study.access;

import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.engine.math.OrderStatistic;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.simulation.SimulationRun;

/** Plays exercises as shipped, tries the free ways of their access maps by brute force, and times the maps. */
public final class AccessStudy {
    private static final int POINTS = 2000;
    private static final double NANO = 1e-9;

    private AccessStudy() {}

    /**
     * What came of one exercise.
     *
     * @param check free ways against every triangle
     * @param mapS time of the access map, for {@value AccessStudy#POINTS} points in reach, s: median of the maps that
     *     were timed; NaN if none was, or if no point is in reach
     */
    public record Result(Rehearsal rehearsal, WayCheck check, double mapS) {}

    /**
     * Plays a plan.
     *
     * @param maps number of maps that are timed, 0 for none
     * @throws org.phrenic.file.BadInputException if the plan cannot be played
     */
    public static Result of(RehearsalPlan plan, int maps, SimulationRun.Progress progress) {
        Rehearsal rehearsal = Rehearsal.play(plan, progress);
        WayCheck check = WayCheck.of(rehearsal.surfaces(), rehearsal.map());
        progress.note(plan.title() + ": played, and its free ways are tried.");
        boolean isTimed = maps > 0 && rehearsal.map().counts().inReach() > 0;
        return new Result(rehearsal, check, isTimed ? mapS(rehearsal, maps) : Double.NaN);
    }

    private static double mapS(Rehearsal rehearsal, int maps) {
        RehearsalPlan plan = rehearsal.plan();
        MovingAnatomy anatomy = new MovingAnatomy(rehearsal.surfaces());
        double[] seconds = new double[maps];
        try (Workers workers = Workers.of(plan.scenario().threads())) {
            for (int i = 0; i < maps; i++) {
                anatomy.update(rehearsal.map().cycle().get(0).frame());
                long begun = System.nanoTime();
                AccessMap map = AccessMap.of(
                        anatomy, rehearsal.map().cycle(), rehearsal.target(), plan.needle(), plan.avoided(), workers);
                seconds[i] = NANO
                        * (System.nanoTime() - begun)
                        * POINTS
                        / map.counts().inReach();
            }
        }
        return OrderStatistic.median(seconds);
    }
}
