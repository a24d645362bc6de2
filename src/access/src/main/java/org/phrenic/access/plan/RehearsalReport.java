package org.phrenic.access.plan;

import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetMotion;
import org.phrenic.access.attempt.AttemptEvent;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.NeedleLoads;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.AccessMap;
import org.phrenic.access.path.Approach;
import org.phrenic.access.path.PathAnalysis;
import org.phrenic.access.path.PathOverBreath;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.file.Numbers;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;

/** The report of a rehearsal, as values for JSON and as a document. */
public final class RehearsalReport {
    private static final int MAX_APPROACHES = 8;

    private final Rehearsal rehearsal;
    private final AttemptRecord record;
    private final List<RehearsalImage> images;

    public RehearsalReport(Rehearsal rehearsal) {
        this.rehearsal = rehearsal;
        record = rehearsal.record();
        images = RehearsalImage.of(rehearsal);
    }

    /** The ultrasound images that the plan asked for; the report names the files of their pictures. */
    public List<RehearsalImage> images() {
        return List.copyOf(images);
    }

    /** Leaves out the file of an image that was not written. */
    public void leaveOutFile(RehearsalImage image) {
        images.set(images.indexOf(image), image.withoutFile());
    }

    /** All values in a fixed order. The same plan gives the same values. */
    public Map<String, Object> values() {
        RehearsalPlan plan = rehearsal.plan();
        OrderedValues map = new OrderedValues()
                .with("title", plan.title())
                .with("done", rehearsal.goalsReached())
                .with("goals", maps(plan.goals().evaluate(record), Goals.GoalResult::toMap))
                .with("attempt", record.toMap());
        map.put("guidance", guidance());
        rehearsal.path().ifPresent(path -> map.put("path", path.toMap()));
        if (!images.isEmpty()) {
            map.put("ultrasound", maps(images, RehearsalImage::toMap));
        }
        if (!rehearsal.body().notInScan().isEmpty()) {
            map.put(
                    "not_in_scan",
                    rehearsal.body().notInScan().stream().sorted().toList());
        }
        return map.with("access", access())
                .with("scenario", plan.scenario().toMap())
                .with("definitions", ReportTerms.of(rehearsal))
                .with("state_sha256", rehearsal.stateHash())
                .with("notice", Disclaimer.TEXT);
    }

    private Map<String, Object> guidance() {
        OrderedValues map = new OrderedValues()
                .with("aids", rehearsal.plan().aids().key())
                .with("aims_by_program", rehearsal.plan().aimsByProgram());
        if (rehearsal.probe().isUsed()) {
            rehearsal.probe().toMap().forEach(map::put);
        }
        return map;
    }

    private Map<String, Object> access() {
        AccessMap map = rehearsal.map();
        OrderedValues access = map.counts().toMap().with("moments", map.cycle().size());
        BreathCycle.limits(map.cycle()).ifPresent(limits -> access.put("limits", limits));
        access.put("avoided", map.avoided().stream().map(NoGoZone::key).toList());
        map.best(AccessMap.SUFFICIENT_MARGIN_MM).ifPresent(v -> {
            OrderedValues best = new OrderedValues()
                    .with("vertex", v)
                    .with("free_moments", map.freeMoments(v))
                    .with("margin_mm", map.marginMm(v))
                    .with("nearest", map.nearest(v))
                    .with("length_mm", map.lengthMm(v));
            if (!Double.isNaN(map.angleDeg(v))) {
                best.put("capsule_angle_deg", map.angleDeg(v));
            }
            access.put("best", best);
        });
        return access.with("by_space", maps(rehearsal.targetAccess().bySpace(), TargetAccess.SpaceCount::toMap));
    }

    private static <T> List<Map<String, Object>> maps(List<T> items, Function<T, Map<String, Object>> values) {
        return items.stream().map(values).toList();
    }

