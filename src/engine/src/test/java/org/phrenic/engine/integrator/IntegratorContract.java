package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleMotions;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** What every scheme must do; a subclass a scheme adds what is its own. */
abstract class IntegratorContract {
    /** How far a measured order may lie from the stated one. */
    static final double ORDER_SLACK = 0.25;

    /** What a few operations on doubles may lose. */
    static final double ROUNDING = 1e-12;

    /** What thousands of steps may lose. */
    static final double MANY_ROUNDINGS = 1e-9;

    private static final double OMEGA = 2 * Math.PI;

    abstract IntegratorKind kind();

    /**
     * Steps a second to begin the convergence series with: small enough to be in the asymptotic range, large enough to
     * stay above rounding.
     */
    int coarse() {
        return switch (kind().order()) {
            case 4 -> 25;
            case 3 -> 50;
            case 2 -> 100;
            default -> 800;
        };
    }

    /** What the solver inside a scheme leaves of a conserved sum, relative. */
    double momentumTolerance() {
        return ROUNDING;
    }

    /** Steps until a scheme's step is its amplification matrix, whatever it starts with. */
    int stepsBeforeItsMatrix() {
        return 0;
    }

    /** Puts what a scheme keeps from earlier steps, times h², behind x and v h. */
    void memory(Integrator integrator, double h, double[] state) {}

    /** Whether x cross v is conserved to rounding, not only to the scheme's order. */
    abstract boolean keepsAngularMomentum();

    /** Runs to a time in n equal steps. */
    static void run(Integrator integrator, double duration, int n) {
        double h = duration / n;
        for (int i = 0; i < n; i++) {
            integrator.step(i * h, h);
        }
    }

    /** Halves the step three times and holds the slope of the error against the stated order. */
    void assertOrder(String what, IntToDoubleFunction errorWithSteps, int first) {
        double[] error = new double[4];
        StringBuilder log =
                new StringBuilder(what).append(", ").append(kind().label()).append(':');
        for (int i = 0; i < error.length; i++) {
            error[i] = errorWithSteps.applyAsDouble(first << i);
            log.append(String.format(Locale.ROOT, " %.3g", error[i]));
        }
        for (int i = 1; i < error.length; i++) {
            double slope = Math.log(error[i - 1] / error[i]) / Math.log(2);
            log.append(String.format(Locale.ROOT, " [%.3f]", slope));
        }
        double slope = Math.log(error[2] / error[3]) / Math.log(2);
        assertThat(slope).as(log.toString()).isCloseTo(kind().order(), within(ORDER_SLACK));
    }

    /** x = e^(-d t/2) (x0 cos w t + (v0 + d x0 / 2)/w sin w t), w² = ω² - d²/4. */
    private double oscillatorError(double damping, int steps) {
        double x0 = 1.5;
        double v0 = 4;
        double duration = 1.3;
        ParticleSystem system = SampleSystems.oscillator(0.1, 0.1 * OMEGA * OMEGA, 0.1 * damping);
        system.positions()[1] = x0;
        system.velocities()[1] = v0;
        run(kind().create(system), duration, steps);
        double w = Math.sqrt(OMEGA * OMEGA - damping * damping / 4);
        double c = (v0 + damping * x0 / 2) / w;
        double decay = Math.exp(-damping * duration / 2);
        double x = decay * (x0 * Math.cos(w * duration) + c * Math.sin(w * duration));
        double v = decay * w * (c * Math.cos(w * duration) - x0 * Math.sin(w * duration)) - damping / 2 * x;
        return Math.hypot(system.positions()[1] - x, (system.velocities()[1] - v) / OMEGA);
    }

    @Test
    void convergesOnTheOscillatorAtItsOrder() {
        assertOrder("oscillator", n -> oscillatorError(0, n), coarse());
        assertOrder("damped oscillator", n -> oscillatorError(1.6, n), coarse());
    }

    private static ParticleSystem viscousNet() {
        ParticleSystem system = SampleSystems.net(0);
        system.setViscosityPerMass(0.7);
        return system;
    }

    @Test
    void convergesOnANonlinearNetAtItsOrder() {
        double duration = 0.4;
        ParticleSystem reference = viscousNet();
        run(IntegratorKind.RK4.create(reference), duration, 6400);
        assertOrder(
                "net",
                n -> {
                    ParticleSystem system = viscousNet();
                    run(kind().create(system), duration, n);
                    double sum = 0;
                    for (int i = 0; i < 81; i++) {
                        double dx = system.positions()[i] - reference.positions()[i];
                        double dv = (system.velocities()[i] - reference.velocities()[i]) / 10;
                        sum += dx * dx + dv * dv;
                    }
                    return Math.sqrt(sum);
                },
                coarse());
    }

