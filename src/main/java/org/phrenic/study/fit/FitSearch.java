package org.phrenic.study.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Function;
import org.phrenic.study.Jobs;

/** A {@link GenerationSearch} over parameters within bounds whose evaluations are done some at a time and kept in a journal, with budgets. */
final class FitSearch {
    /** A search that gained less than this in so many generations is at its end. */
    private static final double GAIN_MM = 0.005;

    private static final int PATIENCE = 12;
    private static final int PATIENCE_AFTER_DESCENT = 2;
    /** Standard deviation of the first generation after a descent, as a share of the bounds. */
    private static final double AFTER_DESCENT = 0.03;

    private final FitSpace space;
    private final FitJournal journal;
    private final int threads;
    private double best = Double.POSITIVE_INFINITY;
    private int done;

    /** Told of each evaluation, one at a time. */
    interface Told {
        void tried(int count, double best);
    }

    /**
     * What a search found.
     *
     * @param trials all that was tried, in order, in the unit cube
     * @param ended why it ended, in words
     */
    record Found(List<Trial> trials, String ended) {
        /** The best of them, the first if several are. */
        Trial best() {
            return trials.stream().min(Comparator.comparingDouble(Trial::value)).orElseThrow();
        }
    }

    FitSearch(List<FitParameter> parameters, FitJournal journal, int threads) {
        space = new FitSpace(parameters);
        this.journal = journal;
        this.threads = threads;
    }

    /**
     * Searches from the parameters' start: down by {@link DescentSearch}, then about the best place by {@link GenerationSearch}; by that alone where there are no shapes.
     *
     * @param work what values of the parameters come to; asked by several threads
     * @param down looks for ways down; null for none
     * @throws IllegalArgumentException if the evaluations allow none
     */
    Found run(
            int population,
            double sigma,
            long seed,
            int maxEvaluations,
            double budgetS,
            Function<double[], Outcome> work,
            DescentSearch.Down down,
            Told told) {
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
        double[] start = space.start();
        double[] spread = new double[start.length];
        for (int i = 0; i < spread.length; i++) {
            spread[i] = sigma * space.parameters().get(i).spread();
        }
        List<Trial> trials = new ArrayList<>();
        if (down != null) {
            boolean[] stopped = {false};
            trials.addAll(new DescentSearch(
                            start.length,
                            (first, points) -> {
                                stopped[0] = !allowed.test(first, points.size());
                                return stopped[0] ? List.of() : evaluate(first, points, true, work, told);
                            },
                            down)
                    .run(start));
            if (stopped[0]) {
                return new Found(trials, ended[0]);
            }
            start = new Found(trials, "").best().values();
            Arrays.fill(spread, AFTER_DESCENT);
        }
        int before = trials.size();
        int patience = (before > 1 ? PATIENCE_AFTER_DESCENT : PATIENCE) * population;
        // The start of the generations is the best of the descent, whose value is known.
        int shift = Math.max(0, before - 1);
        List<Trial> later = new GenerationSearch(start, population, spread, seed)
                .run(
                        (number, points) -> number == 0 && before > 0
                                ? new double[] {new Found(trials, "").best().value()}
                                : evaluate(shift + number, points, false, work, told).stream()
                                        .mapToDouble(Outcome::value)
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
        return new Found(trials, ended[0]);
    }

    private static double best(List<Trial> trials) {
        return trials.stream().mapToDouble(Trial::value).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** What comes of a batch, from the journal or worked out. */
    private List<Outcome> evaluate(
            int number, List<double[]> points, boolean shapes, Function<double[], Outcome> work, Told told) {
        List<Jobs.Job<Outcome>> jobs = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            int which = number + i;
            double[] values = space.values(points.get(i));
            jobs.add(new Jobs.Job<>("evaluation", () -> {
                Outcome outcome = evaluate(which, values, shapes, work);
                synchronized (told) {
                    best = Math.min(best, outcome.value());
                    told.tried(++done, best);
                }
                return outcome;
            }));
        }
        return Jobs.run(jobs, threads, (count, total, what) -> {});
    }

    private Outcome evaluate(int number, double[] values, boolean shapes, Function<double[], Outcome> work) {
        Trial known = journal.known(number);
        if (known != null && !Arrays.equals(known.values(), values)) {
            throw new IllegalStateException(
                    "the journal holds other points than the search asks for, expected the same");
        }
        float[] shape = known != null && shapes ? journal.shape(number) : null;
        if (known != null && (!shapes || shape != null)) {
            return new Outcome(known.value(), shapes ? shape : new float[0]);
        }
        Outcome outcome = work.apply(values);
        if (shapes) {
            journal.add(number, new Trial(values, outcome.value()), outcome.shape());
        } else {
            journal.add(number, new Trial(values, outcome.value()));
        }
        return outcome;
    }
}
