package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.engine.equilibrium.NewtonEquilibrium;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.ReportValues;

/** Cost and error of solver settings for several scenes: tables, a document and JSON values. */
public final class ErrorReport {
    /** Columns of {@link #cells}. */
    public static final List<Column> COLUMNS = Stream.of(("integrator;step, s;sweeps;refresh, s;rms, mm;rms, %"
                            + ";max, mm;max, %;all, rms mm;all, max mm;CPU, s;wall, s;x real time;")
                    .split(";", -1))
            .map(heading -> new Column(heading, !heading.isEmpty() && !heading.equals("integrator")))
            .toList();

    private final List<ErrorStudy> studies;
    private final Map<String, List<MeshRefinementError>> meshes;

    /**
     * @param studies one per scene
     * @param meshes mesh refinement errors by material; empty if not measured
     */
    public ErrorReport(List<ErrorStudy> studies, Map<String, List<MeshRefinementError>> meshes) {
        this.studies = List.copyOf(studies);
        this.meshes = new LinkedHashMap<>(meshes);
    }

    /**
     * Says which setting of a scene is the cheapest that keeps an error, or that none does.
     *
     * @param scenario that was measured
     * @param mostMm rms error of the diaphragm, mm
     */
    public static String cheapestSentence(ErrorTable measured, Scenario scenario, double mostMm) {
        try {
            return measured.cheapest(scenario, mostMm).sentence(scenario);
        } catch (BadInputException none) {
            return "No setting that was measured keeps this error; " + none.getMessage() + ".";
        }
    }

    /** Table rows, one per setting, cheapest first. */
    public static List<List<String>> cells(ErrorStudy study) {
        return study.points().stream()
                .sorted(Comparator.comparingDouble(ErrorPoint::cpuS))
                .map(p -> cells(study, p))
                .toList();
    }

    private static List<String> cells(ErrorStudy study, ErrorPoint p) {
        List<String> cells = new ArrayList<>(List.of(
                p.settings().integrator().label(),
                SolverSettings.number(p.settings().timeStepS()) + (p.substeps() > 1 ? " / " + p.substeps() : ""),
                Integer.toString(p.settings().sweeps()),
                SolverSettings.number(p.settings().refreshS())));
        double rmsPercent = study.percent(p.rmsMm());
        double maxPercent = study.percent(p.maxMm());
        double[] figures = {
            p.rmsMm(), rmsPercent, p.maxMm(), maxPercent, p.allRmsMm(), p.allMaxMm(), p.cpuS(), p.wallS(), p.realTime()
        };
        Arrays.stream(figures).mapToObj(ErrorReport::number).forEach(cells::add);
        String front = p.paretoOptimal() ? "front" : study.isResolved(p) ? "" : "unresolved";
        cells.add(p.isDefault() ? front + (front.isEmpty() ? "default" : ", default") : front);
        return cells;
    }

    /** Describes the scene and its reference solution. */
    public static String heading(ErrorStudy study) {
        double[] uncertainty = study.referenceUncertainty();
        int threads = study.scenario().threads();
        String simulated = SolverSettings.number(study.simulatedS()) + " s of ";
        String breath = simulated + "a breath, preset " + study.scenario().preset();
        String scene = format(
                "%s: %d nodes of %s, %s, domes go down %.2f mm, %d thread%s. Reference: %s; with steps twice as long"
                        + " its",
                title(study),
                study.nodes(),
                SettingChoice.body(study.scenario()),
                breath,
                study.excursionMm(),
                threads,
                threads == 1 ? "" : "s",
                study.reference().label());
        String pattern =
                " diaphragm is %.2g mm rms (%.2g %%) and at most %.2g mm elsewhere, all its nodes %.2g mm rms and"
                        + " at most %.2g mm.";
        double percent = study.percent(uncertainty[0]);
        long unresolved =
                study.points().stream().filter(p -> !study.isResolved(p)).count();
        String ranked = unresolved == 0
                ? ""
                : format(
                        " %d of %d errors are below three times that and not resolved: they are not on the front.",
                        unresolved, study.points().size());
        return scene
                + format(pattern, uncertainty[0], percent, uncertainty[1], uncertainty[2], uncertainty[3])
                + ranked;
    }

    private static String title(ErrorStudy study) {
        return study.scenario().material().label() + ", "
                + ReportNumbers.label(study.scenario().resolution());
    }

