package org.phrenic.study.sweep.report;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.study.ReportNumbers.ofAnySize;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.study.sweep.Factor;
import org.phrenic.study.sweep.FactorScale;
import org.phrenic.study.sweep.RunRow;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.index.Estimate;
import org.phrenic.study.sweep.index.MorrisEffects;
import org.phrenic.study.sweep.index.ResponseCurve;
import org.phrenic.study.sweep.index.SobolIndices;

/** The report of a study, complete or on the way. */
public final class SweepReport {
    private static final int SHOWN_FAILURES = 20;
    private static final double SMALL_WIDTH = 300;
    private static final double SMALL_HEIGHT = 200;
    private static final double MINUTE_S = 60;
    private static final String SPAN = "span of means";

    private final SweepResults results;
    private final double leftS;
    private final int width;
    private final List<String> factors;
    private final List<ResponseAnalysis> analyses;

    /**
     * @param leftS estimated time until the study is complete, s
     * @param width runs at a time
     */
    public SweepReport(SweepResults results, double leftS, int width) {
        this.results = results;
        this.leftS = leftS;
        this.width = width;
        factors = results.plan().study().factors().stream().map(Factor::key).toList();
        analyses = IntStream.range(0, results.plan().model().analysed())
                .mapToObj(r -> ResponseAnalysis.of(results, r))
                .toList();
    }

    /** State and statistics of the study for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("title", results.plan().study().title());
        map.put("design", results.plan().study().design().kind().label());
        map.put("runs", results.plan().size());
        map.put("done", results.done());
        map.put("failed", results.failed());
        map.put("complete", results.isComplete());
        map.put("wall_s", results.wallS());
        map.put("machines", results.machines());
        Map<String, Object> responses = new LinkedHashMap<>();
        analyses.forEach(a -> responses.put(a.name(), a.toMap(factors)));
        map.put("responses", responses);
        Map<String, Object> ways = new WayMap(results).toMap();
        if (!ways.isEmpty()) {
            map.put("free_ways_percent", ways);
        }
        map.put("notice", Disclaimer.TEXT);
        return map;
    }

    /** Rows of a table: response, factor, then the sensitivity measures of the design. */
    public List<List<String>> sensitivity() {
        List<List<String>> rows = new ArrayList<>();
        for (ResponseAnalysis a : analyses) {
            for (int f : order(a)) {
                List<String> row = new ArrayList<>(List.of(a.name(), factors.get(f)));
                measures(a, f).forEach(e -> row.add(text(e)));
                row.add(ofAnySize(span(a, f)));
                rows.add(row);
            }
        }
        return rows;
    }

    /** Headings of {@link #sensitivity}. */
    public List<String> sensitivityHeadings() {
        List<String> headings = new ArrayList<>(List.of("response", "factor"));
        headings.addAll(measureNames());
        headings.add(SPAN);
        return headings;
    }

    private List<String> measureNames() {
        return switch (results.plan().study().design().kind()) {
            case SOBOL -> List.of("first order", "total");
            case MORRIS -> List.of("mu*", "sigma", "mu");
            default -> List.of();
        };
    }

    private static List<Estimate> measures(ResponseAnalysis a, int f) {
        List<Estimate> list = new ArrayList<>();
        a.sobol().ifPresent(s -> list.addAll(List.of(s.first().get(f), s.total().get(f))));
        a.morris()
                .ifPresent(m -> list.addAll(List.of(m.muStar().get(f), m.sigma().get(f), m.mu().get(f))));
        return list;
    }

    /** Greatest minus least mean of the response over the bins of a factor. */
    private static double span(ResponseAnalysis a, int f) {
        double[] ends = a.curves().get(f).extremes();
        return ends[1] - ends[0];
    }

    private static String text(Estimate e) {
        if (!e.isKnown()) {
            return "-";
        }
        return e.hasInterval() ? format("%.3g [%.3g, %.3g]", e.value(), e.low(), e.high()) : format("%.3g", e.value());
    }

