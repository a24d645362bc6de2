package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.ShippedFile;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;

/**
 * Cost and error of measured solver settings, stored as CSV. The cheapest setting within an error bound is chosen from
 * it without a new measurement, so the choice is the same on every machine.
 *
 * @param name file name, for messages
 * @param rows in the order of the file
 */
public record ErrorTable(String name, List<Row> rows) {
    /** A table without rows. */
    public static final ErrorTable EMPTY = new ErrorTable("empty table", List.of());

    private static final int DIGITS = 4;
    /** Digits of an error in a message. */
    private static final int STATED_DIGITS = 3;

    private static final List<String> HEADER =
            List.of(("material preset resolution nodes until_s uncertainty_mm integrator time_step_s"
                            + " projection_sweeps refresh_s substeps rms_mm max_mm rms_percent max_percent all_rms_mm"
                            + " all_max_mm start_rms_mm cpu_s wall_s real_time front usual")
                    .split(" "));
    /** First measured column; values from here on are rounded in the file. */
    private static final int FIRST_MEASURED = HEADER.indexOf("rms_mm");

    /**
     * One setting of a scene.
     *
     * @param material label of the material
     * @param preset breathing preset
     * @param resolution label of the resolution
     * @param nodes number of nodes moved by springs
     * @param untilS simulated time, s
     * @param uncertaintyMm rms distance between the reference and the same with twice the step, mm
     * @param rmsPercent rms error of the diaphragm in per cent of the domes' excursion
     * @param maxPercent maximum error in per cent of the domes' excursion
     * @param point measured cost and error
     */
    public record Row(
            String material,
            String preset,
            String resolution,
            int nodes,
            double untilS,
            double uncertaintyMm,
            double rmsPercent,
            double maxPercent,
            ErrorPoint point) {
        List<String> scene() {
            return List.of(material, preset, resolution);
        }

        private Row with(ErrorPoint other) {
            return new Row(material, preset, resolution, nodes, untilS, uncertaintyMm, rmsPercent, maxPercent, other);
        }

        /** Upper bound of the error, mm: the rms distance from the reference and the reference's uncertainty. */
        double boundMm() {
            return point.rmsMm() + uncertaintyMm;
        }

        /** Setting, cost and error by column name. */
        Map<String, Object> measurement() {
            SolverSettings settings = point.settings();
            Object[] values = {
                settings.integrator().label(),
                settings.timeStepS(),
                settings.sweeps(),
                settings.refreshS(),
                point.substeps(),
                point.rmsMm(),
                point.maxMm(),
                rmsPercent,
                maxPercent,
                point.allRmsMm(),
                point.allMaxMm(),
                point.startRmsMm(),
                point.cpuS(),
                point.wallS(),
                point.realTime(),
                point.paretoOptimal(),
                point.isDefault()
            };
            Map<String, Object> map = new LinkedHashMap<>();
            int scene = HEADER.size() - values.length;
            for (int i = 0; i < values.length; i++) {
                map.put(HEADER.get(scene + i), values[i]);
            }
            return map;
        }

        private List<Object> cells() {
            List<Object> cells = new ArrayList<>(
                    List.of(material, preset, resolution, nodes, untilS, CsvWriter.number(uncertaintyMm, DIGITS)));
            for (Object value : measurement().values()) {
                boolean rounded = cells.size() >= FIRST_MEASURED && value instanceof Double;
                cells.add(rounded ? CsvWriter.number((double) value, DIGITS) : value);
            }
            return cells;
        }
    }

    public ErrorTable {
        rows = List.copyOf(rows);
    }

    /** The table distributed with the program. */
    public static ErrorTable shipped() {
        return of(CsvTable.parse("settings.csv", ShippedFile.text("error/settings.csv")), "settings.csv");
    }

    /**
     * Reads a table.
     *
     * @throws BadInputException with one sentence that names file, line and column
     */
    public static ErrorTable read(Path file) {
        return of(CsvTable.read(file), file.getFileName().toString());
    }

