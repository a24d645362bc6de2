package org.phrenic.study.paper;

import static org.phrenic.study.ReportNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.paper.Reproduction.Run;

/** What the paper says about its fig. 3: how tendon and muscle move, and the three phenomena that move them. */
final class MotionSection {
    private static final String MUSCLE = "muscle_edge_change_percent";
    private static final String TENDON = "tendon_edge_change_percent";
    /** The tendon keeps its geometry: its edges change by less than this share of what the muscle's do. */
    private static final double MAX_TENDON_SHARE = 0.25;
    /** It is the rigid links that keep it: without them its edges change so many times as much. */
    private static final double MIN_CHANGE_WITHOUT_LINKS = 1.5;

    private final Reproduction found;

    MotionSection(Reproduction found) {
        this.found = found;
    }

    void add(ReportDocument report) {
        report.paragraph("The paper begins at the end of inhale (wireframe) and ends at the end of exhale (surface). So"
                + " does this figure; as the bodies here are given at end-expiration, the breath before it is simulated"
                + " from there.");
        Claim.table(report, "", claims());
        addTissueTable(report);
        addPhenomenaTable(report);
    }

    List<Claim> claims() {
        return List.of(
                tendonGeometryClaim(
                        "The tendon has kept its geometry, the muscle has extended more",
                        Run.DEEP,
                        "Model as used here."),
                tendonGeometryClaim(
                        "The same, with the paper's material",
                        Run.PUBLISHED,
                        "One stiffness for both tissues; the action lines pull at the tendon too."),
                tensegrityClaim(),
                phenomenonClaim(
                        "Relaxing muscle raises the domes",
                        Run.DEEP_MUSCLE,
                        breath -> breath.domeDescentMm(),
                        "mm for both domes, ribs still"),
                phenomenonClaim(
                        "The ribs' rotation presses the diaphragm on each side",
                        Run.DEEP_RIBS,
                        breath -> breath.change("transverse_change_mm"),
                        "mm less across, muscle still"),
                phenomenonClaim(
                        "The sternum goes backward and pushes the diaphragm",
                        Run.DEEP_RIBS,
                        breath -> breath.change("ap_change_mm"),
                        "mm less from front to back, muscle still"));
    }

    private Claim tendonGeometryClaim(String what, Run run, String why) {
        Optional<PaperBreath> breath = found.breath(run);
        String printed = "seen in fig. 3";
        if (breath.isEmpty()) {
            return Claim.notMeasured(what, printed);
        }
        double tendon = breath.get().atEndInspiration(TENDON);
        double muscle = breath.get().atEndInspiration(MUSCLE);
        return new Claim(
                what,
                printed,
                "edges change by " + number(tendon) + " % in tendon, " + number(muscle) + " % in muscle (rms)",
                Verdict.agrees(tendon < MAX_TENDON_SHARE * muscle),
                why + " Kept: less than a quarter of the muscle's change.");
    }

    private Claim tensegrityClaim() {
        String what = "It is the tensegrity that keeps the tendon";
        String printed = "said of fig. 3";
        Optional<PaperBreath> with = found.breath(Run.PUBLISHED);
        Optional<PaperBreath> without = found.breath(Run.PUBLISHED_HOMOGENEOUS);
        if (with.isEmpty() || without.isEmpty()) {
            return Claim.notMeasured(what, printed);
        }
        double linked = with.get().atEndInspiration(TENDON);
        double free = without.get().atEndInspiration(TENDON);
        return new Claim(
                what,
                printed,
                "tendon edges change by " + number(linked) + " % with links, " + number(free) + " % without",
                Verdict.agrees(free > MIN_CHANGE_WITHOUT_LINKS * linked),
                "By links: without them edges change at least 1.5 times as much. Links from face to face hold the thickness of the sheet and not its area: both faces stretch together,"
                        + " with one link a node and with three. What keeps the tendon in the model as used here is that"
                        + " its springs are ten times as stiff.");
    }

    private interface Measure {
        double of(PaperBreath breath);
    }

    private Claim phenomenonClaim(String what, Run run, Measure measure, String unit) {
        String printed = "seen in fig. 3";
        return found.breath(run)
                .map(breath -> new Claim(
                        what,
                        printed,
                        number(measure.of(breath)) + " " + unit,
                        Verdict.agrees(measure.of(breath) > 0),
                        "From end-inspiration to end-expiration of a deep breath."))
                .orElseGet(() -> Claim.notMeasured(what, printed));
    }

    private void addTissueTable(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        for (Run run : List.of(Run.DEEP, Run.PUBLISHED, Run.PUBLISHED_THREE_LINKS, Run.PUBLISHED_HOMOGENEOUS)) {
            found.breath(run)
                    .ifPresent(b -> rows.add(List.of(
                            run.label(),
                            number(b.domeDescentMm()),
                            number(b.atEndInspiration(MUSCLE)),
                            number(b.atEndInspiration(TENDON)),
                            number(b.atEndInspiration("tendon_bent_mm")),
                            number(b.atEndInspiration("fibre_shortening_percent")))));
        }
        report.table(
                "What the tissues do in a deep breath: change of the lengths of edges, rms; how far the tendon is from"
                        + " where the best rigid motion would carry it, rms; mean shortening of fibres.",
                List.of(
                        Column.text("breath"),
                        Column.number("domes, mm"),
                        Column.number("muscle, %"),
                        Column.number("tendon, %"),
                        Column.number("tendon bent, mm"),
                        Column.number("fibres, %")),
                rows);
    }

    private void addPhenomenaTable(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        for (Run run : List.of(Run.DEEP, Run.DEEP_MUSCLE, Run.DEEP_RIBS)) {
            found.breath(run)
                    .ifPresent(b -> rows.add(List.of(
                            run.label(),
                            number(-b.change("dome_right_mm")),
                            number(-b.change("dome_left_mm")),
                            number(b.change("transverse_change_mm")),
                            number(b.change("ap_change_mm")),
                            number(b.change("sternum_cranial_mm")),
                            number(b.change("lung_volume_change_ml")))));
        }
        if (rows.size() > 1) {
            report.table(
                    "Three phenomena, apart and together: what inspiration changes when the whole breath is deepest.",
                    List.of(
                            Column.text("breath"),
                            Column.number("right dome down, mm"),
                            Column.number("left dome down, mm"),
                            Column.number("wider, mm"),
                            Column.number("deeper, mm"),
                            Column.number("sternum up, mm"),
                            Column.number("lungs, ml")),
                    rows);
        }
    }
}
