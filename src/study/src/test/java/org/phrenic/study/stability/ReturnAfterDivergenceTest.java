package org.phrenic.study.stability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.study.stability.CaseResult.Outcome;

/** A divergence that was noticed does not excuse a body that ends elsewhere, or a run that cannot go on. */
class ReturnAfterDivergenceTest {
    private static final double STEP_S = 0.05;

    /** A free node at rest that a divergence in the second step leaves some millimetres from its start. */
    private static class Thrown implements StabilityScene {
        private final Stepper stepper;
        private final double leftByMm;
        private final boolean undoes;
        private boolean thrown;

        /** @param undoes whether there is a change to take back */
        Thrown(double leftByMm, boolean undoes) {
            this.leftByMm = leftByMm;
            this.undoes = undoes;
            ParticleSystem system =
                    new ParticleSystem(NodeLayout.natural(1), new double[3], new double[] {1}, Workers.of(1));
            stepper = new Stepper(IntegratorKind.VERLET.create(system), STEP_S, StepPolicy.SUBSTEP);
        }

        @Override
        public Stepper stepper() {
            return stepper;
        }

        @Override
        public void step() {
            if (stepper.steps() == 1 && !thrown) {
                thrown = true;
                diverge();
            }
            stepper.step();
        }

        /** Loses the node; the engine notices and restores it, but its place is now elsewhere. */
        private void diverge() {
            system().positions()[0] = Double.NaN;
            try {
                for (int i = 0; i < 1000; i++) {
                    stepper.step();
                }
            } catch (DivergenceException noticed) {
                system().positions()[0] = leftByMm;
                throw noticed;
            }
        }

        @Override
        public double linkError() {
            return 0;
        }

        @Override
        public boolean undoLastChange() {
            return undoes;
        }

        @Override
        public void close() {
            system().workers().close();
        }
    }

    private static CaseResult run(StabilityCase.Factory factory, boolean impossible) {
        StabilityBounds bounds = impossible ? StabilityBounds.BODY.ofImpossible() : StabilityBounds.BODY;
        StabilityCase made = new StabilityCase("thrown", "", bounds, factory, 1, 1, 0, 0);
        return CaseRun.of(made, IntegratorKind.VERLET, null, 1, 1e9);
    }

    /** Nothing is recovered where nothing goes on; where that is what the case is made for, it is said. */
    @ParameterizedTest
    @CsvSource({"false, STOPPED, true", "true, NOTICED, false"})
    void aDivergenceThatNothingUndoesEndsTheRun(boolean impossible, Outcome expected, boolean fails) {
        CaseResult cell = run((kind, part, duration) -> new Thrown(0, false), impossible);
        assertThat(cell.outcome()).as(cell.sentence()).isEqualTo(expected);
        assertThat(cell.fails()).isEqualTo(fails);
        assertThat(cell.endedEarly()).as("it spent what it might").isFalse();
        assertThat(cell.simulatedS()).isLessThan(0.5);
        assertThat(cell.sentence()).contains("the simulation diverged at");
        StabilityStudy study = new StabilityStudy(Map.of("thrown", ""), List.of(IntegratorKind.VERLET), List.of(cell));
        assertThat(study.passes()).isNotEqualTo(fails);
        assertThat(new StabilityReport(study).table().get(1)).containsExactly("thrown", expected.label());
    }

    static Stream<RuntimeException> refusals() {
        return Stream.of(
                new IllegalArgumentException("found 1, expected 2"), new BadInputException("found 1, expected 2"));
    }

    @ParameterizedTest
    @MethodSource("refusals")
    void onlyWhatIsToldBeforeTheRunIsARefusal(RuntimeException reason) {
        CaseResult before = run(
                (kind, part, duration) -> {
                    throw reason;
                },
                false);
        assertThat(before.outcome()).isEqualTo(Outcome.REFUSED);
        CaseResult within = run(
                (kind, part, duration) -> new Thrown(0, false) {
                    @Override
                    public void step() {
                        if (stepper().steps() == 1) {
                            throw reason;
                        }
                        stepper().step();
                    }
                },
                false);
        assertThat(within.outcome()).isEqualTo(Outcome.STOPPED);
        assertThat(within.sentence()).isEqualTo("found 1, expected 2");
        assertThat(within.simulatedS()).isEqualTo(STEP_S);
    }

    @ParameterizedTest
    @CsvSource({"0.9, RECOVERED, false", "7.2, NOT_RETURNED, true"})
    void theBodyMustBeBackWithinItsBound(double leftByMm, Outcome expected, boolean fails) {
        StabilityBounds bounds = StabilityBounds.BODY.with(StabilityMeasure.RETURN_MM, 1);
        StabilityCase thrown = new StabilityCase(
                "thrown", "", bounds, (kind, part, duration) -> new Thrown(leftByMm, true), 1, 1, 0, 0);
        CaseResult cell = CaseRun.of(thrown, IntegratorKind.VERLET, null, 1, 1e9);
        assertThat(cell.outcome()).as(cell.sentence()).isEqualTo(expected);
        assertThat(cell.fails()).isEqualTo(fails);
        assertThat(cell.value(StabilityMeasure.RETURN_MM)).isGreaterThan(0.5 * leftByMm);
    }
}
