package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.engine.equilibrium.NewtonEquilibrium;

/** Speed against error of several scenes as tables, as a document and as values for JSON. */
public final class ErrorReport {
    /** Columns of {@link #cells}. */
    public static final List<ReportDocument.Column> COLUMNS = List.of(
            ReportDocument.Column.text("integrator"),
            ReportDocument.Column.number("step, s"),
            ReportDocument.Column.number("sweeps"),
            ReportDocument.Column.number("refresh, s"),
            ReportDocument.Column.number("rms, mm"),
            ReportDocument.Column.number("rms, %"),
            ReportDocument.Column.number("max, mm"),
            ReportDocument.Column.number("max, %"),
            ReportDocument.Column.number("all, rms mm"),
            ReportDocument.Column.number("all, max mm"),
            ReportDocument.Column.number("CPU, s"),
            ReportDocument.Column.number("wall, s"),
            ReportDocument.Column.number("x real time"),
            ReportDocument.Column.text(""));

    private final List<ErrorStudy> studies;
    private final Map<String, List<MeshRefinementError>> meshes;

    /**
     * @param studies one a scene
     * @param meshes what coarser meshes change, by material; empty where that was not measured
     */
    public ErrorReport(List<ErrorStudy> studies, Map<String, List<MeshRefinementError>> meshes) {
        this.studies = List.copyOf(studies);
        this.meshes = new LinkedHashMap<>(meshes);
    }

    /** A line a setting, cheapest first. */
    public static List<List<String>> cells(ErrorStudy study) {
        List<List<String>> lines = new ArrayList<>();
        study.points().stream()
                .sorted(Comparator.comparingDouble(ErrorPoint::cpuS))
                .forEach(p -> lines.add(List.of(
                        p.settings().integrator().label(),
                        SolverSettings.number(p.settings().timeStepS())
                                + (p.substeps() > 1 ? " / " + p.substeps() : ""),
                        Integer.toString(p.settings().sweeps()),
                        SolverSettings.number(p.settings().refreshS()),
                        number(p.rmsMm()),
                        number(study.percent(p.rmsMm())),
                        number(p.maxMm()),
                        number(study.percent(p.maxMm())),
                        number(p.allRmsMm()),
                        number(p.allMaxMm()),
                        number(p.cpuS()),
                        number(p.wallS()),
                        number(p.realTime()),
                        (p.paretoOptimal() ? "front" : "")
                                + (p.isDefault() ? (p.paretoOptimal() ? ", " : "") + "default" : ""))));
        return lines;
    }

    /** What was measured and against what, in a sentence or two. */
    public static String heading(ErrorStudy study) {
        return String.format(
                Locale.ROOT,
                "%s, %s: %d nodes, %s breath of %s s, domes go down %.2f mm, %d thread%s. Reference: %s; with steps twice"
                        + " as long its diaphragm is %.2g mm rms (%.2g %%) and at most %.2g mm elsewhere, all its nodes %.2g"
                        + " mm rms and at most %.2g mm.",
                study.scenario().material().label(),
                study.scenario().resolution().name().toLowerCase(Locale.ROOT),
                study.nodes(),
                study.scenario().preset(),
                SolverSettings.number(study.simulatedS()),
                study.excursionMm(),
                study.scenario().threads(),
                study.scenario().threads() == 1 ? "" : "s",
                study.reference().label(),
                study.referenceUncertainty()[0],
                study.percent(study.referenceUncertainty()[0]),
                study.referenceUncertainty()[1],
                study.referenceUncertainty()[2],
                study.referenceUncertainty()[3]);
    }

