package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.data.Percentage.withPercentage;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.engine.ForceField;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.model.assembly.Scene;
import org.phrenic.scenario.Assignment;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

class GravityTest {
    private static final double EARTH = 9.81;
    /** Longer than a ramp of 0.2 s. */
    private static final int STEPS = 400;

    /** Mean displacement of the sheet along an axis after gravity has come on, breath held at expiration, mm. */
    private static double sag(int axis, double tilt, double roll) {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone("hold=true")))) {
            simulation.change(List.of(
                    Assignment.of("test", Gravity.ACCELERATION, EARTH),
                    Assignment.of("test", Gravity.TILT, tilt),
                    Assignment.of("test", Gravity.ROLL, roll)));
            for (int i = 0; i < STEPS; i++) {
                simulation.step();
            }
            Scene scene = simulation.scene();
            double[] now = new double[scene.restPositions().length];
            scene.layout().toCaller(scene.system().positions(), now);
            double sum = 0;
            for (int i = axis; i < now.length; i += 3) {
                sum += now[i] - scene.restPositions()[i];
            }
            return 3 * sum / now.length;
        }
    }

    @ParameterizedTest
    @CsvSource({"2, 0, 0, -1", "2, 180, 0, 1", "1, 90, 0, 1", "0, 0, 90, 1"})
    void theSheetSagsToWhereGravityPoints(int axis, double tilt, double roll, int sign) {
        assertThat(sign * sag(axis, tilt, roll)).isBetween(0.02, 10.0);
    }

    /** Sum of the weights of all nodes in a posture, mN. */
    private static double[] weight(Simulation simulation, double tilt, double roll) {
        simulation.change(List.of(
                Assignment.of("test", Gravity.ACCELERATION, EARTH),
                Assignment.of("test", Gravity.TILT, tilt),
                Assignment.of("test", Gravity.ROLL, roll)));
        Scene scene = simulation.scene();
        ForceField gravity = scene.system().fields().stream()
                .filter(field -> field.getClass().getEnclosingClass() == Gravity.class)
                .findFirst()
                .orElseThrow();
        gravity.prepare(simulation.time() + 1);
        double[] force = new double[scene.restPositions().length];
        for (int block = 0; block < scene.layout().blockCount(); block++) {
            gravity.addForces(scene.system().positions(), scene.system().velocities(), force, block);
        }
        double[] sum = new double[3];
        for (int i = 0; i < force.length; i++) {
            sum[i % 3] += force[i];
        }
        return sum;
    }

    @Test
    void theNodesCarryTheMassOfSheetAndLiverInTheDirectionOfThePosture() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone("liver=true")))) {
            Scene scene = simulation.scene();
            int nodes = scene.layout().nodeCount();
            double sheet = Arrays.stream(Gravity.masses(scene.diaphragm(), null, nodes))
                    .sum();
            double both = Arrays.stream(
                            Gravity.masses(scene.diaphragm(), scene.liver().orElseThrow(), nodes))
                    .sum();
            // 3 mm of muscle of 1.05 g/ml on the mean of the two faces' areas; a tenth of a liver of 1.06 g/ml.
            assertThat(sheet)
                    .isCloseTo(
                            3.15e-3
                                    / 2
                                    * MeshMeasure.area(
                                            scene.diaphragm().diaphragm.sheet()),
                            withPercentage(1e-6));
            double volume = MeshMeasure.signedVolume(
                    scene.liver().orElseThrow().structure.mesh());
            assertThat(both - sheet)
                    .isCloseTo(0.1 * 1.06e-3 * volume, withPercentage(1e-6))
                    .isBetween(80.0, 250.0);

            double milliNewton = EARTH * both;
            double rounding = 1e-9 * milliNewton;
            assertThat(weight(simulation, 0, 0)).containsExactly(new double[] {0, 0, -milliNewton}, within(rounding));
            assertThat(weight(simulation, 90, 0)).containsExactly(new double[] {0, milliNewton, 0}, within(rounding));
            assertThat(weight(simulation, 180, 0)).containsExactly(new double[] {0, 0, milliNewton}, within(rounding));
            assertThat(weight(simulation, 0, 90)).containsExactly(new double[] {milliNewton, 0, 0}, within(rounding));
            assertThat(weight(simulation, 45, -90))
                    .containsExactly(new double[] {-milliNewton, 0, 0}, within(rounding));
            double share = milliNewton / Math.sqrt(8);
            assertThat(weight(simulation, 60, 45))
                    .as("a tilt by 60 and a roll by 45 degrees")
                    .containsExactly(new double[] {2 * share, Math.sqrt(3) * share, -share}, within(rounding));
        }
    }

    @Test
    void withoutGravityThePostureChangesNoBit() {
        try (Simulation standing = Runs.simulation(Runs.scenario(Runs.sheetAlone()));
                Simulation lying = Runs.simulation(Runs.scenario(Runs.sheetAlone("gravity_tilt_deg=90")))) {
            for (int i = 0; i < 20; i++) {
                standing.step();
                lying.step();
            }
            assertThat(lying.stateHash()).isEqualTo(standing.stateHash());
        }
    }
}
