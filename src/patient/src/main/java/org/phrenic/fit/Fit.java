package org.phrenic.fit;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.file.BadInputException;
import org.phrenic.fit.search.Evaluation;
import org.phrenic.fit.search.FitJournal;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.fit.search.LinearShapeModel;
import org.phrenic.fit.search.SearchSpace;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Observation;

/**
 * Fits the parameters of a body to a second breath level. The surfaces at the end of a held inspiration should match
 * the target surfaces. {@link FitSearch} minimises the mean symmetric distance within the bounds of the parameters.
 *
 * <p>The same setup gives the same result for any number of threads, also if the fit is interrupted and resumed from
 * its journal. The exception is a search that is ended by a time limit.
 */
public final class Fit {
    private static final double SENSITIVITY_STEP = 0.05;

    private final FitSetup setup;
    private final int threads;
    private final FitProgress progress;
    private final BlockingQueue<FitObjective> objectives;
    private final AtomicLong cpuNs = new AtomicLong();
    private final AtomicInteger evaluations = new AtomicInteger();

    private Fit(FitSetup setup, FitProgress progress) {
        this.setup = setup;
        this.progress = progress;
        threads = setup.options().threads();
        objectives = new ArrayBlockingQueue<>(threads);
    }

    /**
     * Runs a fit.
     *
     * @param journal file that stores every evaluation; an interrupted fit resumes from it
     * @throws BadInputException if the body lacks the part of a target, or its lungs cannot carry landmarks
     * @throws org.phrenic.fit.search.ForeignJournalException if the journal belongs to another fit or build of the
     *     program
     */
    public static FitResult run(FitSetup setup, Path journal, FitProgress progress) {
        return new Fit(setup, progress)
                .run(new FitJournal(journal, setup.fingerprint(), FitSetup.PROGRAM, setup.parameters()));
    }

    private FitResult run(FitJournal journal) {
        long begun = System.nanoTime();
        try {
            objectives.addAll(parallel(
                    IntStream.range(0, threads).mapToObj(i -> (Supplier<FitObjective>) () -> new FitObjective(setup))));
            FitObjective first = objectives.peek();
            if (setup.options().landmarks().isPresent()) {
                Landmarks.requireLungs(first.breath().surfaces().surfaces());
            }
            double initial = first.initialMm();
            FitSearch.Settings settings = setup.options().search();
            FitSearch.Result found = new FitSearch(
                            setup.parameters(),
                            journal,
                            settings,
                            threads,
                            this::evaluate,
                            (count, best) -> progress.evaluated(count, settings.maxEvaluations(), best, initial))
                    .run(initial, first.hasGradient() ? this::candidates : null);
            return result(first, initial, found, begun);
        } finally {
            objectives.forEach(FitObjective::close);
        }
    }

    private <T> List<T> parallel(Stream<Supplier<T>> jobs) {
        return BatchRunner.run(
                jobs.map(job -> new BatchRunner.Job<>("", job)).toList(), threads, (count, total, what) -> {});
    }

    /** Runs work on an objective that no other thread is using. */
    private <T> T withObjective(Function<FitObjective, T> work) {
        FitObjective objective = objectives.remove();
        try {
            return work.apply(objective);
        } finally {
            objectives.add(objective);
        }
    }

    private Evaluation evaluate(double[] values) {
        return withObjective(objective -> {
            long from = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
            try {
                return objective.evaluate(values);
            } finally {
                cpuNs.addAndGet(ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - from);
                evaluations.incrementAndGet();
            }
        });
    }

    private List<double[]> candidates(LinearShapeModel model, double radius, double[][] tries) {
        return parallel(Stream.of(tries)
                .map(t -> () -> withObjective(
                        objective -> new ReweightedGaussNewton(objective, model).minimize(radius * t[0], t[1]))));
    }

