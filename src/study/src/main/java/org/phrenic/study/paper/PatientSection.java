package org.phrenic.study.paper;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.study.ReportNumbers.grouped;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.fit.InspiratoryHold;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.paper.PatientCase.DistanceChange;

/** The paper's patients (figs. 4 and 5, table 2) and the patients of this study. */
record PatientSection(PatientResults results, ReportPictures pictures) {

    void add(ReportDocument report) {
        report.section("Figs. 4 and 5, table 2: the patients");
        if (!results.missingNote().isEmpty()) {
            report.remark(results.missingNote());
        }
        report.paragraph(PaperTexts.text(
                "patients", ifReal("patients-real"), mesh(results.cases().get(0))));
        for (PatientCase patient : results.cases()) {
            String name = patient.name();
            String levels = PaperTexts.text(patient.synthetic() ? "levels-synthetic" : "levels-real");
            pictures.add(report, 4, pictures.segmented().get(name), PaperTexts.text("figure-4", name, levels));
        }
        addMeshSizes(report);
        for (PatientCase patient : results.cases()) {
            String name = patient.name();
            DistanceChange change = patient.lungChange();
            String caption = PaperTexts.text(
                    "figure-5", name, meanAndDeviation(change.before()), meanAndDeviation(change.after()));
            pictures.add(report, 5, pictures.distances().get(name), caption);
        }
        addDistances(report);
        Claim.addTable(report, claims());
        report.points(results.cases().stream()
                .flatMap(patient -> patient.notes().stream().map(note -> patient.name() + ": " + note + "."))
                .toArray(String[]::new));
    }

    private String ifReal(String text) {
        return results.areRealPatients() ? PaperTexts.text(text) : "";
    }

    private void addMeshSizes(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("the paper's", "diaphragm", "6,633", "13,267"));
        for (PatientCase patient : results.cases()) {
            rows.add(row(patient, "diaphragm", patient.diaphragm()));
            patient.lungs()
                    .forEach(lung -> rows.add(row(
                            patient,
                            lung.target().name() + ", end of inhale",
                            lung.target().surface())));
        }
        report.table(
                PaperTexts.text("meshes-caption", ifReal("meshes-real")),
                PaperTexts.columns(2, "patient", "surface", "nodes", "triangles"),
                rows);
    }

    private static List<String> row(PatientCase patient, String what, TriangleMesh mesh) {
        return List.of(patient.name(), what, grouped(mesh.vertexCount()), grouped(mesh.triangleCount()));
    }

    private void addDistances(ReportDocument report) {
        List<List<String>> rows = PaperTexts.rows("distances");
        for (PatientCase patient : results.cases()) {
            rows.add(row(patient.name() + ", lungs", patient.data(), patient.lungChange()));
            patient.lungBaseChange()
                    .ifPresent(bases -> rows.add(row(patient.name() + ", bases", patient.data(), bases)));
            patient.paperLungChange()
                    .ifPresent(
                            lungs -> rows.add(row(patient.name() + ", lungs, paper's method", patient.data(), lungs)));
            patient.paperBaseChange()
                    .ifPresent(
                            bases -> rows.add(row(patient.name() + ", bases, paper's method", patient.data(), bases)));
        }
        String[] headings = {"subject", "data", "no model", "rms", "95 %", "with the model", "rms", "95 %", "ratio"};
        report.table(PaperTexts.text("distances-caption"), PaperTexts.columns(2, headings), rows);
    }

    private static List<String> row(String who, String data, DistanceChange change) {
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
        return format("%.1f", value);
    }

    private static String hundredths(double value) {
        return format("%.2f", value);
    }

    List<Claim> claims() {
        TriangleMesh mesh = results.cases().get(0).diaphragm();
        String size = grouped(mesh.vertexCount()) + " nodes, " + grouped(mesh.triangleCount()) + " triangles";
        List<Claim> claims = new ArrayList<>(List.of(
                PaperTexts.claim("patient-mesh", Verdict.SHOWN, size),
                nearer("patient-distance", results.cases().stream().map(PatientCase::lungChange))));
        if (results.cases().stream().anyMatch(c -> c.paperFit().isPresent())) {
            claims.add(nearer(
                    "patient-distance-paper",
                    results.cases().stream().map(PatientCase::paperLungChange).flatMap(Optional::stream)));
        }
        claims.add(speed());
        return claims;
    }

    private Claim nearer(String key, Stream<DistanceChange> changes) {
        boolean real = results.areRealPatients();
        List<Double> ratios = changes.map(DistanceChange::ratio).sorted().toList();
        double largest = ratios.get(ratios.size() - 1);
        return PaperTexts.claim(
                key,
                real && !results.quick() ? Verdict.agrees(largest < 1) : Verdict.SHOWN,
                "times " + (ratios.size() > 1 ? hundredths(ratios.get(0)) + " to " : "") + hundredths(largest)
                        + (real ? "" : " (a synthetic patient)"),
                real ? "" : " A synthetic patient agrees with nothing: it only shows the way.",
                results.quick() ? " A quick reproduction tunes nothing." : "");
    }

    private Claim speed() {
        Optional<PatientCase> timed = results.cases().stream()
                .filter(c -> !Double.isNaN(c.fit().search().cpuPerEvaluationS()))
                .findFirst();
        if (timed.isEmpty()) {
            return PaperTexts.notMeasured("patient-speed");
        }
        double steps = InspiratoryHold.searchedAtS(timed.get().fit().scenario())
                / timed.get().fit().scenario().timeStepS()
                / timed.get().fit().search().cpuPerEvaluationS();
        return PaperTexts.claim("patient-speed", Verdict.SHOWN, grouped(steps) + " " + mesh(timed.get()));
    }

    /** The mesh of a fit, as in {@code at low resolution}. */
    private static String mesh(PatientCase patient) {
        long vertices = patient.fit().scenario().get(OrganSettings.MESH_VERTICES);
        return vertices > 0 ? "on a mesh of " + grouped((double) vertices) + " vertices" : "at low resolution";
    }
}
