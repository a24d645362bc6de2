package org.phrenic.study.validation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.Key;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.engine.parallel.BatchRunner;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.Attempts;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.ReportValues;

/**
 * Excursion of the liver in the four kinds of breathing used during interventions on it (quiet, deep, held at
 * expiration, held at inspiration), with published ranges.
 *
 * @param rows one per body and preset
 * @param failures bodies and presets whose breath could not be computed, with their reasons
 */
public record LiverMotion(List<Row> rows, List<String> failures) {
    /** Breathing presets, in report order. */
    public static final List<String> PRESETS = List.of("quiet", "deep", "hold-expiration", "hold-inspiration");

    private static final List<String> AXES = List.of("liver_si_mm", "liver_ap_mm", "liver_lr_mm");
    private static final Set<String> MEASURED = Set.of("liver_top_mm", "liver_edge_mm");
    /** Initial part of a hold that is ignored, s: the tissue still settles from the breath. */
    private static final int SETTLING_S = 1;

    /**
     * Results for one body and preset.
     *
     * @param body as requested
     * @param preset of breathing
     * @param siMm descent of the whole liver from end-expiration to end-inspiration, mm; for a hold at expiration, in
     *     the breath before the hold
     * @param apMm forward excursion, mm; negative if the liver goes back
     * @param lrMm left-right excursion, mm
     * @param topMm descent of the liver's highest fifth, mm
     * @param edgeMm descent of the liver's lowest fifth, mm
     * @param domeMm descent of the right dome of the diaphragm, mm
     * @param liverCreepMm rise of the liver during the hold, after its first second, mm; NaN without a hold
     * @param domeCreepMm rise of the right dome during the hold, likewise, mm
     * @param referenceRanges published ranges of SI, AP, LR and dome creep; empty where none is known
     */
    public record Row(
            String body,
            String preset,
            double siMm,
            double apMm,
            double lrMm,
            double topMm,
            double edgeMm,
            @Key("dome_right_mm") double domeMm,
            double liverCreepMm,
            double domeCreepMm,
            List<Optional<ReferenceRange>> referenceRanges) {
        public Row {
            referenceRanges = List.copyOf(referenceRanges);
        }

        private Map<String, Object> values() {
            Map<String, Object> values = ReportValues.of(this);
            values.remove("reference_ranges");
            return values;
        }

        /** The values with a possible reference range: SI, AP, LR, creep of the dome. */
        public double[] comparedValues() {
            return new double[] {siMm, apMm, lrMm, domeCreepMm};
        }
    }

    public LiverMotion {
        rows = List.copyOf(rows);
        failures = List.copyOf(failures);
    }

    /**
     * Runs the study.
     *
     * @param settings of all runs; preset and anatomy are replaced
     * @param anatomies virtual bodies or folders
     * @param threads number of concurrent runs
     */
    public static LiverMotion of(
            PhysiologyTable table, Scenario settings, List<String> anatomies, int threads, ProgressListener progress) {
        List<BatchRunner.Job<Row>> jobs = new ArrayList<>();
        for (String anatomy : anatomies) {
            Scenario on = settings.with("threads=1")
                    .with(List.of(Assignment.read("--anatomy " + anatomy, "anatomy", anatomy)));
            Thorax thorax = SimulationRun.loadThorax(on);
            for (String preset : PRESETS) {
                Scenario run = on.with("preset=" + preset);
                jobs.add(new BatchRunner.Job<>(
                        anatomy + ", " + preset, () -> row(anatomy, preset, breath(anatomy, run, thorax), table)));
            }
        }
        Attempts<Row> done = Attempts.of(jobs, threads, progress);
        return new LiverMotion(done.results(), done.failures());
    }

    private static BreathSeries breath(String anatomy, Scenario scenario, Thorax thorax) {
        if (!scenario.get(OrganSettings.LIVER)
                || thorax.structuresOf(StructureKind.LIVER).isEmpty()) {
            throw new BadInputException(
                    "found no liver in " + anatomy + ", expected a body with a liver, and liver=true");
        }
        return PresetRun.of(scenario, thorax, PresetRun.SAMPLE_S, MEASURED);
    }

    /** Evaluates one run. */
    static Row row(String body, String preset, BreathSeries series, PhysiologyTable table) {
        int held = series.firstHeldRow();
        int deepest = preset.equals("hold-expiration") ? deepest(series, held) : series.endInspirationRow(0);
        int start = preset.equals("hold-expiration") ? 0 : series.endExpirationRow(0);
        List<Optional<ReferenceRange>> known = new ArrayList<>();
        // The depth of a held breath is that of quiet breathing for a hold at expiration, of deep breathing at
        // inspiration.
        String as = preset.equals("hold-expiration") ? "quiet" : preset.equals("hold-inspiration") ? "deep" : preset;
        AXES.forEach(axis -> known.add(known(table, as, axis, Reduction.SIZE)));
        // The table has no creep range for a hold at expiration.
        known.add(known(table, preset, "dome_right_mm", Reduction.CREEP));
        double si = descent(series, "liver_si_mm", start, deepest);
        // The observable is positive toward the back.
        double ap = descent(series, "liver_ap_mm", start, deepest);
        double lr = Math.abs(descent(series, "liver_lr_mm", start, deepest));
        double top = descent(series, "liver_top_mm", start, deepest);
        double edge = descent(series, "liver_edge_mm", start, deepest);
        double dome = descent(series, "dome_right_mm", start, deepest);
        double creep = creep(series, "dome_right_mm");
        return new Row(body, preset, si, ap, lr, top, edge, dome, creep(series, "liver_si_mm"), creep, known);
    }