    /** This moment as text, for the date of a report. */
    public static String dateNow() {
        return LocalDateTime.now(ZoneId.systemDefault()).format(DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm"));
    }

    /**
     * The report to be read. But for its date and pictures the same plan gives the same document.
     *
     * @param date when the attempt was made, as text
     */
    public ReportDocument document(List<Picture> needlePictures, List<Picture> mapPictures, String date) {
        RehearsalPlan plan = rehearsal.plan();
        ReportDocument document = new ReportDocument(plan.title(), plan.description());
        document.remark(headline());
        String body = RunSettings.bodyLabel(plan.scenario().anatomy());
        document.paragraph("Date: " + date + ". Body: " + body + ". Breathing: " + breathing(plan.scenario())
                + ". Help: " + plan.aids().label().toLowerCase(Locale.ROOT) + ".");
        String notInScan = rehearsal.body().notInScanSummary();
        if (!notInScan.isEmpty()) {
            document.paragraph("Not in the scan, and so not of this person: " + notInScan + ".");
        }
        goals(document);
        attempt(document);
        figure(document, "The needle (blue) and the target (yellow) at the sample.", needlePictures);
        figure(document, RehearsalImage.caption(images), RehearsalImage.pictures(images));
        rehearsal.path().ifPresent(path -> path(document, path));
        accessTable(document);
        String caption = "Where on the skin the target can be reached by a straight path, in per cent of a breath.";
        figure(document, caption, mapPictures);
        return document.section("What the words mean")
                .points(ReportTerms.of(rehearsal).toArray(String[]::new));
    }

    private static String breathing(Scenario scenario) {
        return scenario.trace().map(file -> "recorded, " + file.getFileName()).orElseGet(scenario::preset);
    }

    private static void figure(ReportDocument document, String caption, List<Picture> pictures) {
        if (!pictures.isEmpty()) {
            document.figure(caption, pictures.toArray(Picture[]::new));
        }
    }

    private String headline() {
        return record.decisive().map(this::headline).orElse("No sample was taken.");
    }

    private String headline(TargetingError sample) {
        return record.verdict() + ": " + record.whichSample()
                + (sample.coreInTargetMm().isEmpty() ? "the tip was " : "the middle of the core was ")
                + mm(sample.distanceMm())
                + " mm from the middle of a target of " + mm(rehearsal.target().diameterMm()) + " mm ("
                + place(sample) + ")." + core(sample)
                + motion();
    }

    static String place(TargetingError sample) {
        return mm(sample.axialMm()) + " mm along the needle, " + mm(sample.lateralMm()) + " mm aside";
    }

    private String core(TargetingError sample) {
        return sample.coreInTargetMm().isEmpty()
                ? ""
                : " Of its core of " + mm(sample.coreMm()) + " mm, "
                        + mm(sample.coreInTargetMm().getAsDouble()) + " mm lay in the target.";
    }

    private String motion() {
        Optional<TargetMotion> motion = rehearsal.path().map(PathOverBreath::motion);
        return motion.map(m -> " The target moves " + mm(m.excursionMm()) + " mm in a breath.")
                .orElse("");
    }

    private void goals(ReportDocument document) {
        List<Goals.GoalResult> results = rehearsal.plan().goals().evaluate(record);
        if (results.isEmpty()) {
            return;
        }
        document.section(rehearsal.goalsReached() ? "Done" : "Not done");
        document.table(
                "What counts as done; chosen, not validated.",
                Column.list("Goal | # Asked | # Reached | "),
                results.stream()
                        .map(r -> List.of(
                                r.label(),
                                number(r.limit()),
                                r.reachedText(RehearsalReport::number),
                                r.reached() ? "yes" : "NO"))
                        .toList());
    }

    private void attempt(ReportDocument document) {
        document.section("The attempt");
        List<List<String>> rows = new ArrayList<>();
        String counts = record.count(AttemptEvent.Kind.SKIN_PUNCTURE) + ", "
                + record.count(AttemptEvent.Kind.REDIRECTION) + ", " + record.count(AttemptEvent.Kind.SKIN_CONTACT);
        rows.add(List.of("Skin punctures, redirections, contacts with the skin", counts));
        rows.add(List.of("Time from the first contact, s", number(record.timeS())));
        rows.add(List.of("Time in the body, s", number(record.insideS())));
        rows.add(List.of("Path length of the tip, mm", number(record.tipTravelMm())));
        rows.add(List.of("Time in structures at risk, s", number(record.inNoGoS())));
        record.secondsIn().forEach((zone, s) -> {
            String note = record.avoided().contains(zone) ? "" : " (permitted by the plan)";
            rows.add(List.of("Time in " + zone.label() + ", s" + note, number(s)));
        });
        if (record.needle().coreMm() > 0) {
            rows.add(List.of("Touched by the throw of a core", record.zones().coreText()));
        }
        rows.add(List.of("Contacts with bone", "" + record.count(AttemptEvent.Kind.BONE_CONTACT)));
        rows.add(List.of("Target moved meanwhile, mm", number(record.targetExcursionMm())));
        String warning = record.capsulePullMm() > AttemptRecord.PULL_WARNING_MM ? " (warning)" : "";
        rows.add(List.of("Capsule pulled aside at most, mm", number(record.capsulePullMm()) + warning));
        rows.add(List.of("Needle turned by the liver at most, degrees", number(record.rotationByLiverDeg())));
        NeedleLoads loads = record.loads();
        rows.add(List.of("Greatest force along the needle, N", loads.peaks()));
        rows.add(List.of("Capsule pushed before it was cut, mm", mm(loads.capsulePushMm())));
        rows.add(List.of(
                "Side load at the capsule, N; needle bent by, mm",
                number(loads.sideN()) + "; " + number(loads.bendingMm())));
        ProbeUse probe = rehearsal.probe();
        long aims = rehearsal.plan().aimsByProgram();
        rows.add(List.of("Pointed by the program (0: by hand alone), times", "" + aims));
        if (probe.isUsed()) {
            rows.add(List.of("Probe on the skin, s", number(probe.probeS())));
            rows.add(List.of("Tip in the body and out of the beam, s", number(probe.tipUnseenS())));
            String share = Numbers.format(" (%.0f %%)", 100 * probe.needleInBeamShare());
            rows.add(List.of("Needle in the beam on average, mm", number(probe.needleInBeamMm()) + share));
        }
        document.table("", Column.list("Measure | # Value"), rows);
        List<Column> columns = new ArrayList<>(List.of(Column.text("Event")));
        List.of("Depth, mm", "Time, s", "Breath", "Phase").forEach(name -> columns.add(Column.number(name)));
        columns.add(Column.text("Breathing"));
        document.table(
                "In order",
                columns,
                record.events().stream().map(RehearsalReport::row).toList());
        document.table(
                "Closest approaches of the needle",
                Column.list("Structure | # Distance, mm"),
                record.closest().stream()
                        .sorted(Comparator.comparingDouble(Approach::distanceMm))
                        .limit(MAX_APPROACHES)
                        .map(a -> List.of(a.label(), mm(a.distanceMm())))
                        .toList());
    }

    private static List<String> row(AttemptEvent e) {
        String kind = e.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
        String name = (kind + " " + e.structure()).strip();
        return List.of(
                name,
                mm(e.depthMm()),
                number(e.timeS()),
                "" + e.breath(),
                number(e.position()),
                e.phase().label());
    }

    private static void path(ReportDocument document, PathOverBreath path) {
        document.section("The path over a breath");
        PathAnalysis rest = path.analyses().get(0);
        document.paragraph("At end-expiration: "
                + rest.way().label() + ", "
                + mm(rest.lengthMm()) + " mm to the middle of the target, "
                + rest.crossings().stream()
                        .map(c -> c.label() + " from " + mm(c.fromMm()) + " to " + mm(c.toMm()) + " mm")
                        .collect(Collectors.joining(", "))
                + ". Free at " + path.freeMoments() + " of "
                + path.analyses().size() + " moments"
                + limits(path.cycle()) + ".");
        List<List<String>> rows = new ArrayList<>();
        for (int m = 0; m < path.analyses().size(); m++) {
            BreathMoment moment = path.cycle().get(m);
            String reasons = path.reasons(m).isEmpty() ? "free" : String.join(", ", path.reasons(m));
            rows.add(List.of(
                    number(moment.timeS()),
                    moment.label().label(),
                    reasons,
                    PathAdvice.margin(path.margins().get(m).mm())));
        }
        document.table("", Column.list("# Time, s | Breathing | Path | # Margin, mm"), rows);
    }

    /** What of the breathing is not judged, as the end of a sentence; empty for nothing. */
    static String limits(List<BreathMoment> cycle) {
        return BreathCycle.limits(cycle).map(limits -> "; " + limits).orElse("");
    }

    private void accessTable(ReportDocument document) {
        document.section("Where the target can be reached from");
        AccessMap.Counts counts = rehearsal.map().counts();
        document.paragraph("Of " + counts.points() + " points of the skin the needle reaches the target from "
                + counts.inReach() + "; " + counts.free() + " are free over the whole breath, " + counts.part()
                + " in part of it" + limits(rehearsal.map().cycle()) + ".");
        document.table(
                "Points in reach, by where their path passes the cage at end-expiration",
                Column.list("Where | # Free | # In part | # Never"),
                rehearsal.targetAccess().bySpace().stream()
                        .map(r -> List.of(r.space(), "" + r.free(), "" + r.part(), "" + r.never()))
                        .toList());
    }

    private static String mm(double value) {
        return Numbers.format("%.1f", value);
    }

    private static String number(double value) {
        boolean whole = value == Math.rint(value) && Math.abs(value) < 1e6;
        return Numbers.format(whole ? "%.0f" : "%.2f", value);
    }
}
