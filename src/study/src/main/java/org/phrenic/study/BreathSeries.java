package org.phrenic.study;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.phrenic.breathing.RespiratoryPhase;

/**
 * Time series of a run's observables, divided into breaths.
 *
 * <p>A breath begins at its first sample (end-expiration). End-inspiration is the sample at which the sum of both dome
 * heights is lowest. If a breath contains a hold, only that breath is used. Otherwise all complete breaths are used, or
 * all samples as one breath if none is complete.
 */
public final class BreathSeries {
    private final List<String> columns;
    private final List<double[]> rows;
    private final List<RespiratoryPhase> labels;
    private final List<int[]> breaths = new ArrayList<>();

    /**
     * @param columns column names, including {@code breath}, {@code dome_right_mm}, {@code dome_left_mm}
     * @param rows one value per column, in time order; at least one row
     * @param labels respiratory phase of each row
     */
    public BreathSeries(List<String> columns, List<double[]> rows, List<RespiratoryPhase> labels) {
        if (rows.isEmpty() || rows.size() != labels.size()) {
            throw new IllegalArgumentException("series: " + rows.size() + " rows and " + labels.size()
                    + " labels, expected as many, at least one");
        }
        this.columns = List.copyOf(columns);
        this.rows = List.copyOf(rows);
        this.labels = List.copyOf(labels);
        findBreaths();
    }

    private void findBreaths() {
        int held = labels.indexOf(RespiratoryPhase.HOLD);
        if (held >= 0) {
            double number = value("breath", held);
            int first = held;
            while (first > 0 && value("breath", first - 1) == number) {
                first--;
            }
            breaths.add(new int[] {first, labels.lastIndexOf(RespiratoryPhase.HOLD)});
            return;
        }
        int first = 0;
        for (int i = 1; i < rows.size(); i++) {
            if (value("breath", i) != value("breath", i - 1)) {
                breaths.add(new int[] {first, i});
                first = i;
            }
        }
        if (breaths.isEmpty()) {
            breaths.add(new int[] {0, rows.size() - 1});
        }
    }

    /** The same breaths with columns whose values are unknown: NaN in every row. */
    public BreathSeries withUnknown(Collection<String> names) {
        List<double[]> known = rows.stream().map(double[]::clone).toList();
        for (int c = 0; c < columns.size(); c++) {
            if (names.contains(columns.get(c))) {
                for (double[] row : known) {
                    row[c] = Double.NaN;
                }
            }
        }
        return new BreathSeries(columns, known, labels);
    }

    public boolean hasColumn(String column) {
        return columns.contains(column);
    }

    /** Value of a column in a row. */
    public double value(String column, int row) {
        int c = columns.indexOf(column);
        if (c < 0) {
            throw new IllegalArgumentException("series: found no column '" + column + "'");
        }
        return rows.get(row)[c];
    }

    public int breathCount() {
        return breaths.size();
    }

    /** First row of a breath: end-expiration. */
    public int endExpirationRow(int breath) {
        return breaths.get(breath)[0];
    }

    /** Last row of a breath, or of its hold. */
    public int lastRow(int breath) {
        return breaths.get(breath)[1];
    }

    /** Row of end-inspiration, where the sum of both dome heights is lowest. */
    public int endInspirationRow(int breath) {
        int best = endExpirationRow(breath);
        for (int i = best; i <= lastRow(breath); i++) {
            if (domeHeights(i) < domeHeights(best)) {
                best = i;
            }
        }
        return best;
    }

    private double domeHeights(int row) {
        return value("dome_right_mm", row) + value("dome_left_mm", row);
    }

    /** Whether the series contains a breath hold. */
    public boolean hasHold() {
        return labels.contains(RespiratoryPhase.HOLD);
    }

    /** First row of the hold; -1 without a hold. */
    public int firstHeldRow() {
        return labels.indexOf(RespiratoryPhase.HOLD);
    }

    /** Mean of a column at end-expiration over the breaths. */
    public double meanAtEndExpiration(String column) {
        double sum = 0;
        for (int b = 0; b < breaths.size(); b++) {
            sum += value(column, endExpirationRow(b));
        }
        return sum / breaths.size();
    }

    /** Mean of a column at end-inspiration over the breaths. */
    public double meanAtEndInspiration(String column) {
        double sum = 0;
        for (int b = 0; b < breaths.size(); b++) {
            sum += value(column, endInspirationRow(b));
        }
        return sum / breaths.size();
    }

    /** Mean change of a column from end-expiration to end-inspiration. */
    public double meanChange(String column) {
        return meanAtEndInspiration(column) - meanAtEndExpiration(column);
    }
}
