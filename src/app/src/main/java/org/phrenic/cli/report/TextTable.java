package org.phrenic.cli.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.phrenic.document.report.ReportDocument.Column;

/** A text table with aligned columns. */
public final class TextTable {
    private final List<String[]> rows = new ArrayList<>();
    private final boolean[] rightAligned;

    /** @param rightAligned for each column, whether it is right-aligned */
    public TextTable(boolean... rightAligned) {
        this.rightAligned = rightAligned.clone();
    }

    /** A table with headings and right-aligned numbers. */
    public TextTable(List<Column> columns) {
        rightAligned = new boolean[columns.size()];
        for (int i = 0; i < rightAligned.length; i++) {
            rightAligned[i] = columns.get(i).number();
        }
        row(columns.stream().map(Column::heading).toArray(String[]::new));
    }

    /** A table in which all columns except the first are right-aligned. */
    public static String ofNumbers(List<List<String>> rows) {
        boolean[] right = new boolean[rows.get(0).size()];
        Arrays.fill(right, 1, right.length, true);
        return new TextTable(right).rows(rows).text();
    }

    public TextTable row(String... cells) {
        rows.add(cells);
        return this;
    }

    public TextTable rows(List<List<String>> more) {
        more.forEach(cells -> rows.add(cells.toArray(String[]::new)));
        return this;
    }

    /** Adds a row of label, value and unit for a key such as {@code dome_excursion_right_mm}. */
    public TextTable quantity(String key, Object value) {
        QuantityKey quantity = QuantityKey.parse(key);
        return row(quantity.label(), QuantityKey.format(value), quantity.unit());
    }

    /** The formatted lines, each with a line break and without trailing blanks. */
    public String text() {
        int[] width = new int[rightAligned.length];
        for (String[] row : rows) {
            Arrays.setAll(width, c -> Math.max(width[c], row[c].length()));
        }
        return rows.stream().map(row -> line(row, width)).collect(Collectors.joining());
    }

    private String line(String[] row, int[] width) {
        StringBuilder line = new StringBuilder();
        for (int c = 0; c < row.length; c++) {
            String fill = " ".repeat(width[c] - row[c].length());
            line.append(c == 0 ? "" : "  ").append(rightAligned[c] ? fill + row[c] : row[c] + fill);
        }
        return line.toString().stripTrailing() + "\n";
    }
}
