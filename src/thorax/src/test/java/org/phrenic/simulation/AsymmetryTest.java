package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;

/** Ribs, pressure and muscle that are driven unlike on their sides and in their groups. */
class AsymmetryTest {
    private static final int STEPS = 500;

    /** How far structures move in the breath without settings, by name, mean, mm. */
    private static final Map<String, Double> ALIKE_MOVED = new HashMap<>();

    private static double[] alikeObserved;
    private static Simulation simulation;
    private static SceneSurfaces surfaces;

    @BeforeAll
    static void assemble() {
        Scenario scenario = Scenario.defaults()
                .with(
                        "resolution=low",
                        "mesh_vertices=3000",
                        "preset=deep",
                        "rate_per_min=60",
                        "inspiratory_fraction=0.6",
                        "threads=1");
        simulation = Runs.simulation(scenario);
        surfaces = new SceneSurfaces(simulation);
        breathe();
        for (String name : List.of("rib_02_R", "rib_06_R", "rib_10_R", "rib_06_L", "lung_R")) {
            ALIKE_MOVED.put(name, moved(name));
        }
        alikeObserved = surfaces.observe();
    }

    @AfterAll
    static void close() {
        simulation.close();
    }

    private static void breathe(String... settings) {
        List<ScheduledChange> changes = Arrays.stream(settings)
                .map(s -> ScheduledChange.parse("0:" + s))
                .toList();
        simulation.rerun(changes);
        while (simulation.steps() < STEPS) {
            simulation.step();
        }
    }

    /** How far the vertices of a structure have moved, mean, mm. */
    private static double moved(String name) {
        List<Surface> all = surfaces.surfaces();
        for (int i = 0; i < all.size(); i++) {
            if (all.get(i).name().equals(name)) {
                TriangleMesh now = surfaces.mesh(i);
                double[] rest = all.get(i).rest().positions();
                double sum = 0;
                for (int c = 0; c < rest.length; c += 3) {
                    sum += Math.sqrt(square(now, rest, c) + square(now, rest, c + 1) + square(now, rest, c + 2));
                }
                return 3 * sum / rest.length;
            }
        }
        throw new AssertionError(name);
    }

    private static double square(TriangleMesh now, double[] rest, int c) {
        double d = now.positions()[c] - rest[c];
        return d * d;
    }

    private static double observed(String column) {
        return surfaces.observe()[Observation.COLUMNS.indexOf(column)];
    }

    /** What is observed of the breath without settings. */
    private static double alike(String column) {
        return alikeObserved[Observation.COLUMNS.indexOf(column)];
    }

    @Test
    void ribsTurnByGroupAndSide() {
        Offset<Double> little = Offset.offset(0.02);
        double upper = ALIKE_MOVED.get("rib_02_R");
        double middle = ALIKE_MOVED.get("rib_06_R");
        double lower = ALIKE_MOVED.get("rib_10_R");
        double left = ALIKE_MOVED.get("rib_06_L");
        breathe("upper_rib_rotation=0");
        assertThat(moved("rib_02_R")).isZero();
        assertThat(moved("rib_06_R")).isEqualTo(middle);
        assertThat(moved("rib_10_R")).isEqualTo(lower);
        breathe("lower_rib_rotation=0.5", "rib_left_over_right=0.5");
        // Turns of a few degrees: displacements go with them.
        assertThat(moved("rib_02_R")).isEqualTo(upper);
        assertThat(moved("rib_10_R") / lower).isCloseTo(0.5, little);
        assertThat(moved("rib_06_L") / left).isCloseTo(0.5, little);
        breathe("rib_left_over_right=2");
        assertThat(moved("rib_06_L")).isEqualTo(left);
        assertThat(moved("rib_06_R") / middle).isCloseTo(0.5, little);
    }

    @Test
    void aSmallerBucketHandleWidensLessAndRaisesTheFrontAsFar() {
        double wide = alike("transverse_change_mm");
        double raised = alike("sternum_cranial_mm");
        breathe("bucket_handle=0.5");
        assertThat(observed("transverse_change_mm")).isLessThan(0.8 * wide);
        assertThat(observed("sternum_cranial_mm") / raised).isCloseTo(1, Offset.offset(0.25));
    }

    @Test
    void theMediastinalSurfaceOfOneLungIsPushedOut() {
        double volume = alike("lung_volume_change_ml");
        double right = ALIKE_MOVED.get("lung_R");
        breathe("mediastinum_left_mm=15");
        // Some 150 cm^2 by a part of 15 mm.
        assertThat(observed("lung_volume_change_ml")).isBetween(volume + 15, volume + 250);
        assertThat(moved("lung_R")).isCloseTo(right, Offset.offset(0.05));
    }

    @Test
    void theSideUnderLessPressureGoesDownFarther() {
        breathe("greatest_pressure_kpa=8");
        double both = observed("dome_left_mm");
        double right = observed("dome_right_mm");
        breathe("greatest_pressure_kpa=8", "pressure_left_over_right=0.4");
        assertThat(observed("dome_left_mm")).isLessThan(both - 3);
        // Both hang on one tendon: the other side follows by less than a sixth of its own way.
        assertThat(observed("dome_right_mm")).isCloseTo(right, Offset.offset(Math.abs(right) / 6));
    }

    @Test
    void theBackGoesDownFartherWhereItsMuscleIsTheStronger() {
        double tilt = alike("posterior_right_mm") - alike("anterior_right_mm");
        breathe("front_over_back=0.5");
        assertThat(observed("posterior_right_mm") - observed("anterior_right_mm"))
                .isLessThan(tilt - 3);
    }
}
