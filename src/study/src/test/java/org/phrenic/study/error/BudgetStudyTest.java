package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.BoxBody;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * The quick budget of the virtual man's sheet: the start of a breath on a coarse mesh, with tissue that lets every
 * scheme make the same steps.
 */
class BudgetStudyTest {
    private static final BudgetPlan PLAN =
            heavy(BudgetPlan.quick(List.of(new BudgetPlan.Body("virtual man", "virtual/adult-male"))));

    @TempDir
    private static Path folder;

    private static BudgetTable table;

    private static BudgetPlan heavy(BudgetPlan plan) {
        List<String> settings = new ArrayList<>(plan.settings());
        settings.addAll(List.of("area_density_kg_per_m2=60", "tendon_lightness=1", "mass_scaling_s=0.00125"));
        settings.addAll(List.of("damping_rate_per_s=10", "damping_time_s=0"));
        return new BudgetPlan(
                plan.bodies(),
                plan.breaths(),
                plan.meshes(),
                plan.sheetVertices(),
                plan.windowShare(),
                settings,
                List.of());
    }

    @BeforeAll
    static void measure() {
        table = new BudgetTable(folder, PLAN);
        new BudgetStudy(PLAN, table, (done, total, what) -> {})
                .run(EnumSet.of(BudgetPart.TIME, BudgetPart.SPACE, BudgetPart.ORDER));
    }

    private static List<BudgetRow> rows(BudgetPart part) {
        return table.rows().stream().filter(r -> r.part() == part).toList();
    }

    private static double distance(String scheme, String step) {
        return rows(BudgetPart.ORDER).stream()
                .filter(r -> r.setting().equals(scheme + ", no contact, " + step + " s"))
                .findFirst()
                .orElseThrow()
                .rmsMm();
    }

    @Test
    void withoutContactEachSchemeConvergesWithItsOrder() {
        // Halving the step divides the distance by 2 to the order.
        assertThat(distance("verlet", "0.000625") / distance("verlet", "0.0003125"))
                .isBetween(3.6, 4.4);
        assertThat(distance("stormer", "0.000625") / distance("stormer", "0.0003125"))
                .isBetween(7.0, 9.0);
        assertThat(distance("rk2", "0.000625") / distance("rk2", "0.0003125")).isBetween(3.6, 4.4);
    }

    @Test
    void everyIntegratorIsMeasuredAndTheDefaultIsMarked() {
        Map<Boolean, List<String>> schemes = BudgetPoint.of(table).stream()
                .collect(Collectors.groupingBy(
                        p -> p.row().usual(), Collectors.mapping(BudgetPoint::integrator, Collectors.toList())));
        assertThat(schemes.get(true)).containsExactly("verlet");
        assertThat(schemes.get(false)).contains("stormer", "rk2", "rk4", "lagged", "symplectic-euler");
    }

    @Test
    void theEdgesOfTheMeshesHaveTheRatiosOfTheirNumbersOfVertices() {
        List<BudgetRow> meshes = rows(BudgetPart.SPACE);
        assertThat(meshes).hasSize(3);
        assertThat(meshes.get(0).edgeMm() / meshes.get(2).edgeMm()).isBetween(1.4, 1.6);
    }

    @Test
    void eachSettingHasTheExcursionOfItsOwnRun() {
        BudgetRow usual = rows(BudgetPart.TIME).stream()
                .filter(BudgetRow::usual)
                .findFirst()
                .orElseThrow();
        Scenario scenario = PLAN.scenario(
                PLAN.bodies().get(0), usual.breath(), PLAN.meshes().get(0));
        try (BreathRunner runs =
                new BreathRunner(scenario, SimulationRun.loadThorax(scenario), PLAN.untilS(scenario))) {
            assertThat(usual.excursionMm()).isEqualTo(runs.excursionMm(runs.run(SolverSettings.of(scenario))));
        }
        assertThat(rows(BudgetPart.TIME).stream().mapToDouble(BudgetRow::excursionMm))
                .doesNotHaveDuplicates();
    }

    @Test
    void aTableThatIsReadBackLacksNothing() {
        BudgetTable again = new BudgetTable(folder, PLAN);
        assertThat(again.rows()).hasSameSizeAs(table.rows());
        new BudgetStudy(PLAN, again, (done, total, what) -> {
                    throw new AssertionError("measured " + what + " again");
                })
                .run(EnumSet.of(BudgetPart.TIME, BudgetPart.SPACE, BudgetPart.ORDER));
    }