    /** The table of measured studies. */
    public static ErrorTable of(List<ErrorStudy> studies) {
        List<Row> rows = new ArrayList<>();
        for (ErrorStudy study : studies) {
            Scenario scenario = study.scenario();
            for (ErrorPoint point : study.points()) {
                rows.add(new Row(
                        scenario.material().label(),
                        scenario.preset(),
                        ReportNumbers.label(scenario.resolution()),
                        study.nodes(),
                        study.simulatedS(),
                        study.referenceUncertainty()[0],
                        study.percent(point.rmsMm()),
                        study.percent(point.maxMm()),
                        point));
            }
        }
        return new ErrorTable("measurement", rows);
    }

    private static ErrorTable of(CsvTable csv, String name) {
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < csv.rowCount(); i++) {
            rows.add(row(csv, i));
        }
        return new ErrorTable(name, rows);
    }

    private static Row row(CsvTable csv, int i) {
        SolverSettings settings = new SolverSettings(
                integrator(csv, i),
                csv.numbers("time_step_s")[i],
                (int) csv.numbers("projection_sweeps")[i],
                csv.numbers("refresh_s")[i]);
        ErrorPoint point = new ErrorPoint(
                settings,
                (int) csv.numbers("substeps")[i],
                csv.numbers("rms_mm")[i],
                csv.numbers("max_mm")[i],
                csv.numbers("all_rms_mm")[i],
                csv.numbers("all_max_mm")[i],
                csv.numbers("start_rms_mm")[i],
                csv.numbers("cpu_s")[i],
                csv.numbers("wall_s")[i],
                csv.numbers("until_s")[i] / csv.numbers("cpu_s")[i],
                csv.texts("front").get(i).equals("true"),
                csv.texts("usual").get(i).equals("true"));
        return new Row(
                csv.texts("material").get(i),
                csv.texts("preset").get(i),
                csv.texts("resolution").get(i),
                (int) csv.numbers("nodes")[i],
                csv.numbers("until_s")[i],
                csv.numbers("uncertainty_mm")[i],
                csv.numbers("rms_percent")[i],
                csv.numbers("max_percent")[i],
                point);
    }

    private static IntegratorKind integrator(CsvTable csv, int row) {
        String label = csv.texts("integrator").get(row);
        List<IntegratorKind> kinds = List.of(IntegratorKind.values());
        return kinds.stream()
                .filter(kind -> kind.label().equalsIgnoreCase(label))
                .findFirst()
                .orElseThrow(() -> csv.badCell(
                        row,
                        "integrator",
                        "found '" + label + "', expected one of "
                                + kinds.stream().map(IntegratorKind::label).collect(Collectors.joining(", "))));
    }

    /**
     * Merges two tables. Rows of {@code newer}, which has all settings of its scenes, replace those of the same
     * material, preset and resolution.
     */
    public ErrorTable with(ErrorTable newer) {
        List<Row> all = new ArrayList<>(rows);
        all.removeIf(old -> newer.rows.stream().anyMatch(row -> row.scene().equals(old.scene())));
        all.addAll(newer.rows);
        return new ErrorTable(name, all);
    }

    /**
     * Merges some settings into their scenes. Rows of {@code newer} replace those of the same scene and setting; the
     * front of such a scene is that of all its rows.
     */
    public ErrorTable withSettings(ErrorTable newer) {
        List<Row> all = new ArrayList<>(rows);
        for (Row row : newer.rows) {
            all.removeIf(old -> old.scene().equals(row.scene())
                    && old.point().settings().equals(row.point().settings()));
            all.add(row);
        }
        for (List<String> scene : newer.rows.stream().map(Row::scene).distinct().toList()) {
            List<Row> same =
                    all.stream().filter(row -> row.scene().equals(scene)).toList();
            double leastMm = ErrorStudy.RESOLVED
                    * same.stream().mapToDouble(Row::uncertaintyMm).max().orElseThrow();
            List<ErrorPoint> marked =
                    ErrorStudy.withParetoFront(same.stream().map(Row::point).toList(), leastMm);
            all.removeAll(same);
            for (int i = 0; i < same.size(); i++) {
                all.add(same.get(i).with(marked.get(i)));
            }
        }
        return new ErrorTable(name, all);
    }

    /**
     * Requires that the rows of a scene, if there are some, are of a simulated time: costs and errors of another do not
     * compare.
     *
     * @throws BadInputException with one sentence, if they are not
     */
    public void requireTime(Scenario scenario, double simulatedS) {
        List<String> scene =
                List.of(scenario.material().label(), scenario.preset(), ReportNumbers.label(scenario.resolution()));
        rows.stream()
                .filter(row -> row.scene().equals(scene))
                .filter(row -> Math.abs(row.untilS() - simulatedS) > BreathRunner.SAMPLE_S / 2)
                .findFirst()
                .ifPresent(row -> {
                    String stated = SolverSettings.number(row.untilS());
                    throw new BadInputException(name + ": found rows of " + String.join(", ", scene) + " over "
                            + stated + " s, expected the " + SolverSettings.number(simulatedS)
                            + " s of the new ones (--until " + stated + ", or all settings)");
                });
    }

    /** Writes the table in the format of {@link #read}. */
    public void write(Path file) {
        CsvWriter.write(file, HEADER, rows.stream().map(Row::cells).toList());
    }

    /**
     * The cheapest setting whose rms error and the uncertainty of its reference together do not exceed a bound. For a
     * preset without measurements the quiet preset is used, for such a resolution the finest measured one; the row
     * names what was used.
     *
     * @param scenario material, resolution and breathing
     * @param maxErrorMm rms over the diaphragm's nodes and the whole breath, mm
     * @throws BadInputException with one sentence, if no setting satisfies the bound or the scene was not measured
     */
    public SettingChoice cheapest(Scenario scenario, double maxErrorMm) {
        String material = scenario.material().label();
        List<Row> sameMaterial =
                rows.stream().filter(r -> r.material().equals(material)).toList();
        String resolution = measuredResolution(sameMaterial, ReportNumbers.label(scenario.resolution()));
        List<Row> scene = sameMaterial.stream()
                .filter(r -> r.resolution().equals(resolution))
                .toList();
        boolean known = scene.stream().anyMatch(r -> r.preset().equals(scenario.preset()));
        String preset = known ? scenario.preset() : Scenario.defaults().preset();
        List<Row> candidates =
                scene.stream().filter(r -> r.preset().equals(preset)).toList();
        double least = candidates.stream()
                .mapToDouble(Row::boundMm)
                .min()
                .orElseThrow(() -> new BadInputException("--max-error: found no measurement of material " + material
                        + " in " + name + ", expected one (phrenic bench error --write)"));
        Row row = candidates.stream()
                .filter(r -> r.boundMm() <= maxErrorMm)
                .min(Comparator.comparingDouble(r -> r.point().cpuS()))
                .orElseThrow(() -> new BadInputException(format(
                        "--max-error: found %s mm, expected at least %.3g mm, the least that was measured for material"
                                + " %s at resolution %s",
                        SettingChoice.number(maxErrorMm), upward(least), material, resolution)));
        return new SettingChoice(row, maxErrorMm);
    }

    /** A bound with as many digits as a message states, not below it: what is stated is accepted. */
    private static double upward(double mm) {
        return BigDecimal.valueOf(mm)
                .round(new MathContext(STATED_DIGITS, RoundingMode.CEILING))
                .doubleValue();
    }

    /**
     * The wanted resolution if measured, otherwise the finest measured one: time step and projection errors hardly
     * depend on resolution.
     */
    private static String measuredResolution(List<Row> rows, String wanted) {
        return rows.stream().anyMatch(r -> r.resolution().equals(wanted))
                ? wanted
                : rows.stream()
                        .max(Comparator.comparingInt(Row::nodes))
                        .map(Row::resolution)
                        .orElse(wanted);
    }
}