    /**
     * The complete report.
     *
     * @param provenance how it was made: commit, command, machine, date
     */
    public ReportDocument document(List<String> provenance) {
        ReportDocument page = new ReportDocument(
                "Speed against error",
                "Distance of the diaphragm's nodes (and of all nodes) from a reference, ten times a second over"
                        + " the simulated time, against the processor time that it takes.");
        page.points(provenance.toArray(String[]::new));
        for (ErrorStudy study : studies) {
            page.section(title(study));
            page.paragraph(heading(study));
            page.table("", COLUMNS, cells(study));
            study.equilibrium().forEach(lag -> page.paragraph(lagSentence(study, lag)));
            if (!study.skipped().isEmpty()) {
                page.paragraph("Not run:");
                page.points(study.skipped().toArray(String[]::new));
            }
        }
        if (!meshes.isEmpty()) {
            page.section("Meshes");
            meshSentences().forEach(page::paragraph);
        }
        return page;
    }

    /** Describes the distance from equilibrium at one phase. */
    public static String lagSentence(ErrorStudy study, EquilibriumLag lag) {
        NewtonEquilibrium.Result newton = lag.newton();
        String distances = "At %.1f s the reference's diaphragm is %.3g mm rms (%.2g %%) and at most %.3g mm from"
                + " where it comes to rest with ribs, muscle and pressure of that time, and %.3g mm rms from the"
                + " equilibrium that Newton's method finds.";
        double percent = study.percent(lag.heldRmsMm());
        String outcome = newton.converged() ? "converged to" : "not converged,";
        double residual = newton.residualsMn()[newton.residualsMn().length - 1];
        String more = newton.activeSetChanges() == 0 ? "" : ", " + newton.activeSetChanges() + " more would change";
        return format(distances, lag.timeS(), lag.heldRmsMm(), percent, lag.heldMaxMm(), lag.rmsMm())
                + format(
                        " Newton: %s %.1g mN a node, %d constraints bind%s;",
                        outcome, residual, newton.activeRows(), more)
                + format(" the two are %.2g mm rms apart.", lag.relaxationErrorMm());
    }

    /** Describes the mesh refinement errors, one sentence each. */
    public List<String> meshSentences() {
        List<String> lines = new ArrayList<>();
        meshes.forEach((material, errors) -> errors.forEach(e -> lines.add(format(
                        "%s: the sheet of %d vertices (%s) moves %.3g mm rms",
                        material, e.vertices(), e.resolution(), e.rmsMm())
                + format(
                        " and at most %.3g mm otherwise than that of resolution %s;",
                        e.maxMm(), e.referenceResolution())
                + format(" its domes go down %+.2f mm more.", e.excursionDifferenceMm()))));
        return lines;
    }

    /** The report as values for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        map.put("scenes", studies.stream().map(ErrorReport::values).toList());
        Map<String, Object> coarser = new LinkedHashMap<>();
        meshes.forEach((material, errors) ->
                coarser.put(material, errors.stream().map(ReportValues::of).toList()));
        map.put("meshes", coarser);
        return map;
    }

    private static Map<String, Object> values(ErrorStudy study) {
        return new OrderedValues()
                .with("scenario", study.scenario().toMap())
                .with("nodes", study.nodes())
                .with("until_s", study.simulatedS())
                .with("excursion_mm", study.excursionMm())
                .with("reference", study.reference().label())
                .with("reference_halving_rms_mm", study.referenceUncertainty()[0])
                .with("reference_halving_max_mm", study.referenceUncertainty()[1])
                .with("reference_halving_all_rms_mm", study.referenceUncertainty()[2])
                .with("reference_halving_all_max_mm", study.referenceUncertainty()[3])
                .with(
                        "settings",
                        ErrorTable.of(List.of(study)).rows().stream()
                                .map(ErrorTable.Row::measurement)
                                .toList())
                .with(
                        "equilibrium",
                        study.equilibrium().stream().map(ErrorReport::values).toList())
                .with("left_out", study.skipped());
    }

    private static Map<String, Object> values(EquilibriumLag lag) {
        Map<String, Object> map = ReportValues.of(lag);
        map.remove("newton");
        map.put("newton_converged", lag.newton().converged());
        map.put("newton_settled", lag.newton().activeSetSettled());
        map.put("newton_residuals_mn", lag.newton().residualsMn());
        map.put("newton_binding", lag.newton().activeRows());
        return map;
    }

    private static String number(double value) {
        double size = Math.abs(value);
        String format = size == 0 || size >= 100
                ? "%.0f"
                : size < 1e-3 ? "%.1e" : size < 0.1 ? "%.4f" : size < 10 ? "%.2f" : "%.1f";
        return format(format, value);
    }
}
