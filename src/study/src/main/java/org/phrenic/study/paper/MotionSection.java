package org.phrenic.study.paper;

import static org.phrenic.file.Numbers.trimmed;
import static org.phrenic.study.ReportNumbers.number;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.paper.Reproduction.Run;

/** The paper's statements about fig. 3: motion of tendon and muscle, and the three phenomena that cause it. */
record MotionSection(Reproduction reproduction) {
    private static final String MUSCLE = "muscle_edge_change_percent";
    private static final String TENDON = "tendon_edge_change_percent";
    /** Largest ratio of tendon to muscle edge length change at which the tendon counts as keeping its shape. */
    private static final double MAX_TENDON_SHARE = 0.25;
    /** Smallest ratio of tendon edge change without links to that with links for the links to count as effective. */
    private static final double MIN_CHANGE_WITHOUT_LINKS = 1.5;

    void add(ReportDocument report) {
        report.paragraph(PaperTexts.text("motion"));
        Claim.addTable(report, claims());
        report.table(
                PaperTexts.text("tissue-caption"),
                columns("domes, mm", "muscle, %", "tendon, %", "tendon bent, mm", "fibres, %"),
                rows(
                        List.of(Run.DEEP, Run.PUBLISHED, Run.PUBLISHED_THREE_LINKS, Run.PUBLISHED_HOMOGENEOUS),
                        PaperBreath::domeDescentMm,
                        b -> b.atEndInspiration(MUSCLE),
                        b -> b.atEndInspiration(TENDON),
                        b -> b.atEndInspiration("tendon_bent_mm"),
                        b -> b.atEndInspiration("fibre_shortening_percent")));
        List<List<String>> phenomena = rows(
                List.of(Run.DEEP, Run.DEEP_MUSCLE, Run.DEEP_RIBS),
                b -> -b.change("dome_right_mm"),
                b -> -b.change("dome_left_mm"),
                b -> b.change("transverse_change_mm"),
                b -> b.change("ap_change_mm"),
                b -> b.change("sternum_cranial_mm"),
                b -> b.change("lung_volume_change_ml"));
        if (phenomena.size() > 1) {
            List<Column> columns = columns(
                    "right dome down, mm",
                    "left dome down, mm",
                    "wider, mm",
                    "deeper, mm",
                    "sternum up, mm",
                    "lungs, ml");
            report.table(PaperTexts.text("phenomena-caption"), columns, phenomena);
        }
    }

    private static List<Column> columns(String... headings) {
        List<String> all = new ArrayList<>(List.of("breath"));
        all.add("scheme");
        all.addAll(Arrays.asList(headings));
        return PaperTexts.columns(2, all.toArray(String[]::new));
    }

    @SafeVarargs
    @SuppressWarnings("varargs")
    private List<List<String>> rows(List<Run> runs, ToDoubleFunction<PaperBreath>... measures) {
        List<List<String>> rows = new ArrayList<>();
        for (Run run : runs) {
            reproduction.breath(run).ifPresent(breath -> {
                List<String> row = new ArrayList<>(List.of(run.label(), run.scheme()));
                Arrays.stream(measures).forEach(m -> row.add(number(m.applyAsDouble(breath))));
                rows.add(row);
            });
        }
        return rows;
    }

    List<Claim> claims() {
        return List.of(
                tendonGeometry("tendon-deep", Run.DEEP),
                tendonGeometry("tendon-published", Run.PUBLISHED),
                tensegrity(),
                phenomenon("muscle", Run.DEEP_MUSCLE, PaperBreath::domeDescentMm, "mm for both domes, ribs still"),
                phenomenon(
                        "ribs", Run.DEEP_RIBS, b -> b.change("transverse_change_mm"), "mm less across, muscle still"),
                phenomenon(
                        "sternum",
                        Run.DEEP_RIBS,
                        b -> b.change("ap_change_mm"),
                        "mm less from front to back, muscle still"));
    }

    private Claim tendonGeometry(String key, Run run) {
        Optional<PaperBreath> breath = reproduction.breath(run);
        if (breath.isEmpty()) {
            return PaperTexts.notMeasured(key);
        }
        double tendon = breath.get().atEndInspiration(TENDON);
        double muscle = breath.get().atEndInspiration(MUSCLE);
        String measured =
                "edges change by " + number(tendon) + " % in tendon, " + number(muscle) + " % in muscle (rms)";
        return PaperTexts.claim(key, Verdict.agrees(tendon < MAX_TENDON_SHARE * muscle), measured);
    }

    private Claim tensegrity() {
        Optional<PaperBreath> with = reproduction.breath(Run.PUBLISHED);
        Optional<PaperBreath> without = reproduction.breath(Run.PUBLISHED_HOMOGENEOUS);
        if (with.isEmpty() || without.isEmpty()) {
            return PaperTexts.notMeasured("tensegrity");
        }
        double linked = with.get().atEndInspiration(TENDON);
        double free = without.get().atEndInspiration(TENDON);
        return PaperTexts.claim(
                "tensegrity",
                Verdict.agrees(free > MIN_CHANGE_WITHOUT_LINKS * linked),
                "tendon edges change by " + number(linked) + " % with links, " + number(free) + " % without",
                trimmed(Materials.PHYSICAL.defaultOf(SheetSprings.TENDON_RATIO, Scenario.defaults()), 4));
    }

    private Claim phenomenon(String key, Run run, ToDoubleFunction<PaperBreath> measure, String unit) {
        Optional<PaperBreath> breath = reproduction.breath(run);
        if (breath.isEmpty()) {
            return PaperTexts.notMeasured(key);
        }
        double value = measure.applyAsDouble(breath.get());
        return PaperTexts.claim(key, Verdict.agrees(value > 0), number(value) + " " + unit);
    }
}