    /**
     * Computes the effect of moving the value of each parameter alone, in both directions: on the linear model of the
     * search if it has one, otherwise with a breath each, observed when the best breath is.
     */
    private List<FitResult.Effect> effects(double[] values, double bestMm, LinearShapeModel model) {
        SearchSpace space = new SearchSpace(setup.parameters());
        List<Supplier<Double>> jobs = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            FitParameter p = setup.parameters().get(i);
            for (int side = -1; side <= 1; side += 2) {
                double to = p.toUnit(values[i]) + side * SENSITIVITY_STEP;
                double[] moved = values.clone();
                moved[i] = p.fromUnit(to);
                double[] way = space.wayOf(values, i, moved[i]);
                Supplier<Double> mean =
                        () -> withObjective(o -> model == null ? o.observedMm(moved) : bestMm + change(o, model, way));
                jobs.add(() -> to >= 0 && to <= 1 ? mean.get() : Double.NaN);
            }
        }
        List<Double> means = parallel(jobs.stream());
        return IntStream.range(0, values.length)
                .mapToObj(i -> {
                    FitParameter p = setup.parameters().get(i);
                    return new FitResult.Effect(p, step(p, values[i]), means.get(2 * i), means.get(2 * i + 1));
                })
                .toList();
    }

    /** The step up from a value, in the unit of the parameter; the step down where the step up leaves the bounds. */
    private static double step(FitParameter p, double value) {
        double above = p.toUnit(value) + SENSITIVITY_STEP;
        return above <= 1 ? p.fromUnit(above) - value : value - p.fromUnit(p.toUnit(value) - SENSITIVITY_STEP);
    }

    /** Change of the objective on a way from the centre of a linear model, mm. */
    private static double change(FitObjective objective, LinearShapeModel model, double[] way) {
        double[] shape = new double[model.length()];
        double[] point = model.centre().clone();
        model.predict(point, shape);
        double before = objective.meanMm(shape);
        for (int i = 0; i < way.length; i++) {
            point[i] += way[i];
        }
        model.predict(point, shape);
        return objective.meanMm(shape) - before;
    }

    /**
     * Simulates the best breath up to its observation. A breath that fails after the time to which the search simulates
     * is left for the next best.
     */
    private double[] bestBreath(InspiratoryHold breath, FitSearch.Result found) {
        String failure = "";
        for (Evaluation e : found.fromBest()) {
            double[] values = new SearchSpace(setup.parameters()).values(e.point());
            String reason = e.drive() > 0 ? breath.breatheIn(values) : e.failure();
            if (reason.isEmpty()) {
                return values;
            }
            failure = failure.isEmpty() ? reason : failure;
        }
        throw new BadInputException("fit: found no breath of this body that does not fail among "
                + found.trials().size() + ", also with less drive, expected one; the first: " + failure);
    }

    private List<String> warnings(FitSearch.Result found) {
        int needed = 1 + setup.parameters().size();
        int count = found.trials().size();
        if (count > needed || !found.isCutShort()) {
            return List.of();
        }
        String expected = found.isOutOfTime() ? "more --minutes" : "--evaluations of " + 3 * needed + " or more";
        return List.of("Only " + count + (count == 1 ? " breath was" : " breaths were") + " simulated: the first and"
                + " what each of " + (needed - 1) + " parameters does take " + needed
                + ", so hardly anything was searched; expected " + expected + ".");
    }

    private FitResult result(FitObjective objective, double initialMm, FitSearch.Result found, long begunNs) {
        InspiratoryHold breath = objective.breath();
        double[] values = bestBreath(breath, found);
        double bestMm = objective.currentMm();
        String hash = breath.stateHash();
        Scenario scenario = InspiratoryHold.scenario(setup.base(), setup.parameters(), values);
        FitHalf half = setup.options().half();
        boolean held = half != FitHalf.ALL;
        List<FitResult.TargetResult> targets = objective.distances().stream()
                .map(d -> new FitResult.TargetResult(
                        d.target(),
                        d.atRest(FitHalf.ALL),
                        d.of(breath, FitHalf.ALL),
                        held ? d.atRest(half.other()) : null,
                        held ? d.of(breath, half.other()) : null,
                        held ? d.of(breath, half) : null))
                .toList();
        Map<String, Double> observed = new LinkedHashMap<>();
        Observation.COLUMNS.forEach(column -> observed.put(column, breath.observed(column)));
        observed.values().removeIf(value -> value.isNaN());
        // All that is read of the best breath precedes the effects, which breathe with the same objectives.
        Optional<Landmarks.Errors> errors = setup.options().landmarks().map(l -> l.errors(breath));
        List<String> warnings = warnings(found);
        warnings.forEach(progress::note);
        List<FitResult.Effect> effects =
                setup.options().sensitivity() ? effects(values, bestMm, found.model()) : List.of();
        int count = evaluations.get();
        return new FitResult(
                setup,
                values,
                bestMm,
                initialMm,
                found.startMm(),
                targets,
                errors,
                effects,
                observed,
                scenario,
                hash.equals(stateHash(scenario)),
                new FitResult.Search(
                        found.trials().stream().mapToDouble(Evaluation::value).toArray(),
                        found.ended(),
                        FailedBreaths.of(found.trials()),
                        warnings,
                        count == 0 ? Double.NaN : cpuNs.get() * 1e-9 / count,
                        (System.nanoTime() - begunNs) * 1e-9));
    }

    /** Hash of the state that the scenario reaches in a newly assembled simulation. */
    private String stateHash(Scenario scenario) {
        try (Simulation simulation = Simulation.of(scenario, setup.thorax())) {
            long steps = SimulationRun.stepsFor(scenario.durationS(), scenario.timeStepS());
            while (simulation.steps() < steps) {
                simulation.step();
            }
            return simulation.stateHash();
        }
    }
}
