package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.document.CsvWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.Numbers;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.ReportValues;

/** A study of bodies as a report, CSV and values for JSON. */
public final class BodyReport {
    private static final List<Column> COLUMNS =
            Column.list("body | # quiet R mm | # L | # return mm | # deep R mm | # L | # air ml | # return mm"
                    + " | # through: rest | # quiet | # deep | # deepest mm | # outside cage mm"
                    + " | # insertion mm | # 95 %");

    private static final List<Column> RIB_COLUMNS =
            Column.list("body | # ribs | # heads off: mean mm | # greatest mm | # axes off: mean mm"
                    + " | # greatest mm | # necks: mean deg | # greatest deg");

    private static final List<Column> SURFACE_COLUMNS =
            Column.list("body | kind | # structures | # mean mm | # 95 % mm");

    /** Keys that are stated elsewhere, or that the numbers do not depend on. */
    private static final Set<String> SET_BY_STUDY = Set.of("resolution", "threads");

    private final BodyStudy study;

    public BodyReport(BodyStudy study) {
        this.study = study;
    }

    /** One-line summary. */
    public String summary() {
        long within = study.bodies().stream().filter(BodyResult::passes).count();
        long breathe = study.bodies().stream().filter(BodyResult::breathes).count();
        return study.bodies().size() + " bodies: " + breathe + " breathe quietly and deeply to the end, " + within
                + " within all limits";
    }

