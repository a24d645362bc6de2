package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Predicate;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * A row of a table of settings, measured again.
 *
 * @param row the row
 * @param statedMm rms error that the table states, mm
 * @param measuredMm the same measured again, mm
 */
public record TableCheck(ErrorTable.Row row, double statedMm, double measuredMm) {
    /** Largest relative difference of a row that is up to date. */
    private static final double TOLERANCE = 0.25;

    private static final int RADIX = 16;
    private static final int SEED_DIGITS = 15;

    /** Whether the table states what is measured, within 25 %. */
    public boolean holds() {
        return Math.abs(measuredMm - statedMm) <= TOLERANCE * statedMm;
    }

    /**
     * Draws rows of one table.
     *
     * @param hash hexadecimal hash that decides which rows are drawn, such as that of the file
     * @param condition rows from which to draw
     */
    public static List<ErrorTable.Row> draw(
            ErrorTable table, String hash, int count, Predicate<ErrorTable.Row> condition) {
        List<ErrorTable.Row> rows =
                new ArrayList<>(table.rows().stream().filter(condition).toList());
        Collections.shuffle(rows, new Random(Long.parseLong(hash.substring(0, SEED_DIGITS), RADIX)));
        return List.copyOf(rows.subList(0, Math.min(count, rows.size())));
    }

    /**
     * Measures rows again.
     *
     * @param startAlone whether to measure the first {@value ErrorStudy#START_S} s alone, otherwise as long as the
     *     table states
     */
    public static List<TableCheck> measure(List<ErrorTable.Row> rows, boolean startAlone) {
        Map<List<String>, List<ErrorTable.Row>> scenes = new LinkedHashMap<>();
        rows.forEach(row ->
                scenes.computeIfAbsent(row.scene(), s -> new ArrayList<>()).add(row));
        List<TableCheck> checks = new ArrayList<>();
        scenes.values().forEach(scene -> measureScene(scene, startAlone, checks));
        return checks;
    }

    private static void measureScene(List<ErrorTable.Row> rows, boolean startAlone, List<TableCheck> checks) {
        ErrorTable.Row any = rows.get(0);
        Scenario scenario = Scenario.defaults()
                .with(
                        "material=" + any.material(),
                        "preset=" + any.preset(),
                        "resolution=" + any.resolution(),
                        "threads=1");
        double untilS = startAlone ? ErrorStudy.START_S : any.untilS();
        try (BreathRunner runs = new BreathRunner(scenario, SimulationRun.loadThorax(scenario), untilS)) {
            boolean[] sheet = runs.diaphragmNodes();
            Trajectory exact = runs.run(SolverGrid.reference(scenario, 1));
            for (ErrorTable.Row row : rows) {
                double measured = runs.run(row.point().settings()).distanceFrom(exact, sheet)[0];
                double stated =
                        startAlone ? row.point().startRmsMm() : row.point().rmsMm();
                checks.add(new TableCheck(row, stated, measured));
            }
        }
    }

    /** One line on the row, what the table states and what was measured. */
    public String sentence() {
        return String.join(", ", row.scene()) + ", " + row.point().settings().label() + ": stated "
                + format("%.3g mm, measured %.3g mm", statedMm, measuredMm)
                + (holds() ? "" : " (stale)");
    }
}
