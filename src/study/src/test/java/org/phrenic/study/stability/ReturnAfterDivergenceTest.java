package org.phrenic.study.stability;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.study.stability.CaseResult.Outcome;

/** A divergence that was noticed and undone does not excuse a body that ends elsewhere. */
class ReturnAfterDivergenceTest {
    private static final double STEP_S = 0.05;

    /** A free node at rest that a divergence in the second step leaves some millimetres from its start. */
    private static final class Thrown implements StabilityScene {
        private final Stepper stepper;
        private final double leftByMm;
        private boolean thrown;

        Thrown(double leftByMm) {
            this.leftByMm = leftByMm;
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
            return true;
        }

        @Override
        public void close() {
            system().workers().close();
        }
    }

    @ParameterizedTest
    @CsvSource({"0.9, RECOVERED, false", "7.2, NOT_RETURNED, true"})
    void theBodyMustBeBackWithinItsBound(double leftByMm, Outcome expected, boolean fails) {
        StabilityBounds bounds = StabilityBounds.BODY.with(StabilityMeasure.RETURN_MM, 1);
        StabilityCase thrown =
                new StabilityCase("thrown", "", bounds, (kind, part, duration) -> new Thrown(leftByMm), 1, 1, 0, 0);
        CaseResult cell = CaseRun.of(thrown, IntegratorKind.VERLET, null, 1, 1e9);
        assertThat(cell.outcome()).as(cell.sentence()).isEqualTo(expected);
        assertThat(cell.fails()).isEqualTo(fails);
        assertThat(cell.value(StabilityMeasure.RETURN_MM)).isGreaterThan(0.5 * leftByMm);
    }
}
