package org.phrenic.study.error;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

class EquilibriumLagTest {
    /** A step of 5 ms is beyond what the springs bear: the breath is split, and a hold in whole steps diverges. */
    @Test
    void aBreathThatIsSplitIntoSubstepsIsHeldInSubsteps() {
        BudgetPlan plan = BudgetPlan.quick(List.of(new BudgetPlan.Body("virtual man", "virtual/adult-male")));
        Scenario scenario = plan.scenario(
                        plan.bodies().get(0), "quiet", plan.meshes().get(0))
                .with("time_step_s=0.005");
        SolverSettings settings = SolverSettings.of(scenario);
        try (BreathRunner runs =
                new BreathRunner(scenario, SimulationRun.loadThorax(scenario), BreathRunner.SAMPLE_S)) {
            Trajectory run = runs.run(settings);
            assertThat(run.substeps()).isGreaterThan(1);
            List<EquilibriumLag> alone = EquilibriumLag.of(runs, run, settings, List.of(0.75));
            assertThat(EquilibriumLag.of(runs, run, settings, List.of(0.3, 0.75)))
                    .as("each phase begins anew")
                    .hasSize(2)
                    .usingRecursiveFieldByFieldElementComparator()
                    .endsWith(alone.get(0))
                    .allSatisfy(lag -> {
                        assertThat(lag.heldMaxMm()).isBetween(0.001, 1.0);
                        assertThat(lag.heldDriftMm()).isBetween(0.0, 0.1);
                        assertThat(lag.newton().converged()).isTrue();
                        assertThat(lag.relaxationErrorMm()).isPositive().isLessThan(0.1 * lag.heldRmsMm());
                        assertThat(lag.rmsMm())
                                .as("from Newton's equilibrium, not from where the held body rests")
                                .isNotEqualTo(lag.heldRmsMm())
                                .isCloseTo(lag.heldRmsMm(), within(lag.relaxationErrorMm()));
                        assertThat(lag.maxMm()).isGreaterThan(lag.rmsMm());
                    });
        }
    }
}
