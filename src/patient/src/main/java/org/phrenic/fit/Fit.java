package org.phrenic.fit;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.fit.search.CmaEsSearch;
import org.phrenic.fit.search.EvaluatedPoint;
import org.phrenic.fit.search.Evaluation;
import org.phrenic.fit.search.FitJournal;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.fit.search.GaussNewtonSearch;
import org.phrenic.fit.search.LinearShapeModel;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Observation;

/**
 * Tunes a body until its surfaces, breathed in and held, lie on those of a second breath level: the mean symmetric
 * distance is made small within bounds by {@link GaussNewtonSearch} and what that leaves by {@link CmaEsSearch}.
 *
 * <p>The same setup gives the same result, on any number of threads, and also if it was killed and gone on with, as
 * long as what ends it is not a time.
 */
public final class Fit {
    private static final double EFFECT_STEP = 0.05;

    private final FitSetup setup;
    private final FitJournal journal;
    private final FitProgress progress;
    private final BlockingQueue<FitObjective> bodies;
    private final AtomicLong cpuNanos = new AtomicLong();
    private int made;

    private Fit(FitSetup setup, FitJournal journal, FitProgress progress) {
        this.setup = setup;
        this.journal = journal;
        this.progress = progress;
        bodies = new ArrayBlockingQueue<>(setup.threads());
    }

    /**
     * Fits.
     *
     * @param journal file that keeps every evaluation; a fit that was killed goes on from what it holds
     * @throws org.phrenic.format.BadInputException with one sentence, if the body has no part of a target or the
     *     journal is of another fit
     */
    public static FitResult run(FitSetup setup, Path journal, FitProgress progress) {
        try (FitJournal kept = new FitJournal(journal, setup.fingerprint(), setup.parameters())) {
            return new Fit(setup, kept, progress).run();
        }
    }

    private FitResult run() {
        long begun = System.nanoTime();
        try {
            BatchRunner.<FitObjective>run(
                            IntStream.range(0, setup.threads())
                                    .mapToObj(i -> new BatchRunner.Job<>("body", () -> new FitObjective(setup)))
                                    .toList(),
                            setup.threads(),
                            silent())
                    .forEach(bodies::add);
            FitObjective first = bodies.peek();
            double initial = first.initialMm();
            FitSearch search = new FitSearch(setup.parameters(), journal, setup.threads());
            GaussNewtonSearch.SubproblemSolver down = first.hasGradient() ? this::candidates : null;
            FitSearch.Result found = search.run(
                    setup.populationSize(),
                    setup.sigma(),
                    setup.seed(),
                    setup.maxEvaluations(),
                    setup.budgetS(),
                    this::evaluate,
                    down,
                    (count, best) -> progress.evaluated(count, setup.maxEvaluations(), best, initial));
            EvaluatedPoint best = found.best();
            double[] values = setup.parameters(best.point());
            List<FitResult.Effect> effects = setup.sensitivity() ? effects(values) : List.of();
            return result(first, values, best.value(), initial, found.trials(), effects, found.ended(), begun);
        } finally {
            bodies.forEach(FitObjective::close);
        }
    }

    private Evaluation evaluate(double[] values) {
        FitObjective body = bodies.remove();
        long from = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        try {
            return body.evaluate(values);
        } finally {
            cpuNanos.addAndGet(ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - from);
            synchronized (this) {
                made++;
            }
            bodies.add(body);
        }
    }

    /** Ways down, some side by side. */
    private List<double[]> candidates(LinearShapeModel linear, double reach, double[][] tries) {
        List<BatchRunner.Job<double[]>> jobs = new ArrayList<>();
        for (double[] way : tries) {
            jobs.add(new BatchRunner.Job<>("way", () -> {
                FitObjective body = bodies.remove();
                try {
                    return new ReweightedGaussNewton(body, linear).minimize(reach * way[0], way[1]);
                } finally {
                    bodies.add(body);
                }
            }));
        }
        return BatchRunner.run(jobs, setup.threads(), silent());
    }

    /** One parameter after the other is moved a little to both sides. */
    private List<FitResult.Effect> effects(double[] values) {
        List<BatchRunner.Job<Double>> jobs = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            FitParameter p = setup.parameters().get(i);
            for (int side = -1; side <= 1; side += 2) {
                double to = p.toUnit(values[i]) + side * EFFECT_STEP;
                double[] moved = values.clone();
                moved[i] = p.fromUnit(to);
                jobs.add(new BatchRunner.Job<>(
                        "effect", () -> to >= 0 && to <= 1 ? evaluate(moved).value() : Double.NaN));
            }
        }
        progress.note("Moving each parameter to both sides");
        List<Double> means = BatchRunner.run(jobs, setup.threads(), silent());
        List<FitResult.Effect> effects = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            FitParameter p = setup.parameters().get(i);
            double step = p.fromUnit(Math.min(1, p.toUnit(values[i]) + EFFECT_STEP)) - values[i];
            effects.add(new FitResult.Effect(p, step, means.get(2 * i), means.get(2 * i + 1)));
        }
        return effects;
    }

    private FitResult result(
            FitObjective body,
            double[] values,
            double bestMm,
            double initialMm,
            List<EvaluatedPoint> trials,
            List<FitResult.Effect> effects,
            String ended,
            long begun) {
        Scenario scenario = InspiratoryHold.scenario(setup.base(), setup.parameters(), values);
        List<String> hashes = BatchRunner.run(
                List.of(
                        new BatchRunner.Job<>("best", () -> {
                            body.breath().breatheIn(values);
                            return body.breath().stateHash();
                        }),
                        new BatchRunner.Job<>("anew", () -> stateHash(scenario))),
                setup.threads(),
                silent());
        List<FitResult.TargetResult> targets = body.distances().stream()
                .map(d -> new FitResult.TargetResult(
                        d.target(),
                        d.atRest(FitHalf.ALL),
                        d.of(body.breath(), FitHalf.ALL),
                        setup.holdOutHalf() ? d.atRest(FitHalf.HELD_OUT) : null,
                        setup.holdOutHalf() ? d.of(body.breath(), FitHalf.HELD_OUT) : null,
                        setup.holdOutHalf() ? d.of(body.breath(), FitHalf.FITTED) : null))
                .toList();
        Map<String, Double> observed = new LinkedHashMap<>();
        for (String column : Observation.COLUMNS) {
            observed.put(column, body.breath().observed(column));
        }
        return new FitResult(
                setup,
                values,
                bestMm,
                initialMm,
                trials.get(0).value(),
                targets,
                effects,
                observed,
                scenario,
                hashes.get(0).equals(hashes.get(1)),
                trials.stream().mapToDouble(EvaluatedPoint::value).toArray(),
                ended,
                made == 0 ? Double.NaN : cpuNanos.get() * 1e-9 / made,
                (System.nanoTime() - begun) * 1e-9);
    }

    /** State that the scenario leads to, put together anew. */
    private String stateHash(Scenario scenario) {
        try (Simulation simulation = Simulation.of(scenario, setup.thorax())) {
            long steps = Math.round(scenario.durationS() / scenario.timeStepS());
            while (simulation.steps() < steps) {
                simulation.step();
            }
            return simulation.stateHash();
        }
    }

    private static ProgressListener silent() {
        return (count, total, what) -> {};
    }
}
