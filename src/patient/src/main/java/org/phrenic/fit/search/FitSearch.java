package org.phrenic.fit.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import org.phrenic.engine.parallel.BatchRunner;

/**
 * Searches parameters within bounds. {@link GaussNewtonSearch} runs from the start, then {@link CmaEsSearch} around the
 * best point. Evaluations run in parallel and are stored in a journal. Their number and the search time are limited.
 * Each instance runs one search.
 */
public final class FitSearch {
    /** The search ends when the objective improves by less than this in {@link #PATIENCE} generations, mm. */
    private static final double MIN_GAIN_MM = 0.005;

    private static final int PATIENCE = 12;
    private static final int PATIENCE_AFTER_DESCENT = 2;

    /**
     * Standard deviation of the first generation after the Gauss-Newton descent, as a fraction of the range of the
     * bounds.
     */
    private static final double SIGMA_AFTER_DESCENT = 0.03;

    private enum Ending {
        CONVERGED("the search converged"),
        EVALUATIONS("the evaluations were used up"),
        TIME("the time was used up"),
        NO_GAIN("nothing was gained any more");

        private final String label;

        Ending(String label) {
            this.label = label;
        }
    }

    /**
     * Settings of CMA-ES and limits of the search.
     *
     * @param seed random seed of CMA-ES
     * @param population points per generation; 0 for {@link CmaEsSearch#defaultPopulation}
     * @param sigma standard deviation of the first generation, as a fraction of the range of the bounds
     * @param maxEvaluations maximum number of evaluations, at least 1
     * @param budgetS time after which no batch is started, s; may be infinite; the start is always evaluated
     */
    public record Settings(long seed, int population, double sigma, int maxEvaluations, double budgetS) {
        private static final double SIGMA = 0.2;

        public Settings {
            if (maxEvaluations < 1) {
                throw new IllegalArgumentException(
                        "fit: found a budget of " + maxEvaluations + " evaluations, expected at least one");
            }
        }

        /** Settings with the default standard deviation. */
        public Settings(long seed, int population, int maxEvaluations, double budgetS) {
            this(seed, population, SIGMA, maxEvaluations, budgetS);
        }

        /** Settings with the default population and standard deviation, and no time limit. */
        public Settings(long seed, int maxEvaluations) {
            this(seed, 0, maxEvaluations, Double.POSITIVE_INFINITY);
        }

        /** Points per generation for a number of parameters. */
        public int population(int parameters) {
            return population > 0 ? population : CmaEsSearch.defaultPopulation(parameters);
        }
    }

    /** Drives of the attempts at a breath, relative to the requested one, until one does not fail. */
    private static final double[] DRIVES = {1, 0.7, 0.4};

    /** Drives of the attempts at the first breath, from which the search starts. */
    private static final double[] FIRST_DRIVES = {1, 0.7, 0.4, 0.2, 0.1, 0.05};

    /** Drives of the breaths from which the search starts where the first one is too deep. */
    private static final double[] WEAKER = {0.7, 0.4, 0.2};

    /** Receives evaluations one at a time. */
    public interface Listener {
        void evaluated(int count, double best);
    }

    /**
     * The result of a search.
     *
     * @param trials all evaluations in order, with points in the unit cube and without shapes
     * @param ended why the search ended, as text
     * @param model linear model near the best point; null if the search has none
     */
    public record Result(List<Evaluation> trials, String ended, LinearShapeModel model) {
        /** The best evaluation; the first one if several are equal. */
        public Evaluation best() {
            return FitSearch.best(trials);
        }

        /** Value of the first breath; NaN if it failed, also if one with less drive did not. */
        public double startMm() {
            Evaluation start = trials.get(0);
            return start.hasFailed() ? Double.NaN : start.value();
        }

        /** All evaluations, the best first. */
        public List<Evaluation> fromBest() {
            return trials.stream()
                    .sorted(Comparator.comparingDouble(Evaluation::value))
                    .toList();
        }

        /** Whether a limit ended the search. */
        public boolean isCutShort() {
            return ended.equals(Ending.EVALUATIONS.label) || isOutOfTime();
        }

        /** Whether the limit of time ended the search. */
        public boolean isOutOfTime() {
            return ended.equals(Ending.TIME.label);
        }
    }

    private final SearchSpace space;
    private final FitJournal journal;
    private final Settings settings;
    private final int threads;
    private final Function<double[], Evaluation> objective;
    private final Listener listener;
    private final long begunNs = System.nanoTime();
    private Ending ending = Ending.CONVERGED;
    private double best = Double.POSITIVE_INFINITY;
    private int done;

    /** @param objective maps parameter values to an evaluation; called from several threads */
    public FitSearch(
            List<FitParameter> parameters,
            FitJournal journal,
            Settings settings,
            int threads,
            Function<double[], Evaluation> objective,
            Listener listener) {
        space = new SearchSpace(parameters);
        this.journal = journal;
        this.settings = settings;
        this.threads = threads;
        this.objective = objective;
        this.listener = listener;
    }

