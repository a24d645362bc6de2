package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.model.material.Materials;
import org.phrenic.scenario.Scenario;

/** A material chosen in the window, {@link Scenario#withMaterial}, computes what {@code --material} computes. */
class MaterialChoiceTest {
    private static final int STEPS = 30;

    private static String hash(Scenario scenario) {
        try (Simulation simulation = Simulation.of(scenario, Runs.male())) {
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
}
