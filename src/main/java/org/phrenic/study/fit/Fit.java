package org.phrenic.study.fit;

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
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.study.Jobs;
import org.phrenic.study.StudyProgress;

/**
 * Tunes a body until its surfaces, breathed in and held, lie on those of a second breath level: the mean symmetric distance is made small by {@link GenerationSearch} within bounds.
 *
 * <p>The same setup gives the same result, on any number of threads, and also if it was killed and gone on with, as long as what ends it is not a time.
 */
public final class Fit {
    /** What a body that came apart is worth, mm: worse than any that did not. */
    private static final double CAME_APART_MM = 1000;

    private static final double EFFECT_STEP = 0.05;

    private final FitSetup setup;
    private final FitJournal journal;
    private final FitProgress progress;
    private final BlockingQueue<Body> bodies;
    private final AtomicLong cpuNanos = new AtomicLong();
    private int made;

    /** A body that breathes, and how far it is from its targets. */
    private static final class Body {
        final HeldBreath breath;
        final List<TargetDistance> distances;

        Body(FitSetup setup) {
            breath = new HeldBreath(setup.base().with("threads=1"), setup.thorax(), setup.parameters());
            distances = setup.targets().stream()
                    .map(t -> new TargetDistance(t, breath.surfaces()))
                    .toList();
        }

        double mean(FitHalf half) {
            return weighted(d -> d.of(breath, half).mean());
        }

        double initial(FitHalf half) {
            return weighted(d -> d.atRest(half).mean());
        }

        private double weighted(java.util.function.ToDoubleFunction<TargetDistance> mean) {
            double sum = 0;
            double weights = 0;
            for (TargetDistance d : distances) {
                double weight = d.target().weight();
                if (weight > 0) {
                    sum += weight * mean.applyAsDouble(d);
                    weights += weight;
                }
            }
            return sum / weights;
        }
    }

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
     * @throws org.phrenic.format.BadInputException with one sentence, if the body has no part of a target or the journal is of another fit
     */
    public static FitResult run(FitSetup setup, Path journal, FitProgress progress) {
        try (FitJournal kept = new FitJournal(journal, setup.mark(), setup.parameters())) {
            return new Fit(setup, kept, progress).run();
        }
    }

    private FitResult run() {
        long begun = System.nanoTime();
        try {
            Jobs.<Body>run(
                            IntStream.range(0, setup.threads())
                                    .mapToObj(i -> new Jobs.Job<>("body", () -> new Body(setup)))
                                    .toList(),
                            setup.threads(),
                            silent())
                    .forEach(bodies::add);
            Body first = bodies.peek();
            double initial = first.initial(setup.fitted());
            FitSearch search = new FitSearch(setup.parameters(), journal, setup.threads());
            FitSearch.Found found = search.run(
                    setup.generation(),
                    setup.sigma(),
                    setup.seed(),
                    setup.maxEvaluations(),
                    setup.budgetS(),
                    this::evaluate,
                    (count, best) -> progress.tried(count, setup.maxEvaluations(), best, initial));
            Trial best = found.best();
            List<FitResult.Effect> effects = setup.sensitivity() ? effects(best.values()) : List.of();
            return result(
                    first,
                    setup.parameters(best.values()),
                    best.value(),
                    initial,
                    found.trials(),
                    effects,
                    found.ended(),
                    begun);
        } finally {
            bodies.forEach(b -> b.breath.close());
        }
    }

    private double evaluate(double[] values) {
        Body body = bodies.remove();
        long from = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        try {
            return body.breath.to(values) ? body.mean(setup.fitted()) : CAME_APART_MM;
        } finally {
            cpuNanos.addAndGet(ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - from);
            synchronized (this) {
                made++;
            }
            bodies.add(body);
        }
    }

    /** One parameter after the other is moved a little to both sides. */
    private List<FitResult.Effect> effects(double[] unit) {
        List<Jobs.Job<Double>> jobs = new ArrayList<>();
        for (int i = 0; i < unit.length; i++) {
            for (int side = -1; side <= 1; side += 2) {
                double[] moved = unit.clone();
                moved[i] += side * EFFECT_STEP;
                boolean within = moved[i] >= 0 && moved[i] <= 1;
                jobs.add(new Jobs.Job<>("effect", () -> within ? evaluate(setup.parameters(moved)) : Double.NaN));
            }
        }
        progress.note("Moving each parameter to both sides");
        List<Double> means = Jobs.run(jobs, setup.threads(), silent());
        List<FitResult.Effect> effects = new ArrayList<>();
        for (int i = 0; i < unit.length; i++) {
            FitParameter p = setup.parameters().get(i);
            double step = p.at(Math.min(1, unit[i] + EFFECT_STEP)) - p.at(unit[i]);
            effects.add(new FitResult.Effect(p, step, means.get(2 * i), means.get(2 * i + 1)));
        }
        return effects;
    }

    private FitResult result(
            Body body,
            double[] values,
            double bestMm,
            double initialMm,
            List<Trial> trials,
            List<FitResult.Effect> effects,
            String ended,
            long begun) {
        body.breath.to(values);
        List<FitResult.TargetResult> targets = body.distances.stream()
                .map(d -> new FitResult.TargetResult(
                        d.target(),
                        d.atRest(FitHalf.ALL),
                        d.of(body.breath, FitHalf.ALL),
                        setup.holdOutHalf() ? d.atRest(FitHalf.HELD_OUT) : null,
                        setup.holdOutHalf() ? d.of(body.breath, FitHalf.HELD_OUT) : null,
                        setup.holdOutHalf() ? d.of(body.breath, FitHalf.FITTED) : null))
                .toList();
        Map<String, Double> observed = new LinkedHashMap<>();
        for (String column : Observation.COLUMNS) {
            observed.put(column, body.breath.observed(column));
        }
        Scenario scenario = HeldBreath.scenario(setup.base(), setup.parameters(), values);
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
                stateHash(scenario).equals(body.breath.stateHash()),
                trials.stream().mapToDouble(Trial::value).toArray(),
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

    private static StudyProgress silent() {
        return (count, total, what) -> {};
    }
}
