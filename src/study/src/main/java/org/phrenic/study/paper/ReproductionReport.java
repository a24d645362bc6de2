package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Resolution;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Settings;
import org.phrenic.study.Attempts;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.paper.Reproduction.Run;
import org.phrenic.study.speed.SpeedCase;

/**
 * Report with every table, figure and claim of the paper in its order, as printed and as reproduced.
 *
 * @param provenance how it was made: commit, command, machine, date
 */
public record ReproductionReport(
        Reproduction reproduction, PatientResults patients, ReportPictures pictures, List<String> provenance) {
    private static final List<Column> PAPER_AND_HERE = PaperTexts.columns(2, "the paper", "here");

    public ReproductionReport {
        provenance = List.copyOf(provenance);
    }

    /** The complete report. */
    public ReportDocument document() {
        ReportDocument report =
                new ReportDocument("Villard, Bourne and Bello 2009, reproduced", PaperTexts.text("lead"));
        ModelSection model = new ModelSection(reproduction);
        SpeedSection speed = new SpeedSection(reproduction);
        MotionSection motion = new MotionSection(reproduction);
        PhysiologySection physiology = new PhysiologySection(reproduction);
        PatientSection patient = new PatientSection(patients, pictures);
        addSummary(report, motion.claims(), speed.claims(), physiology.claims(), patient.claims());
        addSchemes(report);
        Attempts.addFailures(report, "Not simulated", reproduction.failures());
        report.section("Fig. 1: anatomy and attachment points");
        addFigure(report, 1);
        model.addAttachments(report);
        model.add(report);
        report.section("Fig. 2: the interface");
        addFigure(report, 2);
        addInterfaceTables(report);
        report.section("Fig. 3: the motion of the diaphragm");
        addFigure(report, 3);
        motion.add(report);
        speed.add(report);
        physiology.add(report);
        patient.add(report);
        report.section("What the paper leaves to the future");
        report.table("", PAPER_AND_HERE, PaperTexts.rows("future"));
        addProvenance(report);
        return report;
    }

    private void addFigure(ReportDocument report, int number) {
        pictures.add(report, number, pictures.figures().get(number), PaperTexts.text("figure-" + number));
    }

    private void addSummary(
            ReportDocument report, List<Claim> motion, List<Claim> speed, List<Claim> physiology, List<Claim> patient) {
        report.section("At a glance");
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("Figures"));
        Map<Integer, String> figures =
                Map.of(1, "anatomy and attachment points", 2, "the interface", 3, "motion of the diaphragm");
        for (int number = 1; number <= 3; number++) {
            boolean shown = !pictures.figures().getOrDefault(number, List.of()).isEmpty();
            String verdict = shown ? Verdict.SHOWN.label() : "no picture could be made";
            rows.add(List.of("Fig. " + number + ": " + figures.get(number), "", verdict));
        }
        add(rows, "What fig. 3 shows", motion);
        add(rows, "Table 1 and what is said of it", speed);
        add(rows, "Physiology", physiology);
        add(rows, "Patients", patient);
        report.table(
                "Verdicts: agrees or differs by the rule stated with each claim below.",
                PaperTexts.columns(3, "of the paper", "found here", "verdict"),
                rows);
    }

    /** Which material and scheme each figure is of. */
    private static void addSchemes(ReportDocument report) {
        String published = Run.PUBLISHED.scheme();
        String used = Run.DEEP.scheme();
        report.table(
                PaperTexts.text("schemes"),
                PaperTexts.columns(3, "of the paper", "material here", "scheme and step here"),
                List.of(
                        List.of("Fig. 3 and what it shows, the published model", "published", published),
                        List.of("Fig. 3 and what it shows, the model as used here", "physical", used),
                        List.of("Table 1, iterations a second", "published", "rk2, 0.5 ms, whole"),
                        List.of("Real time", "published", published),
                        List.of("Physiology", "physical", used),
                        List.of("Figs. 4 and 5 and table 2, patients", "physical", used),
                        List.of("Fig. 5, patients by the paper's method", "paper", PatientStudy.paperScheme())));
    }

    private static void add(List<List<String>> rows, String heading, List<Claim> claims) {
        rows.add(List.of(heading));
        claims.forEach(
                c -> rows.add(List.of(c.statement(), c.measured(), c.verdict().label())));
    }

    private static void addInterfaceTables(ReportDocument report) {
        List<List<String>> tuned = PaperTexts.rows(
                "tuned",
                String.join(", ", BreathingPreset.names()),
                keys("rib_rotation"),
                keys("muscle_activation", "muscle_force_mn", "left_over_right"),
                Materials.parameters().size());
        report.table("What can be tuned while it runs.", PAPER_AND_HERE, tuned);
        report.table("What is displayed.", PAPER_AND_HERE, PaperTexts.rows("displayed"));
    }

    private static String keys(String... keys) {
        return Arrays.stream(keys)
                .map(Settings::parameter)
                .map(p -> p.label() + " (" + p.key() + ")")
                .collect(Collectors.joining(", "));
    }

    private void addProvenance(ReportDocument report) {
        Resolution measured = reproduction.breathResolution();
        String meshed =
                reproduction.quick() ? "on a coarse mesh" : "at " + ReportNumbers.label(measured) + " resolution";
        String drawn = reproduction.quick() ? "on that mesh" : "at low resolution";
        String vertices = ReportNumbers.grouped(
                reproduction.speed().row(measured, SpeedCase.HETEROGENEOUS).vertices());
        report.section("How this was made");
        report.points(provenance.toArray(String[]::new));
        report.paragraph(
                PaperTexts.text("breaths", meshed, vertices, drawn) + " Speeds are of this machine at this moment.");
    }
}
