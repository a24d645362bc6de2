package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * Cost against error of one scene. Every solver setting simulates the same breath from the same start, and its node
 * positions, sampled ten times a second, are compared with a reference solution.
 *
 * @param scenario simulated scenario
 * @param nodes number of nodes moved by springs
 * @param simulatedS simulated time, s
 * @param excursionsMm descent of the domes, mean of both sides, in the reference and with each of the points' settings,
 *     mm
 * @param reference settings of the reference solution
 * @param referenceUncertainty distance between the reference and the same solution with twice the time step, mm: rms
 *     and maximum of the diaphragm's nodes, then rms and maximum of all nodes
 * @param points one per setting
 * @param equilibrium distance of the reference from equilibrium at several phases; empty for the paper's material and
 *     for a quick study
 * @param skipped settings that were not run, each with the reason
 */
public record ErrorStudy(
        Scenario scenario,
        int nodes,
        double simulatedS,
        Map<SolverSettings, Double> excursionsMm,
        SolverSettings reference,
        double[] referenceUncertainty,
        List<ErrorPoint> points,
        List<EquilibriumLag> equilibrium,
        List<String> skipped) {
    /** Least ratio of an error to the uncertainty of what it is measured against. */
    static final double RESOLVED = 3;

    /** Simulated time of a quick study, s: enough for the sheet to move. */
    private static final double QUICK_S = 0.2;

    /** Time from the start within which each setting's error is also stated, s; it is cheap to measure again. */
    static final double START_S = 0.2;

    /** Maximum number of force evaluations per simulated second; settings that need more are skipped. */
    private static final double MAX_EVALUATIONS_PER_S = 20_000;

    /** Above this cost only one combination of sweeps and refresh interval is measured. */
    private static final double COSTLY_EVALUATIONS_PER_S = 5_000;

    /** Cost of one backward Euler solve in force evaluations, at the time steps for which the scheme is used. */
    private static final double EVALUATIONS_PER_SOLVE = 150;

    public ErrorStudy {
        points = List.copyOf(points);
        excursionsMm = Map.copyOf(excursionsMm);
        equilibrium = List.copyOf(equilibrium);
        skipped = List.copyOf(skipped);
    }

    /**
     * Runs the study.
     *
     * @param scenario material, body, resolution, breathing and threads
     * @param grid settings to measure besides the scenario's own
     * @param quick whether to simulate only part of a breath
     */
    public static ErrorStudy of(Scenario scenario, SolverGrid grid, boolean quick, ProgressListener progress) {
        return of(scenario, grid, quick ? QUICK_S : breathS(scenario), !quick, progress);
    }

    /** Time of a whole breath, s. */
    public static double breathS(Scenario scenario) {
        double periodS = scenario.breathing().pattern().periodS();
        return Double.isInfinite(periodS) ? scenario.breathing().pattern().fullDurationS() : periodS;
    }

    /**
     * Runs the study for a part of a breath.
     *
     * @param untilS simulated time, s
     * @param lag whether to measure the distance from equilibrium too, in the physical material
     */
    public static ErrorStudy of(
            Scenario scenario, SolverGrid grid, double untilS, boolean lag, ProgressListener progress) {
        Thorax thorax = SimulationRun.loadThorax(scenario);
        try (BreathRunner runs = new BreathRunner(scenario, thorax, untilS)) {
            List<SolverSettings> wanted = new ArrayList<>();
            List<String> leftOut = new ArrayList<>();
            for (SolverSettings settings : grid.settings(scenario)) {
                String reason = reasonToSkip(runs, settings, grid);
                if (reason == null) {
                    wanted.add(settings);
                } else if (!reason.isEmpty()) {
                    leftOut.add(settings.label() + ": " + reason);
                }
            }
            int total = wanted.size() + 2;
            SolverSettings reference = SolverGrid.reference(scenario, 1);
            SolverSettings coarser = SolverGrid.reference(scenario, 2);
            Trajectory coarse = runs.run(coarser);
            progress.done(1, total, "reference, " + coarser.label());
            Trajectory exact = runs.run(reference);
            progress.done(2, total, "reference, " + reference.label());
            boolean[] sheet = runs.diaphragmNodes();
            double[] apart = coarse.distanceFrom(exact, sheet);
            double[] allApart = coarse.distanceFrom(exact);
            double[] proof = {apart[0], apart[1], allApart[0], allApart[1]};
            List<ErrorPoint> points = new ArrayList<>();
            Map<SolverSettings, Double> excursionsMm = new HashMap<>();
            int measured = 2;
            for (SolverSettings settings : wanted) {
                try {
                    Trajectory run = runs.run(settings);
                    points.add(point(run, exact, sheet, settings, runs.durationS(), scenario));
                    excursionsMm.put(settings, runs.excursionMm(run));
                } catch (DivergenceException | IllegalArgumentException gone) {
                    leftOut.add(settings.label() + ": " + gone.getMessage());
                }
                progress.done(++measured, total, settings.label());
            }
            List<EquilibriumLag> equilibrium = scenario.material() == Materials.PHYSICAL && lag
                    ? EquilibriumLag.of(runs, exact, SolverSettings.of(scenario), EquilibriumLag.phases())
                    : List.of();
            excursionsMm.put(reference, runs.excursionMm(exact));
            List<ErrorPoint> marked = withParetoFront(points, RESOLVED * proof[0]);
            return new ErrorStudy(
                    scenario,
                    runs.nodes(),
                    runs.durationS(),
                    excursionsMm,
                    reference,
                    proof,
                    marked,
                    equilibrium,
                    leftOut);
        }
    }

    private static ErrorPoint point(
            Trajectory run,
            Trajectory exact,
            boolean[] sheet,
            SolverSettings settings,
            double untilS,
            Scenario scenario) {
        double[] d = run.distanceFrom(exact, sheet);
        double[] all = run.distanceFrom(exact);
        boolean own = settings.equals(SolverSettings.of(scenario));
        double speed = untilS / (scenario.threads() == 1 ? run.cpuS() : run.wallS());
        double start = run.until(START_S).distanceFrom(exact.until(START_S), sheet)[0];
        return new ErrorPoint(
                settings,
                run.substeps(),
                d[0],
                d[1],
                all[0],
                all[1],
                start,
                run.cpuS(),
                run.wallS(),
                speed,
                false,
                own);
    }

    /** Reason to skip a setting: null if it is run, empty if another setting of its scheme and step represents it. */
    private static String reasonToSkip(BreathRunner runs, SolverSettings settings, SolverGrid grid) {
        int substeps = runs.substeps(settings);
        if (substeps == Integer.MAX_VALUE) {
            return "grows at every step";
        }
        boolean implicit = settings.integrator() == IntegratorKind.BACKWARD_EULER;
        double cost = substeps
                / settings.timeStepS()
                * (implicit ? EVALUATIONS_PER_SOLVE : settings.integrator().forceEvaluations());
        if (cost > MAX_EVALUATIONS_PER_S) {
            return format("some %.0f force evaluations a simulated second, more than any use is worth", cost);
        }
        boolean finest = !grid.isCrossed()
                || (settings.sweeps() == Collections.max(grid.sweeps())
                        && settings.refreshS() == Collections.min(grid.refreshesS()));
        if (cost > COSTLY_EVALUATIONS_PER_S && !finest) {
            return "";
        }
        boolean shorterThere = grid.timeStepsS().stream().anyMatch(step -> step < settings.timeStepS());
        return substeps > 1 && shorterThere && !isShortestAffordable(runs, settings, grid)
                ? "is split into " + substeps + " substeps, which a shorter step is"
                : null;
    }

    /** Whether every shorter step of the scheme is too costly. The split step is then run to represent the scheme. */
    private static boolean isShortestAffordable(BreathRunner runs, SolverSettings settings, SolverGrid grid) {
        return grid.timeStepsS().stream()
                .filter(step -> step < settings.timeStepS())
                .noneMatch(step -> {
                    SolverSettings shorter =
                            new SolverSettings(settings.integrator(), step, settings.sweeps(), settings.refreshS());
                    double substeps = runs.substeps(shorter);
                    return substeps / step * settings.integrator().forceEvaluations() <= MAX_EVALUATIONS_PER_S;
                });
    }

    /**
     * Marks the points of the Pareto front whose error is at least {@code leastMm}. A smaller error is not resolved: it
     * has no mark itself, and points that cost more have none beside it.
     */
    static List<ErrorPoint> withParetoFront(List<ErrorPoint> points, double leastMm) {
        boolean[] front = ParetoFront.of(
                points.stream().mapToDouble(ErrorPoint::cpuS).toArray(),
                points.stream().mapToDouble(ErrorPoint::rmsMm).toArray());
        List<ErrorPoint> marked = new ArrayList<>();
        for (int i = 0; i < front.length; i++) {
            ErrorPoint point = points.get(i);
            marked.add(point.withParetoOptimal(front[i] && point.rmsMm() >= leastMm));
        }
        return marked;
    }

    /**
     * Whether the reference is known well enough to measure this error: the error is at least three times the distance
     * between the reference and the same with twice the step. A setting whose error is not resolved is never on the
     * front.
     */
    public boolean isResolved(ErrorPoint point) {
        return point.rmsMm() >= RESOLVED * referenceUncertainty[0];
    }

    /** Mesh refinement errors, each resolution simulated with its own settings. */
    public static List<MeshRefinementError> meshes(Scenario scenario, ProgressListener progress) {
        List<Scenario> all = Arrays.stream(Resolution.values())
                .map(r -> scenario.with("resolution=" + r.name().toLowerCase(Locale.ROOT)))
                .toList();
        return MeshRefinementError.of(all, breathS(scenario), progress);
    }

    /** Descent of the domes in the reference, mean of both sides, mm. */
    public double excursionMm() {
        return excursionsMm.get(reference);
    }

    /** A distance in per cent of the excursion of the reference. */
    public double percent(double mm) {
        return 100 * mm / excursionMm();
    }
}
