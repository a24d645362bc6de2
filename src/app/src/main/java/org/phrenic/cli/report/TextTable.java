package org.phrenic.cli.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Columns of text, aligned: the first to the left, numbers to the right. */
public final class TextTable {
    private final List<String[]> rows = new ArrayList<>();
    private final boolean[] rightAligned;

    /** @param right for each column, whether it is aligned to the right */
    public TextTable(boolean... right) {
        this.rightAligned = right.clone();
    }

    public TextTable row(String... cells) {
        rows.add(cells);
        return this;
    }

    public TextTable rows(List<List<String>> more) {
        more.forEach(cells -> rows.add(cells.toArray(String[]::new)));
        return this;
    }

    /** The lines, each ended; blanks at their ends are left out. */
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
