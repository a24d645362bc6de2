package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.junit.jupiter.api.Test;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.scenario.Scenario;

/** The model of Villard, Bourne and Bello 2009: k = 15, m = 0.1, gamma = 0.02, dt = 0.01 s. */
class PaperMaterialTest {
    private static final String[] PAPER = Runs.sheetAlone("material=paper", "pressure=false", "tendon=plane");

    private static String[] paper(String... more) {
        String[] all = java.util.Arrays.copyOf(PAPER, PAPER.length + more.length);
        System.arraycopy(more, 0, all, PAPER.length, more.length);
        return all;
    }

    @Test
    void itsStepIsStableWithVerletAndItMovesAndStaysBounded() {
        Runs.Run breaths = Runs.of(8, paper("preset=deep", "step_policy=refuse"));
        assertThat(breaths.substeps()).isEqualTo(1);
        assertThat(breaths.most("from_rest_rms_mm"))
                .as("rms of all nodes, 14.0 mm when this was written")
                .isBetween(12.0, 16.0);
        assertThat(breaths.fall("dome_right_mm")).as("the force pulls down").isPositive();
        assertThat(breaths.most("rigid_link_error")).isLessThanOrEqualTo(1e-4);
    }

    /** The sheet is nearly symmetric, so its domes change places with the ratio. */
    @Test
    void theStrongerActionLineMovesItsSideFarther() {
        Runs.Run left = Runs.of(2, paper("preset=deep", "muscle_force_left_over_right=2"));
        Runs.Run right = Runs.of(2, paper("preset=deep", "muscle_force_left_over_right=0.5"));
        assertThat(left.fall("dome_left_mm")).isGreaterThan(1.3 * left.fall("dome_right_mm"));
        assertThat(right.fall("dome_right_mm")).isGreaterThan(1.3 * right.fall("dome_left_mm"));
        assertThat(left.fall("dome_left_mm"))
                .as("the stronger side has the force of muscle_force_mn")
                .isCloseTo(Runs.of(2, paper("preset=deep")).fall("dome_left_mm"), withinPercentage(5));
    }

    @Test
    void itsOwnRungeKuttaSchemeIsBeyondItsLimitAndIsSplit() {
        Scenario scenario = Runs.scenario(paper("integrator=rk2"));
        try (Simulation simulation = Runs.simulation(scenario)) {
            assertThat(simulation.stepper().substeps()).isGreaterThan(1);
            assertThat(simulation.stepper().limit().describe(IntegratorKind.RK2, 0.01))
                    .contains("0.01")
                    .contains("beyond the stability limit")
                    .contains("rk2");
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Runs.simulation(scenario.with("step_policy=refuse")))
                .withMessageContaining("time step 0.0100000 s")
                .withMessageContaining("stability limit 0.0")
                .withMessageEndingWith("refused");
    }
}
