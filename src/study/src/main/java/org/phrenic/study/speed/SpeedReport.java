package org.phrenic.study.speed;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.ReportValues;

/** A {@link SpeedStudy} as tables, Markdown, CSV and values for JSON. */
public record SpeedReport(SpeedStudy study) {

    /** Measured cell of table 1 for a number of threads. */
    private record Cell(int threads, SpeedTable.Row row, double speedup, double realTimeFactor) {
        String resolution() {
            return ReportNumbers.label(row.resolution());
        }

        double published() {
            return row.forces().publishedStepsPerS(row.resolution());
        }

        double nanosPerNodeStep() {
            return 1e9 / row.stepsPerS() / row.vertices();
        }

        Map<String, Object> values() {
            return new OrderedValues()
                    .with("forces", row.forces().label())
                    .with("resolution", resolution())
                    .with("vertices", row.vertices())
                    .with("threads", threads)
                    .with("paper_steps_per_s", published())
                    .with("steps_per_s", row.stepsPerS())
                    .with("times_the_paper", speedup())
                    .with("realtime_factor", realTimeFactor)
                    .with("ns_per_node_step", nanosPerNodeStep())
                    .with("trials_steps_per_s", row.trials());
        }
    }

    private List<Cell> cells() {
        List<Cell> cells = new ArrayList<>();
        study.tables().forEach((threads, table) -> table.resolutions().forEach(resolution -> {
            for (SpeedCase forces : SpeedCase.values()) {
                SpeedTable.Row row = table.row(resolution, forces);
                double speedup = study.speedupOverPaper(threads, resolution, forces);
                cells.add(new Cell(threads, row, speedup, row.stepsPerS() * study.stepS()));
            }
        }));
        return cells;
    }

    /** Table 1 of the paper with the measured values: a header and one row per cell. */
    public List<List<String>> table() {
        List<List<String>> rows = new ArrayList<>();
        String header =
                "forces;resolution;vertices;threads;paper, steps/s;steps/s;times the paper;real time;ns a node-step";
        rows.add(List.of(header.split(";", -1)));
        for (Cell cell : cells()) {
            rows.add(List.of(
                    cell.row().forces().label(),
                    cell.resolution(),
                    String.valueOf(cell.row().vertices()),
                    String.valueOf(cell.threads()),
                    format("%.2f", cell.published()),
                    format("%.0f", cell.row().stepsPerS()),
                    format("%.0f", cell.speedup()),
                    format("%.1f", cell.realTimeFactor()),
                    format("%.1f", cell.nanosPerNodeStep())));
        }
        return rows;
    }

    /** Relative cost of rib motion by resolution and threads, with the value from the paper. */
    public List<List<String>> ribMotionOverhead() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("resolution", "threads", "rib motion adds, %", "paper, %"));
        SpeedTable paper = SpeedTable.published();
        study.tables().forEach((threads, table) -> {
            for (Resolution resolution : table.resolutions()) {
                double published = paper.overheadPercent(resolution, SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY);
                rows.add(List.of(
                        ReportNumbers.label(resolution),
                        String.valueOf(threads),
                        format("%.1f", study.ribMotionOverheadPercent(threads, resolution)),
                        format("%.1f", published)));
            }
        });
        return rows;
    }

    /** The bare workload by size: a header and one row per size and number of threads. */
    public List<List<String>> scaling() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("nodes", "springs", "threads", "kernel", "steps/s", "ns a node-step"));
        for (SizeScaling.Row row : study.scaling().rows()) {
            rows.add(List.of(
                    String.valueOf(row.nodes()),
                    String.valueOf(row.springs()),
                    String.valueOf(row.threads()),
                    row.kernel(),
                    format("%.4g", row.stepsPerS()),
                    format("%.1f", row.nanosPerNodeStep())));
        }
        return rows;
    }

    /** Describes how the cost scales with size. */
    public String exponent() {
        return format(
                "On one thread the time of a step grows as the number of nodes to the power %.3f.",
                study.scaling().exponent());
    }

    /**
     * The whole report.
     *
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument(
                "Speed",
                "Table 1 of Villard, Bourne and Bello 2009 (a dual-core processor of 2.4 GHz, Java 1.6, 2008; their"
                        + " scheme evaluates forces twice a step) and the same scenes here: their material and step of"
                        + " 0.01 s, velocity Verlet. Median of the trials; processor time on one thread, the clock on"
                        + " several.");
        report.points(provenance.toArray(String[]::new));
        add(report, table());
        add(report, ribMotionOverhead());
        report.section("Against the number of nodes");
        report.paragraph("The bare workload (springs with dashpots, loads, no links) on the virtual body's diaphragm.");
        add(report, scaling());
        report.paragraph(exponent());
        return report;
    }

    private static void add(ReportDocument report, List<List<String>> rows) {
        report.table("", rows.get(0).stream().map(Column::text).toList(), rows.subList(1, rows.size()));
    }

    /** One line per cell of the table, then one line per size. */
    public String csv() {
        List<List<String>> rows = new ArrayList<>();
        for (Cell cell : cells()) {
            SpeedTable.Row row = cell.row();
            rows.add(line(
                    row.forces().label(),
                    new int[] {cell.threads(), row.vertices()},
                    row.stepsPerS(),
                    cell.nanosPerNodeStep(),
                    cell.published(),
                    cell.realTimeFactor()));
        }
        for (SizeScaling.Row row : study.scaling().rows()) {
            int[] counts = {row.threads(), row.nodes()};
            rows.add(line("bare sheet", counts, row.stepsPerS(), row.nanosPerNodeStep(), Double.NaN, Double.NaN));
        }
        String header = "scene threads nodes steps_per_s ns_per_node_step paper_steps_per_s realtime_factor";
        return CsvWriter.format(List.of(header.split(" ")), rows);
    }

    private static List<String> line(String scene, int[] counts, double... figures) {
        List<String> line = new ArrayList<>(List.of(scene));
        for (int count : counts) {
            line.add(String.valueOf(count));
        }
        for (double figure : figures) {
            line.add(CsvWriter.number(figure, CsvWriter.ALL_DIGITS));
        }
        return line;
    }

    /** The study as values for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("step_s", study.stepS());
        map.put("table", cells().stream().map(Cell::values).toList());
        List<Object> ribs = new ArrayList<>();
        study.tables().forEach((threads, rows) -> rows.resolutions().forEach(resolution -> {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("resolution", ReportNumbers.label(resolution));
            each.put("threads", threads);
            each.put("rib_motion_adds_percent", study.ribMotionOverheadPercent(threads, resolution));
            ribs.add(each);
        }));
        map.put("rib_motion", ribs);
        List<Object> scaling = new ArrayList<>();
        for (SizeScaling.Row row : study.scaling().rows()) {
            Map<String, Object> each = ReportValues.of(row);
            each.put("ns_per_node_step", row.nanosPerNodeStep());
            scaling.add(each);
        }
        map.put("scaling", scaling);
        map.put("scaling_exponent", study.scaling().exponent());
        return map;
    }
}