    /** Factors in descending order of their effect. */
    private static List<Integer> order(ResponseAnalysis a) {
        return IntStream.range(0, a.curves().size())
                .boxed()
                .sorted(Comparator.comparingDouble(f -> -effect(a, f)))
                .toList();
    }

    private static double effect(ResponseAnalysis a, int f) {
        double value;
        if (a.sobol().isPresent()) {
            value = a.sobol().get().total().get(f).value();
        } else if (a.morris().isPresent()) {
            value = a.morris().get().muStar().get(f).value();
        } else {
            value = span(a, f);
        }
        return Double.isNaN(value) ? 0 : value;
    }

    /** The report as one HTML page. */
    public String html() {
        ReportDocument page = new ReportDocument(results.plan().study().title(), state());
        failures(page);
        factorsAndResponses(page);
        analyses.forEach(a -> response(page, a));
        new WayMap(results).addTo(page);
        new SeriesBands(results).addTo(page);
        machines(page);
        return HtmlPage.format(page);
    }

    private void machines(ReportDocument page) {
        page.section("Machines");
        results.builds().ifPresent(page::paragraph);
        results.machines().forEach((machine, count) -> page.paragraph(machine + ": " + count + " runs."));
    }

    /**
     * What the study found, without curves: factors, responses, measures of sensitivity, machines.
     *
     * @param provenance lines on how it was made
     */
    public ReportDocument summary(List<String> provenance) {
        ReportDocument page = new ReportDocument(results.plan().study().title(), state());
        page.points(provenance.toArray(String[]::new));
        failures(page);
        factorsAndResponses(page);
        for (ResponseAnalysis a : analyses) {
            page.section(a.name());
            measures(page, a);
        }
        machines(page);
        return page;
    }

    private void factorsAndResponses(ReportDocument page) {
        page.section("Factors");
        page.table(
                "",
                Column.list("factor | values"),
                results.plan().scales().stream().map(SweepReport::describe).toList());
        page.section("Responses");
        page.table(
                "Over the completed runs.",
                Column.list("response | # mean | # SD | # least | # 2.5 % | # median | # 97.5 % | # greatest"),
                analyses.stream().map(SweepReport::summary).toList());
    }

    private String state() {
        int size = results.plan().size();
        String state = format(
                "%d of %d runs of the design '%s' are done, %d failed; %.0f s of computing time%s.",
                results.done(),
                size,
                results.plan().study().design().kind().label(),
                results.failed(),
                results.wallS(),
                width > 1 ? ", " + width + " at a time" : "");
        return results.isComplete() || leftS <= 0
                ? state
                : state + format(" About %.0f min are left.", Math.ceil(leftS / MINUTE_S));
    }

    private void failures(ReportDocument page) {
        if (results.failed() == 0) {
            return;
        }
        List<List<String>> rows = results.rows().stream()
                .filter(RunRow::isFailed)
                .limit(SHOWN_FAILURES)
                .map(row -> List.of(
                        String.valueOf(row.index()),
                        results.plan().points().get(row.index()).description(),
                        row.failure()))
                .toList();
        page.section("Failed runs");
        page.table(
                results.failed() > rows.size() ? "The first " + rows.size() + "." : "",
                Column.list("# run | factors | reason"),
                rows);
    }

    private static List<String> describe(FactorScale scale) {
        Factor factor = scale.factor();
        String values;
        if (factor.isListed()) {
            values = String.join(", ", factor.values());
        } else {
            double low = scale.range()[0];
            double high = scale.range()[1];
            values = factor.normal()
                    .map(n -> "normal, mean " + n[0] + ", SD " + n[1] + ", cut at " + low + " and " + high)
                    .orElse(low + " to " + high + (factor.log() ? ", log" : ""));
        }
        return List.of(factor.key(), values);
    }

    private static List<String> summary(ResponseAnalysis a) {
        double[] q = a.quantiles();
        return List.of(
                a.name(),
                ofAnySize(a.mean()),
                ofAnySize(a.deviation()),
                ofAnySize(q[0]),
                ofAnySize(q[1]),
                ofAnySize(q[2]),
                ofAnySize(q[3]),
                ofAnySize(q[4]));
    }

