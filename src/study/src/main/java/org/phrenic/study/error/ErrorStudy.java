package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * Speed against error of one scene: each setting carries the same breath from the same start, and the places of the
 * nodes, ten times a second, are held against a reference.
 *
 * @param scenario what breathed
 * @param nodes how many springs move
 * @param simulatedS simulated time, s
 * @param excursionMm how far the domes went down, mean of both, mm
 * @param reference setting of the reference
 * @param referenceUncertainty distance, rms and greatest, mm, of the reference from itself with steps twice as long: of
 *     the diaphragm's nodes, then of all
 * @param points one a setting
 * @param equilibrium how far the reference is from equilibrium at a few phases; empty for the paper's material and a
 *     quick study
 * @param skipped settings that were not run, each with the reason
 */
public record ErrorStudy(
        Scenario scenario,
        int nodes,
        double simulatedS,
        double excursionMm,
        SolverSettings reference,
        double[] referenceUncertainty,
        List<ErrorPoint> points,
        List<EquilibriumLag> equilibrium,
        List<String> skipped) {
    /** Of a quick study, s: enough for the sheet to move. */
    private static final double QUICK_S = 0.2;

    /** Force evaluations that one simulated second may cost: beyond, a setting is no choice. */
    private static final double MAX_EVALUATIONS_PER_S = 20_000;

    /** Beyond, one setting of sweeps and refresh must do. */
    private static final double COSTLY_EVALUATIONS_PER_S = 5_000;

    /** What one solve of backward Euler is worth, in force evaluations, at the steps it is there for. */
    private static final double EVALUATIONS_PER_SOLVE = 150;

    public ErrorStudy {
        points = List.copyOf(points);
        equilibrium = List.copyOf(equilibrium);
        skipped = List.copyOf(skipped);
    }

    /**
     * Measures.
     *
     * @param scenario material, body, resolution, breathing and threads
     * @param grid settings to measure besides the scenario's own
     * @param quick whether a part of a breath will do
     */
    public static ErrorStudy of(Scenario scenario, SolverGrid grid, boolean quick, ProgressListener progress) {
        Thorax thorax = SimulationRun.loadThorax(scenario);
        double periodS = scenario.breathing().pattern().periodS();
        double breathS = quick
                ? QUICK_S
                : Double.isInfinite(periodS) ? scenario.breathing().pattern().fullDurationS() : periodS;
        try (BreathRunner runs = new BreathRunner(scenario, thorax, breathS)) {
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
            SolverSettings reference = SolverGrid.reference(SolverGrid.referenceStepS(scenario.material()));
            Trajectory coarse = runs.run(SolverGrid.reference(2 * reference.timeStepS()));
            progress.done(
                    1,
                    total,
                    "reference, "
                            + SolverGrid.reference(2 * reference.timeStepS()).label());
            Trajectory exact = runs.run(reference);
            progress.done(2, total, "reference, " + reference.label());
            boolean[] sheet = runs.diaphragmNodes();
            double[] apart = coarse.distanceFrom(exact, sheet);
            double[] allApart = coarse.distanceFrom(exact);
            double[] proof = {apart[0], apart[1], allApart[0], allApart[1]};
            List<ErrorPoint> points = new ArrayList<>();
            for (SolverSettings settings : wanted) {
                try {
                    points.add(point(runs.run(settings), exact, sheet, settings, runs.durationS(), scenario));
                } catch (DivergenceException | IllegalArgumentException gone) {
                    leftOut.add(settings.label() + ": " + gone.getMessage());
                }
                progress.done(points.size() + 2, total, settings.label());
            }
            List<EquilibriumLag> equilibrium = scenario.material() == Materials.PHYSICAL && !quick
                    ? EquilibriumLag.of(runs, exact, SolverSettings.of(scenario))
                    : List.of();
            return new ErrorStudy(
                    scenario,
                    runs.nodes(),
                    runs.durationS(),
                    runs.excursionMm(exact),
                    reference,
                    proof,
                    withParetoFront(points),
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
        double[] distance = run.distanceFrom(exact, sheet);
        double[] all = run.distanceFrom(exact);
        return new ErrorPoint(
                settings,
                run.substeps(),
                distance[0],
                distance[1],
                all[0],
                all[1],
                run.cpuS(),
                run.wallS(),
                untilS / run.wallS(),
                false,
                settings.equals(SolverSettings.of(scenario)));
    }

    /** Why a setting is not run; empty if another of its scheme and step shows it, null if it is run. */
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
            return String.format(
                    Locale.ROOT, "some %.0f force evaluations a simulated second, more than any use is worth", cost);
        }
        boolean finest = settings.sweeps() == Collections.max(grid.sweeps())
                && settings.refreshS() == Collections.min(grid.refreshesS());
        if (cost > COSTLY_EVALUATIONS_PER_S && !finest) {
            return "";
        }
        boolean shorterThere = grid.timeStepsS().stream().anyMatch(step -> step < settings.timeStepS());
        return substeps > 1 && shorterThere && !isShortestAffordable(runs, settings, grid)
                ? "is split into " + substeps + " substeps, which a shorter step is"
                : null;
    }

    /** Whether a split step is the only one of its scheme that can be afforded, so that the scheme is seen at all. */
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

    private static List<ErrorPoint> withParetoFront(List<ErrorPoint> points) {
        boolean[] front = ParetoFront.of(
                points.stream().mapToDouble(ErrorPoint::cpuS).toArray(),
                points.stream().mapToDouble(ErrorPoint::rmsMm).toArray());
        List<ErrorPoint> marked = new ArrayList<>();
        for (int i = 0; i < front.length; i++) {
            marked.add(points.get(i).withParetoOptimal(front[i]));
        }
        return marked;
    }

    /** What coarser meshes change, with each resolution's own settings. */
    public static List<MeshRefinementError> meshes(Scenario scenario, ProgressListener progress) {
        List<Scenario> all = Arrays.stream(Resolution.values())
                .map(r -> scenario.with("resolution=" + r.name().toLowerCase(Locale.ROOT)))
                .toList();
        return MeshRefinementError.of(all, scenario.breathing().pattern().periodS(), progress);
    }

    /** Per cent of the excursion. */
    public double percent(double mm) {
        return 100 * mm / excursionMm;
    }
}