    @Test
    void thePageHasATableAPart() {
        String page = MarkdownPage.format(
                new BudgetReport(table).document(List.of("Commit abc", "Machine: any"), "error.png"));
        assertThat(page)
                .contains("- Commit abc", "## The defaults", "## Every integrator", "## Error in space")
                .contains("## Order of convergence in time", "error.png", "extrapolated")
                .doesNotContain("NaN", "Infinity");
    }

    private static BudgetRow lag(String mesh, String phase, double rmsMm, double maxMm) {
        return new BudgetRow(
                BudgetPart.EQUILIBRIUM,
                "virtual man",
                "deep",
                mesh,
                phase,
                true,
                Double.NaN,
                50,
                rmsMm,
                maxMm,
                0.02,
                4,
                2);
    }

    @Test
    void distancesFromEquilibriumAreARowAScene() {
        BudgetTable lags = new BudgetTable();
        double[] rms = {0.25, 0.5, 0.75, 0.1};
        for (int i = 0; i < rms.length; i++) {
            String phase = i + " s";
            lags.add(List.of(lag("low", phase, rms[i], i), lag("low, heavy-tissue", phase, 10 * rms[i], 2 * i)));
            // What Newton's method finds is told apart: it adds nothing to the distances of the held sheet.
            lags.add(List.of(lag("low", phase + ", Newton", 3 * rms[i], 100)));
        }
        assertThat(MarkdownPage.format(new BudgetReport(lags).document(List.of(), "")))
                .contains("| virtual man | deep | low | 50.00 | 2.00 | 0.50 | 1.00 | 1.50 | 0.20 | 3.0 | 0.040 | 4.5 |")
                .contains("| virtual man | deep | low, heavy-tissue | 50.00 | 2.00 | 5.00 | 10.00 | 15.00 | 2.00 | 6.0"
                        + " | 0.040 |  |");
    }

    @Test
    void anUnknownPartInATableIsRefused(@TempDir Path other) throws Exception {
        copy(other, "\ntime,", "\nluck,");
        refused(other, PLAN, "luck");
    }

    private static void copy(Path other, String replaced, String by) throws IOException {
        Files.copy(folder.resolve("plan.yaml"), other.resolve("plan.yaml"), StandardCopyOption.REPLACE_EXISTING);
        String rows = Files.readString(folder.resolve("budget.csv"));
        assertThat(rows).containsPattern(replaced);
        Files.writeString(other.resolve("budget.csv"), rows.replaceFirst(replaced, by));
    }

    private static void refused(Path other, BudgetPlan plan, String part) {
        assertThatThrownBy(() -> new BudgetTable(other, plan))
                .isInstanceOf(BadInputException.class)
                .hasMessageStartingWith(other.toString())
                .hasMessageContaining(part)
                .message()
                .doesNotContain("\n");
    }

    /** Excursions of another window, body or program would be extrapolated together with those of this one. */
    @Test
    void aTableOfAnotherPlanIsRefused(@TempDir Path other) throws Exception {
        copy(other, "\nspace,", "\nspace,");
        assertThat(new BudgetTable(other, PLAN).rows()).isNotEmpty();
        refused(other, BudgetPlan.full(PLAN.bodies(), List.of(Resolution.LOW), List.of()), "plan.yaml differs");
        refused(other, BudgetPlan.quick(PLAN.bodies()), "plan.yaml differs");
        copy(other, "\nspace,virtual man,quiet,560,", "\nspace,virtual man,quiet,3870,");
        refused(other, PLAN, "none of the scenes of plan.yaml");
        Files.delete(other.resolve("plan.yaml"));
        refused(other, PLAN, "found budget.csv without plan.yaml");
        Files.delete(other.resolve("budget.csv"));
        Files.writeString(other.resolve("plan.yaml"), "title: a rehearsal\n");
        refused(other, PLAN, "found a file of another kind");
    }

    @Test
    void aBodyIsKnownByItsSurfacesWhereverItIs(@TempDir Path one, @TempDir Path same) {
        for (Path body : List.of(one, same)) {
            BoxBody.structures().forEach(s -> MeshFiles.write(body.resolve(s.name() + ".ply"), s.mesh()));
        }
        String identity = planOf(one).identity();
        assertThat(planOf(same).identity()).isEqualTo(identity);
        MeshFiles.write(same.resolve("liver.ply"), BoxBody.box(0, 0, 0, 5));
        assertThat(planOf(same).identity()).isNotEqualTo(identity);
    }

    private static BudgetPlan planOf(Path body) {
        return BudgetPlan.quick(List.of(new BudgetPlan.Body("scanned man", body.toString())));
    }
}
