package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.file.Numbers.trimmed;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Picture;

/** The error budget as a document and as values. */
public final class BudgetReport {
    /** Columns of {@link #cells}. */
    public static final List<Column> COLUMNS =
            Column.list("body | breath | mesh | integrator | # excursion, mm | # time, % | # max, mm"
                    + " | # space, % | # equilibrium, % | # whole, % | # x real time | ");

    private final BudgetTable table;
    private final List<BudgetPoint> points;

    public BudgetReport(BudgetTable table) {
        this.table = table;
        points = BudgetPoint.of(table);
    }

    /** Points of the chart: those of which the whole error is known. */
    public List<BudgetPoint> charted() {
        return points.stream().filter(p -> !Double.isNaN(p.wholePercent())).toList();
    }

    /** Rows of the defaults, or of every setting. */
    public List<List<String>> cells(boolean defaultsAlone) {
        return points.stream()
                .filter(p -> p.row().usual() || !defaultsAlone)
                .map(BudgetReport::cells)
                .toList();
    }

    private static List<String> cells(BudgetPoint p) {
        BudgetRow row = p.row();
        List<String> remarks = new ArrayList<>();
        if (row.usual()) {
            remarks.add("default");
        }
        if (!p.resolved()) {
            remarks.add("unresolved");
        }
        if (!p.extrapolated() && !Double.isNaN(p.spacePercent())) {
            remarks.add("no order");
        }
        return List.of(
                row.body(),
                row.breath(),
                row.mesh(),
                p.integrator(),
                format("%.2f", row.excursionMm()),
                percent(p.timePercent()),
                percent(row.maxMm()),
                percent(p.spacePercent()),
                percent(p.equilibriumPercent()),
                percent(p.wholePercent()),
                format("%.2f", row.realTime()),
                String.join(", ", remarks));
    }

    private static String percent(double value) {
        return Double.isNaN(value) ? "" : trimmed(value, 2);
    }

    /**
     * The results page.
     *
     * @param provenance what made it, on which machine and when
     * @param picture path of the chart relative to the page; empty for none
     */
    public ReportDocument document(List<String> provenance, String picture) {
        ReportDocument page = new ReportDocument(
                "Speed against the whole error",
                "Error of the default settings in time, in space and against quasi-static equilibrium, in per cent of"
                        + " the excursion of the domes, and the speed: simulated time over processor time on one"
                        + " thread.");
        page.points(provenance.toArray(String[]::new));
        page.paragraph("How each part is measured is described in error.md of the documentation. The parts of the"
                + " whole are added; where one of them was not measured, the whole is left blank. \"Unresolved\":"
                + " the error in time is below three times the uncertainty of its reference; the sum of both is"
                + " given. \"No order\": the excursions do not converge as a power of the edge length by more than"
                + " three times their scatter from mesh to mesh; the part in space is the distance from the mean of"
                + " the three finest meshes.");
        if (!points.isEmpty()) {
            page.section("The defaults");
            page.table("", COLUMNS, cells(true));
        }
        if (!picture.isEmpty()) {
            String caption = "Whole error against speed: every integrator on the first body's quiet breath, and the"
                    + " defaults of all scenes.";
            page.figure("", new Picture(picture, "Whole error against speed", caption));
        }
        List<List<String>> all = points.stream()
                .filter(p -> !p.row().usual() || hasOthers(p.row()))
                .map(BudgetReport::cells)
                .toList();
        if (!all.isEmpty()) {
            page.section("Every integrator");
            page.table("", COLUMNS, all);
        }
        addSpace(page);
        addEquilibrium(page);
        addOrder(page);
        addImplicit(page);
        return page;
    }

    /** Whether other settings of the scene were measured too. */
    private boolean hasOthers(BudgetRow row) {
        return table.rows(BudgetPart.TIME, row.body(), row.breath(), row.mesh()).size() > 1;
    }

    private void addSpace(ReportDocument page) {
        List<List<String>> rows = new ArrayList<>();
        Set<List<String>> scenes = new LinkedHashSet<>();
        table.rows().stream()
                .filter(r -> r.part() == BudgetPart.SPACE)
                .forEach(r -> scenes.add(List.of(r.body(), r.breath())));
        for (List<String> scene : scenes) {
            List<BudgetRow> meshes = BudgetPoint.meshes(table, scene.get(0), scene.get(1));
            meshes.forEach(m -> rows.add(List.of(
                    m.body(),
                    m.breath(),
                    m.mesh(),
                    format("%.2f", m.edgeMm()),
                    Double.isNaN(m.excursionMm()) ? "diverged" : format("%.3f", m.excursionMm()),
                    "",
                    "")));
            BudgetPoint.convergence(table, scene.get(0), scene.get(1))
                    .ifPresent(fit -> rows.add(List.of(
                            scene.get(0),
                            scene.get(1),
                            "extrapolated",
                            "0",
                            format("%.3f", fit.limit()),
                            order(fit),
                            Double.isNaN(fit.scatter()) ? "" : format("%.3f", fit.scatter()))));
        }
        if (!rows.isEmpty()) {
            page.section("Error in space");
            page.paragraph("The sheet with lungs and sternum that do not move it, time step in proportion to the edge"
                    + " length, on meshes finer than the default to its square; excursion of the domes by the"
                    + " diaphragm's number of vertices, and the fit limit + c edge^order. The scatter is the standard"
                    + " deviation about the fit.");
            page.table(
                    "",
                    Column.list("body | breath | vertices | # edge, mm | # excursion, mm | # order | # scatter, mm"),
                    rows);
        }
    }

