package org.phrenic.study.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.phrenic.study.Jobs;

/** A {@link GenerationSearch} over parameters within bounds whose evaluations are done some at a time and kept in a journal, with budgets. */
final class FitSearch {
    /** A search that gained less than this in {@value #PATIENCE} generations is at its end. */
    private static final double GAIN_MM = 0.005;

    private static final int PATIENCE = 12;

    private final List<FitParameter> parameters;
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
        this.parameters = parameters;
        this.journal = journal;
        this.threads = threads;
    }

    /** Values at a place of the unit cube. */
    static double[] values(List<FitParameter> parameters, double[] unit) {
        return IntStream.range(0, unit.length)
                .mapToDouble(i -> parameters.get(i).at(unit[i]))
                .toArray();
    }

    /**
     * Searches from the parameters' start.
     *
     * @param work what values of the parameters are worth; asked by several threads
     * @throws IllegalArgumentException if the evaluations allow none
     */
    Found run(
            int population,
            double sigma,
            long seed,
            int maxEvaluations,
            double budgetS,
            ToDoubleFunction<double[]> work,
            Told told) {
        if (maxEvaluations < 1) {
            throw new IllegalArgumentException(
                    "fit: found a budget of " + maxEvaluations + " evaluations, expected at least one");
        }
        long begun = System.nanoTime();
        double[] start = parameters.stream().mapToDouble(p -> p.unit(p.start())).toArray();
        double[] spread =
                parameters.stream().mapToDouble(p -> sigma * p.spread()).toArray();
        String[] ended = {"the search converged"};
        int patience = PATIENCE * population;
        List<Trial> trials = new GenerationSearch(start, population, spread, seed)
                .run((number, points) -> evaluate(number, points, work, told), (soFar, next) -> {
                    if (soFar.size() + next > maxEvaluations) {
                        ended[0] = "the evaluations were used up";
                        return false;
                    }
                    // What is known costs no time and is always gone through; the start is always looked at.
                    if (!soFar.isEmpty()
                            && journal.known(soFar.size()) == null
                            && (System.nanoTime() - begun) * 1e-9 > budgetS) {
                        ended[0] = "the time was used up";
                        return false;
                    }
                    if (soFar.size() > patience
                            && best(soFar.subList(0, soFar.size() - patience)) - best(soFar) < GAIN_MM) {
                        ended[0] = "nothing was gained any more";
                        return false;
                    }
                    return true;
                });
        return new Found(trials, ended[0]);
    }

    private static double best(List<Trial> trials) {
        return trials.stream().mapToDouble(Trial::value).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** Values of a generation, from the journal or worked out. */
    private double[] evaluate(int number, List<double[]> points, ToDoubleFunction<double[]> work, Told told) {
        List<Jobs.Job<Double>> jobs = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            int which = number + i;
            double[] values = values(parameters, points.get(i));
            jobs.add(new Jobs.Job<>("evaluation", () -> {
                Trial known = journal.known(which);
                if (known != null && !Arrays.equals(known.values(), values)) {
                    throw new IllegalStateException(
                            "the journal holds other points than the search asks for, expected the same");
                }
                Trial trial = known != null ? known : new Trial(values, work.applyAsDouble(values));
                if (known == null) {
                    journal.add(which, trial);
                }
                synchronized (told) {
                    best = Math.min(best, trial.value());
                    told.tried(++done, best);
                }
                return trial.value();
            }));
        }
        return Jobs.run(jobs, threads, (count, total, what) -> {}).stream()
                .mapToDouble(v -> v)
                .toArray();
    }
}
