package org.phrenic.study.paper;

import static org.phrenic.study.paper.SpeedSection.grouped;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.model.material.TissueMass;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;

/** The paper's model part by part and its parameters, with what stands here in their place. */
final class ModelSection {
    private static final List<Column> PARTS = List.of(
            Column.text("part"), Column.text("the paper"), Column.text("here"), Column.text("what differs and why"));

    private final Reproduction found;

    ModelSection(Reproduction found) {
        this.found = found;
    }

    void addAttachments(ReportDocument report) {
        ModelCounts own = found.defaultModel();
        ModelCounts published = found.publishedModel();
        List<List<String>> rows = new ArrayList<>();
        for (String place : ModelCounts.PLACES) {
            rows.add(List.of(
                    place,
                    grouped(published.attachedByPlace().get(place)),
                    grouped(own.attachedByPlace().get(place))));
        }
        rows.add(List.of("in all", grouped(published.attachedCount()), grouped(own.attachedCount())));
        report.table(
                "Vertices of the diaphragm that are held, by the part of the skeleton nearest to each. The paper names the"
                        + " first four places and gives no numbers.",
                List.of(
                        Column.text("place"),
                        Column.number("the paper's rule: nearer than 25 mm"),
                        Column.number("here: the border of the sheet")),
                rows);
        report.paragraph(
                "By distance alone the paper's rule also holds muscle that lies against the lower ribs and slides"
                        + " there in people (the zone of apposition). So the model as used here holds the border only, exactly,"
                        + " and lets the rest slide along the chest wall without passing through it.");
    }

    void add(ReportDocument report) {
        report.section("The model, part by part");
        ModelCounts own = found.defaultModel();
        ModelCounts published = found.publishedModel();
        report.table(
                "The model. \"The paper's material\" is a setting of the program (material: paper).",
                PARTS,
                List.of(
                        part(
                                "Diaphragm",
                                "Closed surface of 11,359 nodes and 22,722 triangles; tendon and muscle separated by a"
                                        + " plane",
                                grouped(own.diaphragmVertices()) + " vertices, " + grouped(own.diaphragmTriangles())
                                        + " triangles; tendon of three leaflets, "
                                        + grouped(own.tendonVertices()) + " vertices, or above a plane, "
                                        + grouped(published.tendonVertices()),
                                "The paper's counts have an Euler characteristic of -2 if the surface is closed, as two"
                                        + " openings in a sheet of two faces would give; here it is "
                                        + own.eulerCharacteristic()
                                        + ": no openings. A plane takes the tops of the domes for tendon and"
                                        + " leaves its middle to the muscle."),
                        part(
                                "Muscle tissue",
                                "Springs on the mesh's edges, F = -k (l - l0); damping F = -γ v at each node",
                                grouped(published.springs()) + " springs in all of the scene, the same two laws",
                                "Also a membrane stiffness that does not change with the mesh, prestress, and pressure from"
                                        + " below; with the paper's springs alone nothing holds a dome up."),
                        part(
                                "Tendon tissue",
                                "Elastic links and rigid links between upper and lower face: near masses, those on the same"
                                        + " face removed by the angle, sorted",
                                grouped(published.rigidLinks()) + " rigid links by the same rule; as used here "
                                        + grouped(own.rigidLinks()) + " and a tendon ten times as stiff",
                                "The paper gives no distance and no number but \"hundreds\"."),
                        part(
                                "Rigid links",
                                "Each step: move freely, put both ends back along their line, shared as eq. 5, new"
                                        + " velocities",
                                String.format(
                                        Locale.ROOT,
                                        "The same; largest relative error of length in a breath %.0e",
                                        worstLinkError()),
                                "Links that share a node are swept until the error is below 1e-6."),
                        part(
                                "Integration",
                                "Runge-Kutta of second order, eq. 6",
                                "Midpoint Runge-Kutta (rk2) and eq. 6 as it reads, with an acceleration of the step before"
                                        + " (lagged); Störmer's formula and velocity Verlet otherwise",
                                "As printed, eq. 6 can be read in more ways than one."),
                        part(
                                "Ribs",
                                "Rigid, by the finite helical axis method",
                                "The same, twelve pairs, axes from measured rotations",
                                "The paper does not print its axes."),
                        part(
                                "Sternum, cartilage, ligaments",
                                "A very stiff mass-spring system that follows the ribs",
                                "The same, its springs eight times as stiff as the muscle's",
                                "Stiffer ones would shorten the step for everything."),
                        part(
                                "Muscle action",
                                "Vertical action lines; a force that falls with the distance from the line",
                                "The same in the paper's material (two lines, 60 mm); otherwise muscle shortens along its"
                                        + " fibres against pressure",
                                "The paper gives neither places nor forces. A vertical force stretches fibres that shorten"
                                        + " in life."),
                        part(
                                "Lungs",
                                "In the patients: linked to the diaphragm by springs",
                                "The same, in the virtual body too",
                                "-")));
        parameters(report);
    }

    private static List<String> part(String name, String printed, String here, String why) {
        return List.of(name, printed, here, why);
    }

    private double worstLinkError() {
        PaperBreath breath = found.breath(Reproduction.Run.PUBLISHED).orElseThrow();
        double worst = 0;
        for (int row = 0; row <= breath.series().lastRow(0); row++) {
            worst = Math.max(worst, breath.series().value("rigid_link_error", row));
        }
        return worst;
    }

    private void parameters(ReportDocument report) {
        report.section("The parameters");
        ModelCounts published = found.publishedModel();
        report.table(
                "",
                List.of(
                        Column.text("parameter"),
                        Column.text("the paper"),
                        Column.text("here, the paper's material"),
                        Column.text("here otherwise"),
                        Column.text("what differs and why")),
                List.of(
                        List.of(
                                "Stiffness",
                                "15",
                                value(SheetSprings.SPRING_STIFFNESS, Materials.PAPER),
                                value(SheetSprings.MUSCLE_STIFFNESS, Materials.PHYSICAL) + ", membrane",
                                "The paper prints no units; N/m, kg, N s/m and s are taken."),
                        List.of(
                                "Mass of a node",
                                "0.1",
                                value(TissueMass.NODE_MASS, Materials.PAPER),
                                value(TissueMass.AREA_DENSITY, Materials.PHYSICAL),
                                "One mass a node makes a finer mesh heavier and its waves slower."),
                        List.of(
                                "Damping",
                                "-0.02",
                                value(TissueMass.DAMPING, Materials.PAPER),
                                value(TissueMass.DAMPING_RATE, Materials.PHYSICAL) + ", over mass",
                                "The sign is that of the force, F = -γ v."),
                        List.of(
                                "Time step",
                                "0.01",
                                "0.01 s",
                                "0.00125 s",
                                String.format(
                                        Locale.ROOT,
                                        "Midpoint Runge-Kutta with these numbers is stable up to %.2f ms here, where sternum"
                                                + " and cartilage are stiffer than the sheet, and would split the step in"
                                                + " %d; velocity Verlet takes it whole.",
                                        1000 * published.rk2LimitS(),
                                        published.rk2Substeps()))));
    }

    private static String value(Parameter parameter, TissueMaterial material) {
        double value = material.defaultOf(parameter, Scenario.defaults());
        String number = value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
        return number + " " + parameter.unit();
    }
}
