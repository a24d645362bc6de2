package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Settings;
import org.phrenic.study.paper.Claim.Verdict;

/** The report: every table, figure and claim of the paper in its order, as printed and as found here. */
public final class ReproductionReport {
    private static final String TITLE = "Villard, Bourne and Bello 2009, reproduced";
    private static final String LEAD =
            "Every table, figure and claim of \"Interactive Simulation of Diaphragm Motion Through Muscle and Rib"
                    + " Kinematics\" (Recent Advances in the 3D Physiological Human, Springer 2009, pp. 91-103, doi"
                    + " 10.1007/978-1-84882-565-9_6), as printed and as found here. No picture is the paper's; its numbers"
                    + " are restated.";

    private final Reproduction found;
    private final PatientResults patients;
    private final Map<Integer, List<Picture>> pictures;
    private final Map<String, List<Picture>> segmented;
    private final Map<String, List<Picture>> distances;
    private final String noPictures;
    private final String madeBy;

    /**
     * A report.
     *
     * @param patients what was found of them
     * @param pictures of figures 1 to 3, by their number
     * @param segmented of figure 4, by the name of a patient
     * @param distances of figure 5, likewise
     * @param noPictures where a figure has no pictures: why, in one sentence
     * @param madeBy program and version
     */
    public ReproductionReport(
            Reproduction found,
            PatientResults patients,
            Map<Integer, List<Picture>> pictures,
            Map<String, List<Picture>> segmented,
            Map<String, List<Picture>> distances,
            String noPictures,
            String madeBy) {
        this.found = found;
        this.patients = patients;
        this.segmented = Map.copyOf(segmented);
        this.distances = Map.copyOf(distances);
        this.pictures = Map.copyOf(pictures);
        this.noPictures = noPictures;
        this.madeBy = madeBy;
    }

    /** All of it. */
    public ReportDocument document() {
        ReportDocument report = new ReportDocument(TITLE, LEAD);
        ModelSection model = new ModelSection(found);
        SpeedSection speed = new SpeedSection(found);
        MotionSection motion = new MotionSection(found);
        PhysiologySection physiology = new PhysiologySection(found);
        PatientSection patient = new PatientSection(patients, segmented, distances, noPictures);
        addSummary(report, motion.claims(), speed.claims(), physiology.claims(), patient.claims());
        report.section("Fig. 1: anatomy and attachment points");
        addFigure(
                report,
                1,
                "Fig. 1. Thorax of the virtual adult male, and the attachment points of its diaphragm (orange): xiphoid,"
                        + " costal margin, ends of ribs 11 and 12, lumbar vertebrae. The paper shows a commercial anatomy set"
                        + " (Anatomium), which is not free; this body is generated from a table of measures.");
        model.addAttachments(report);
        model.add(report);
        report.section("Fig. 2: the interface");
        addFigure(
                report,
                2,
                "Fig. 2. The interface, in the middle of a deep breath: the window's own view, docks and status line,"
                        + " painted without a screen; its menu and tool bar are left out. The paper's part a shows the"
                        + " model; its parts b to d show patients.");
        addInterfaceTables(report);
        report.section("Fig. 3: the motion of the diaphragm");
        addFigure(
                report,
                3,
                "Fig. 3. A deep breath: the diaphragm at the end of inhale (wireframe) and at the end of exhale (surface; red"
                        + " muscle, pale tendon), and how far each point has gone in between. Seen from the front; the"
                        + " patient's right is on the left.");
        motion.add(report);
        speed.add(report);
        physiology.add(report);
        patient.add(report);
        addFutureWork(report);
        addProvenance(report);
        return report;
    }

    private void addFigure(ReportDocument report, int number, String caption) {
        List<Picture> shown = pictures.getOrDefault(number, List.of());
        if (shown.isEmpty()) {
            report.remark("Fig. " + number + " has no picture here. " + noPictures);
        } else {
            report.add(new Figure(caption, shown));
        }
    }

