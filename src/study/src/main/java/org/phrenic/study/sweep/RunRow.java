package org.phrenic.study.sweep;

import java.io.Serializable;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Objects;
import java.util.stream.Stream;
import org.phrenic.document.ShippedFileException;
import org.phrenic.file.UnreadableException;

/**
 * A completed run.
 *
 * @param index of its point
 * @param outcome what it gave; NaN responses if it failed
 * @param failure why it failed; empty if it did not
 * @param wallS time that it took, s
 * @param machine where it was computed
 */
public record RunRow(int index, SweepOutcome outcome, String failure, double wallS, String machine)
        implements Serializable {
    /**
     * Evaluates a point. A run that fails is a row with its reason; one that fails on an interrupted thread tells only
     * that its study ends, and is none, and one that cannot reach a file tells of the machine and not of the point.
     *
     * @throws RuntimeException the failure of a run that is no row
     */
    public static RunRow of(SweepModel model, SweepPoint point) {
        long begun = System.nanoTime();
        SweepOutcome outcome;
        String failure = "";
        try {
            outcome = model.evaluate(point);
        } catch (RuntimeException reason) {
            if (Thread.currentThread().isInterrupted() || isReading(reason)) {
                throw reason;
            }
            outcome = failed(model);
            failure = sentence(reason);
        }
        return new RunRow(point.index(), outcome, failure, (System.nanoTime() - begun) * 1e-9, RunMachine.text());
    }

    private static boolean isReading(RuntimeException reason) {
        return Stream.<Throwable>iterate(reason, Objects::nonNull, Throwable::getCause)
                .anyMatch(e -> e instanceof UnreadableException
                        || e instanceof UncheckedIOException
                        || e instanceof ShippedFileException);
    }

    private static SweepOutcome failed(SweepModel model) {
        double[] responses = new double[model.responses().size()];
        Arrays.fill(responses, Double.NaN);
        double[][] series = new double[model.series().size()][SweepOutcome.SERIES_POINTS];
        for (double[] values : series) {
            Arrays.fill(values, Double.NaN);
        }
        return new SweepOutcome(responses, "", series);
    }

    private static String sentence(RuntimeException reason) {
        String message = reason.getMessage() == null ? "" : reason.getMessage();
        String plain = message.replaceAll("\\s+", " ").strip();
        return plain.isEmpty() ? reason.getClass().getSimpleName() : plain;
    }

    public boolean isFailed() {
        return !failure.isEmpty();
    }

    /** Whether another run of the same point gave the same bits; times and machines may differ. */
    public boolean hasResultOf(RunRow other) {
        return index == other.index
                && failure.equals(other.failure)
                && outcome.stateSha256().equals(other.outcome.stateSha256())
                && Arrays.equals(outcome.responses(), other.outcome.responses())
                && Arrays.deepEquals(outcome.series(), other.outcome.series());
    }
}
