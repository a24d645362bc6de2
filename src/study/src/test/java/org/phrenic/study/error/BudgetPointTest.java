package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.phrenic.document.report.MarkdownPage;

/** The whole error of made-up measurements, whose excursions converge to a known limit with order 2. */
class BudgetPointTest {
    private static final double LIMIT_MM = 50;
    private static final double UNKNOWN = Double.NaN;
    /** Rows of the time part: the settings of a default and of another integrator, with their own excursions. */
    private static final List<BudgetRow> TIME = List.of(
            row(BudgetPart.TIME, "medium", "verlet, a step", true, UNKNOWN, 48, 0.4),
            row(BudgetPart.TIME, "medium", "rk4, a step", false, UNKNOWN, 40, 0.2));

    /** One row a phase; the largest distance counts. */
    private static final BudgetRow[] LAGS = DoubleStream.of(0.12, 0.48, 0.36, 0.24)
            .mapToObj(rmsMm -> row(BudgetPart.EQUILIBRIUM, "medium", rmsMm + " s", true, UNKNOWN, 48, rmsMm))
            .toArray(BudgetRow[]::new);

    private static BudgetRow row(
            BudgetPart part,
            String mesh,
            String setting,
            boolean usual,
            double edgeMm,
            double excursionMm,
            double rmsMm) {
        return new BudgetRow(
                part, "virtual man", "deep", mesh, setting, usual, edgeMm, excursionMm, rmsMm, rmsMm, 0, 4, 2);
    }

    private static BudgetPoint ofUncertain(double rmsMm, double uncertaintyMm) {
        BudgetTable table = new BudgetTable();
        table.add(List.of(new BudgetRow(
                BudgetPart.TIME,
                "virtual man",
                "deep",
                "medium",
                "verlet, a step",
                true,
                UNKNOWN,
                48,
                rmsMm,
                rmsMm,
                uncertaintyMm,
                4,
                2)));
        return BudgetPoint.of(table).get(0);
    }

    private static List<BudgetRow> meshes() {
        List<BudgetRow> meshes = new ArrayList<>();
        for (double edgeMm : new double[] {8, 6, 4, 3}) {
            double excursionMm = LIMIT_MM - 0.1 * edgeMm * edgeMm;
            meshes.add(row(BudgetPart.SPACE, edgeMm + " mm", "verlet", false, edgeMm, excursionMm, UNKNOWN));
        }
        return meshes;
    }

    private static BudgetTable table(List<BudgetRow> first, BudgetRow... more) {
        BudgetTable table = new BudgetTable();
        table.add(first);
        table.add(List.of(more));
        return table;
    }

    @Test
    void theWholeIsTheSumOfItsThreeParts() {
        BudgetTable table = table(TIME, LAGS);
        table.add(meshes());
        BudgetPoint usual = BudgetPoint.of(table).get(0);
        assertThat(usual.timePercent()).isCloseTo(100 * 0.4 / 48, within(1e-9));
        assertThat(usual.spacePercent()).isCloseTo(100 * (LIMIT_MM - 48) / LIMIT_MM, within(1e-3));
        assertThat(usual.equilibriumPercent()).isCloseTo(1, within(1e-9));
        assertThat(usual.wholePercent())
                .isEqualTo(usual.timePercent() + usual.spacePercent() + usual.equilibriumPercent());
    }

    @Test
    void theUncertaintyOfTheReferenceIsPartOfTheErrorInTime() {
        assertThat(ofUncertain(0.4, 0.2).timePercent()).isCloseTo(100 * 0.6 / 48, within(1e-9));
        assertThat(ofUncertain(0.4, 0.2).resolved()).isFalse();
        assertThat(ofUncertain(0.75, 0.25).resolved())
                .as("three times as large")
                .isTrue();
    }

    /** Newton's method may find the equilibrium of another fold of the sheet. */
    @Test
    void theEquilibriumIsThatOfTheHeldBody() {
        BudgetRow newton = row(BudgetPart.EQUILIBRIUM, "medium", "0.3 s" + BudgetRow.NEWTON, true, UNKNOWN, 48, 5);
        BudgetTable table = table(TIME, LAGS);
        table.add(List.of(newton));
        assertThat(BudgetPoint.of(table).get(0).equilibriumPercent()).isCloseTo(1, within(1e-9));
    }

    @Test
    void withoutAnOrderTheMeanOfTheThreeFinestMeshesStandsForTheLimit() {
        double[] edgesMm = {8, 6, 4, 3};
        double[] excursionsMm = {47, 49, 46, 48.5};
        BudgetTable table = table(TIME);
        for (int i = 0; i < edgesMm.length; i++) {
            String mesh = edgesMm[i] + " mm";
            table.add(List.of(row(BudgetPart.SPACE, mesh, "verlet", false, edgesMm[i], excursionsMm[i], UNKNOWN)));
        }
        double limitMm = (49 + 46 + 48.5) / 3;
        BudgetPoint point = BudgetPoint.of(table).get(0);
        assertThat(point.extrapolated()).isFalse();
        assertThat(point.spacePercent()).isCloseTo(100 * (48 - limitMm) / limitMm, within(1e-9));
    }

    @Test
    void thePartInSpaceIsThatOfTheDefaultForEverySettingOfItsMesh() {
        BudgetTable table = table(TIME);
        table.add(meshes());
        List<BudgetPoint> points = BudgetPoint.of(table);
        assertThat(points.get(1).spacePercent()).isEqualTo(points.get(0).spacePercent());
        assertThat(points.get(1).row().excursionMm()).isEqualTo(40);
    }

    @Test
    void withoutTheDefaultsOwnExcursionThePartInSpaceIsUnknown() {
        BudgetTable table = table(TIME.subList(1, 2), LAGS);
        table.add(meshes());
        assertThat(BudgetPoint.of(table)).singleElement().satisfies(p -> {
            assertThat(p.spacePercent()).isNaN();
            assertThat(p.wholePercent()).isNaN();
        });
    }

    @Test
    void aWholeThatLacksAPartIsBlankAndNotCharted() {
        BudgetReport report = new BudgetReport(table(TIME, LAGS));
        assertThat(report.charted()).isEmpty();
        assertThat(report.cells(true)).singleElement().satisfies(cells -> {
            int whole =
                    BudgetReport.COLUMNS.stream().map(c -> c.heading()).toList().indexOf("whole, %");
            assertThat(cells.get(whole)).isEmpty();
        });
        assertThat(MarkdownPage.format(report.document(List.of(), "")))
                .contains("where one of them was not measured, the whole is left blank")
                .doesNotContain("NaN");
        BudgetTable full = table(TIME, LAGS);
        full.add(meshes());
        assertThat(new BudgetReport(full).charted()).hasSize(TIME.size());
    }
}
