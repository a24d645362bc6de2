package org.phrenic.study.error;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;

/**
 * Measurements of the error budget in a CSV file. The file is written after each measurement, so a study that was
 * interrupted goes on where it ended.
 */
public final class BudgetTable {
    private final Path file;
    private final List<BudgetRow> rows = new ArrayList<>();

    /**
     * Opens a table.
     *
     * @param file read if it exists; null to keep the rows in memory
     * @throws org.phrenic.file.BadInputException with one sentence, if the file is not such a table
     */
    public BudgetTable(Path file) {
        this.file = file;
        if (file != null && Files.exists(file)) {
            rows.addAll(read(CsvTable.read(file)));
        }
    }

    private static List<BudgetRow> read(CsvTable csv) {
        List<BudgetRow> list = new ArrayList<>();
        for (int i = 0; i < csv.rowCount(); i++) {
            int row = i;
            BudgetPart part = BudgetPart.of(csv.texts("part").get(row))
                    .orElseThrow(() -> csv.badCell(
                            row, "part", "found '" + csv.texts("part").get(row) + "', expected a part of the budget"));
            list.add(new BudgetRow(
                    part,
                    csv.texts("body").get(row),
                    csv.texts("breath").get(row),
                    csv.texts("mesh").get(row),
                    csv.texts("setting").get(row),
                    csv.texts("usual").get(row).equals("true"),
                    number(csv, row, "edge_mm"),
                    number(csv, row, "excursion_mm"),
                    number(csv, row, "rms_mm"),
                    number(csv, row, "max_mm"),
                    number(csv, row, "uncertainty_mm"),
                    number(csv, row, "cpu_s"),
                    number(csv, row, "real_time")));
        }
        return list;
    }

    /** A number, NaN for an empty cell. */
    private static double number(CsvTable csv, int row, String column) {
        String text = csv.texts(column).get(row);
        try {
            return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw csv.badCell(row, column, "found '" + text + "', expected a number");
        }
    }

    /** All rows, in the order in which they were measured. */
    public List<BudgetRow> rows() {
        return List.copyOf(rows);
    }

    /** Rows of a part of the budget of a scene. */
    List<BudgetRow> rows(BudgetPart part, String body, String breath, String mesh) {
        return rows.stream().filter(r -> r.isOf(part, body, breath, mesh)).toList();
    }

    /** The default's row of a part of the budget of a scene. */
    Optional<BudgetRow> usual(BudgetPart part, String body, String breath, String mesh) {
        return rows(part, body, breath, mesh).stream().filter(BudgetRow::usual).findFirst();
    }

    /** Whether a part of the budget of a scene was measured. */
    boolean has(BudgetPart part, String body, String breath, String mesh) {
        return !rows(part, body, breath, mesh).isEmpty();
    }

    /** Adds rows and writes the file. */
    void add(List<BudgetRow> more) {
        rows.removeIf(old -> more.stream().anyMatch(row -> row.replaces(old)));
        rows.addAll(more);
        if (file != null) {
            CsvWriter.write(
                    file, BudgetRow.HEADER, rows.stream().map(BudgetRow::cells).toList());
        }
    }
}
