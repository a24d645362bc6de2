package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.fit.InspiratoryHold;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.study.paper.Claim.Verdict;

/** The paper's patients, figs. 4 and 5 and table 2, and ours beside them. */
final class PatientSection {
    private final PatientResults found;
    private final Map<String, List<Picture>> segmented;
    private final Map<String, List<Picture>> distances;
    private final String noPictures;

    /**
     * @param segmented pictures in the manner of fig. 4 by the name of a patient
     * @param distances pictures in the manner of fig. 5, likewise
     * @param noPictures why there are none, in one sentence
     */
    PatientSection(
            PatientResults found,
            Map<String, List<Picture>> segmented,
            Map<String, List<Picture>> distances,
            String noPictures) {
        this.found = found;
        this.segmented = segmented;
        this.distances = distances;
        this.noPictures = noPictures;
    }

    void add(ReportDocument report) {
        report.section("Figs. 4 and 5, table 2: the patients");
        if (!found.missingNote().isEmpty()) {
            report.remark(found.missingNote());
        }
        report.paragraph(
                "The paper's patients (two 4D CT of tidal breathing, one volunteer's MRI at two breath holds) are not public. "
                        + (found.areRealPatients()
                                ? "Ours are public scans: both lungs at expiration and at the end of a deep, held inspiration. "
                                : "")
                        + "The paper tuned by hand; here a search of a few breaths at low resolution stands in, and docs/fit.md"
                        + " has longer ones.");
        for (PatientCase patient : found.cases()) {
            figure(
                    report,
                    "Fig. 4",
                    segmented.getOrDefault(patient.name(), List.of()),
                    "Fig. 4, " + patient.name() + ": " + levels(patient)
                            + " The paper shows a diaphragm segmented by hand within its scan, and its mesh.");
        }
        addMeshSizes(report);
        for (PatientCase patient : found.cases()) {
            PatientCase.DistanceChange whole = patient.lungChange();
            figure(
                    report,
                    "Fig. 5",
                    distances.getOrDefault(patient.name(), List.of()),
                    String.format(
                            Locale.ROOT,
                            "Fig. 5, %s: distance of the lungs' surface from that at the end of inhale, in one scale. Left: lungs at the end of exhale (%.1f ± %.1f mm). Right: lungs of the model, breathed in (%.1f ± %.1f mm).",
                            patient.name(),
                            whole.before().mean(),
                            whole.before().deviation(),
                            whole.after().mean(),
                            whole.after().deviation()));
        }
        addDistances(report);
        Claim.table(report, "", claims());
        List<String> notes = new ArrayList<>();
        for (PatientCase patient : found.cases()) {
            patient.notes().forEach(note -> notes.add(patient.name() + ": " + note + "."));
        }
        report.points(notes.toArray(String[]::new));
    }

    private void figure(ReportDocument report, String which, List<Picture> pictures, String caption) {
        if (pictures.isEmpty()) {
            report.remark(which + " has no picture here. " + noPictures);
        } else {
            report.add(new Figure(caption, pictures));
        }
    }

    private static String levels(PatientCase patient) {
        return patient.synthetic()
                ? "lungs at the two breath levels, as a scan would show them, and the body's diaphragm with its mesh."
                : "lungs segmented at the two breath levels, meshed as the paper did; and the diaphragm that was made from"
                        + " their bases, with its mesh.";
    }

