package org.phrenic.study.access;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.study.ReportNumbers.number;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.Crossing;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.RunSettings;
import org.phrenic.study.Attempts;

/**
 * Access maps of exercises, their free ways, and what came of the plans, as values for JSON and as a page.
 *
 * @param failures exercises that were not played, each with the reason
 */
public record AccessReport(List<AccessStudy.Result> results, List<String> failures) {
    public AccessReport {
        results = List.copyOf(results);
        failures = List.copyOf(failures);
    }

    /** Whether all were played, no free way crosses what it should avoid and none begins on a cut end. */
    public boolean passes() {
        return failures.isEmpty() && results.stream().allMatch(r -> r.check().passes());
    }

    /** What was found, in one sentence without a full stop. */
    public String summary() {
        String found = format(
                "Of %,d free ways (an entry at a moment), %d cross what their plan avoids; of %,d entries, %d"
                        + " lie on a cut end of the body; %d of %d plans reach their goals",
                results.stream().mapToInt(r -> r.check().ways()).sum(),
                results.stream().mapToInt(r -> r.check().crossing()).sum(),
                results.stream().mapToInt(r -> r.check().entries()).sum(),
                results.stream().mapToInt(r -> r.check().atCutEnd()).sum(),
                results.stream().filter(r -> r.rehearsal().goalsReached()).count(),
                results.size());
        return failures.isEmpty() ? found : failures.size() + " exercises could not be played. " + found;
    }

    /** Points that are free at all moments if organs and vessels are no obstacles. */
    private static long freeWithoutOrgans(AccessMap map) {
        Set<NoGoZone> others = EnumSet.noneOf(NoGoZone.class);
        others.addAll(map.avoided());
        others.remove(NoGoZone.ORGAN);
        return IntStream.range(0, map.size())
                .filter(v -> IntStream.range(0, map.cycle().size())
                        .allMatch(m -> map.isInReach(m, v)
                                && map.touched(m, v).stream().noneMatch(others::contains)))
                .count();
    }

    private static long throughPleura(AccessMap map) {
        return IntStream.range(0, map.size())
                .filter(v -> map.access(v) == AccessMap.Access.FREE && map.crossesPleura(v))
                .count();
    }

    /** One line for each exercise: its access map, and the check of the free ways. */
    public List<List<String>> table() {
        List<List<String>> rows = new ArrayList<>();
        for (AccessStudy.Result r : results) {
            AccessMap map = r.rehearsal().map();
            AccessMap.Counts counts = map.counts();
            rows.add(List.of(
                    r.rehearsal().plan().title(),
                    count(counts.inReach()),
                    count(freeWithoutOrgans(map)),
                    count(counts.free()),
                    counts.inReach() == 0 ? "" : format("%.1f", 100.0 * counts.free() / counts.inReach()),
                    count(counts.part()),
                    count(throughPleura(map)),
                    count(r.check().ways()),
                    count(r.check().crossing()),
                    count(r.check().atCutEnd()),
                    number(r.mapS())));
        }
        return rows;
    }

    private static String count(long n) {
        return Long.toString(n);
    }

    /** Shares of the free skin by way, %; intercostal spaces by number. */
    private static List<String> ways(Rehearsal rehearsal) {
        List<TargetAccess.SpaceCount> ways = rehearsal.targetAccess().bySpace();
        double free = Math.max(1, rehearsal.map().counts().free());
        return List.of(
                rehearsal.plan().title(),
                spaces(ways, "right", free),
                spaces(ways, "left", free),
                share(ways, w -> w.equals("right subcostal"), free),
                share(ways, w -> w.equals("left subcostal"), free),
                share(ways, w -> w.equals("subxiphoid"), free),
                share(ways, w -> w.startsWith("over "), free));
    }

    private static String spaces(List<TargetAccess.SpaceCount> ways, String side, double free) {
        return ways.stream()
                .filter(w -> w.free() > 0 && w.space().endsWith("intercostal space, " + side))
                .map(w -> w.space().replaceFirst(" .*", "") + format(" %.1f", 100 * w.free() / free))
                .collect(Collectors.joining(", "));
    }

    private static String share(List<TargetAccess.SpaceCount> ways, Predicate<String> which, double free) {
        int n = ways.stream()
                .filter(w -> which.test(w.space()))
                .mapToInt(TargetAccess.SpaceCount::free)
                .sum();
        return n == 0 ? "" : format("%.1f", 100 * n / free);
    }

    /** How a plan goes in, and what came of it. */
    private static List<String> outcome(Rehearsal rehearsal) {
        AttemptRecord record = rehearsal.record();
        Optional<PathAnalysis> path = rehearsal.path().map(p -> p.analyses().get(0));
        Optional<TargetingError> sample = record.samples().stream().findFirst();
        return List.of(
                rehearsal.plan().title(),
                path.map(p -> p.way().label()).orElse(""),
                path.map(p -> format("%.1f", p.lengthMm())).orElse(""),
                path.flatMap(p -> p.crossing(Crossing.RECESS))
                        .map(c -> format("%.1f to %.1f", c.fromMm(), c.toMm()))
                        .orElse("none"),
                path.map(p -> format("%.0f", p.capsuleAngleDeg())).orElse(""),
                rehearsal
                        .path()
                        .map(p -> p.freeMoments() + " of " + p.analyses().size())
                        .orElse(""),
                record.hit() ? "yes" : "no",
                sample.map(s -> format("%.1f", s.axialMm())).orElse(""),
                sample.map(s -> format("%.1f", s.lateralMm())).orElse(""),
                format("%.1f", record.capsulePullMm()),
                format("%.1f", record.timeS()),
                format("%.2f", record.inNoGoS()),
                rehearsal.goalsReached() ? "yes" : "no");
    }

