package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.access.CostalGroove;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.PleuralReflection;
import org.phrenic.access.attempt.AttemptEvent;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.AccessBySpace;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.Approach;
import org.phrenic.access.path.IntercostalSpace;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Picture;

/** What is written of a rehearsal: plain values for JSON, and a report card to be read. */
public final class RehearsalReport {
    private static final int CLOSEST = 8;

    private final Rehearsal rehearsal;
    private final AttemptRecord record;

    public RehearsalReport(Rehearsal rehearsal) {
        this.rehearsal = rehearsal;
        record = rehearsal.record();
    }

    /** Everything, in the order in which it is written. The same plan gives the same values. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        RehearsalPlan plan = rehearsal.plan();
        map.put("title", plan.title());
        map.put("done", rehearsal.goalsReached());
        map.put(
                "goals",
                plan.goals().evaluate(record).stream()
                        .map(Goals.GoalResult::toMap)
                        .toList());
        map.put("attempt", record.toMap());
        rehearsal.path().ifPresent(path -> map.put("path", path.toMap()));
        map.put("access", access());
        map.put("scenario", plan.scenario().toMap());
        map.put("definitions", definitions());
        map.put("state_sha256", rehearsal.stateHash());
        map.put("notice", Disclaimer.TEXT);
        return map;
    }

    private Map<String, Object> access() {
        AccessMap map = rehearsal.map();
        Map<String, Object> access = new LinkedHashMap<>(map.counts());
        access.put("moments", map.cycle().size());
        access.put("avoided", map.avoided().stream().map(NoGoZone::key).toList());
        map.best(Rehearsal.SUFFICIENT_MARGIN_MM).ifPresent(v -> {
            Map<String, Object> best = new LinkedHashMap<>();
            best.put("vertex", v);
            best.put("free_moments", map.freeMoments(v));
            best.put("margin_mm", map.marginMm(v));
            best.put("nearest", map.nearest(v));
            best.put("length_mm", map.lengthMm(v));
            if (!Double.isNaN(map.angleDeg(v))) {
                best.put("capsule_angle_deg", map.angleDeg(v));
            }
            access.put("best", best);
        });
        access.put("by_space", AccessBySpace.plain(rehearsal.targetAccess().bySpace()));
        return access;
    }

    /** What words in a report mean, and what this body cannot show. */
    private List<String> definitions() {
        List<String> words = new ArrayList<>(List.of(
                "Hit: the tip was within the target when a sample was taken. Axial: along the needle, positive where the target's middle lies deeper; lateral: distance of the middle from the needle's line.",
                "Pleural recess: the space between the inner rib cage and the diaphragm where no lung lies; crossed by a path that enters the diaphragm more than "
                        + mm(PleuralReflection.HEIGHT_ABOVE_ORIGIN_MM) + " mm above its lower rim.",
                "Vessels below a rib: within " + mm(CostalGroove.NEUROVASCULAR_ZONE_MM)
                        + " mm of the rib's lower border.",
                "Capsule pulled: distance between the needle and where it went through the capsule, which moves with the liver. No force is worked out.",
                "The body has no organs but those listed in its scene: bowel, gall bladder, kidney and large vessels count only where the body has them.",
                AttemptRecord.NOT_VALIDATED));
        if (rehearsal.surfaces().stream().noneMatch(s -> s.kind() == StructureKind.LUNG)) {
            words.add("This body has no lungs: a path through them is not noticed.");
        }
        return words;
    }

    /** The report card. */
    public ReportDocument document(List<Picture> needlePictures, List<Picture> mapPictures) {
        RehearsalPlan plan = rehearsal.plan();
        ReportDocument document = new ReportDocument(plan.title(), plan.description());
        document.remark(headline());
        goals(document);
        attempt(document);
        if (!needlePictures.isEmpty()) {
            document.figure(
                    "The needle (blue) and the target (yellow) at the sample.", needlePictures.toArray(Picture[]::new));
        }
        path(document);
        accessTable(document);
        if (!mapPictures.isEmpty()) {
            document.figure(
                    "Where on the skin the target can be reached by a straight path, in per cent of a breath.",
                    mapPictures.toArray(Picture[]::new));
        }
        document.section("What the words mean");
        document.points(definitions().toArray(String[]::new));
        return document;
    }

    private String headline() {
        if (record.samples().isEmpty()) {
            return "No sample was taken.";
        }
        TargetingError last = record.samples().get(record.samples().size() - 1);
        return (record.hit() ? "Hit" : "Missed") + ": the tip was " + mm(last.distanceMm())
                + " mm from the middle of a target of " + mm(rehearsal.target().diameterMm()) + " mm ("
                + mm(last.axialMm()) + " mm along the needle, " + mm(last.lateralMm()) + " mm aside)."
                + rehearsal
                        .path()
                        .map(p -> " The target moves " + mm(p.motion().excursionMm()) + " mm in a breath.")
                        .orElse("");
    }