    /** A header and one row for each body. */
    public List<List<String>> table() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(COLUMNS.stream().map(Column::heading).toList());
        study.bodies().forEach(body -> rows.add(row(body)));
        return rows;
    }

    private static Optional<BreathResult> breath(BodyResult body, BreathDepth depth) {
        return body.breaths().stream().filter(b -> b.depth() == depth).findFirst();
    }

    private static List<String> row(BodyResult body) {
        List<String> row = new ArrayList<>(List.of(body.name()));
        for (BreathDepth depth : BreathDepth.values()) {
            Optional<BreathResult> b = breath(body, depth);
            row.add(number(b.map(r -> r.motion().domeRightMm())));
            row.add(number(b.map(r -> r.motion().domeLeftMm())));
            if (depth == BreathDepth.DEEP) {
                row.add(number(b.map(r -> r.motion().airMl())));
            }
            row.add(number(b.map(r -> r.motion().returnRmsMm())));
        }
        Optional<BreathResult> quiet = breath(body, BreathDepth.QUIET);
        Optional<BreathResult> deep = breath(body, BreathDepth.DEEP);
        row.add(count(quiet.map(BreathResult::atRest)));
        row.add(count(quiet.flatMap(BreathResult::atInspiration)));
        row.add(count(deep.flatMap(BreathResult::atInspiration)));
        row.add(number(body.breaths().stream()
                .flatMap(b -> Stream.concat(Stream.of(b.atRest()), b.atInspiration().stream()))
                .map(OrganCrossing::deepestMm)
                .max(Double::compare)));
        row.add(ReportNumbers.number(body.measure("outside_cage_maximum_mm")));
        row.add(ReportNumbers.number(body.measure("insertion_to_margin_mean_mm")));
        row.add(ReportNumbers.number(body.measure("insertion_to_margin_percentile_95_mm")));
        return row;
    }

    private static String number(Optional<Double> value) {
        return ReportNumbers.number(value.orElse(Double.NaN));
    }

    private static String count(Optional<OrganCrossing> crossing) {
        return crossing.map(c -> String.valueOf(c.vertices())).orElse("");
    }

    /**
     * The whole report.
     *
     * @param provenance lines on how it was made: commit, machine, date
     */
    public ReportDocument document(List<String> provenance) {
        boolean imported =
                study.bodies().stream().anyMatch(body -> !body.notInScan().isEmpty());
        ReportDocument report =
                new ReportDocument(imported ? "Imported bodies" : "Bodies that breathe", summary() + ".");
        report.points(provenance.toArray(String[]::new));
        report.paragraph("One quiet and one deep breath of each body from rest, " + numbers() + ", "
                + ReportNumbers.label(study.scenario().resolution())
                + " resolution. Wanted, for a body of an adult's height: domes "
                + range(BodyLimits.QUIET_LEAST_MM, BodyLimits.QUIET_MOST_MM) + " mm (quiet) and "
                + range(BodyLimits.DEEP_LEAST_MM, BodyLimits.DEEP_MOST_MM) + " mm (deep), return within "
                + BodyLimits.RETURN_RMS_MM + " mm rms, no organ vertex more than "
                + Numbers.trimmed(BodyLimits.THROUGH_MM, 2) + " mm through the diaphragm at rest or at full"
                + " inspiration (columns through: number of such vertices), diaphragm at rest at most "
                + Numbers.trimmed(BodyLimits.OUTSIDE_CAGE_MM, 2)
                + " mm outside the cage. Insertion: mean and 95 % of the"
                + " distances of the border from the bones and ligaments where it inserts.");
        List<List<String>> table = table();
        report.table("", COLUMNS, table.subList(1, table.size()));
        report.section(imported ? "What the scans show" : "How the bodies were made");
        List<Column> columns = new ArrayList<>(Column.list("body | made of"));
        if (imported) {
            columns.add(Column.text("not in the scan"));
        }
        columns.add(Column.text("status"));
        report.table(
                "",
                columns,
                study.bodies().stream().map(b -> origin(b, imported)).toList());
        compareRibs(report);
        compareSurfaces(report);
        return report;
    }

    private String numbers() {
        String given = settings().entrySet().stream()
                .map(entry -> entry.getKey() + " = " + entry.getValue())
                .collect(Collectors.joining(", "));
        return given.isEmpty() ? "default numbers" : "default numbers but for " + given;
    }

    /** Settings of all breaths that are not the default's, by key. */
    private Map<String, Object> settings() {
        Map<String, Object> settings = new LinkedHashMap<>(study.scenario().toMap());
        Map<String, Object> usual = Scenario.defaults().toMap();
        settings.entrySet()
                .removeIf(entry -> SET_BY_STUDY.contains(entry.getKey())
                        || Objects.equals(entry.getValue(), usual.get(entry.getKey())));
        return settings;
    }

    private void compareRibs(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        for (BodyResult body : study.bodies()) {
            body.ribs().ifPresent(ribs -> {
                List<String> row = new ArrayList<>(List.of(body.name()));
                row.addAll(ribs.cells());
                rows.add(row);
            });
        }
        if (rows.isEmpty()) {
            return;
        }
        report.section("Ribs against the body that was scanned");
        report.paragraph("A helical axis passes through the head of its rib in a direction from the table of axes,"
                + " the same for all bodies: its angle is exact, and its place is as far off as the head. Necks: angle"
                + " between the directions from the head to what lies "
                + Numbers.trimmed(RibComparison.NECK_MM, 2)
                + " mm away.");
        report.table("", RIB_COLUMNS, rows);
    }

    private void compareSurfaces(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        for (BodyResult body : study.bodies()) {
            for (SurfaceMiss miss : body.surfaces()) {
                List<String> row = new ArrayList<>(List.of(body.name()));
                row.addAll(miss.cells());
                rows.add(row);
            }
        }
        if (!rows.isEmpty()) {
            report.section("Surfaces against the body that was scanned");
            report.paragraph("Structures with the same name in both; distances both ways, by area: mean over the"
                    + " structures, and the greatest 95 % of one.");
            report.table("", SURFACE_COLUMNS, rows);
        }
    }

    private static List<String> origin(BodyResult body, boolean imported) {
        List<String> row = new ArrayList<>(List.of(body.name(), body.origin()));
        if (imported) {
            row.add(body.notInScan());
        }
        row.add(body.status());
        return row;
    }

    private static String range(double low, double high) {
        return Numbers.trimmed(low, 3) + " to " + Numbers.trimmed(high, 3);
    }

    /** One line for each breath with all values. */
    public String csv() {
        List<String> header = new ArrayList<>(List.of("body", "made_of", "breath"));
        List<List<String>> rows = new ArrayList<>();
        for (BodyResult body : study.bodies()) {
            for (BreathResult breath : body.breaths()) {
                Map<String, Object> figures = figures(breath);
                List<String> row = new ArrayList<>(
                        List.of(body.name(), body.origin(), breath.depth().preset()));
                figures.values().forEach(v -> row.add(cell(v)));
                rows.add(row);
                if (header.size() == 3) {
                    header.addAll(figures.keySet());
                }
            }
        }
        return CsvWriter.format(header, rows);
    }

    private static String cell(Object value) {
        return value instanceof Double number ? CsvWriter.number(number, CsvWriter.ALL_DIGITS) : String.valueOf(value);
    }

    /** All values of a breath by CSV column and JSON field. */
    private static Map<String, Object> figures(BreathResult breath) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("failure", breath.failure());
        map.put("dome_right_mm", breath.motion().domeRightMm());
        map.put("dome_left_mm", breath.motion().domeLeftMm());
        map.put("air_ml", breath.motion().airMl());
        map.put("return_rms_mm", breath.motion().returnRmsMm());
        ReportValues.of(breath.atRest()).forEach((key, value) -> map.put("rest_" + key, value));
        Optional<OrganCrossing> inspired = breath.atInspiration();
        ReportValues.of(inspired.orElse(OrganCrossing.NONE))
                .forEach((key, value) -> map.put("inspired_" + key, inspired.isPresent() ? value : Double.NaN));
        return map;
    }

    /** The study as values for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("passes", study.passes());
        map.put("resolution", ReportNumbers.label(study.scenario().resolution()));
        map.put("settings", settings());
        List<Map<String, Object>> bodies = new ArrayList<>();
        for (BodyResult body : study.bodies()) {
            Map<String, Object> one = new LinkedHashMap<>();
            one.put("body", body.name());
            one.put("made_of", body.origin());
            one.put("not_in_scan", body.notInScan());
            one.put("refusal", body.refusal());
            one.put("status", body.status());
            body.sheet()
                    .ifPresent(sheet -> sheet.measures().forEach(measure -> one.put(measure.key(), measure.value())));
            body.ribs().ifPresent(ribs -> one.put("ribs", ReportValues.of(ribs)));
            if (!body.surfaces().isEmpty()) {
                one.put(
                        "surfaces",
                        body.surfaces().stream().map(ReportValues::of).toList());
            }
            for (BreathResult breath : body.breaths()) {
                Map<String, Object> figures = figures(breath);
                figures.values().removeIf(v -> v instanceof Double d && !Double.isFinite(d));
                one.put(breath.depth().preset(), figures);
            }
            one.put("faults", body.faults());
            bodies.add(one);
        }
        map.put("bodies", bodies);
        return map;
    }
}