    /** All of it, to be written as a page. */
    public ReportDocument document() {
        ReportDocument page = new ReportDocument(
                "Speed against error",
                "Distance of the diaphragm's nodes (and of all nodes) from a reference, ten times a second over a breath, against the time that the breath takes to compute.");
        for (ErrorStudy study : studies) {
            page.section(study.scenario().material().label() + ", "
                    + study.scenario().resolution().name().toLowerCase(Locale.ROOT));
            page.paragraph(heading(study));
            page.table("", COLUMNS, cells(study));
            study.equilibrium().forEach(q -> page.paragraph(lagSentence(study, q)));
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

    /** How far from equilibrium a phase is, in a sentence. */
    public static String lagSentence(ErrorStudy study, EquilibriumLag q) {
        NewtonEquilibrium.Result newton = q.newton();
        return String.format(
                Locale.ROOT,
                "At %.1f s the reference's diaphragm is %.3g mm rms (%.2g %%) and at most %.3g mm from the equilibrium of ribs,"
                        + " muscle and pressure at that time, and all its nodes %.3g mm rms from where they come to rest by"
                        + " themselves. Newton: %s %.1g mN a node, %d constraints bind%s; relaxation alone was %.2g mm"
                        + " rms off.",
                q.timeS(),
                q.rmsMm(),
                study.percent(q.rmsMm()),
                q.maxMm(),
                q.relaxedRmsMm(),
                newton.converged() ? "converged to" : "not converged,",
                newton.residualsMn()[newton.residualsMn().length - 1],
                newton.activeRows(),
                newton.activeSetSettled() ? "" : ", " + newton.activeSetChanges() + " more would change",
                q.relaxationErrorMm());
    }

    /** What coarser meshes change, a sentence each. */
    public List<String> meshSentences() {
        List<String> lines = new ArrayList<>();
        meshes.forEach((material, errors) -> errors.forEach(e -> lines.add(String.format(
                Locale.ROOT,
                "%s: the sheet of %d vertices (%s) moves %.3g mm rms and at most %.3g mm otherwise than that of resolution"
                        + " %s; its domes go down %+.2f mm more.",
                material,
                e.vertices(),
                e.resolution(),
                e.rmsMm(),
                e.maxMm(),
                e.referenceResolution(),
                e.excursionDifferenceMm()))));
        return lines;
    }

    /** All of it as values, for JSON. */
    public Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("notice", Disclaimer.TEXT);
        List<Object> scenes = new ArrayList<>();
        for (ErrorStudy study : studies) {
            Map<String, Object> scene = new LinkedHashMap<>();
            scene.put("scenario", study.scenario().toMap());
            scene.put("nodes", study.nodes());
            scene.put("breath_s", study.simulatedS());
            scene.put("excursion_mm", study.excursionMm());
            scene.put("reference", study.reference().label());
            scene.put("reference_halving_rms_mm", study.referenceUncertainty()[0]);
            scene.put("reference_halving_max_mm", study.referenceUncertainty()[1]);
            scene.put("reference_halving_all_rms_mm", study.referenceUncertainty()[2]);
            scene.put("reference_halving_all_max_mm", study.referenceUncertainty()[3]);
            scene.put(
                    "settings",
                    study.points().stream().map(p -> values(study, p)).toList());
            scene.put(
                    "equilibrium",
                    study.equilibrium().stream().map(ErrorReport::values).toList());
            scene.put("left_out", study.skipped());
            scenes.add(scene);
        }
        map.put("scenes", scenes);
        Map<String, Object> coarser = new LinkedHashMap<>();
        meshes.forEach((material, errors) ->
                coarser.put(material, errors.stream().map(ErrorReport::values).toList()));
        map.put("meshes", coarser);
        return map;
    }

    private static Map<String, Object> values(EquilibriumLag q) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("time_s", q.timeS());
        map.put("rms_mm", q.rmsMm());
        map.put("max_mm", q.maxMm());
        map.put("relaxed_rms_mm", q.relaxedRmsMm());
        map.put("relaxed_max_mm", q.relaxedMaxMm());
        map.put("relaxation_left_mm", q.relaxationErrorMm());
        map.put("newton_converged", q.newton().converged());
        map.put("newton_settled", q.newton().activeSetSettled());
        map.put(
                "newton_residuals_mn",
                Arrays.stream(q.newton().residualsMn()).boxed().toList());
        map.put("newton_binding", q.newton().activeRows());
        return map;
    }

    private static Map<String, Object> values(MeshRefinementError e) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("resolution", e.resolution());
        map.put("against", e.referenceResolution());
        map.put("vertices", e.vertices());
        map.put("rms_mm", e.rmsMm());
        map.put("max_mm", e.maxMm());
        map.put("dome_excursion_mm", e.excursionDifferenceMm());
        return map;
    }

    private static Map<String, Object> values(ErrorStudy study, ErrorPoint p) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("integrator", p.settings().integrator().label());
        map.put("time_step_s", p.settings().timeStepS());
        map.put("projection_sweeps", p.settings().sweeps());
        map.put("refresh_s", p.settings().refreshS());
        map.put("substeps", p.substeps());
        map.put("rms_mm", p.rmsMm());
        map.put("max_mm", p.maxMm());
        map.put("rms_percent", study.percent(p.rmsMm()));
        map.put("max_percent", study.percent(p.maxMm()));
        map.put("all_rms_mm", p.allRmsMm());
        map.put("all_max_mm", p.allMaxMm());
        map.put("cpu_s", p.cpuS());
        map.put("wall_s", p.wallS());
        map.put("real_time", p.realTime());
        map.put("front", p.paretoOptimal());
        map.put("usual", p.isDefault());
        return map;
    }

    private static String number(double value) {
        double size = Math.abs(value);
        if (size == 0 || size >= 100) {
            return String.format(Locale.ROOT, "%.0f", value);
        }
        return size < 1e-3
                ? String.format(Locale.ROOT, "%.1e", value)
                : String.format(Locale.ROOT, size < 0.1 ? "%.4f" : size < 10 ? "%.2f" : "%.1f", value);
    }
}