    private static List<String> exercise(Rehearsal rehearsal) {
        double[] range = rehearsal.map().motion().rangeMm();
        return List.of(
                rehearsal.plan().title(),
                RunSettings.bodyLabel(rehearsal.plan().scenario().anatomy()),
                OrganSettings.meshLabel(rehearsal.plan().scenario()),
                format("%.0f", rehearsal.target().diameterMm()),
                format("%.1f", rehearsal.map().motion().excursionMm()),
                format("%.1f, %.1f, %.1f", range[0], range[1], range[2]),
                count(rehearsal.map().size()),
                count(rehearsal.map().cycle().size()));
    }

    /** @param provenance how it was made: commit, command, machine, date */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument("Ways in of the exercises", summary() + ".");
        report.points(provenance.toArray(String[]::new));
        Attempts.addFailures(report, "Not played", failures);
        List<Rehearsal> all =
                results.stream().map(AccessStudy.Result::rehearsal).toList();
        report.table(
                "Exercises as shipped",
                Column.list("exercise | body | resolution | # target mm | # moves mm | # LR, AP, SI mm"
                        + " | # points of the skin | # moments"),
                all.stream().map(AccessReport::exercise).toList());
        addMaps(report);
        addWays(report, all);
        addOutcomes(report, all);
        return report;
    }

    private void addMaps(ReportDocument report) {
        report.section("Access maps");
        report.paragraph("Points of the skin from which the needle reaches the target at the first moment; those of"
                + " them whose way is free at every moment, without and with organs and vessels, with their share; free"
                + " in part of the breath; free and through the pleura. Every way was then tried at every moment at"
                + " which the map calls it free against every triangle of every lung, bone, organ and vessel that the"
                + " plan avoids, without the map's tree: ways tried, ways that cross one, entries that lie on a flat"
                + " end of the skin. The last column is the time of a map for 2,000 points in reach on the scenario's"
                + " threads, where it was measured.");
        report.table(
                "",
                Column.list("exercise | # in reach | # free without organs | # free | # % | # in part"
                        + " | # through pleura | # ways tried | # crossing | # on a cut end | # map s"),
                table());
    }

    private static void addWays(ReportDocument report, List<Rehearsal> all) {
        report.section("Ways");
        report.paragraph(
                "Shares of the skin that is free over the breath, %, by the way of its path at the first" + " moment.");
        report.table(
                "",
                Column.list("exercise | right intercostal spaces | left intercostal spaces | right subcostal"
                        + " | left subcostal | subxiphoid | over a rib or the margin"),
                all.stream().map(AccessReport::ways).toList());
    }

    private static void addOutcomes(ReportDocument report, List<Rehearsal> all) {
        report.section("Plans as shipped");
        report.paragraph("The planned path at end-expiration: its way, length to the middle of the target, where it"
                + " lies in the pleural recess, angle to the capsule, moments at which it is free. Then what came of"
                + " it: hit, error along and beside the needle, how far the capsule was pulled aside, time from the"
                + " first contact, time in structures at risk, whether all goals were reached. The program points the"
                + " needle in these plans.");
        report.table(
                "",
                Column.list("exercise | way | # length mm | # recess mm | # angle ° | # free at | # hit"
                        + " | # axial mm | # lateral mm | # capsule aside mm | # time s | # at risk s | # done"),
                all.stream().map(AccessReport::outcome).toList());
    }

    /** The values for JSON. */
    public OrderedValues values() {
        return new OrderedValues()
                .with("passes", passes())
                .with("exercises", results.stream().map(AccessReport::values).toList())
                .with("not_played", failures)
                .with("notice", Disclaimer.TEXT);
    }

    private static OrderedValues values(AccessStudy.Result r) {
        Rehearsal rehearsal = r.rehearsal();
        OrderedValues values = new OrderedValues()
                .with("exercise", rehearsal.plan().title())
                .with("body", rehearsal.plan().scenario().anatomy())
                .with("access", rehearsal.map().counts().toMap())
                .with("free_without_organs", freeWithoutOrgans(rehearsal.map()))
                .with("free_through_pleura", throughPleura(rehearsal.map()))
                .with("ways_tried", r.check().ways())
                .with("ways_crossing", r.check().crossed())
                .with("entries_on_a_cut_end", r.check().atCutEnd())
                .with(
                        "by_space",
                        rehearsal.targetAccess().bySpace().stream()
                                .map(TargetAccess.SpaceCount::toMap)
                                .toList())
                .with("attempt", rehearsal.record().headlines())
                .with("done", rehearsal.goalsReached());
        if (!Double.isNaN(r.mapS())) {
            values.put("map_s_for_2000_points", r.mapS());
        }
        return values;
    }
}