    private void goals(ReportDocument document) {
        List<Goals.GoalResult> outcomes = rehearsal.plan().goals().evaluate(record);
        if (outcomes.isEmpty()) {
            return;
        }
        document.section(rehearsal.goalsReached() ? "Done" : "Not done");
        document.table(
                "What counts as done; chosen, not validated.",
                List.of(Column.text("Goal"), Column.number("Asked"), Column.number("Reached"), Column.text("")),
                outcomes.stream()
                        .map(o -> List.of(
                                o.label(),
                                number(o.limit()),
                                Double.isFinite(o.value()) ? number(o.value()) : "no sample",
                                o.reached() ? "yes" : "NO"))
                        .toList());
    }

    private void attempt(ReportDocument document) {
        document.section("The attempt");
        List<List<String>> rows = new ArrayList<>();
        rows.add(row(
                "Attempts, redirections, contacts with the skin",
                record.count(AttemptEvent.Kind.SKIN_PUNCTURE)
                        + ", " + record.count(AttemptEvent.Kind.REDIRECTION) + ", "
                        + record.count(AttemptEvent.Kind.SKIN_CONTACT)));
        rows.add(row("Time from the first contact, s", number(record.timeS())));
        rows.add(row("Time in the body, s", number(record.insideS())));
        rows.add(row("Way of the tip by hand, mm", number(record.tipTravelMm())));
        rows.add(row("Time in what is to be avoided, s", number(record.inNoGoS())));
        record.secondsIn()
                .forEach((what, s) -> rows.add(row(
                        "Time in " + what.label() + ", s"
                                + (record.avoided().contains(what) ? "" : " (not to be avoided here)"),
                        number(s))));
        rows.add(row("Contacts with bone", "" + record.count(AttemptEvent.Kind.BONE_CONTACT)));
        rows.add(row("Target moved meanwhile, mm", number(record.targetExcursionMm())));
        rows.add(row(
                "Capsule pulled aside at most, mm",
                number(record.capsulePullMm())
                        + (record.capsulePullMm() > AttemptRecord.PULL_WARNING_MM ? " (warning)" : "")));
        rows.add(row("Needle turned by the liver at most, degrees", number(record.rotationByLiverDeg())));
        document.table("", List.of(Column.text("Measure"), Column.number("Value")), rows);
        document.table(
                "In order",
                List.of(
                        Column.text("Event"),
                        Column.number("Depth, mm"),
                        Column.number("Time, s"),
                        Column.number("Breath"),
                        Column.number("Phase"),
                        Column.text("Breathing")),
                record.events().stream()
                        .map(e -> List.of(
                                (e.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ') + " " + e.structure())
                                        .strip(),
                                mm(e.depthMm()),
                                number(e.timeS()),
                                "" + e.breath(),
                                number(e.phase()),
                                e.label().name().toLowerCase(Locale.ROOT)))
                        .toList());
        document.table(
                "Closest approaches of the needle",
                List.of(Column.text("Structure"), Column.number("Distance, mm")),
                record.closest().stream()
                        .sorted(java.util.Comparator.comparingDouble(Approach::distanceMm))
                        .limit(CLOSEST)
                        .map(a -> List.of(a.label(), mm(a.distanceMm())))
                        .toList());
    }

    private void path(ReportDocument document) {
        rehearsal.path().ifPresent(path -> {
            document.section("The path over a breath");
            PathAnalysis rest = path.analyses().get(0);
            document.paragraph("At end-expiration: "
                    + rest.space().map(IntercostalSpace::label).orElse("no intercostal space") + ", "
                    + mm(rest.lengthMm()) + " mm to the middle of the target, "
                    + rest.crossings().stream()
                            .map(c -> c.label() + " from " + mm(c.fromMm()) + " to " + mm(c.toMm()) + " mm")
                            .collect(Collectors.joining(", "))
                    + ". Free at " + path.freeMoments() + " of "
                    + path.analyses().size() + " moments.");
            List<List<String>> rows = new ArrayList<>();
            for (int m = 0; m < path.analyses().size(); m++) {
                rows.add(List.of(
                        number(path.cycle().get(m).timeS()),
                        path.cycle().get(m).label().name().toLowerCase(Locale.ROOT),
                        path.isFree(m)
                                ? "free"
                                : String.join(", ", path.analyses().get(m).reasons(path.avoided())),
                        mm(path.marginsMm()[m])));
            }
            document.table(
                    "",
                    List.of(
                            Column.number("Time, s"),
                            Column.text("Breathing"),
                            Column.text("Path"),
                            Column.number("Margin, mm")),
                    rows);
        });
    }

    private void accessTable(ReportDocument document) {
        document.section("Where the target can be reached from");
        Map<String, Object> counts = rehearsal.map().counts();
        document.paragraph("Of " + counts.get("skin_points") + " points of the skin the needle reaches the target from "
                + counts.get("in_reach") + "; " + counts.get("free") + " are free over the whole breath, "
                + counts.get("in_part") + " in part of it.");
        document.table(
                "Points in reach, by where their path passes the cage at end-expiration",
                List.of(Column.text("Where"), Column.number("Free"), Column.number("In part"), Column.number("Never")),
                rehearsal.targetAccess().bySpace().stream()
                        .map(r -> List.of(r.space(), "" + r.free(), "" + r.part(), "" + r.never()))
                        .toList());
    }

    private static List<String> row(String what, String value) {
        return List.of(what, value);
    }

    private static String mm(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e6
                ? String.format(Locale.ROOT, "%.0f", value)
                : String.format(Locale.ROOT, "%.2f", value);
    }
}
