package org.phrenic.study.error;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.TextFile;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;

/**
 * Measurements of the error budget in a folder: {@code budget.csv}, and {@code plan.yaml}, which states what they are
 * of. The table is written after each measurement, so a study that was interrupted goes on where it ended.
 */
public final class BudgetTable {
    private static final String TABLE = "budget.csv";
    private static final String PLAN = "plan.yaml";

    private final Path file;
    private final List<BudgetRow> rows = new ArrayList<>();

    /** A table that is kept in memory. */
    public BudgetTable() {
        file = null;
    }

    /**
     * Opens the table of a folder, or begins it.
     *
     * @throws BadInputException with one sentence, if what is there is no such table or one of another plan
     */
    public BudgetTable(Path folder, BudgetPlan plan) {
        file = folder.resolve(TABLE);
        Path stated = folder.resolve(PLAN);
        String identity = plan.identity();
        if (!Files.exists(file)) {
            if (Files.exists(stated) && !TextFile.read(stated, "a plan").startsWith(BudgetPlan.FIRST_KEY + ":")) {
                throw new BadInputException(stated + ": found a file of another kind, expected another folder");
            }
            AtomicFile.write(stated, identity);
            return;
        }
        if (!Files.exists(stated)) {
            throw new BadInputException(folder + ": found " + TABLE + " without " + PLAN
                    + ", which states what it is of, expected both or another folder");
        }
        if (!TextFile.read(stated, "a plan").equals(identity)) {
            throw new BadInputException(folder + ": found the measurements of another plan, body or program (" + PLAN
                    + " differs), expected another folder");
        }
        CsvTable csv = CsvTable.read(file);
        rows.addAll(read(csv));
        for (int row = 0; row < rows.size(); row++) {
            if (!plan.includes(rows.get(row))) {
                throw csv.badCell(
                        row, "mesh", "found a row of none of the scenes of " + PLAN + ", expected only those");
            }
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