    private void response(ReportDocument page, ResponseAnalysis a) {
        page.section(a.name());
        measures(page, a);
        page.figure("Tornado: least and greatest mean of the response over the bins of each factor.", tornado(a));
        List<Picture> curves = order(a).stream().map(f -> curve(a, f)).toList();
        page.add(new Figure("Mean response over each factor, with one standard deviation.", curves));
    }

    private void measures(ReportDocument page, ResponseAnalysis a) {
        List<Column> columns = new ArrayList<>(List.of(Column.text("factor")));
        measureNames().forEach(name -> columns.add(Column.number(name + " [95 %]")));
        if (measureNames().isEmpty()) {
            columns.add(Column.number(SPAN));
        }
        page.table("", columns, order(a).stream().map(f -> measured(a, f)).toList());
        a.sobol()
                .ifPresent(s -> page.figure(
                        "Sobol' indices: first order (blue), total (orange), with 95 % intervals of " + s.samples()
                                + " samples.",
                        indices(a, s)));
        a.morris()
                .ifPresent(m -> page.figure(
                        "Mean absolute elementary effect mu* (blue) and standard deviation sigma (orange), in units of"
                                + " the response per range of the factor, between two values if they are names.",
                        effects(a, m)));
    }

    private List<String> measured(ResponseAnalysis a, int f) {
        List<String> row = new ArrayList<>(List.of(factors.get(f)));
        measures(a, f).forEach(e -> row.add(text(e)));
        if (measureNames().isEmpty()) {
            row.add(ofAnySize(span(a, f)));
        }
        return row;
    }

    private Picture indices(ResponseAnalysis a, SobolIndices s) {
        BarChart chart = new BarChart("share of the variance");
        order(a).forEach(f ->
                chart.add(factors.get(f), bar(s.first().get(f)), bar(s.total().get(f))));
        return chart.picture("Sobol' indices of " + a.name(), "");
    }

    private Picture effects(ResponseAnalysis a, MorrisEffects m) {
        BarChart chart = new BarChart(a.name() + " per range");
        order(a).forEach(f ->
                chart.add(factors.get(f), bar(m.muStar().get(f)), bar(m.sigma().get(f))));
        return chart.picture("Elementary effects on " + a.name(), "");
    }

    private static BarChart.Bar bar(Estimate e) {
        return new BarChart.Bar(0, e.value(), e.low(), e.high());
    }

    private Picture tornado(ResponseAnalysis a) {
        BarChart chart = new BarChart(a.name());
        IntStream.range(0, factors.size())
                .boxed()
                .sorted(Comparator.comparingDouble(f -> {
                    double[] ends = a.curves().get(f).extremes();
                    return Double.isNaN(ends[0]) ? 0 : ends[0] - ends[1];
                }))
                .forEach(f -> {
                    double[] ends = a.curves().get(f).extremes();
                    chart.add(factors.get(f), new BarChart.Bar(ends[0], ends[1], Double.NaN, Double.NaN));
                });
        return chart.picture("Tornado of " + a.name(), "");
    }

    private Picture curve(ResponseAnalysis a, int f) {
        ResponseCurve c = a.curves().get(f);
        double[] low = new double[c.at().length];
        double[] high = new double[low.length];
        for (int i = 0; i < low.length; i++) {
            low[i] = c.mean()[i] - c.deviation()[i];
            high[i] = c.mean()[i] + c.deviation()[i];
        }
        FactorScale scale = results.plan().scales().get(f);
        CurveChart chart = new CurveChart(SMALL_WIDTH, SMALL_HEIGHT, factors.get(f))
                .named(
                        scale.isNumeric()
                                ? List.of()
                                : scale.factor().values().stream().distinct().toList())
                .band(c.at(), low, high)
                .curve(c.at(), c.mean(), false)
                .curve(c.at(), c.mean(), true);
        return chart.picture(a.name() + " over " + factors.get(f), "");
    }
}