    private void addSummary(
            ReportDocument report, List<Claim> motion, List<Claim> speed, List<Claim> physiology, List<Claim> patient) {
        report.section("At a glance");
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("Figures"));
        for (int number = 1; number <= 3; number++) {
            boolean there = !pictures.getOrDefault(number, List.of()).isEmpty();
            String what = List.of("anatomy and attachment points", "the interface", "motion of the diaphragm")
                    .get(number - 1);
            rows.add(List.of(
                    "Fig. " + number + ": " + what, "", there ? Verdict.SHOWN.label() : "no picture could be made"));
        }
        add(rows, "What fig. 3 shows", motion);
        add(rows, "Table 1 and what is said of it", speed);
        add(rows, "Physiology", physiology);
        add(rows, "Patients", patient);
        report.table(
                "Verdicts: agrees or differs by the rule stated with each claim below.",
                List.of(Column.text("of the paper"), Column.text("found here"), Column.text("verdict")),
                rows);
    }

    private static void add(List<List<String>> rows, String heading, List<Claim> claims) {
        rows.add(List.of(heading));
        claims.forEach(
                c -> rows.add(List.of(c.statement(), c.measured(), c.verdict().label())));
    }

    private void addInterfaceTables(ReportDocument report) {
        List<Column> columns = List.of(Column.text("the paper"), Column.text("here"));
        report.table(
                "What can be tuned while it runs.",
                columns,
                List.of(
                        List.of("types of breathing", String.join(", ", BreathingPreset.names()) + "; recorded traces"),
                        List.of("breath hold", "hold, at any moment"),
                        List.of("ribs' rotation", keys("rib_rotation")),
                        List.of(
                                "diaphragm's muscle force intensity",
                                keys("muscle_activation", "muscle_force_mn", "left_over_right")),
                        List.of(
                                "damping, stiffness, mass, step",
                                "these and more: " + Materials.parameters().size()
                                        + " parameters, the time step and the integrator")));
        report.table(
                "What is displayed.",
                columns,
                List.of(
                        List.of("skin, by transparency, rigid", "skin, clear, carried by ribs and belly"),
                        List.of("spine, rigid", "the same"),
                        List.of("ribs, by kinematics", "the same"),
                        List.of("sternum and ligaments, a very stiff mass-spring system", "the same"),
                        List.of("diaphragm", "diaphragm, in tissues, displacement or change of area"),
                        List.of("-", "lungs, liver, springs, rigid links, attachments, fibres, action lines, axes")));
    }

    private static String keys(String... keys) {
        return Arrays.stream(keys)
                .map(Settings::parameter)
                .map(p -> p.label() + " (" + p.key() + ")")
                .collect(Collectors.joining(", "));
    }

    private static void addFutureWork(ReportDocument report) {
        report.section("What the paper leaves to the future");
        report.table(
                "",
                List.of(Column.text("the paper"), Column.text("here")),
                List.of(
                        List.of(
                                "liver biopsy planning and rehearsal",
                                "phrenic rehearse: a needle in the body that breathes"),
                        List.of(
                                "monitoring lung motion in radiotherapy",
                                "phrenic run --meshes: the moving lungs; phrenic compare: their distance to others"),
                        List.of(
                                "patient-specific segmentations, meshes and diaphragm actions",
                                "phrenic import: a body of a segmented scan; phrenic fit: its breath tuned to a second scan")));
    }

    private void addProvenance(ReportDocument report) {
        report.section("How this was made");
        report.points(
                "By " + madeBy + ", with: phrenic reproduce --out DIR" + (found.quick() ? " --quick" : ""),
                "Breaths: virtual adult male, "
                        + found.breathResolution().name().toLowerCase(Locale.ROOT) + " resolution ("
                        + SpeedSection.grouped(found.breathResolution().vertices())
                        + " vertices that move); of pictures low resolution, so that a wireframe can be read. The same"
                        + " command gives the same numbers, but for those of speed and of the window.",
                "Machine: " + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ", "
                        + Runtime.getRuntime().availableProcessors() + " processors, Java "
                        + System.getProperty("java.version") + ". Speeds are of this machine at this moment.");
    }
}
