package org.phrenic.study.speed;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.CsvWriter;

/** A {@link SpeedStudy} as tables, Markdown, CSV and values for JSON. */
public final class SpeedReport {
    private static final String NOTICE = "For research and training only. Not for clinical use.";

    private final SpeedStudy study;

    public SpeedReport(SpeedStudy study) {
        this.study = study;
    }

    private record Cell(int threads, SpeedTable.Row row) {}

    private List<Cell> cells() {
        List<Cell> cells = new ArrayList<>();
        study.tables().forEach((threads, table) -> table.resolutions().forEach(resolution -> {
            for (SpeedCase forces : SpeedCase.values()) {
                cells.add(new Cell(threads, table.row(resolution, forces)));
            }
        }));
        return cells;
    }

    private static String name(Resolution resolution) {
        return resolution.name().toLowerCase(Locale.ROOT);
    }

    private static double published(SpeedTable.Row row) {
        return row.forces().publishedStepsPerS(row.resolution());
    }

    private double realTimeFactor(SpeedTable.Row row) {
        return row.stepsPerS() * study.stepS();
    }

    private static double nanosPerNodeStep(SpeedTable.Row row) {
        return 1e9 / row.stepsPerS() / row.vertices();
    }

    /** The paper's table 1, ours beside it: a header and a row a cell. */
    public List<List<String>> table() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of(
                "forces",
                "resolution",
                "vertices",
                "threads",
                "paper, steps/s",
                "steps/s",
                "times the paper",
                "real time",
                "ns a node-step"));
        for (Cell cell : cells()) {
            SpeedTable.Row row = cell.row();
            rows.add(List.of(
                    row.forces().label(),
                    name(row.resolution()),
                    String.valueOf(row.vertices()),
                    String.valueOf(cell.threads()),
                    String.format(Locale.ROOT, "%.2f", published(row)),
                    String.format(Locale.ROOT, "%.0f", row.stepsPerS()),
                    String.format(Locale.ROOT, "%.0f", row.stepsPerS() / published(row)),
                    String.format(Locale.ROOT, "%.1f", realTimeFactor(row)),
                    String.format(Locale.ROOT, "%.1f", nanosPerNodeStep(row))));
        }
        return rows;
    }

    /** What rib motion adds to a step, by resolution and threads, and what the paper's figures say. */
    public List<List<String>> ribMotionOverhead() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("resolution", "threads", "rib motion adds, %", "paper, %"));
        SpeedTable paper = SpeedTable.published();
        study.tables().forEach((threads, table) -> table.resolutions()
                .forEach(resolution -> rows.add(List.of(
                        name(resolution),
                        String.valueOf(threads),
                        String.format(Locale.ROOT, "%.1f", study.ribMotionOverheadPercent(threads, resolution)),
                        String.format(
                                Locale.ROOT,
                                "%.1f",
                                paper.overheadPercent(resolution, SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY))))));
        return rows;
    }

    /** The bare workload by size: a header and a row a size and count of threads. */
    public List<List<String>> scaling() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("nodes", "springs", "threads", "kernel", "steps/s", "ns a node-step"));
        for (SizeScaling.Row row : study.scaling().rows()) {
            rows.add(List.of(
                    String.valueOf(row.nodes()),
                    String.valueOf(row.edges()),
                    String.valueOf(row.threads()),
                    row.kernel(),
                    String.format(Locale.ROOT, "%.4g", row.stepsPerSecond()),
                    String.format(Locale.ROOT, "%.1f", row.nanosPerNodeStep())));
        }
        return rows;
    }

    /** How the cost grows. */
    public String exponent() {
        return String.format(
                Locale.ROOT,
                "On one thread a step takes nodes to the power of %.3f.",
                study.scaling().exponent());
    }

    /** The whole report as Markdown. */
    public String markdown() {
        return "# Speed\n\n"
                + "Table 1 of Villard, Bourne and Bello 2009 (a dual-core processor of 2.4 GHz, Java 1.6, 2008; their scheme evaluates"
                + " forces twice a step) and the same scenes here: their material and step of 0.01 s, velocity Verlet."
                + " Median of the trials; processor time on one thread, the clock on several.\n\n"
                + markdown(table()) + "\n" + markdown(ribMotionOverhead())
                + "\n## Against the number of nodes\n\nThe bare workload (springs with dashpots, loads, no links) on the"
                + " virtual body's diaphragm.\n\n"
                + markdown(scaling()) + "\n" + exponent() + "\n\n" + NOTICE + "\n";
    }

    private static String markdown(List<List<String>> rows) {
        StringBuilder text = new StringBuilder();
        for (int r = 0; r < rows.size(); r++) {
            text.append("| ").append(String.join(" | ", rows.get(r))).append(" |\n");
            if (r == 0) {
                text.append("|---".repeat(rows.get(0).size())).append("|\n");
            }
        }
        return text.toString();
    }

    /** A line a cell of the table, then a line a size. */
    public String csv() {
        List<List<String>> rows = new ArrayList<>();
        for (Cell cell : cells()) {
            SpeedTable.Row row = cell.row();
            rows.add(line(
                    row.forces().label(),
                    cell.threads(),
                    row.vertices(),
                    row.stepsPerS(),
                    nanosPerNodeStep(row),
                    published(row),
                    realTimeFactor(row)));
        }
        for (SizeScaling.Row row : study.scaling().rows()) {
            rows.add(line(
                    "bare sheet",
                    row.threads(),
                    row.nodes(),
                    row.stepsPerSecond(),
                    row.nanosPerNodeStep(),
                    Double.NaN,
                    Double.NaN));
        }
        return CsvWriter.format(
                List.of(
                        "scene",
                        "threads",
                        "nodes",
                        "steps_per_s",
                        "ns_per_node_step",
                        "paper_steps_per_s",
                        "realtime_factor"),
                rows);
    }

    private static List<String> line(String scene, int threads, int nodes, double... figures) {
        List<String> line = new ArrayList<>(List.of(scene, String.valueOf(threads), String.valueOf(nodes)));
        for (double figure : figures) {
            line.add(CsvWriter.number(figure, CsvWriter.ALL_DIGITS));
        }
        return line;
    }

    /** All of it as values, for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", NOTICE);
        map.put("step_s", study.stepS());
        List<Object> table = new ArrayList<>();
        for (Cell cell : cells()) {
            SpeedTable.Row row = cell.row();
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("forces", row.forces().label());
            each.put("resolution", name(row.resolution()));
            each.put("vertices", row.vertices());
            each.put("threads", cell.threads());
            each.put("paper_steps_per_s", published(row));
            each.put("steps_per_s", row.stepsPerS());
            each.put("times_the_paper", row.stepsPerS() / published(row));
            each.put("realtime_factor", realTimeFactor(row));
            each.put("ns_per_node_step", nanosPerNodeStep(row));
            each.put("trials_steps_per_s", row.trials());
            table.add(each);
        }
        map.put("table", table);
        List<Object> ribs = new ArrayList<>();
        study.tables().forEach((threads, rows) -> rows.resolutions().forEach(resolution -> {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("resolution", name(resolution));
            each.put("threads", threads);
            each.put("rib_motion_adds_percent", study.ribMotionOverheadPercent(threads, resolution));
            ribs.add(each);
        }));
        map.put("rib_motion", ribs);
        List<Object> scaling = new ArrayList<>();
        for (SizeScaling.Row row : study.scaling().rows()) {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("nodes", row.nodes());
            each.put("springs", row.edges());
            each.put("threads", row.threads());
            each.put("kernel", row.kernel());
            each.put("steps_per_s", row.stepsPerSecond());
            each.put("ns_per_node_step", row.nanosPerNodeStep());
            scaling.add(each);
        }
        map.put("scaling", scaling);
        map.put("scaling_exponent", study.scaling().exponent());
        return map;
    }
}
