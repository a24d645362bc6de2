package org.phrenic.study.error;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.document.CsvTable;
import org.phrenic.document.CsvWriter;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

/**
 * Settings with what they cost and how far from the reference they are: a CSV file that a measurement writes and from
 * which the cheapest setting that keeps an error is chosen. Costs were measured once; to choose takes no measurement,
 * so the same request gives the same setting on every machine.
 *
 * @param name of the file, for sentences
 * @param rows in the order of the file
 */
public record ErrorTable(String name, List<Row> rows) {
    private static final String SHIPPED = "/org/phrenic/data/error/settings.csv";
    private static final int DIGITS = 4;
    private static final List<String> HEADER = List.of(
            "material",
            "preset",
            "resolution",
            "nodes",
            "integrator",
            "time_step_s",
            "projection_sweeps",
            "refresh_s",
            "substeps",
            "rms_mm",
            "max_mm",
            "rms_percent",
            "max_percent",
            "all_rms_mm",
            "all_max_mm",
            "cpu_s",
            "wall_s",
            "real_time",
            "front",
            "usual");

    /**
     * A setting of a scene.
     *
     * @param material label of the material
     * @param preset breathing
     * @param resolution label
     * @param nodes how many springs move
     * @param rmsPercent rms error of the diaphragm in per cent of the domes' excursion
     * @param maxPercent greatest error in per cent of it
     * @param point what was measured
     */
    public record Row(
            String material,
            String preset,
            String resolution,
            int nodes,
            double rmsPercent,
            double maxPercent,
            ErrorPoint point) {
        private boolean sameScene(Row other) {
            return material.equals(other.material)
                    && preset.equals(other.preset)
                    && resolution.equals(other.resolution);
        }
    }

    /**
     * A setting that was chosen.
     *
     * @param settings the setting
     * @param sentence what was chosen, and why
     */
    public record Chosen(SolverSettings settings, String sentence) {}

    public ErrorTable {
        rows = List.copyOf(rows);
    }

