package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleSystems;

/** The clock, what it does with too long a step, and what it does when a state is lost. */
class StepperTest {
    /** ω = 40 1/s: verlet's limit is 0.05 s. */
    private static ParticleSystem fast() {
        ParticleSystem system = SampleSystems.oscillator(0.1, 160, 0);
        system.positions()[0] = 1;
        return system;
    }

    private static Stepper stepper(ParticleSystem system, double dt, StepPolicy policy) {
        return new Stepper(IntegratorKind.VERLET.create(system), dt, policy);
    }

    @Test
    void splitsAStepBeyondTheLimit() {
        ParticleSystem system = fast();
        Stepper stepper = stepper(system, 0.2, StepPolicy.SUBSTEP);
        // 0.2 s in parts of at most 0.9 x 0.05 s.
        assertThat(stepper.substeps()).isEqualTo(5);
        for (int i = 0; i < 1000; i++) {
            stepper.step();
        }
        assertThat(stepper.steps()).isEqualTo(1000);
        assertThat(stepper.time()).isEqualTo(1000 * 0.2);
        assertThat(system.kineticEnergy() + system.potentialEnergy()).isLessThan(1.7 * 80);
    }

    @Test
    void stepsByPartsAreTheSameAsSmallSteps() {
        ParticleSystem split = fast();
        Stepper stepper = stepper(split, 0.1, StepPolicy.SUBSTEP);
        ParticleSystem small = fast();
        Stepper fine = stepper(small, 0.1 / stepper.substeps(), StepPolicy.REFUSE);
        stepper.step();
        for (int i = 0; i < stepper.substeps(); i++) {
            fine.step();
        }
        assertThat(split.positions()[0]).isEqualTo(small.positions()[0]);
    }