    private static String order(RichardsonFit fit) {
        return fit.hasOrder() ? format("%.2f", fit.order()) : "none";
    }

    private void addEquilibrium(ReportDocument page) {
        Map<List<String>, List<BudgetRow>> scenes = table.rows().stream()
                .filter(r -> r.part() == BudgetPart.EQUILIBRIUM)
                .collect(Collectors.groupingBy(
                        r -> List.of(r.body(), r.breath(), r.mesh()), LinkedHashMap::new, Collectors.toList()));
        if (scenes.isEmpty()) {
            return;
        }
        List<Column> columns = new ArrayList<>(Column.list("body | breath | mesh | # excursion, mm | # x real time"));
        EquilibriumLag.phases().forEach(phase -> columns.add(Column.number("rms at " + phase + ", %")));
        columns.add(Column.number("max, mm"));
        columns.add(Column.number("drift, %"));
        columns.add(Column.number("Newton, %"));
        List<List<String>> rows = new ArrayList<>();
        scenes.forEach((scene, phases) -> {
            BudgetRow first = phases.get(0);
            List<String> cells = new ArrayList<>(scene);
            cells.add(format("%.2f", first.excursionMm()));
            cells.add(Double.isNaN(first.realTime()) ? "" : format("%.2f", first.realTime()));
            List<BudgetRow> held =
                    phases.stream().filter(row -> !row.isOfNewton()).toList();
            held.forEach(row -> cells.add(format("%.2f", row.percent())));
            cells.add(greatest(held, BudgetRow::maxMm));
            cells.add(greatest(held, row -> 100 * row.uncertaintyMm() / row.excursionMm()));
            cells.add(greatest(phases.stream().filter(BudgetRow::isOfNewton).toList(), BudgetRow::percent));
            rows.add(cells);
        });
        page.section("Distance from equilibrium");
        page.paragraph("Ribs, muscle and pressure are stopped at a phase of the breath, in parts of its period; rms"
                + " distance of the diaphragm's nodes from where they come to rest in 4 s, in per cent of the"
                + " excursion. Of all phases: the greatest distance of a node, the greatest rms that the nodes still"
                + " move in the last 2 s, and the greatest rms distance from the equilibrium that Newton's method"
                + " finds from there, which may be that of another fold. A mesh with the name of a scenario is of its"
                + " settings, the others are of the defaults.");
        page.table("", columns, rows);
    }

    /** The greatest known value of some rows; empty if none is known. */
    private static String greatest(List<BudgetRow> rows, ToDoubleFunction<BudgetRow> value) {
        double greatest = rows.stream()
                .mapToDouble(value)
                .filter(v -> !Double.isNaN(v))
                .max()
                .orElse(Double.NaN);
        return Double.isNaN(greatest) ? "" : format("%.2g", greatest);
    }

    private void addOrder(ReportDocument page) {
        List<List<String>> rows = new ArrayList<>();
        Map<String, Double> before = new LinkedHashMap<>();
        for (BudgetRow row : table.rows()) {
            if (row.part() == BudgetPart.ORDER) {
                String series = row.body()
                        + row.breath()
                        + row.mesh()
                        + row.setting().substring(0, row.setting().lastIndexOf(','));
                Double coarser = before.put(series, row.rmsMm());
                // A step beyond the stability limit is split into those of the next row, so both agree.
                boolean known = coarser != null && coarser > 0 && row.rmsMm() > 0;
                String order = known ? format("%.2f", StrictMath.log(coarser / row.rmsMm()) / StrictMath.log(2)) : "";
                rows.add(List.of(
                        row.body(), row.breath(), row.mesh(), row.setting(), format("%.2g", row.rmsMm()), order));
            }
        }
        if (!rows.isEmpty()) {
            page.section("Order of convergence in time");
            page.paragraph("The whole scene, first part of a breath, constraints swept to convergence: rms distance"
                    + " of the diaphragm's nodes between the solution with a step and that with half of it.");
            page.table("", Column.list("body | breath | mesh | scheme and step | # rms, mm | # order"), rows);
        }
    }

    private void addImplicit(ReportDocument page) {
        addDistances(
                page,
                BudgetPart.IMPLICIT,
                "A second reference",
                "Distance of the default from backward Euler, extrapolated to step 0 from two steps; the uncertainty"
                        + " is the distance between the two. With the true mass of muscle, 3.15 kg/m2 and no mass"
                        + " scaling, it includes what the scaled masses change.",
                "masses");
    }

    private void addDistances(ReportDocument page, BudgetPart part, String heading, String text, String setting) {
        List<List<String>> rows = table.rows().stream()
                .filter(r -> r.part() == part)
                .map(r -> List.of(
                        r.body(),
                        r.breath(),
                        r.mesh(),
                        r.setting(),
                        format("%.3g", r.rmsMm()),
                        percent(r.percent()),
                        format("%.3g", r.maxMm()),
                        Double.isNaN(r.uncertaintyMm()) ? "" : format("%.2g", r.uncertaintyMm())))
                .toList();
        if (!rows.isEmpty()) {
            page.section(heading);
            page.paragraph(text);
            page.table(
                    "",
                    Column.list(
                            "body | breath | mesh | " + setting + " | # rms, mm | # % | # max, mm | # uncertainty, mm"),
                    rows);
        }
    }

    /** The budget as values for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("columns", BudgetRow.HEADER);
        map.put("rows", table.rows().stream().map(BudgetRow::cells).toList());
        return map;
    }
}