    /** Row before a given one at which the right dome is lowest. */
    private static int deepest(BreathSeries series, int before) {
        int best = 0;
        for (int i = 0; i < before; i++) {
            best = series.value("dome_right_mm", i) < series.value("dome_right_mm", best) ? i : best;
        }
        return best;
    }

    private static double descent(BreathSeries series, String column, int from, int to) {
        return series.hasColumn(column) ? series.value(column, from) - series.value(column, to) : Double.NaN;
    }

    private static double creep(BreathSeries series, String column) {
        if (series.firstHeldRow() < 0) {
            return Double.NaN;
        }
        int from = series.firstHeldRow() + (int) Math.round(SETTLING_S / PresetRun.SAMPLE_S);
        int to = series.lastRow(0);
        return from < to ? series.value(column, to) - series.value(column, from) : Double.NaN;
    }

    /** The first range of the table for an observable and a preset. */
    private static Optional<ReferenceRange> known(
            PhysiologyTable table, String preset, String observable, Reduction reduction) {
        return table.ranges().stream()
                .filter(r -> r.preset().equals(Optional.of(preset))
                        && r.reduction() == reduction
                        && r.observables().equals(List.of(observable))
                        && r.body().isEmpty())
                .findFirst();
    }

    /** Table cells with header; ranges are in brackets and values outside their range are marked. */
    public List<List<String>> table() {
        List<List<String>> lines = new ArrayList<>();
        lines.add(List.of(
                "body", "preset", "SI mm", "AP mm", "LR mm", "top mm", "edge mm", "dome mm", "creep mm", "of dome mm"));
        for (Row r : rows) {
            List<String> line = new ArrayList<>(List.of(r.body(), r.preset(), cell(r, 0), cell(r, 1), cell(r, 2)));
            DoubleStream.of(r.topMm(), r.edgeMm(), r.domeMm(), r.liverCreepMm())
                    .mapToObj(ReportNumbers::number)
                    .forEach(line::add);
            line.add(cell(r, 3));
            lines.add(line);
        }
        return lines;
    }

    /**
     * The study as a page.
     *
     * @param settings of all runs
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(Scenario settings, List<String> provenance) {
        ReportDocument page = new ReportDocument(
                "Motion of the liver",
                "At " + ReportNumbers.label(settings.resolution()) + " resolution; values out of their range: "
                        + outOfRangeCount() + ".");
        page.points(provenance.toArray(String[]::new));
        Attempts.addFailures(page, "Not computed", failures);
        page.section("Excursions");
        page.paragraph("From end-expiration to end-inspiration, of a hold at expiration in the breath before it, mm:"
                + " SI down, AP forward, LR to the side, of all vertices; top and edge: descent of the highest and"
                + " the lowest fifth; dome: descent of the right dome; creep: rise of the liver, and of the right"
                + " dome, during a hold after its first second. In brackets: the range of people, where one is known.");
        page.table("", columns(table().get(0)), table().subList(1, rows.size() + 1));
        page.section("Shares");
        page.paragraph("Forward: AP over SI. Top: descent of the top over that of the right dome.");
        page.table("", columns(List.of("body", "preset", "forward", "top")), shares());
        page.section("Ranges");
        page.points(rows.stream()
                .flatMap(r -> r.referenceRanges().stream().flatMap(Optional::stream))
                .distinct()
                .map(r -> r.key() + ": " + ValidationReport.range(r) + " " + r.unit() + ", " + r.source())
                .toArray(String[]::new));
        return page;
    }

    private List<List<String>> shares() {
        return rows.stream()
                .map(r -> List.of(r.body(), r.preset(), share(r.apMm(), r.siMm()), share(r.topMm(), r.domeMm())))
                .toList();
    }

    private static String share(double part, double whole) {
        return ReportNumbers.number(part / whole);
    }

    /** A body and a preset, then numbers. */
    private static List<Column> columns(List<String> headings) {
        return IntStream.range(0, headings.size())
                .mapToObj(i -> new Column(headings.get(i), i > 1))
                .toList();
    }

    private static String cell(Row row, int which) {
        double value = row.comparedValues()[which];
        if (Double.isNaN(value)) {
            return "";
        }
        String text = ReportNumbers.number(value);
        return row.referenceRanges()
                .get(which)
                .map(k -> text + " (" + ValidationReport.range(k) + (k.contains(value) ? ")" : ") OUT"))
                .orElse(text);
    }

    /** Number of measured values outside their range. */
    public long outOfRangeCount() {
        return rows.stream()
                .mapToLong(r -> IntStream.range(0, r.comparedValues().length)
                        .filter(i -> !Double.isNaN(r.comparedValues()[i]))
                        .filter(i -> r.referenceRanges()
                                .get(i)
                                .filter(range -> !range.contains(r.comparedValues()[i]))
                                .isPresent())
                        .count())
                .sum();
    }

    /** The study as values for JSON. */
    public Map<String, Object> values() {
        return new OrderedValues()
                .with("rows", rows.stream().map(Row::values).toList())
                .with("outside", outOfRangeCount())
                .with("failures", failures);
    }

    /** Whether every breath was computed and no value is outside its range. */
    public boolean passes() {
        return failures.isEmpty() && outOfRangeCount() == 0;
    }
}
