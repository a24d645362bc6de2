package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleMotions;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

class BackwardEulerTest extends IntegratorContract {
    @Override
    IntegratorKind kind() {
        return IntegratorKind.BACKWARD_EULER;
    }

    @Override
    boolean keepsAngularMomentum() {
        return false;
    }

    /** Conjugate gradients stop at a residual of 1e-8. */
    @Override
    double momentumTolerance() {
        return 1e-7;
    }

    /**
     * Undamped, at steps far beyond what explicit schemes stand (ω h = 10): the energy falls in each step by 1/(1 +
     * y²).
     */
    @Test
    void energyNeverGrows() {
        for (double y : new double[] {0.1, 1, 10}) {
            ParticleSystem system = SampleSystems.oscillator(0.1, 0.1 * y * y, 0);
            system.positions()[0] = 1;
            system.velocities()[1] = y;
            Integrator integrator = kind().create(system);
            double before = system.kineticEnergy() + system.potentialEnergy();
            for (int i = 0; i < 20; i++) {
                integrator.step(i, 1);
                double after = system.kineticEnergy() + system.potentialEnergy();
                assertThat(after / before).isCloseTo(1 / (1 + y * y), within(MANY_ROUNDINGS));
                before = after;
            }
        }
    }

    /** What is held stiffly is where its anchor is at the end of the step, not where it was. */
    @Test
    void takesAnchorsAtTheEndOfTheStep() {
        ParticleSystem system = SampleSystems.oneNode(0.1);
        system.add(new Attachments(
                system.layout(), new int[] {0}, new double[] {1e9}, 0, SampleMotions.swinging(new double[3], 0, 2, 3)));
        kind().create(system).step(0, 0.3);
        assertThat(system.positions()[0]).isCloseTo(2 * Math.sin(0.9), within(1e-6));
    }

    /**
     * A hundred times the largest step of velocity Verlet on a net far from rest: it comes to rest instead of flying
     * apart.
     */
    @Test
    void staysStableAtAnyStep() {
        ParticleSystem system = SampleSystems.net(0);
        double h = 100 * StabilityLimit.of(system).largestStep(IntegratorKind.VERLET);
        system.setViscosityPerMass(1);
        Integrator integrator = kind().create(system);
        double before = system.kineticEnergy() + system.potentialEnergy();
        for (int i = 0; i < 50; i++) {
            integrator.step(i * h, h);
        }
        assertThat(system.kineticEnergy() + system.potentialEnergy()).isLessThan(0.01 * before);
        assertThat(((BackwardEuler) integrator).lastIterationCount()).isLessThan(100);
    }

    /**
     * A chain of 4000 nodes that falls under a load, at ω h = 1012: the velocities are those of the three-term system,
     * solved by elimination.
     */
    @Test
    void aLongStiffChainIsSolvedToTheEnd() {
        int n = 4000;
        double h = 0.016;
        double mass = 1e-6;
        double stiffness = 1000;
        double length = 0.9;
        double[] x = new double[3 * n];
        double[] load = new double[3 * n];
        for (int i = 0; i < n; i++) {
            x[3 * i] = i;
            load[3 * i + 2] = -1e-3;
        }
        NodeLayout layout = NodeLayout.natural(n);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(n, mass), Workers.of(1));
        int[] first = IntStream.range(0, n - 1).toArray();
        int[] second = IntStream.range(1, n).toArray();
        system.add(Springs.between(layout, first, second)
                .stiffness(stiffness)
                .restLengths(SampleSystems.masses(n - 1, length))
                .build());
        system.add(new ConstantLoad(layout, load));
        system.fix(0, n - 1);
        kind().create(system).step(0, h);
        // Across the chain, springs stretched to 1 mm resist by k (1 - l).
        double beside = -h * h * stiffness * (1 - length);
        double[] exact = threeTerms(n - 2, mass - 2 * beside, beside, -1e-3 * h);
        for (int i = 0; i < n - 2; i++) {
            assertThat(system.velocities()[3 * (i + 1) + 2]).isCloseTo(exact[i], within(1e-4));
        }
    }

    /** Solves the system with one number on the diagonal, one beside it and one on the right. */
    private static double[] threeTerms(int n, double diagonal, double beside, double right) {
        double[] factor = new double[n];
        double[] v = new double[n];
        for (int i = 0; i < n; i++) {
            double pivot = diagonal - (i == 0 ? 0 : beside * factor[i - 1]);
            factor[i] = beside / pivot;
            v[i] = (right - (i == 0 ? 0 : beside * v[i - 1])) / pivot;
        }
        for (int i = n - 2; i >= 0; i--) {
            v[i] -= factor[i] * v[i + 1];
        }
        return v;
    }
}
