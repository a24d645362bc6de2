package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.path.AccessMap;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.Simulation;

/** Access to a target as a study: directions of ways, the motion of the target, its factors. */
class AccessStudyTest {
    private static final String COARSE = "mesh_vertices: 2000, lungs: embedded, sternum: kinematic";

    /** LPS: x to the left, y to the back, z up. */
    @Test
    void directionsHaveTheirSectors() {
        assertThat(column(-0.01, -1, 0.01)).isEqualTo("free_a010_e+10");
        assertThat(column(-1, -0.01, 0.2)).isEqualTo("free_a090_e+10");
        assertThat(column(-1, 0.01, -0.4)).isEqualTo("free_a090_e-30");
        assertThat(column(-1, -1.2, 0)).startsWith("free_a030");
        assertThat(WaySectors.sector(new double[] {1, 0, 0}))
                .as("from the left")
                .isNegative();
        assertThat(WaySectors.sector(new double[] {0, 1, 0}))
                .as("from the back")
                .isNegative();
        assertThat(WaySectors.sector(new double[] {0, 0, 1})).as("from above").isNegative();
        assertThat(WaySectors.columns()).doesNotHaveDuplicates().hasSize(45);
    }

    private static String column(double x, double y, double z) {
        return WaySectors.columns().get(WaySectors.sector(new double[] {x, y, z}));
    }

    /**
     * The virtual man: a target in the right lobe goes down with the breath and is reached from some directions alone.
     */
    @Test
    void aTargetGoesDownInInspirationAndSomeWaysToItAreFree() {
        SweepPlan plan = SweepPlan.of(SweepStudy.parse(
                "study.yaml",
                "model: access\nsettings: {" + COARSE + ", rate_per_min: 60}\n"
                        + "design: {kind: list, columns: [target.from_right], points: [[0.2]]}\n"));
        RunRow row = RunRow.of(plan.model(), plan.points().get(0));
        assertThat(row.failure()).isEmpty();
        double[] up = row.outcome().series()[2];
        int lowest = IntStream.range(0, up.length).reduce(0, (a, b) -> up[a] <= up[b] ? a : b);
        assertThat(up[0]).isZero();
        assertThat(up[up.length - 1]).isCloseTo(0, within(1e-12));
        assertThat(lowest).isBetween(8, 30);
        double[] values = row.outcome().responses();
        assertThat(values[2])
                .as("excursion")
                .isGreaterThanOrEqualTo(-up[lowest])
                .isBetween(2.0, 30.0);
        assertThat(values[0]).as("free, per cent").isBetween(1.0, 99.0);
        assertThat(IntStream.range(3, values.length).mapToObj(i -> values[i])).contains(1.0, 0.0);
    }

    /** A body in another size has kidneys, bowel and vessels as well, and some ways to the target pass through them. */
    @Test
    void organsOfABodyInAnotherSizeStandInTheWay() {
        SweepPlan plan = SweepPlan.of(SweepStudy.parse(
                "study.yaml",
                "model: access\nsettings: {" + COARSE + ", rate_per_min: 150}\n"
                        + "design: {kind: list, columns: [body.scale], points: [[1.05]]}\n"));
        SweepPoint point = plan.points().get(0);
        try (Simulation simulation = ((AccessModel) plan.model()).simulation(point)) {
            AccessMap map = AccessModel.map(simulation, point);
            assertThat(IntStream.range(0, map.size()).filter(v -> map.isInReach(0, v)))
                    .anyMatch(v -> map.touched(0, v).contains(NoGoZone.ORGAN));
        }
    }

    @Test
    void factorsOfTheTargetHaveLimits() {
        assertThatThrownBy(() -> SweepStudy.parse(
                        "study.yaml",
                        "model: access\nfactors:\n  - {key: target.diameter_mm, range: [1, 20]}\n"
                                + "design: {kind: grid}\n"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("line 3")
                .hasMessageContaining("expected 5.0 to 80.0");
        SweepPlan plan = SweepPlan.of(
                SweepStudy.parse("study.yaml", "model: access\ncohort: {persons: 3}\ndesign: {kind: grid}\n"));
        assertThat(plan.model().responses()).startsWith("free_percent", "part_percent", "target_excursion_mm");
        assertThat(plan.model().traitNames()).isEqualTo(List.of("sex", "age_y", "height_m", "weight_kg"));
    }
}