    /**
     * 2,000 undamped periods at ω h = 0.2: the energy swings within a band that does not move.
     *
     * @param above relative height of the band above the initial energy, of the scheme's order in ω h
     * @param below relative depth of the band below it
     */
    void assertEnergyStaysInItsBand(double above, double below) {
        ParticleSystem system = SampleSystems.oscillator(0.1, 0.1, 0);
        system.positions()[0] = 1;
        Integrator integrator = kind().create(system);
        int period = 31;
        double[] high = new double[2];
        double[] low = {1, 1};
        for (int i = 0; i < 2000 * period; i++) {
            integrator.step(i * 0.2, 0.2);
            double energy = system.kineticEnergy() + system.potentialEnergy();
            int part = i < 1000 * period ? 0 : 1;
            high[part] = Math.max(high[part], energy);
            low[part] = Math.min(low[part], energy);
        }
        // 1/2 m (v² + ω² x²) of 0.05 µJ at the start.
        assertThat(high[0]).isLessThan(0.05 * (1 + above));
        assertThat(low[0]).isGreaterThan(0.05 * (1 - below));
        assertThat(high[1]).isCloseTo(high[0], within(1e-6));
        assertThat(low[1]).isCloseTo(low[0], within(1e-6));
    }

    /** A mass on a spring whose other end swings as A sin Ωt: x = A ω²/(ω² - Ω²) (sin Ωt - Ω/ω sin ωt) from rest. */
    private static double swungError(double x, double v, double t) {
        double factor = 2 * OMEGA * OMEGA / (OMEGA * OMEGA - 9);
        double exactX = factor * (Math.sin(3 * t) - 3 / OMEGA * Math.sin(OMEGA * t));
        double exactV = factor * 3 * (Math.cos(3 * t) - Math.cos(OMEGA * t));
        return Math.hypot(x - exactX, (v - exactV) / OMEGA);
    }

    @Test
    void convergesAtItsOrderWhenAHeldNodeOrAnAnchorMoves() {
        double k = 0.1 * OMEGA * OMEGA;
        double duration = 1.1;
        assertOrder(
                "held node moves",
                n -> {
                    double[] x = {0, 0, 0, 20, 0, 0};
                    ParticleSystem system =
                            new ParticleSystem(NodeLayout.natural(2), x, SampleSystems.masses(2, 0.1), Workers.of(1));
                    system.add(Springs.between(system.layout(), new int[] {0}, new int[] {1})
                            .stiffness(k)
                            .restLengthsAt(x)
                            .build());
                    system.prescribe(new int[] {0}, SampleMotions.swinging(new double[3], 0, 2, 3));
                    run(kind().create(system), duration, n);
                    return swungError(system.positions()[3] - 20, system.velocities()[3], duration);
                },
                coarse());
        assertOrder(
                "anchor moves",
                n -> {
                    ParticleSystem system = SampleSystems.oneNode(0.1);
                    system.add(new Attachments(
                            system.layout(),
                            new int[] {0},
                            new double[] {k},
                            0,
                            SampleMotions.swinging(new double[3], 0, 2, 3)));
                    run(kind().create(system), duration, n);
                    return swungError(system.positions()[0], system.velocities()[0], duration);
                },
                coarse());
    }