    /** Sizes of meshes. */
    private void addMeshSizes(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("the paper's", "diaphragm", "6,633", "13,267"));
        for (PatientCase patient : found.cases()) {
            rows.add(row(patient, "diaphragm", patient.diaphragm()));
            patient.lungs()
                    .forEach(lung -> rows.add(row(
                            patient,
                            lung.target().name() + ", end of inhale",
                            lung.target().surface())));
        }
        report.table(
                "Fig. 4: meshes. 13,267, an odd number of triangles, is no closed surface."
                        + (found.areRealPatients()
                                ? " Lungs go through the paper's steps, windowed sinc (pass band 0.2), 50 % decimation and 200 more"
                                        + " iterations, and are then remeshed to triangles of one size."
                                : ""),
                List.of(
                        Column.text("patient"),
                        Column.text("surface"),
                        Column.number("nodes"),
                        Column.number("triangles")),
                rows);
    }

    private static List<String> row(PatientCase patient, String what, TriangleMesh mesh) {
        return List.of(
                patient.name(),
                what,
                SpeedSection.grouped(mesh.vertexCount()),
                SpeedSection.grouped(mesh.triangleCount()));
    }

    private void addDistances(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("The paper"));
        rows.add(List.of("subject 1", "4D CT", "-", "-", "-", "moved too little", "-", "-", "-"));
        rows.add(List.of("subject 2", "4D CT", "5.8 ± 5", "-", "-", "4.29 ± 3.6", "-", "-", "0.74"));
        rows.add(List.of("subject 3", "MRI, two breath holds", "16 ± 9.4", "-", "-", "12 ± 6.7", "-", "-", "0.75"));
        rows.add(List.of("Here"));
        for (PatientCase patient : found.cases()) {
            rows.add(row(patient.name() + ", lungs", patient.data(), patient.lungChange()));
            patient.lungBaseChange()
                    .ifPresent(bases -> rows.add(row(patient.name() + ", bases", patient.data(), bases)));
        }
        report.table(
                "Fig. 5: distance between the lungs' surface and that of the scan at the end of inhale, mm; without a model, from"
                        + " the end of exhale. The paper: mean ± SD by MeshDev; here both ways, by area. Ratio: of the means.",
                List.of(
                        Column.text("subject"),
                        Column.text("data"),
                        Column.number("no model"),
                        Column.number("rms"),
                        Column.number("95 %"),
                        Column.number("with the model"),
                        Column.number("rms"),
                        Column.number("95 %"),
                        Column.number("ratio")),
                rows);
    }

    private static List<String> row(String who, String data, PatientCase.DistanceChange change) {
        return List.of(
                who,
                data,
                meanAndDeviation(change.before()),
                tenths(change.before().rms()),
                tenths(change.before().percentile95()),
                meanAndDeviation(change.after()),
                tenths(change.after().rms()),
                tenths(change.after().percentile95()),
                hundredths(change.ratio()));
    }

    private static String meanAndDeviation(DistanceSummary d) {
        return tenths(d.mean()) + " ± " + tenths(d.deviation());
    }

    private static String tenths(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    private static String hundredths(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }

    List<Claim> claims() {
        return List.of(
                new Claim(
                        "Fig. 4: patient's diaphragm, segmented and meshed",
                        "6,633 nodes, 13,267 triangles",
                        SpeedSection.grouped(found.cases().get(0).diaphragm().vertexCount()) + " nodes, "
                                + SpeedSection.grouped(
                                        found.cases().get(0).diaphragm().triangleCount()) + " triangles",
                        Verdict.SHOWN,
                        "Our scans show lungs; the diaphragm is a virtual one, brought to their bases."),
                nearer(),
                speed());
    }

    private Claim nearer() {
        List<Double> ratios =
                found.cases().stream().map(c -> c.lungChange().ratio()).sorted().toList();
        double most = ratios.get(ratios.size() - 1);
        return new Claim(
                "Fig. 5: the model brings the lungs nearer to the scan",
                "mean distance times 0.74 and 0.75",
                "times " + (ratios.size() > 1 ? hundredths(ratios.get(0)) + " to " : "") + hundredths(most)
                        + (found.areRealPatients() ? "" : " (a synthetic patient)"),
                found.areRealPatients() && !found.quick() ? Verdict.agrees(most < 1) : Verdict.SHOWN,
                "Agrees if the mean distance of whole lungs gets smaller in every patient."
                        + (found.areRealPatients()
                                ? ""
                                : " A synthetic patient agrees with nothing: it only shows the way.")
                        + (found.quick() ? " A quick reproduction tunes nothing." : ""));
    }

    private Claim speed() {
        String what = "Table 2: iterations a second, a patient";
        String printed = "repeats table 1 in every figure";
        Optional<PatientCase> timed = found.cases().stream()
                .filter(c -> !Double.isNaN(c.fit().cpuPerEvaluationS()))
                .findFirst();
        return timed.map(c -> new Claim(
                        what,
                        printed,
                        SpeedSection.grouped(InspiratoryHold.OBSERVED_AT_S
                                        / c.fit().scenario().timeStepS()
                                        / c.fit().cpuPerEvaluationS())
                                + " at low resolution",
                        Verdict.SHOWN,
                        "As printed the table repeats table 1, vertices included, although the patient's mesh is another: the"
                                + " patient's speed is unknown. Ours is that of the fit's breaths, distances included, by"
                                + " processor time."))
                .orElseGet(() -> Claim.notMeasured(what, printed));
    }
}