    /**
     * Runs the search from the start values of the parameters. A first breath that is farther from the target than the
     * body at rest is too deep: less drive is tried, and the search starts from the best.
     *
     * @param restMm objective value of the body at rest, mm
     * @param solver solver of the Gauss-Newton subproblem; null to use CMA-ES only
     */
    public Result run(double restMm, GaussNewtonSearch.SubproblemSolver solver) {
        GaussNewtonSearch descent = new GaussNewtonSearch(
                space.parameters().size(),
                (first, points) -> isAllowed(first, points.size()) ? evaluate(first, points, true) : List.of(),
                solver);
        List<Evaluation> trials = solver == null
                ? new ArrayList<>()
                : descent.run(space.startPoint(), weaker(space.startPoint()), restMm);
        if (ending == Ending.CONVERGED) {
            refine(trials);
        }
        return new Result(trials, ending.label, descent.model());
    }

    private List<double[]> weaker(double[] start) {
        return Arrays.stream(WEAKER)
                .mapToObj(drive -> space.withDrive(start, drive))
                .toList();
    }

    /** Continues with CMA-ES. Its first point is the best of the descent, whose value is already known. */
    private void refine(List<Evaluation> trials) {
        boolean begun = !trials.isEmpty();
        boolean descended = begun && best(trials).drive() > 0;
        int offset = begun ? trials.size() - 1 : 0;
        int population = settings.population(space.parameters().size());
        int patience = (trials.size() > 1 ? PATIENCE_AFTER_DESCENT : PATIENCE) * population;
        double[] start = begun ? best(trials).point() : space.startPoint();
        double[] sigma = new double[start.length];
        Arrays.setAll(
                sigma,
                i -> descended
                        ? SIGMA_AFTER_DESCENT
                        : settings.sigma * space.parameters().get(i).relativeSigma());
        List<Evaluation> generations = new ArrayList<>();
        new CmaEsSearch(start, population, sigma, settings.seed).run((first, points) -> {
            List<Evaluation> batch;
            if (first == 0 && begun) {
                Evaluation known = best(trials);
                batch = List.of(new Evaluation(known.point(), known.value()));
            } else if (!isAllowed(offset + first, points.size())) {
                return List.of();
            } else if (first > patience
                    && best(generations.subList(0, first - patience)).value()
                                    - best(generations).value()
                            < MIN_GAIN_MM) {
                ending = Ending.NO_GAIN;
                return List.of();
            } else {
                batch = evaluate(offset + first, points, false);
            }
            generations.addAll(batch);
            return batch;
        });
        trials.addAll(begun ? generations.subList(1, generations.size()) : generations);
    }

    private boolean isAllowed(int first, int count) {
        if (first + count > settings.maxEvaluations) {
            ending = Ending.EVALUATIONS;
            return false;
        }
        // Evaluations from the journal take no time.
        if (first > 0 && journal.known(first) == null && (System.nanoTime() - begunNs) * 1e-9 > settings.budgetS) {
            ending = Ending.TIME;
            return false;
        }
        return true;
    }

    private static Evaluation best(List<Evaluation> trials) {
        return trials.stream()
                .min(Comparator.comparingDouble(Evaluation::value))
                .orElseThrow();
    }

    /** Evaluates a batch, or reads it from the journal. */
    private List<Evaluation> evaluate(int first, List<double[]> points, boolean shapes) {
        List<BatchRunner.Job<Evaluation>> jobs = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            int number = first + i;
            double[] point = points.get(i);
            jobs.add(new BatchRunner.Job<>("evaluation", () -> {
                Evaluation evaluation = evaluate(number, point, shapes);
                synchronized (listener) {
                    best = Math.min(best, evaluation.value());
                    listener.evaluated(++done, best);
                }
                return evaluation;
            }));
        }
        return BatchRunner.run(jobs, threads, (count, total, what) -> {});
    }

    private Evaluation evaluate(int number, double[] point, boolean shapes) {
        double[] values = space.values(point);
        Evaluation known = journal.known(number, values);
        float[] shape = known == null ? null : shapes ? journal.shape(number) : new float[0];
        if (shape != null) {
            double[] at = space.withDrive(point, known.drive() == 0 ? 1 : known.drive());
            return new Evaluation(at, known.value(), shape, known.drive(), known.failure());
        }
        Evaluation e = attempts(point, number == 0 ? FIRST_DRIVES : DRIVES);
        journal.add(number, new Evaluation(values, e.value(), e.shape(), e.drive(), e.failure()), shapes);
        return e;
    }

    /** Evaluates a point with less and less drive until an attempt does not fail. */
    private Evaluation attempts(double[] point, double[] drives) {
        String failure = "";
        for (double drive : drives) {
            double[] at = space.withDrive(point, drive);
            Evaluation e = objective.apply(space.values(at));
            if (!e.hasFailed()) {
                return new Evaluation(at, e.value(), e.shape(), drive, failure);
            }
            failure = failure.isEmpty() ? e.failure() : failure;
        }
        return Evaluation.failed(point, failure);
    }
}
