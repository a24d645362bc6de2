package org.phrenic.study.paper;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.file.Numbers.trimmed;
import static org.phrenic.study.ReportNumbers.grouped;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.ActionLines;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.model.material.TissueMass;
import org.phrenic.model.organ.SternumPart;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;

/** The parts and parameters of the paper's model and their counterparts in this program. */
final class ModelSection {
    private final Reproduction reproduction;
    private final ModelCounts ours;
    private final ModelCounts published;

    ModelSection(Reproduction reproduction) {
        this.reproduction = reproduction;
        ours = reproduction.defaultModel();
        published = reproduction.publishedModel();
    }

    void addAttachments(ReportDocument report) {
        List<List<String>> rows = new ArrayList<>();
        for (String place : ModelCounts.PLACES) {
            rows.add(List.of(
                    place,
                    grouped(published.attachedByPlace().get(place)),
                    grouped(ours.attachedByPlace().get(place))));
        }
        rows.add(List.of("in all", grouped(published.attachedCount()), grouped(ours.attachedCount())));
        report.table(
                PaperTexts.text("attachments-caption"),
                PaperTexts.columns(
                        1,
                        "place",
                        "the paper's material: border and 25 mm beside it",
                        "here: the border of the sheet"),
                rows);
        report.paragraph(PaperTexts.text("attachments"));
    }

    void add(ReportDocument report) {
        report.section("The model, part by part");
        double ratio = Materials.PHYSICAL.defaultOf(SheetSprings.TENDON_RATIO, Scenario.defaults());
        double radius = Materials.PAPER.defaultOf(ActionLines.ACTION_RADIUS, Scenario.defaults());
        Object[] model = {
            grouped(ours.diaphragmVertices()), grouped(ours.diaphragmTriangles()), grouped(ours.tendonVertices()),
            grouped(published.tendonVertices()), ours.eulerCharacteristic(), grouped(published.springs()),
            grouped(published.rigidLinks()), grouped(ours.rigidLinks()), trimmed(ratio, 4),
            worstLinkError(), trimmed(SternumPart.STIFFNESS, 4), trimmed(radius, 4)
        };
        report.table(
                "The model. \"The paper's material\" is a setting of the program (material: paper).",
                PaperTexts.columns(4, "part", "the paper", "here", "what differs and why"),
                PaperTexts.rows("model", model));
        report.section("The parameters");
        String[] headings = {
            "parameter", "the paper", "here, the paper's material", "here otherwise", "what differs and why"
        };
        Object[] parameters = {
            value(SheetSprings.SPRING_STIFFNESS, Materials.PAPER),
            value(SheetSprings.MUSCLE_STIFFNESS, Materials.PHYSICAL),
            value(TissueMass.NODE_MASS, Materials.PAPER),
            value(TissueMass.AREA_DENSITY, Materials.PHYSICAL),
            value(TissueMass.DAMPING, Materials.PAPER),
            value(TissueMass.DAMPING_RATE, Materials.PHYSICAL),
            timeStep("published"),
            timeStep("physical"),
            format("%.2f", 1000 * published.rk2LimitS()),
            format("%.2f", 1000 * published.rk2SternumLimitS()),
            published.rk2Substeps(),
            published.rk2SternumSubsteps()
        };
        report.table("", PaperTexts.columns(5, headings), PaperTexts.rows("parameters", parameters));
    }

    /** The worst error in the published breath. */
    private String worstLinkError() {
        Optional<PaperBreath> published = reproduction.breath(Reproduction.Run.PUBLISHED);
        if (published.isEmpty()) {
            return "-";
        }
        PaperBreath breath = published.get();
        double worst = 0;
        for (int row = 0; row <= breath.series().lastRow(0); row++) {
            worst = Math.max(worst, breath.series().value("rigid_link_error", row));
        }
        return format("%.0e", worst);
    }

    private static String timeStep(String material) {
        return trimmed(Scenario.defaults().with("material=" + material).timeStepS(), 4);
    }

    private static String value(Parameter parameter, TissueMaterial material) {
        double value = material.defaultOf(parameter, Scenario.defaults());
        String number = value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
        return number + " " + parameter.unit();
    }
}
