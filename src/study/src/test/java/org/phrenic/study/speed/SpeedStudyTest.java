package org.phrenic.study.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.study.bare.BareScene;

class SpeedStudyTest {
    private static final double ROUNDING = 1e-12;

    /**
     * A table on one thread in which all forces take 10 % longer than muscle alone, and everything is so many times the
     * paper's.
     */
    private static SpeedStudy made(double timesThePaper) {
        List<SpeedTable.Row> rows = new ArrayList<>();
        for (SpeedCase forces : SpeedCase.values()) {
            double perS = timesThePaper * forces.publishedStepsPerS(Resolution.HIGH);
            double one = forces == SpeedCase.MUSCLE_ONLY
                    ? 1.1 * timesThePaper * SpeedCase.HETEROGENEOUS.publishedStepsPerS(Resolution.HIGH)
                    : perS;
            rows.add(new SpeedTable.Row(Resolution.HIGH, forces, 20_909, List.of(one, one, one)));
        }
        // 100 steps/s at 10,000 nodes, 10 at 100,000: linear.
        SizeScaling scaling = new SizeScaling(List.of(
                new SizeScaling.Row(10_000, 29_994, 1, "loops", 100),
                new SizeScaling.Row(100_000, 299_994, 1, "loops", 10)));
        return new SpeedStudy(Map.of(1, new SpeedTable(rows)), 0.01, scaling);
    }

    @Test
    void comparesWithThePaperCellByCell() {
        SpeedStudy study = made(200);
        assertThat(study.speedupOverPaper(1, Resolution.HIGH, SpeedCase.HETEROGENEOUS))
                .isCloseTo(200, within(200 * ROUNDING));
        assertThat(study.ribMotionOverheadPercent(1, Resolution.HIGH)).isCloseTo(10, within(1000 * ROUNDING));
        assertThat(study.scaling().exponent()).isCloseTo(1, within(ROUNDING));
        assertThat(study.scaling().rows().get(0).nanosPerNodeStep()).isCloseTo(1000, within(1000 * ROUNDING));
    }

    @Test
    void reportsTheSameInEveryForm() {
        SpeedReport report = new SpeedReport(made(100));
        // The paper's 8.13 iterations a second, a hundred times, in steps of 0.01 s.
        assertThat(report.table())
                .contains(List.of(
                        "heterogeneous, all forces", "high", "20909", "1", "8.13", "813", "100", "8.1", "58.8"));
        assertThat(MarkdownPage.format(report.document(List.of("Commit 1"))))
                .contains(
                        "| 8.13 | 813 | 100 |",
                        "grows as the number of nodes to the power 1.000.",
                        "Not for clinical use");
        assertThat(report.csv())
                .startsWith("scene,threads,nodes,steps_per_s")
                .contains("bare sheet,1,10000,100.0,1000.0,,");
        assertThat(JsonWriter.format(report.values()))
                .contains("\"scaling_exponent\": ", "\"paper_steps_per_s\": 8.13");
    }

    @Test
    void theSheetComesInAnySizeClosed() {
        SheetWorkloads scenes = new SheetWorkloads();
        for (int nodes : new int[] {1_000, 24_000}) {
            BareScene scene = scenes.ofSize(nodes);
            assertThat(scene.mesh().vertexCount()).isBetween((int) (0.98 * nodes), (int) (1.02 * nodes));
            assertThat(new MeshTopology(scene.mesh()).isClosed()).isTrue();
            assertThat(scene.fixed()).isNotEmpty().doesNotContain(scene.loaded());
        }
    }

    @Test
    void aShortStudyHasEveryCell() {
        SpeedStudy.Settings settings =
                new SpeedStudy.Settings(List.of(Resolution.LOW), List.of(1), List.of(500, 1_000), 1, 0.001);
        List<String> told = new ArrayList<>();
        SpeedStudy study = SpeedStudy.of(settings, (count, total, what) -> told.add(count + "/" + total));
        assertThat(told).containsExactly("1/3", "2/3", "3/3");
        SpeedReport report = new SpeedReport(study);
        assertThat(report.table()).hasSize(1 + SpeedCase.values().length);
        assertThat(report.scaling()).hasSize(3);
        assertThat(study.tables()
                        .get(1)
                        .row(Resolution.LOW, SpeedCase.HETEROGENEOUS)
                        .stepsPerS())
                .isPositive();
    }
}