    @Test
    void refusesAStepBeyondTheLimitInOneSentenceWithBothNumbers() {
        assertThatThrownBy(() -> stepper(fast(), 0.06, StepPolicy.REFUSE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("0.0600000 s")
                .hasMessageContaining("0.0500")
                .hasMessageContaining("verlet");
        // What is allowed is taken as it is, also next to the limit.
        assertThat(stepper(fast(), 0.049, StepPolicy.REFUSE).substeps()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.01, Double.NaN, Double.POSITIVE_INFINITY})
    void refusesAStepThatIsNone(double dt) {
        assertThatThrownBy(() -> stepper(fast(), dt, StepPolicy.SUBSTEP))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("time step: found " + dt);
    }

    @Test
    void measuresAnewWhenAsked() {
        ParticleSystem system = fast();
        Stepper stepper = stepper(system, 0.04, StepPolicy.SUBSTEP);
        assertThat(stepper.substeps()).isEqualTo(1);
        system.masses()[0] /= 4;
        system.inverseMasses()[0] *= 4;
        stepper.measureStabilityLimit();
        assertThat(stepper.substeps()).isEqualTo(2);
        assertThat(stepper.limit().omegaMax()).isCloseTo(80, within(1e-9));
    }

    /** A force that can be made to break: it turns to NaN, or to a huge pull, at a time. */
    private static final class Breaking implements ForceField {
        private double from = Double.POSITIVE_INFINITY;
        private double pull;
        private boolean broken;

        @Override
        public void prepare(double time) {
            broken = time > from;
        }

        @Override
        public void addForces(double[] x, double[] v, double[] force, int block) {
            if (broken) {
                force[1] += pull;
            }
        }
    }

    @ParameterizedTest
    @EnumSource(IntegratorKind.class)
    void goesBackToTheLastGoodStateAndCanGoOn(IntegratorKind kind) {
        ParticleSystem system = SampleSystems.net(0.01);
        system.setViscosity(0.5);
        Breaking breaking = new Breaking();
        system.add(breaking);
        Stepper stepper = new Stepper(kind.create(system), 0.001, StepPolicy.SUBSTEP);
        for (int i = 0; i < 256; i++) {
            stepper.step();
        }
        double[] goodX = system.positions().clone();
        double[] goodV = system.velocities().clone();
        double[] causes = {Double.NaN, 1e9};
        String[] sentences = {"is not a finite number", "mm/s, the bound is 1.00e+04 mm/s"};
        for (int c = 0; c < 2; c++) {
            breaking.from = 0.3005;
            breaking.pull = causes[c];
            while (stepper.steps() < 300) {
                stepper.step();
            }
            DivergenceException thrown = catchThrowableOfType(DivergenceException.class, stepper::step);
            // A scheme that takes its forces at the start of a step meets the fault in the next one.
            if (thrown == null) {
                thrown = catchThrowableOfType(DivergenceException.class, stepper::step);
            }
            assertThat(thrown)
                    .hasMessageContaining(sentences[c])
                    .hasMessageContaining("node 0 ")
                    .hasMessageContaining("0.2560 s was restored");
            assertThat(stepper.steps()).isEqualTo(256);
            assertThat(stepper.time()).isEqualTo(256 * 0.001);
            assertThat(system.positions()).isEqualTo(goodX);
            assertThat(system.velocities()).isEqualTo(goodV);
        }
        breaking.from = Double.POSITIVE_INFINITY;
        while (stepper.steps() < 600) {
            stepper.step();
        }
        assertThat(system.kineticEnergy()).isFinite();
    }

    /** Several parts of a failed step have the fault in what a scheme keeps of them. */
    @ParameterizedTest
    @EnumSource(names = {"VERLET", "STORMER", "SYMPLECTIC_EULER", "RK4"})
    void afterAFailedStepOfSeveralPartsItGoesOnAsARunThatNeverFailed(IntegratorKind kind) {
        ParticleSystem failed = fast();
        ParticleSystem other = fast();
        Stepper stepper = new Stepper(kind.create(failed), 0.2, StepPolicy.SUBSTEP);
        Stepper undisturbed = new Stepper(kind.create(other), 0.2, StepPolicy.SUBSTEP);
        assertThat(stepper.substeps()).isGreaterThan(1);
        stepper.step();
        failed.velocities()[0] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(stepper.steps()).isZero();
        for (int i = 0; i < 5; i++) {
            stepper.step();
            undisturbed.step();
        }
        assertThat(failed.positions()).isEqualTo(other.positions()).doesNotContain(Double.NaN);
    }

    /** What a field took from the positions of a failed state is not good for the state before it. */
    @Test
    void fieldsForgetWhatTheyTookFromAFailedState() {
        ParticleSystem system = SampleSystems.oneNode(1);
        int[] forgotten = new int[1];
        system.add(new ForceField() {
            @Override
            public void addForces(double[] x, double[] v, double[] force, int block) {}

            @Override
            public void invalidate() {
                forgotten[0]++;
            }
        });
        Stepper stepper = stepper(system, 0.001, StepPolicy.SUBSTEP);
        stepper.step();
        int before = forgotten[0];
        system.velocities()[2] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(forgotten[0]).isEqualTo(before + 1);
    }

    /**
     * What a given motion and a field that is off keep from earlier times belongs to the checkpoint: the field may be
     * switched on before the state is lost.
     */
    @Test
    void aCheckpointHoldsTheHistoryOfGivenMotionAndOfFieldsThatAreOff() {
        ParticleSystem system = SampleSystems.oneNode(1);
        List<String> calls = new ArrayList<>();
        ForceField field = new ForceField() {
            @Override
            public void addForces(double[] x, double[] v, double[] force, int block) {}

            @Override
            public void saveHistory() {
                calls.add("field saved");
            }

            @Override
            public void restoreHistory() {
                calls.add("field restored");
            }
        };
        system.add(field);
        system.prescribe(new int[0], new PrescribedMotion() {
            @Override
            public int pointCount() {
                return 0;
            }

            @Override
            public void at(double time, double[] position, double[] velocity) {}

            @Override
            public void saveMotion() {
                calls.add("motion saved");
            }

            @Override
            public void restoreMotion() {
                calls.add("motion restored");
            }
        });
        system.setEnabled(field, false);
        Stepper stepper = stepper(system, 0.001, StepPolicy.SUBSTEP);
        stepper.step();
        calls.clear();
        stepper.checkpoint();
        system.setEnabled(field, true);
        system.velocities()[2] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(calls).containsExactly("field saved", "motion saved", "field restored", "motion restored");
    }

    /** One step before it leaves all bounds a node is very fast and yet within them: no state to go back to. */
    @Test
    void aStateAboutToLeaveAllBoundsIsNotKept() {
        ParticleSystem system = SampleSystems.oneNode(1);
        Stepper stepper = stepper(system, 0.001, StepPolicy.SUBSTEP);
        for (int i = 0; i < 300; i++) {
            stepper.step();
        }
        double[] kept = {9_000, 2_000};
        long[] backTo = {256, 512};
        for (int c = 0; c < 2; c++) {
            Arrays.fill(system.velocities(), 0);
            system.velocities()[2] = kept[c];
            for (int i = 0; i < 256 && stepper.steps() < 600; i++) {
                stepper.step();
            }
            system.velocities()[2] = Double.NaN;
            assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
            assertThat(stepper.steps()).isEqualTo(backTo[c]);
            while (stepper.steps() < 300) {
                stepper.step();
            }
        }
    }

    /** A change may ruin a state long before a node is fast: for 2 s the state before the change is the one kept. */
    @Test
    void theStateBeforeAChangeIsKeptForTwoSeconds() {
        ParticleSystem system = SampleSystems.oneNode(1);
        Stepper stepper = stepper(system, 0.001, StepPolicy.SUBSTEP);
        long[] ruined = {1000, 2299, 2400};
        long[] backTo = {300, 300, 2300};
        while (stepper.steps() < 300) {
            stepper.step();
        }
        stepper.checkpoint();
        for (int c = 0; c < ruined.length; c++) {
            while (stepper.steps() < ruined[c]) {
                stepper.step();
            }
            system.velocities()[2] = Double.NaN;
            assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
            assertThat(stepper.steps()).isEqualTo(backTo[c]);
            assertThat(system.velocities()[2]).isZero();
        }
    }

    @Test
    void noticesInTheSameStepWhatIsPutIn() {
        for (boolean position : new boolean[] {true, false}) {
            ParticleSystem system = SampleSystems.net(0);
            Stepper stepper = stepper(system, 0.001, StepPolicy.SUBSTEP);
            stepper.step();
            (position ? system.positions() : system.velocities())[3 * 5 + 1] = Double.NaN;
            assertThatThrownBy(stepper::step)
                    .isInstanceOf(DivergenceException.class)
                    .hasMessageContaining("diverged at 0.0020 s")
                    .hasMessageContaining("the state at 0.0000 s was restored");
            assertThat(stepper.time()).isZero();
        }
    }

    @Test
    void speedOfASinglePieceBeyondTheBoundIsNamed() {
        ParticleSystem system = SampleSystems.oneNode(1);
        Stepper stepper = stepper(system, 0.001, StepPolicy.SUBSTEP);
        system.velocities()[2] = 9_999;
        stepper.step();
        system.velocities()[2] = 10_001;
        assertThatThrownBy(stepper::step)
                .isInstanceOf(DivergenceException.class)
                .hasMessageContaining("node 0 moves at 1.00e+04 mm/s");
        // What was set before the first step belongs to the state at 0 s.
        assertThat(system.velocities()[2]).isEqualTo(9_999);
        stepper.nameNodes(node -> "knot " + node);
        system.velocities()[2] = 10_001;
        assertThatThrownBy(stepper::step).hasMessageContaining("(knot 0 moves at 1.00e+04 mm/s");
        stepper.step();
        assertThat(stepper.steps()).isEqualTo(1);
    }

    @Test
    void refusesAStepThatWouldTakeMoreThanTenThousandParts() {
        // The lagged scheme needs h ω² < γ/m: 1e-2 / 1600 s here, a 16,000th of the step.
        ParticleSystem system = SampleSystems.oscillator(0.1, 160, 0.001);
        assertThatThrownBy(() -> new Stepper(IntegratorKind.LAGGED.create(system), 0.1, StepPolicy.SUBSTEP))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("substeps, expected at most 10000")
                .hasMessageContaining("lagged");
    }

    /**
     * A spring that becomes almost three times as stiff without telling, as a scene under load does; it swings by 1 mm.
     */
    private static ParticleSystem stiffening() {
        return stiffening(1);
    }

    private static ParticleSystem stiffening(double fromS) {
        ParticleSystem system = fast();
        system.add(new ForceField() {
            private double more;

            @Override
            public void prepare(double time) {
                more = time > fromS ? 284.7 : 0;
            }

            @Override
            public void addForces(double[] x, double[] v, double[] force, int block) {
                force[0] -= more * x[0];
            }
        });
        return system;
    }

    @Test
    void carriesOnInFinerPartsWhatHasBecomeTooStiff() {
        ParticleSystem system = stiffening();
        Stepper stepper = stepper(system, 0.03, StepPolicy.SUBSTEP);
        assertThat(stepper.substeps()).isEqualTo(1);
        while (stepper.time() < 20) {
            stepper.step();
        }
        // ω goes from 40 to 66.7 1/s: at a step of 0.03 s just beyond the limit, it grows by 5 % a step. What had grown
        // until it was noticed swings on, but grows no more.
        assertThat(Math.abs(system.positions()[0])).isLessThan(100);
        assertThat(stepper.substeps()).isEqualTo(2);
        assertThat(stepper.substepRefinementReason()).isEqualTo("node 0 turns round in every substep");
    }

    /** From there a run goes on as one that never left it, so its substeps are those that it had there. */
    @Test
    void aReturnToTheStateBeforeAChangeRestoresItsSubsteps() {
        ParticleSystem system = stiffening();
        Stepper stepper = stepper(system, 0.03, StepPolicy.SUBSTEP);
        while (stepper.time() < 1) {
            stepper.step();
        }
        long changed = stepper.steps();
        stepper.checkpoint();
        while (stepper.substeps() == 1) {
            stepper.step();
        }
        assertThat(stepper.time()).isLessThan(3);
        system.velocities()[0] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(stepper.steps()).isEqualTo(changed);
        assertThat(stepper.substeps()).isEqualTo(1);
        assertThat(stepper.substepRefinementReason()).isEmpty();
    }

    /** Of which no change was made: every 256 steps, and at the start. */
    @ParameterizedTest
    @CsvSource({"1, 0", "8, 256"})
    void aReturnToAnyStateRestoresTheSubstepsThatItHad(double stiffFromS, long backTo) {
        ParticleSystem system = stiffening(stiffFromS);
        Stepper stepper = stepper(system, 0.03, StepPolicy.SUBSTEP);
        while (stepper.substeps() == 1) {
            stepper.step();
        }
        assertThat(stepper.steps()).isLessThan(backTo + 256);
        system.velocities()[0] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(stepper.steps()).isEqualTo(backTo);
        assertThat(stepper.substeps()).isEqualTo(1);
        assertThat(stepper.substepRefinementReason()).isEmpty();
    }

    /** No change is taken back then, so what was measured last holds for the state that comes back, too. */
    @Test
    void aReturnKeepsALimitThatWasMeasuredSince() {
        ParticleSystem system = fast();
        Stepper stepper = stepper(system, 0.04, StepPolicy.SUBSTEP);
        stepper.step();
        system.masses()[0] /= 4;
        system.inverseMasses()[0] *= 4;
        stepper.measureStabilityLimit();
        system.velocities()[0] = Double.NaN;
        assertThatThrownBy(stepper::step).isInstanceOf(DivergenceException.class);
        assertThat(stepper.substeps()).isEqualTo(2);
    }

    @Test
    void refusingStepperSaysThatASceneChatters() {
        ParticleSystem system = fast();
        system.positions()[0] = 10;
        Stepper stepper = stepper(system, 0.049, StepPolicy.REFUSE);
        stepper.nameNodes(node -> "knot " + node);
        // Within the limit, but at 40 1/s it turns round in every substep.
        assertThatThrownBy(() -> {
                    for (int i = 0; i < 1000; i++) {
                        stepper.step();
                    }
                })
                .isInstanceOf(DivergenceException.class)
                .hasMessageContaining("knot 0 turns round in every substep");
    }

    /** A membrane that is blown up without end is never fast: here a node that goes its way at 100 mm/s. */
    @Test
    void aNodeThatSlowlyLeavesIsNoticedAndPutBackWhereAGoodStateWas() {
        ParticleSystem system = SampleSystems.oscillator(0.1, 1e-6, 0);
        Stepper stepper = stepper(system, 0.01, StepPolicy.SUBSTEP);
        stepper.boundDisplacement(250);
        double home = system.positions()[0];
        system.velocities()[0] = 100;
        DivergenceException lost = catchThrowableOfType(DivergenceException.class, () -> {
            for (int i = 0; i < 1000; i++) {
                stepper.step();
            }
        });
        assertThat(lost).hasMessageContaining("node 0").hasMessageContaining("the bound is 250 mm");
        // 250 mm take 2.5 s; it is looked for every 16 steps.
        assertThat(stepper.time()).isLessThan(2.5);
        assertThat(Math.abs(system.positions()[0] - home)).isLessThan(250);
    }

    /** So that a run that makes the same changes without a divergence goes the same way. */
    @Test
    void afterAChangeANodeHasTheTimeToTurnRoundThatItHasAfterAReturn() {
        ParticleSystem system = SampleSystems.oscillator(0.1, 1e-6, 0);
        Stepper stepper = stepper(system, 0.01, StepPolicy.SUBSTEP);
        stepper.boundDisplacement(250);
        system.velocities()[0] = 100;
        while (stepper.steps() < 240) {
            stepper.step();
        }
        stepper.checkpoint();
        while (stepper.steps() < 240 + 255) {
            stepper.step();
        }
        assertThatThrownBy(stepper::step).hasMessageContaining("the bound is 250 mm");
        assertThat(stepper.steps()).isEqualTo(240);
    }

    @Test
    void withoutAReachANodeMayGoAnywhere() {
        ParticleSystem system = SampleSystems.oscillator(0.1, 1e-6, 0);
        Stepper stepper = stepper(system, 0.01, StepPolicy.SUBSTEP);
        system.velocities()[0] = 100;
        for (int i = 0; i < 1000; i++) {
            stepper.step();
        }
        assertThat(system.positions()[0]).isGreaterThan(900);
    }
}