    /**
     * Free fall: schemes of order 2 and more, and the lagged one, are exact; both Euler schemes are off by ± g h t / 2.
     */
    @Test
    void fallsFreely() {
        double g = -9810;
        ParticleSystem system = SampleSystems.oneNode(0.2);
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, 0.2 * g}));
        run(kind().create(system), 0.5, 64);
        boolean euler = kind() == IntegratorKind.SYMPLECTIC_EULER || kind() == IntegratorKind.BACKWARD_EULER;
        double off = euler ? g * 0.5 / 64 * 0.5 / 2 : 0;
        assertThat(system.positions()[2]).isCloseTo(g * 0.125 + off, within(1e-9));
        assertThat(system.velocities()[2]).isCloseTo(g * 0.5, within(1e-9));
    }

    /**
     * Ties the stability theory to the code: the scheme's own step on one node is its amplification matrix on (x, v h,
     * a h²).
     */
    @Test
    void stepIsTheAmplificationMatrix() {
        for (double[] number : new double[][] {{0.3, 0.1}, {1.7, 0}, {2.5, 0.4}, {0, 0.2}}) {
            assertStepIs(kind().amplification(number[0], number[1]), number[0], number[1], 0);
        }
        assertStepIs(kind().amplification(0.9, 0.2, 0.7), 0.9, 0.2, 0.7);
    }

    private void assertStepIs(double[][] matrix, double a, double b, double c) {
        double m = 0.3;
        double h = 0.02;
        double k = m * a / (h * h);
        ParticleSystem system = SampleSystems.oneNode(m);
        if (a > 0) {
            system.add(new Attachments(
                    system.layout(),
                    new int[] {0},
                    new double[] {k},
                    c * m / h / k,
                    PrescribedMotion.stationary(new double[3])));
        }
        system.setViscosity(m * b / h);
        double[] state = new double[Math.max(3, matrix.length)];
        state[0] = 0.8;
        state[1] = -0.5;
        system.positions()[0] = state[0];
        system.velocities()[0] = state[1] / h;
        // What a scheme keeps from before its first step: the acceleration, for verlet without its implicit viscosity.
        double viscous = kind() == IntegratorKind.VERLET ? 0 : b;
        state[2] = -a * state[0] - (viscous + c) * state[1];
        Integrator integrator = kind().create(system);
        int first = stepsBeforeItsMatrix();
        for (int step = 0; step < first; step++) {
            integrator.step(step * h, h);
            state[0] = system.positions()[0];
            state[1] = system.velocities()[0] * h;
            memory(integrator, h, state);
        }
        for (int step = first; step < first + 5; step++) {
            double[] next = new double[state.length];
            for (int i = 0; i < matrix.length; i++) {
                for (int j = 0; j < matrix.length; j++) {
                    next[i] += matrix[i][j] * state[j];
                }
            }
            state = next;
            integrator.step(step * h, h);
            assertThat(system.positions()[0]).as("x, a=%s b=%s c=%s", a, b, c).isCloseTo(state[0], within(ROUNDING));
            assertThat(system.velocities()[0] * h)
                    .as("v h, a=%s b=%s c=%s", a, b, c)
                    .isCloseTo(state[1], within(ROUNDING));
        }
    }

    /** Linear momentum in [0..2], angular in [3..5]. */
    static double[] momentum(ParticleSystem system) {
        double[] x = system.positions();
        double[] v = system.velocities();
        double[] p = new double[6];
        for (int n = 0; n < system.nodeCount(); n++) {
            double m = system.masses()[n];
            int i = 3 * n;
            for (int axis = 0; axis < 3; axis++) {
                int b = i + (axis + 1) % 3;
                int c = i + (axis + 2) % 3;
                p[axis] += m * v[i + axis];
                p[3 + axis] += m * (x[b] * v[c] - x[c] * v[b]);
            }
        }
        return p;
    }

    private double angularDrift(int steps) {
        ParticleSystem system = SampleSystems.net(0.005);
        double[] before = momentum(system);
        run(kind().create(system), 0.5, steps);
        double[] after = momentum(system);
        double scale = Math.abs(before[5]);
        return Math.hypot(after[3] - before[3], Math.hypot(after[4] - before[4], after[5] - before[5])) / scale;
    }

    @Test
    void internalForcesKeepMomentum() {
        ParticleSystem system = SampleSystems.net(0.005);
        double[] before = momentum(system);
        run(kind().create(system), 0.5, 200);
        double[] after = momentum(system);
        double scale = Math.abs(before[0]) + Math.abs(before[1]) + Math.abs(before[2]);
        for (int axis = 0; axis < 3; axis++) {
            assertThat(after[axis]).isCloseTo(before[axis], within(momentumTolerance() * scale));
        }
        double coarse = angularDrift(200);
        if (keepsAngularMomentum()) {
            assertThat(coarse).isLessThan(ROUNDING);
        } else {
            assertThat(angularDrift(400)).isLessThan(coarse * Math.pow(2, -(kind().order() - ORDER_SLACK)));
        }
    }

    @Test
    void rigidLinksAreAtTheirLengthAfterEachStep() {
        ParticleSystem system = SampleSystems.net(0);
        RigidLinks links = RigidLinks.gaussSeidel(
                system.layout(),
                new int[] {0, 1, 9, 13, 26},
                new int[] {1, 2, 1, 22, 25},
                system.positions().clone(),
                1e-10,
                500);
        system.add(links);
        Integrator integrator = kind().create(system);
        for (int i = 0; i < 200; i++) {
            integrator.step(i * 0.005, 0.005);
            assertThat(links.error(system)).isLessThan(1e-9);
        }
        assertThat(system.positions()).doesNotContain(Double.NaN);
    }

    /** Links keep the order of schemes of order 1 and 2; projecting once a step allows no more than 2. */
    @Test
    void linkedNodesMoveAsOnAPendulum() {
        double coarse = PendulumSystem.angleError(kind(), 1000);
        double fine = PendulumSystem.angleError(kind(), 2000);
        double order = Math.min(2, kind().order());
        assertThat(coarse).isLessThan(order == 1 ? 2e-3 : 1e-5);
        assertThat(Math.log(coarse / fine) / Math.log(2)).isGreaterThan(order - ORDER_SLACK);
    }

    /** 10,000 steps, some 16 swings, of a pendulum: a link neither heats nor brakes it. */
    @Test
    void linkNeitherHeatsNorBrakes() {
        ParticleSystem system = PendulumSystem.create();
        double before = PendulumSystem.energy(system);
        Integrator integrator = kind().create(system);
        double h = 0.001;
        double tolerance = kind().order() == 1 ? 0.006 : 0.0002;
        for (int i = 0; i < 10_000; i++) {
            integrator.step(i * h, h);
            double ratio = PendulumSystem.energy(system) / before;
            if (Math.abs(ratio - 1) > tolerance) {
                assertThat(ratio).as("step %s", i).isCloseTo(1, within(tolerance));
            }
        }
    }

    @Test
    void givenNodesAreWhereTheyBelongToTheLastBit() {
        ParticleSystem system = SampleSystems.sheets(8, 6, 1);
        Integrator integrator = kind().create(system);
        double[] start = {21, 15, 0, 18, 15, 0};
        int last = 47;
        double[] at = new double[3];
        for (int i = 0; i < 2; i++) {
            system.position(last - i, at);
            System.arraycopy(at, 0, start, 3 * i, 3);
        }
        PrescribedMotion motion = SampleMotions.swinging(start, 1, 0.2, 9);
        double[] x = new double[6];
        double[] v = new double[6];
        for (int step = 0; step < 30; step++) {
            integrator.step(step * 0.005, 0.005);
            motion.at(step * 0.005 + 0.005, x, v);
            for (int i = 0; i < 2; i++) {
                int node = 3 * system.layout().internal(last - i);
                for (int axis = 0; axis < 3; axis++) {
                    assertThat(system.positions()[node + axis]).isEqualTo(x[3 * i + axis]);
                    assertThat(system.velocities()[node + axis]).isEqualTo(v[3 * i + axis]);
                }
            }
        }
    }

    @Test
    void sameBitsOnAnyNumberOfThreads() {
        double[] expected = null;
        for (int threads = 1; threads <= 3; threads++) {
            ParticleSystem system = SampleSystems.sheets(45, 40, threads);
            try (Workers workers = system.workers()) {
                assertThat(system.nodeCount()).isGreaterThan(3000);
                assertThat(system.layout().blockCount()).isGreaterThan(4);
                Integrator integrator = kind().create(system);
                for (int i = 0; i < 12; i++) {
                    integrator.step(i * 0.005, 0.005);
                }
                assertThat(workers.count()).isEqualTo(threads);
            }
            double[] state = DoubleStream.concat(Arrays.stream(system.positions()), Arrays.stream(system.velocities()))
                    .toArray();
            assertThat(Arrays.stream(state).allMatch(Double::isFinite)).isTrue();
            double wall = 2.2 - 2 * 0.06;
            assertThat(IntStream.range(0, system.nodeCount())
                            .filter(n -> Math.abs(system.positions()[3 * n + 2] - wall) < ROUNDING)
                            .count())
                    .as("nodes that lie against the wall")
                    .isGreaterThan(20);
            if (expected == null) {
                expected = state;
            }
            assertThat(Arrays.equals(state, expected)).as("%s threads", threads).isTrue();
        }
    }

    @Test
    void allocatesNothingInAStep() {
        ParticleSystem system = SampleSystems.sheets(6, 5, 1);
        Stepper stepper = new Stepper(kind().create(system), 0.002, StepPolicy.SUBSTEP);
        for (int i = 0; i < 500; i++) {
            stepper.step();
        }
        ThreadMXBean bean = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        // An object a step is 16,000 bytes in every window; linking a call site or a reading is a few hundred in one.
        long least = Long.MAX_VALUE;
        for (int window = 0; window < 3; window++) {
            long before = bean.getThreadAllocatedBytes(id);
            for (int i = 0; i < 1000; i++) {
                stepper.step();
            }
            least = Math.min(least, bean.getThreadAllocatedBytes(id) - before);
        }
        assertThat(least).isLessThan(500);
    }
}
