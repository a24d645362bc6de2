package org.phrenic.study.access;

import static org.phrenic.file.Numbers.format;

import java.util.List;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.Attempts;
import org.phrenic.study.ReportNumbers;

/**
 * Times of ultrasound images and radiographs, as values for JSON and as a page.
 *
 * @param failures bodies that were not imaged, each with the reason
 */
public record ImagingReport(Scenario scenario, List<ImagingStudy.Result> results, List<String> failures) {
    private static final double LEAST_PER_S = 15;
    private static final double LONGEST_S = 0.1;
    private static final double MILLI = 1000;

    public ImagingReport {
        results = List.copyOf(results);
        failures = List.copyOf(failures);
    }

    private static boolean isWithin(ImagingStudy.Result r) {
        return r.besideScene().perS() >= LEAST_PER_S && r.radiographs().quantile(0.5) <= LONGEST_S;
    }

    /** What was found, in one sentence without a full stop. */
    public String summary() {
        if (results.isEmpty()) {
            return "No body could be imaged";
        }
        double slowest =
                results.stream().mapToDouble(r -> r.besideScene().perS()).min().orElseThrow();
        double longest = results.stream()
                .mapToDouble(r -> r.radiographs().quantile(0.5))
                .max()
                .orElseThrow();
        return format(
                "Ultrasound beside the running scene: at least %.1f images/s (wanted: %.0f); a radiograph: at most"
                        + " %.0f ms (wanted: %.0f); of each body the mean rate and the median time",
                slowest, LEAST_PER_S, MILLI * longest, MILLI * LONGEST_S);
    }

    /** One line for each body. */
    public List<List<String>> table() {
        return results.stream()
                .map(r -> List.of(
                        r.body(),
                        ReportNumbers.grouped(r.triangles()),
                        ms(r.radiographs(), 0.5),
                        ms(r.radiographs(), 0.95),
                        ms(r.images(), 0.5),
                        ms(r.besideScene(), 0.5),
                        ms(r.besideScene(), 0.95),
                        format("%.1f", r.besideScene().perS()),
                        format("%.2f", r.realtimeFactor()),
                        isWithin(r) ? "yes" : "no"))
                .toList();
    }

    private static String ms(ImagingStudy.Times times, double share) {
        return format("%.1f", MILLI * times.quantile(share));
    }

    /** @param provenance how it was made: commit, command, machine, date */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument("Time of pictures", summary() + ".");
        report.points(provenance.toArray(String[]::new));
        report.paragraph(format(
                "Pictures of 512 x 512 pixels of bodies with their organs at %s resolution. Radiograph: frontal, two"
                        + " threads, nothing else at work. Ultrasound: right intercostal, 150 mm deep, the probe"
                        + " turned by a degree after each image; on two threads alone, and on one thread while the"
                        + " scene breathes (%s) on another no faster than the clock, each image of its latest"
                        + " frame. p95: 95 %% of the pictures take no longer.",
                ReportNumbers.label(scenario.resolution()), breath()));
        report.table(
                "",
                Column.list("body | # triangles | # radiograph ms | # p95 | # ultrasound alone ms"
                        + " | # beside the scene ms | # p95 | # images/s | # simulated over real time | within"),
                table());
        Attempts.addFailures(report, "Not imaged", failures);
        return report;
    }

    private String breath() {
        return scenario.trace()
                .map(file -> "as recorded in " + file.getFileName())
                .orElse("preset " + scenario.preset());
    }

    /** The values for JSON. */
    public OrderedValues values() {
        return new OrderedValues()
                .with("resolution", ReportNumbers.label(scenario.resolution()))
                .with("breath", breath())
                .with(
                        "bodies",
                        results.stream()
                                .map(r -> new OrderedValues()
                                        .with("body", r.body())
                                        .with("triangles", r.triangles())
                                        .with("radiograph_s", r.radiographs().quantile(0.5))
                                        .with("ultrasound_s", r.images().quantile(0.5))
                                        .with(
                                                "ultrasound_beside_scene_s",
                                                r.besideScene().quantile(0.5))
                                        .with("images_per_s", r.besideScene().perS())
                                        .with("realtime_factor", r.realtimeFactor()))
                                .toList())
                .with("not_imaged", failures)
                .with("notice", Disclaimer.TEXT);
    }
}