    /** The table that comes with the program. */
    public static ErrorTable shipped() {
        try (InputStream in = ErrorTable.class.getResourceAsStream(SHIPPED)) {
            if (in == null) {
                throw new IllegalStateException("the table of errors is missing from the program");
            }
            return of(
                    CsvTable.parse("settings.csv", new String(in.readAllBytes(), StandardCharsets.UTF_8)),
                    "settings.csv");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Reads a table.
     *
     * @throws BadInputException with one sentence that names file, line and column
     */
    public static ErrorTable read(Path file) {
        return of(CsvTable.read(file), file.getFileName().toString());
    }

    /** What studies measured. */
    public static ErrorTable of(List<ErrorStudy> studies) {
        List<Row> rows = new ArrayList<>();
        for (ErrorStudy study : studies) {
            Scenario scenario = study.scenario();
            for (ErrorPoint point : study.points()) {
                rows.add(new Row(
                        scenario.material().label(),
                        scenario.preset(),
                        scenario.resolution().name().toLowerCase(Locale.ROOT),
                        study.nodes(),
                        study.percent(point.rmsMm()),
                        study.percent(point.maxMm()),
                        point));
            }
        }
        return new ErrorTable("measurement", rows);
    }

    private static ErrorTable of(CsvTable csv, String name) {
        List<Row> rows = new ArrayList<>();
        List<String> integrators = csv.texts("integrator");
        for (int i = 0; i < csv.rowCount(); i++) {
            IntegratorKind integrator;
            try {
                integrator = IntegratorKind.of(integrators.get(i));
            } catch (IllegalArgumentException unknown) {
                throw csv.badCell(i, "integrator", unknown.getMessage().replaceFirst("^integrator: ", ""));
            }
            SolverSettings settings = new SolverSettings(
                    integrator,
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
                    csv.numbers("cpu_s")[i],
                    csv.numbers("wall_s")[i],
                    csv.numbers("real_time")[i],
                    csv.texts("front").get(i).equals("true"),
                    csv.texts("usual").get(i).equals("true"));
            rows.add(new Row(
                    csv.texts("material").get(i),
                    csv.texts("preset").get(i),
                    csv.texts("resolution").get(i),
                    (int) csv.numbers("nodes")[i],
                    csv.numbers("rms_percent")[i],
                    csv.numbers("max_percent")[i],
                    point));
        }
        return new ErrorTable(name, rows);
    }

    /** This table with the rows of another, which replace those of the same material, breathing and resolution. */
    public ErrorTable with(ErrorTable newer) {
        List<Row> all = new ArrayList<>(rows);
        all.removeIf(old -> newer.rows.stream().anyMatch(old::sameScene));
        all.addAll(newer.rows);
        return new ErrorTable(name, all);
    }

    /** Writes it as {@link #read} takes it. */
    public void write(Path file) {
        CsvWriter.write(file, HEADER, rows.stream().map(ErrorTable::cells).toList());
    }

    private static List<Object> cells(Row row) {
        ErrorPoint p = row.point();
        return List.of(
                row.material(),
                row.preset(),
                row.resolution(),
                row.nodes(),
                p.settings().integrator().label(),
                p.settings().timeStepS(),
                p.settings().sweeps(),
                p.settings().refreshS(),
                p.substeps(),
                number(p.rmsMm()),
                number(p.maxMm()),
                number(row.rmsPercent()),
                number(row.maxPercent()),
                number(p.allRmsMm()),
                number(p.allMaxMm()),
                number(p.cpuS()),
                number(p.wallS()),
                number(p.realTime()),
                p.paretoOptimal(),
                p.isDefault());
    }

    private static String number(double value) {
        return CsvWriter.number(value, DIGITS);
    }

    /**
     * The cheapest setting whose rms error is at most so much. Breathing that was not measured is taken for the quiet
     * one, a resolution that was not for the finest that was; the sentence names what was measured.
     *
     * @param scenario material, resolution and breathing
     * @param maxErrorMm rms over the diaphragm's nodes and the whole breath, mm
     * @throws BadInputException with one sentence, if none keeps it or the scene was not measured
     */
    public Chosen cheapest(Scenario scenario, double maxErrorMm) {
        String material = scenario.material().label();
        String wanted = scenario.resolution().name().toLowerCase(Locale.ROOT);
        List<Row> sameMaterial =
                rows.stream().filter(r -> r.material().equals(material)).toList();
        boolean measured = sameMaterial.stream().anyMatch(r -> r.resolution().equals(wanted));
        // Where errors come from (step, projection, folds that snap) the resolutions are alike: the finest measured
        // stands for one that was not.
        String resolution = measured
                ? wanted
                : sameMaterial.stream()
                        .max(Comparator.comparingInt(Row::nodes))
                        .map(Row::resolution)
                        .orElse(wanted);
        List<Row> scene = sameMaterial.stream()
                .filter(r -> r.resolution().equals(resolution))
                .toList();
        boolean known = scene.stream().anyMatch(r -> r.preset().equals(scenario.preset()));
        String preset = known ? scenario.preset() : Scenario.defaults().preset();
        List<Row> candidates =
                scene.stream().filter(r -> r.preset().equals(preset)).toList();
        if (candidates.isEmpty()) {
            throw new BadInputException("--max-error: found no measurement of material " + material + " in " + name
                    + ", expected one (phrenic bench error --write)");
        }
        Optional<Row> cheapest = candidates.stream()
                .filter(r -> r.point().rmsMm() <= maxErrorMm)
                .min(Comparator.comparingDouble(r -> r.point().cpuS()));
        if (cheapest.isEmpty()) {
            double least = candidates.stream()
                    .mapToDouble(r -> r.point().rmsMm())
                    .min()
                    .orElseThrow();
            throw new BadInputException(String.format(
                    Locale.ROOT,
                    "--max-error: found %s mm, expected at least %.3g mm, the least that was measured for material %s at"
                            + " resolution %s",
                    plain(maxErrorMm),
                    least,
                    material,
                    resolution));
        }
        Row row = cheapest.get();
        String sentence = String.format(
                Locale.ROOT,
                "For an error of at most %s mm rms of the diaphragm: %s; measured %.3g mm rms (%.2g %% of the excursion),"
                        + " %.3g mm at worst, on a %s breath of the virtual adult male at %s resolution.",
                plain(maxErrorMm),
                row.point().settings().label(),
                row.point().rmsMm(),
                row.rmsPercent(),
                row.point().maxMm(),
                preset,
                resolution);
        return new Chosen(row.point().settings(), sentence);
    }

    private static String plain(double mm) {
        return String.format(Locale.ROOT, "%.6g", mm)
                .replaceFirst("(\\.\\d*?)0+$", "$1")
                .replaceFirst("\\.$", "");
    }
}
