package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/**
 * A steady breath that is repeated from its record beside the same breath simulated on: how far they are apart, when
 * the record counts, and that the same run gives the same bits.
 */
class BreathRepetitionTest {
    private static final Scenario SIMULATED = Scenario.defaults()
            .with(
                    "resolution=low",
                    "mesh_vertices=3300",
                    "lungs=embedded",
                    "sternum=kinematic",
                    "rate_per_min=30",
                    "threads=1");
    private static final Scenario REPEATED = SIMULATED.with("repeat_breath=true");
    private static final double PERIOD_S = 2;

    private static Simulation simulation(Scenario scenario) {
        return Runs.simulation(scenario);
    }

    private static double[] distances(Simulation one, Simulation other) {
        double[] x = one.system().positions();
        double[] y = other.system().positions();
        double most = 0;
        double squares = 0;
        for (int i = 0; i < x.length; i++) {
            most = Math.max(most, Math.abs(x[i] - y[i]));
            squares += (x[i] - y[i]) * (x[i] - y[i]);
        }
        return new double[] {most, Math.sqrt(3 * squares / x.length)};
    }

    private static void change(String text, Simulation... simulations) {
        for (Simulation simulation : simulations) {
            simulation.change(Assignment.parse(text));
        }
    }

    @Test
    void followsTheSimulatedBreathThroughBreathsAHoldAndTheBreathsAfterIt() {
        try (Simulation simulated = simulation(SIMULATED);
                Simulation repeated = simulation(REPEATED)) {
            long hold = Math.round(2.4 * PERIOD_S / simulated.stepper().dt());
            long release = hold + Math.round(5 / simulated.stepper().dt());
            long end = release + Math.round(2 * PERIOD_S / simulated.stepper().dt());
            long breathing = 0;
            long held = 0;
            long after = 0;
            double most = 0;
            double rms = 0;
            while (simulated.steps() < end) {
                if (simulated.steps() == hold || simulated.steps() == release) {
                    assertThat(repeated.isRepeating())
                            .as("at %s s", simulated.time())
                            .isTrue();
                    change("hold=" + (simulated.steps() == hold), simulated, repeated);
                    assertThat(repeated.isRepeating()).as("after a change").isFalse();
                }
                boolean repeats = repeated.isRepeating();
                simulated.step();
                repeated.step();
                if (repeats) {
                    breathing += simulated.steps() <= hold ? 1 : 0;
                    held += simulated.steps() > hold && simulated.steps() <= release ? 1 : 0;
                    after += simulated.steps() > release ? 1 : 0;
                }
                double[] apart = distances(simulated, repeated);
                most = Math.max(most, apart[0]);
                rms = Math.max(rms, apart[1]);
            }
            // Of 1.4 breaths after the first, 5 s of hold and two breaths after it.
            double dt = simulated.stepper().dt();
            assertThat(breathing * dt).as("repeated before the hold, s").isGreaterThan(0.3 * PERIOD_S);
            assertThat(held * dt).as("still in the hold, s").isBetween(0.4, 4.5);
            assertThat(after * dt).as("repeated after the hold, s").isGreaterThan(0.5 * PERIOD_S);
            assertThat(repeated.repeatedSteps()).isEqualTo(breathing + held + after);
            assertThat(rms).as("rms distance, mm").isBetween(1e-6, 0.1);
            assertThat(most).as("of a node while the sheet folds, mm").isLessThan(1);
        }
    }

    @Test
    void givesTheSameBitsAgainAfterARestartAndAsChangesOfTheScenario() {
        String fresh;
        List<ScheduledChange> made;
        try (Simulation simulation = simulation(REPEATED)) {
            fresh = changedBreath(simulation);
            made = simulation.changes();
            simulation.rerun(List.of());
            assertThat(simulation.isRepeating()).isFalse();
            assertThat(changedBreath(simulation)).as("again").isEqualTo(fresh);
        }
        Scenario scheduled = REPEATED.with("threads=2").withChanges(made);
        try (Simulation simulation = simulation(scheduled)) {
            runTo(simulation, 2.2 * PERIOD_S);
            assertThat(simulation.stateHash()).as("on two threads").isEqualTo(fresh);
        }
    }

    /** Changes the depth while the breath is repeated, and simulates on. */
    private static String changedBreath(Simulation simulation) {
        runTo(simulation, 2 * PERIOD_S);
        assertThat(simulation.isRepeating()).isTrue();
        change("depth=0.8", simulation);
        runTo(simulation, 2.2 * PERIOD_S);
        assertThat(simulation.isRepeating()).as("after another depth").isFalse();
        return simulation.stateHash();
    }

    private static void runTo(Simulation simulation, double timeS) {
        while (simulation.steps() < Math.round(timeS / simulation.stepper().dt())) {
            simulation.step();
        }
    }

    @Test
    void repeatsNothingUnlessItIsAskedToNorAPatternWithoutAPeriod() {
        try (Simulation simulation = simulation(SIMULATED)) {
            runTo(simulation, 1.6 * PERIOD_S);
            assertThat(simulation.repeatedSteps()).isZero();
            change("repeat_breath=true", simulation);
            runTo(simulation, 3.2 * PERIOD_S);
            assertThat(simulation.isRepeating()).as("asked to later").isTrue();
            change("repeat_breath=false", simulation);
            runTo(simulation, 3.25 * PERIOD_S);
            assertThat(simulation.isRepeating()).as("not any more").isFalse();
        }
        try (Simulation simulation = simulation(REPEATED.with("preset=hold-inspiration"))) {
            assertThat(simulation.breathPeriodS()).isInfinite();
            runTo(simulation, 3);
            assertThat(simulation.repeatedSteps()).isZero();
        }
    }
}
