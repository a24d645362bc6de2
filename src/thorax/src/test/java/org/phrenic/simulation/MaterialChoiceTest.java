package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;

/** A material chosen in the window, {@link Scenario#withMaterial}, computes what {@code --material} computes. */
class MaterialChoiceTest {
    private static final int STEPS = 30;

    private static String hash(Scenario scenario) {
        try (Simulation simulation = Runs.simulation(scenario)) {
            for (int i = 0; i < STEPS; i++) {
                simulation.step();
            }
            return simulation.stateHash();
        }
    }

    @Test
    void bothWaysToThePaperAndBackGiveTheSameBits() {
        Scenario physical = Runs.scenario(Runs.sheetAlone("muscle_stiffness_n_per_m=300"));
        Scenario paper = physical.withMaterial(Materials.PAPER);
        String asOnTheCommandLine = hash(Runs.scenario(Runs.sheetAlone("material=paper")));
        assertThat(hash(paper)).isEqualTo(asOnTheCommandLine);
        Scenario back = paper.withMaterial(Materials.PHYSICAL);
        assertThat(hash(back)).isEqualTo(hash(Runs.scenario(Runs.sheetAlone()))).isNotEqualTo(asOnTheCommandLine);
    }

    /** The published model is one word: its scheme, step and tendon come with the material. */
    @Test
    void thePublishedModelIsThePapersMaterialWithItsSchemeStepAndTendon() {
        Scenario published = Runs.scenario("material=published");
        assertThat(published.integrator()).isEqualTo(IntegratorKind.RK2);
        assertThat(published.timeStepS()).isEqualTo(0.01);
        assertThat(published.toMap())
                .containsAllEntriesOf(Map.of("tendon", "plane", "projection_sweeps", 1))
                .containsEntry("spring_stiffness_n_per_m", 15.0)
                .containsEntry("node_mass_kg", 0.1)
                .containsEntry("damping_ns_per_m", 0.02);
        assertThat(Runs.scenario("muscle_stiffness_n_per_m=450").withMaterial(Materials.PUBLISHED))
                .isEqualTo(published);
    }

    @Test
    void sternumStepsApartMoveNothingElse() {
        try (Simulation apart = Runs.simulation(Runs.scenario("material=published"));
                Simulation whole = Runs.simulation(Runs.scenario("material=paper", "tendon=plane", "integrator=rk2"))) {
            assertThat(apart.stepper().substeps()).isEqualTo(2);
            assertThat(apart.stepper().substeps() * apart.stepper().stepsApart())
                    .isEqualTo(whole.stepper().substeps());
            for (int i = 0; i < 2 * STEPS; i++) {
                apart.step();
                whole.step();
            }
            double[] x = positions(apart);
            double[] fine = positions(whole);
            double largest = 0;
            for (int i = 0; i < x.length; i++) {
                largest = Math.max(largest, Math.abs(x[i] - fine[i]));
            }
            // Sternum and cartilages make the same steps; the sheet makes 5 ms steps instead of 1.7 ms.
            assertThat(largest).isLessThan(0.05).isPositive();
        }
    }

    private static double[] positions(Simulation simulation) {
        double[] x = new double[simulation.system().positions().length];
        simulation.system().layout().toCaller(simulation.system().positions(), x);
        return x;
    }
}
