package org.phrenic.model.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.model.assembly.Scene;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

class TissueMassTest {
    /** A live change is complete, s. */
    private static final double RAMPED_S = 0.25;

    /** Largest diagonal of the box of a usual sheet, mm. */
    private static final double USUAL_SIZE_MM = 380;

    /** Springs of the lungs do not change with the muscle's, so that their nodes need no other least mass. */
    @Test
    void aLiveChangeOfTheMuscleGivesLungsTheMassesOfASceneAssembledWithIt() {
        Scenario usual = Scenario.defaults().with("mesh_vertices=2000", "sternum=kinematic", "threads=1");
        String change = "muscle_stiffness_n_per_m=" + 0.5 * usual.get(SheetSprings.MUSCLE_STIFFNESS);
        try (Simulation live = Runs.simulation(usual);
                Simulation assembled = Runs.simulation(usual.with(change))) {
            live.change(Assignment.parse(change));
            while (live.time() < RAMPED_S) {
                live.step();
            }
            ParticleSystem system = live.scene().system();
            double[] expected = assembled.scene().nodeMasses().all();
            int compared = 0;
            for (int i = 0; i < expected.length; i++) {
                int node = system.layout().caller(i);
                if (node >= live.scene().firstLungNode()) {
                    assertThat(system.masses()[i]).as("node %d", node).isCloseTo(expected[node], withPercentage(1e-6));
                    compared++;
                }
            }
            assertThat(compared).as("nodes of lungs").isPositive();
        }
    }

    /** The force on a node of mass m and velocity v is -γ v; in a sheet of usual size γ / m is the rate, 1/s. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 5, 40})
    void dampingOverMassIsTheRateOfTheScenario(double rate) {
        String[] settings = Runs.sheetAlone("mesh_vertices=2000", "damping_rate_per_s=" + rate);
        try (Simulation simulation = Runs.simulation(Runs.scenario(settings))) {
            ParticleSystem system = simulation.scene().system();
            assertThat(simulation.scene().diaphragm().relativeSize()).isEqualTo(1);
            for (int i = 0; i < system.nodeCount(); i++) {
                assertThat(system.viscosities()[i]).isCloseTo(rate * system.masses()[i], withPercentage(1e-9));
            }
        }
    }

    /** Of a sheet 1.25 times as large, in a scene that is assembled and not settled. */
    @Test
    void aLargeSheetIsDampedLessByTheSquareOfItsSize() {
        Scenario scenario = Scenario.defaults().with(Runs.sheetAlone("mesh_vertices=2000"));
        Thorax body = scaled(VirtualThorax.ofPreset("adult-male", new MeshBudget(2000)), 1.25);
        double[] box = body.find("diaphragm").orElseThrow().mesh().bounds();
        double size = Math.hypot(Math.hypot(box[3] - box[0], box[4] - box[1]), box[5] - box[2]) / USUAL_SIZE_MM;
        assertThat(size).isGreaterThan(1.05);
        Scene scene = Runs.assembled(scenario, body);
        double relative = scene.diaphragm().relativeSize();
        // The sheet of a scene is meshed anew: its box is almost that of the body's.
        assertThat(relative).isCloseTo(size, withPercentage(0.5));
        ParticleSystem system = scene.system();
        double rate = scenario.get(TissueMass.DAMPING_RATE) / (relative * relative);
        for (int i = 0; i < system.nodeCount(); i++) {
            assertThat(system.viscosities()[i]).isCloseTo(rate * system.masses()[i], withPercentage(1e-9));
        }
    }

    private static Thorax scaled(Thorax body, double factor) {
        List<Structure> structures = body.structuresAndOrgans().stream()
                .map(s -> s.withMesh(s.mesh()
                        .withPositions(DoubleStream.of(s.mesh().positions())
                                .map(mm -> factor * mm)
                                .toArray())))
                .toList();
        return new Thorax(body.name(), structures, body.notes());
    }
}
