package org.phrenic.fit.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Function;
import org.phrenic.engine.parallel.BatchRunner;

/**
 * A {@link CmaEsSearch} over parameters within bounds whose evaluations are done some at a time and kept in a journal,
 * with budgets.
 */
public final class FitSearch {
    /** A search that gained less than this in so many generations is at its end. */
    private static final double GAIN_MM = 0.005;

    private static final int PATIENCE = 12;
    private static final int PATIENCE_AFTER_DESCENT = 2;
    /** Standard deviation of the first generation after a descent, as a share of the bounds. */
    private static final double AFTER_DESCENT = 0.03;

    private final SearchSpace space;
    private final FitJournal journal;
    private final int threads;
    private double best = Double.POSITIVE_INFINITY;
    private int done;

    /** Told of each evaluation, one at a time. */
    public interface Listener {
        void evaluated(int count, double best);
    }

    /**
     * What a search found.
     *
     * @param trials all that was tried, in order, in the unit cube
     * @param ended why it ended, in words
     */
    public record Result(List<EvaluatedPoint> trials, String ended) {
        /** The best of them, the first if several are. */
        public EvaluatedPoint best() {
            return trials.stream()
                    .min(Comparator.comparingDouble(EvaluatedPoint::value))
                    .orElseThrow();
        }
    }

    public FitSearch(List<FitParameter> parameters, FitJournal journal, int threads) {
        space = new SearchSpace(parameters);
        this.journal = journal;
        this.threads = threads;
    }

    /**
     * Searches from the parameters' start: down by {@link GaussNewtonSearch}, then about the best place by
     * {@link CmaEsSearch}; by that alone where there are no shapes.
     *
     * @param work what values of the parameters come to; asked by several threads
     * @param down looks for ways down; null for none
     * @throws IllegalArgumentException if the evaluations allow none
     */
    public Result run(
            int population,
            double sigma,
            long seed,
            int maxEvaluations,
            double budgetS,
            Function<double[], Evaluation> work,
            GaussNewtonSearch.SubproblemSolver down,
            Listener told) {
        if (maxEvaluations < 1) {
            throw new IllegalArgumentException(
                    "fit: found a budget of " + maxEvaluations + " evaluations, expected at least one");
        }
        long begun = System.nanoTime();
        String[] ended = {"the search converged"};
        BiPredicate<Integer, Integer> allowed = (first, next) -> {
            if (first + next > maxEvaluations) {
                ended[0] = "the evaluations were used up";
                return false;
            }
            // What is known costs no time and is always gone through; the start is always looked at.
            if (first > 0 && journal.known(first) == null && (System.nanoTime() - begun) * 1e-9 > budgetS) {
                ended[0] = "the time was used up";
                return false;
            }
            return true;
        };
        double[] start = space.startPoint();
        double[] spread = new double[start.length];
        for (int i = 0; i < spread.length; i++) {
            spread[i] = sigma * space.parameters().get(i).relativeSigma();
        }
        List<EvaluatedPoint> trials = new ArrayList<>();
        if (down != null) {
            boolean[] stopped = {false};
            trials.addAll(new GaussNewtonSearch(
                            start.length,
                            (first, points) -> {
                                stopped[0] = !allowed.test(first, points.size());
                                return stopped[0] ? List.of() : evaluate(first, points, true, work, told);
                            },
                            down)
                    .run(start));
            if (stopped[0]) {
                return new Result(trials, ended[0]);
            }
            start = new Result(trials, "").best().point();
            Arrays.fill(spread, AFTER_DESCENT);
        }
        int before = trials.size();
        int patience = (before > 1 ? PATIENCE_AFTER_DESCENT : PATIENCE) * population;
        // The start of the generations is the best of the descent, whose value is known.
        int shift = Math.max(0, before - 1);
        List<EvaluatedPoint> later = new CmaEsSearch(start, population, spread, seed)
                .run(
                        (number, points) -> number == 0 && before > 0
                                ? new double[] {new Result(trials, "").best().value()}
                                : evaluate(shift + number, points, false, work, told).stream()
                                        .mapToDouble(Evaluation::value)
                                        .toArray(),
                        (soFar, next) -> {
                            if (soFar.isEmpty() && before > 0) {
                                return true;
                            }
                            if (!allowed.test(shift + soFar.size(), next)) {
                                return false;
                            }
                            if (soFar.size() > patience
                                    && best(soFar.subList(0, soFar.size() - patience)) - best(soFar) < GAIN_MM) {
                                ended[0] = "nothing was gained any more";
                                return false;
                            }
                            return true;
                        });
        trials.addAll(before > 0 ? later.subList(1, later.size()) : later);
        return new Result(trials, ended[0]);
    }

    private static double best(List<EvaluatedPoint> trials) {
        return trials.stream().mapToDouble(EvaluatedPoint::value).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** What comes of a batch, from the journal or worked out. */
    private List<Evaluation> evaluate(
            int number, List<double[]> points, boolean shapes, Function<double[], Evaluation> work, Listener told) {
        List<BatchRunner.Job<Evaluation>> jobs = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            int which = number + i;
            double[] values = space.values(points.get(i));
            jobs.add(new BatchRunner.Job<>("evaluation", () -> {
                Evaluation outcome = evaluate(which, values, shapes, work);
                synchronized (told) {
                    best = Math.min(best, outcome.value());
                    told.evaluated(++done, best);
                }
                return outcome;
            }));
        }
        return BatchRunner.run(jobs, threads, (count, total, what) -> {});
    }

    private Evaluation evaluate(int number, double[] values, boolean shapes, Function<double[], Evaluation> work) {
        EvaluatedPoint known = journal.known(number);
        if (known != null && !Arrays.equals(known.point(), values)) {
            throw new IllegalStateException(
                    "the journal holds other points than the search asks for, expected the same");
        }
        float[] shape = known != null && shapes ? journal.shape(number) : null;
        if (known != null && (!shapes || shape != null)) {
            return new Evaluation(known.value(), shapes ? shape : new float[0]);
        }
        Evaluation outcome = work.apply(values);
        if (shapes) {
            journal.add(number, new EvaluatedPoint(values, outcome.value()), outcome.shape());
        } else {
            journal.add(number, new EvaluatedPoint(values, outcome.value()));
        }
        return outcome;
    }
}
