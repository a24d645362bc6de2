package org.phrenic.study;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.plan.RobotOperator;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;

/**
 * How hard exercises are, as values for JSON and as a page, with whether each is in the range that is wanted: hit rates
 * of 30 to 95 %, median errors of 2 to 10 mm, fewer hits and greater errors in free than in held breath.
 *
 * @param results of each exercise that in free breath, then that in held breath
 * @param failures exercises that were not done, each with the reason
 */
public record ExerciseReport(RobotOperator.Hand hand, List<ExerciseStudy.Result> results, List<String> failures) {
    private static final double FEWEST_HITS = 0.30;
    private static final double MOST_HITS = 0.95;
    private static final double LEAST_MM = 2;
    private static final double MOST_MM = 10;

    public ExerciseReport {
        results = List.copyOf(results);
        failures = List.copyOf(failures);
    }

    private static boolean isWithin(ExerciseStudy.Result r) {
        return r.hitShare() >= FEWEST_HITS
                && r.hitShare() <= MOST_HITS
                && r.medianMm() >= LEAST_MM
                && r.medianMm() <= MOST_MM;
    }

    /** What an exercise lacks of the wanted range; "yes" if nothing. */
    private static String verdict(ExerciseStudy.Result free, ExerciseStudy.Result held) {
        if (!isWithin(free) || !isWithin(held)) {
            return "no: out of range";
        }
        boolean harder = free.hitShare() < held.hitShare() && free.medianMm() > held.medianMm();
        return harder ? "yes" : "no: not harder in free breath";
    }

    /** The values for JSON. */
    public OrderedValues values() {
        return new OrderedValues()
                .with("reaction_s", hand.reactionS())
                .with("latency_s", hand.latencyS())
                .with("hand_deg", hand.angleDeg())
                .with("hand_depth_mm", hand.depthMm())
                .with(
                        "results",
                        results.stream().map(ExerciseStudy.Result::toMap).toList())
                .with("not_done", failures)
                .with("notice", Disclaimer.TEXT);
    }

    /** @param provenance how it was made: commit, command, machine, date */
    public ReportDocument document(List<String> provenance) {
        List<List<String>> rows = new ArrayList<>();
        int within = 0;
        for (int i = 0; i + 1 < results.size(); i += 2) {
            ExerciseStudy.Result free = results.get(i);
            ExerciseStudy.Result held = results.get(i + 1);
            String verdict = verdict(free, held);
            within += "yes".equals(verdict) ? 1 : 0;
            rows.add(List.of(
                    free.exercise(),
                    free.body(),
                    format("%.0f", free.targetMm()),
                    String.valueOf(free.attempts()),
                    format("%.0f", 100 * free.hitShare()),
                    format("%.1f", free.medianMm()),
                    format("%.0f", 100 * held.hitShare()),
                    format("%.1f", held.medianMm()),
                    verdict));
        }
        ReportDocument report = new ReportDocument(
                "Exercises",
                format(
                        "How hard exercises are for a robot with a reaction time of %.2f s, a latency of the image of"
                                + " %.1f s, errors of %.1f degrees of each angle and of %.1f mm of the depth (standard"
                                + " deviations). %d of %d are within the range that is wanted.",
                        hand.reactionS(), hand.latencyS(), hand.angleDeg(), hand.depthMm(), within, rows.size()));
        report.points(provenance.toArray(String[]::new));
        report.paragraph(
                "Wanted: hit rates of 30 to 95 %, median distances of the sample from the middle of the target of 2 to"
                        + " 10 mm, fewer hits and greater distances in free than in held breath. The numbers of"
                        + " attempts are those in either way of breathing; of 50, a rate of 70 % has a standard error"
                        + " of 6.5 %.");
        List<Column> columns = Column.list("exercise | body | # target mm | # attempts | # free: hits % | # median mm"
                + " | # held: hits % | # median mm | within");
        report.table("", columns, rows);
        Attempts.addFailures(report, "Not done", failures);
        return report;
    }
}
