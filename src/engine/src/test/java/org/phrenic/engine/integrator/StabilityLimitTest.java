package org.phrenic.engine.integrator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.SphereMeshes;
import org.phrenic.engine.SphereMeshes.TriangleSurface;
import org.phrenic.engine.force.Attachments;
import org.phrenic.engine.force.Springs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

class StabilityLimitTest {
    /** The paper's parameters (Villard, Bourne and Bello 2009): stiffness, mass, damping, step. */
    private static final double K = 15;

    private static final double M = 0.1;
    private static final double GAMMA = 0.02;
    private static final double DT = 0.01;
    /** The margin that is put on the highest frequency found, which comes from below. */
    private static final double MARGIN = 1.03;
    /** How near bisection and the allowance for rounding bring a limit to the formula. */
    private static final double NEAR = 1e-4;

    /** n nodes in a row between two held ones, joined by n + 1 equal springs at rest. */
    private static ParticleSystem chain(int n) {
        double[] x = new double[3 * (n + 2)];
        Arrays.setAll(x, i -> i % 3 == 0 ? i / 3 * 2.0 : 0);
        ParticleSystem system =
                new ParticleSystem(NodeLayout.morton(x), x, SampleSystems.masses(n + 2, M), Workers.of(1));
        int[] a = IntStream.range(0, n + 1).toArray();
        int[] b = IntStream.range(1, n + 2).toArray();
        system.add(Springs.between(system.layout(), a, b)
                .stiffness(K)
                .restLengthsAt(x)
                .build());
        system.fix(0, n + 1);
        return system;
    }

    private static ParticleSystem surface(double[] x, int[] triangles) {
        NodeLayout layout = NodeLayout.morton(x);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(x.length / 3, M), Workers.of(1));
        int[][] edges = SampleSystems.edgesOf(triangles);
        system.add(Springs.between(layout, edges[0], edges[1])
                .stiffness(K)
                .restLengthsAt(x)
                .build());
        system.setViscosity(GAMMA);
        return system;
    }

    /** By bisection of all frequencies at once, from a step that all schemes bear. */
    private static double bisected(IntegratorKind kind, StabilityLimit limit) {
        double low = 1e-6 / Math.max(limit.omegaMax(), limit.maxDamping());
        double high = low;
        while (limit.isStable(kind, high)) {
            low = high;
            high *= 1.5;
        }
        for (int i = 0; i < 40; i++) {
            double middle = 0.5 * (low + high);
            if (limit.isStable(kind, middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /**
     * In a system of much damping and little stiffness the lowest frequency limits the explicit schemes, else the
     * highest one does.
     */
    @Test
    void theLimitIsThatOfAllFrequenciesToTheLastBit() {
        StabilityLimit light = new StabilityLimit(900, 900, 0.4, 3, 0, true);
        StabilityLimit[] limits = {
            new StabilityLimit(700, 800, 0.3, 40, 2, true),
            new StabilityLimit(30, 40, 100, 100, 0, false),
            new StabilityLimit(500, 500, 1, 5, 0, true, Optional.of(light)),
        };
        int compared = 0;
        for (IntegratorKind kind : IntegratorKind.values()) {
            for (StabilityLimit limit : limits) {
                double largest = limit.largestStep(kind);
                if (largest == 0 || Double.isInfinite(largest)) {
                    continue;
                }
                double here = bisected(kind, limit);
                boolean apart = limit.apart().isPresent() && !kind.stepsNodesApart();
                assertThat(largest)
                        .as("%s, %s", kind, limit)
                        .isEqualTo(apart ? Math.min(here, bisected(kind, light)) : here);
                compared++;
            }
        }
        assertThat(compared).isGreaterThanOrEqualTo(12);
    }

    @Test
    void findsTheFrequencyOfOneOscillator() {
        StabilityLimit limit = StabilityLimit.of(SampleSystems.oscillator(M, K, GAMMA));
        assertThat(limit.omegaMax()).isCloseTo(Math.sqrt(K / M), within(1e-12));
        assertThat(limit.omegaBound()).isCloseTo(Math.sqrt(K / M), within(1e-12));
        assertThat(limit.minDamping()).isCloseTo(GAMMA / M, within(1e-12));
        assertThat(limit.maxDamping()).isCloseTo(GAMMA / M, within(1e-12));
    }

    /** Longitudinal modes of a chain between walls: ω_j = 2 √(k/m) sin(j π / (2 (n+1))). */
    @Test
    void findsTheHighestFrequencyOfAChain() {
        for (int n : new int[] {1, 2, 5, 50, 500}) {
            StabilityLimit limit = StabilityLimit.of(chain(n));
            double exact = 2 * Math.sqrt(K / M) * Math.sin(n * Math.PI / (2.0 * (n + 1)));
            assertThat(limit.omegaMax()).as("%s nodes", n).isBetween(exact * (1 - 1e-6), exact * MARGIN * (1 + 1e-6));
            assertThat(limit.omegaBound()).isCloseTo(2 * Math.sqrt(K / M), within(1e-9));
            assertThat(limit.omegaMax()).isLessThanOrEqualTo(limit.omegaBound());
        }
    }

    /** A plane lattice of equilateral triangles: ω² = 6 k/m at the zone's edge; its Gershgorin bound is 12 k/m. */
    @Test
    void findsTheHighestFrequencyOfATriangularLattice() {
        int side = 40;
        double[] x = new double[3 * side * side];
        for (int i = 0; i < side * side; i++) {
            x[3 * i] = i % side + 0.5 * (i / side);
            x[3 * i + 1] = Math.sqrt(3) / 2 * (i / side);
        }
        int[] triangles = new int[6 * (side - 1) * (side - 1)];
        for (int c = 0; c < (side - 1) * (side - 1); c++) {
            int i = c / (side - 1) * side + c % (side - 1);
            int[] two = {i, i + 1, i + side, i + 1, i + side + 1, i + side};
            System.arraycopy(two, 0, triangles, 6 * c, 6);
        }
        StabilityLimit limit = StabilityLimit.of(surface(x, triangles));
        double exact = Math.sqrt(6 * K / M);
        assertThat(limit.omegaMax()).isBetween(exact, exact * MARGIN);
        assertThat(limit.omegaBound()).isCloseTo(Math.sqrt(12 * K / M), within(1e-9));
    }

    /**
     * Springs of all lengths and stretches: the estimate never passes Gershgorin's bound nor lies below what motion
     * shows.
     */
    @Test
    void liesBetweenAnyRayleighQuotientAndGershgorin() {
        for (int seed = 0; seed < 5; seed++) {
            double[] x = SampleSystems.gridPositions(4, 3, seed);
            int[][] edges = SampleSystems.gridEdges(4);
            ParticleSystem system =
                    new ParticleSystem(NodeLayout.morton(x), x, SampleSystems.masses(64, M), Workers.of(1));
            system.add(Springs.between(system.layout(), edges[0], edges[1])
                    .stiffness(K)
                    .restLengthsAt(SampleSystems.gridPositions(4, 0, 0))
                    .build());
            StabilityLimit limit = StabilityLimit.of(system);
            assertThat(limit.omegaMax()).isLessThanOrEqualTo(limit.omegaBound());
            double best = 0;
            Random random = new Random(seed);
            for (int trial = 0; trial < 50; trial++) {
                double[] u = random.doubles(192, -1, 1).toArray();
                double[] ku = new double[192];
                system.addStiffness(system.positions(), u, ku, 0);
                double above =
                        IntStream.range(0, 192).mapToDouble(i -> u[i] * ku[i]).sum();
                double below = Arrays.stream(u).map(value -> M * value * value).sum();
                best = Math.max(best, above / below);
            }
            assertThat(limit.omegaMax()).isGreaterThan(Math.sqrt(best));
        }
    }

    private static StabilityLimit undamped(double omega) {
        return new StabilityLimit(omega, omega, 0, 0, 0, false);
    }

    @Test
    void knowsTheLimitsOfTheSchemes() {
        StabilityLimit limit = undamped(40);
        assertThat(limit.largestStep(IntegratorKind.VERLET)).isCloseTo(2.0 / 40, within(NEAR / 40));
        assertThat(limit.largestStep(IntegratorKind.SYMPLECTIC_EULER)).isCloseTo(2.0 / 40, within(NEAR / 40));
        assertThat(limit.largestStep(IntegratorKind.RK4)).isCloseTo(2 * Math.sqrt(2) / 40, within(NEAR / 40));
        // det(M - λ) has a root -1 at ω h = √3.
        assertThat(limit.largestStep(IntegratorKind.STORMER)).isCloseTo(Math.sqrt(3) / 40, within(NEAR / 40));
        assertThat(limit.largestStep(IntegratorKind.BACKWARD_EULER)).isInfinite();
        assertThat(limit.largestStep(IntegratorKind.RK2)).isZero();
        assertThat(limit.largestStep(IntegratorKind.LAGGED)).isZero();
    }

    /**
     * ω⁴ h³ / 8 = γ / 2m to leading order in h (numerics of midpoint Runge-Kutta), γ/m = h ω² for the lagged scheme.
     */
    @Test
    void dampingSetsTheLimitOfSchemesThatGrow() {
        double damping = GAMMA / M;
        StabilityLimit limit = new StabilityLimit(36, 36, damping, damping, 0, false);
        double h = Math.cbrt(4 * damping / Math.pow(36, 4));
        assertThat(limit.largestStep(IntegratorKind.RK2)).isCloseTo(h, within(0.02 * h));
        double lagged = damping / (36 * 36);
        assertThat(limit.largestStep(IntegratorKind.LAGGED)).isCloseTo(lagged, within(0.01 * lagged));
    }

    /**
     * Viscosity of any strength, however small, neither takes away verlet's 2/ω nor shows as growth where there is
     * none.
     */
    @Test
    void viscosityLeavesVerletItsLimit() {
        for (double damping = 1e-12; damping < 1e6; damping *= 10) {
            StabilityLimit limit = new StabilityLimit(30, 30, damping, damping, 0, false);
            assertThat(limit.largestStep(IntegratorKind.VERLET))
                    .as("γ/m = %s", damping)
                    .isCloseTo(2.0 / 30, within(NEAR / 30));
            assertThat(limit.largestStep(IntegratorKind.BACKWARD_EULER)).isInfinite();
        }
    }

    /**
     * Dashpots are explicit in verlet: at rest frequency ω and dashpot rate e it needs ω² h² < 4 - 2 e h; run to see
     * that it is so.
     */
    @Test
    void dashpotsLimitVerlet() {
        double omega = 30;
        double rate = 100;
        StabilityLimit limit = new StabilityLimit(omega, omega, 0, rate, rate, false);
        double h = (-rate + Math.sqrt(rate * rate + 4 * omega * omega)) / (omega * omega);
        assertThat(limit.largestStep(IntegratorKind.VERLET)).isCloseTo(h, within(NEAR * h));
        assertThat(limit.largestStep(IntegratorKind.BACKWARD_EULER)).isLessThan(10 / rate);
        // Viscosity of other nodes is no help.
        StabilityLimit mixed = new StabilityLimit(omega, omega, 0, 2 * rate, rate, false);
        assertThat(mixed.largestStep(IntegratorKind.VERLET)).isLessThanOrEqualTo(h * (1 + NEAR));
        double implicit = limit.largestStep(IntegratorKind.BACKWARD_EULER);
        assertThat(mixed.largestStep(IntegratorKind.BACKWARD_EULER)).isCloseTo(implicit, within(NEAR * implicit));
        for (IntegratorKind kind : IntegratorKind.values()) {
            double step = limit.largestStep(kind);
            assertThat(dashedEnergy(kind, omega, rate, 0.98 * step))
                    .as(kind + " below")
                    .isLessThan(1);
            // Schemes that grow without damping are limited by the modes that dashpots leave alone, not by this one.
            if (kind != IntegratorKind.RK2 && kind != IntegratorKind.LAGGED) {
                assertThat(dashedEnergy(kind, omega, rate, 1.2 * step))
                        .as(kind + " above")
                        .isGreaterThan(1);
            }
        }
    }

    /** A node of mass 1 on a damped spring from a held one. */
    private static ParticleSystem dashed(double omega, double rate) {
        double[] x = {0, 0, 0, 10, 0, 0};
        ParticleSystem system = new ParticleSystem(NodeLayout.natural(2), x, SampleSystems.masses(2, 1), Workers.of(1));
        system.add(Springs.between(system.layout(), new int[] {0}, new int[] {1})
                .stiffness(omega * omega)
                .restLengthsAt(x)
                .damping(rate)
                .build());
        system.fix(0);
        return system;
    }

    /** The row of a spring's node holds its dashpot twice, as of two free ends; that of an attachment holds it once. */
    @Test
    void findsTheDashpotsOfSpringsAndAttachments() {
        ParticleSystem spring = dashed(30, 100);
        spring.setViscosity(7);
        StabilityLimit limit = StabilityLimit.of(spring);
        assertThat(limit.minDamping()).isEqualTo(7);
        assertThat(limit.maxDamping()).isEqualTo(207);
        assertThat(limit.maxDashpot()).isEqualTo(200);
        double undamped = 2 / limit.omegaMax();
        assertThat(limit.largestStep(IntegratorKind.VERLET)).isLessThan(0.3 * undamped);
        ParticleSystem attached = SampleSystems.oneNode(M);
        attached.add(new Attachments(
                attached.layout(), new int[] {0}, new double[] {K}, 2, PrescribedMotion.stationary(new double[3])));
        assertThat(StabilityLimit.of(attached).maxDashpot()).isCloseTo(2 * K / M, within(1e-12));
    }

    /**
     * Energy of a pair on a damped spring after 2,000 steps, as a share of that at the start; NaN counts as infinite.
     */
    private static double dashedEnergy(IntegratorKind kind, double omega, double rate, double h) {
        ParticleSystem system = dashed(omega, rate);
        system.positions()[3] += 1e-3;
        double before = system.potentialEnergy();
        IntegratorContract.run(kind.create(system), 2000 * h, 2000);
        double after = (system.kineticEnergy() + system.potentialEnergy()) / before;
        return after >= 0 ? after : Double.POSITIVE_INFINITY;
    }

    private static ParticleSystem paperScene(int level) {
        TriangleSurface dome = SphereMeshes.doubleDome(100, 3, level, 0.25);
        return surface(dome.positions().clone(), dome.triangles());
    }

    /**
     * The published step is beyond midpoint Runge-Kutta's limit with the published parameters, on a mesh of like
     * valence.
     */
    @Test
    void publishedStepIsUnstableForMidpointRungeKutta() {
        StabilityLimit limit = StabilityLimit.of(paperScene(5));
        double largest = limit.largestStep(IntegratorKind.RK2);
        assertThat(largest).isBetween(0.0070, 0.0086);
        assertThat(limit.isStable(IntegratorKind.RK2, DT)).isFalse();
        assertThat(limit.isStable(IntegratorKind.VERLET, DT)).isTrue();
        assertThat(limit.describe(IntegratorKind.RK2, DT))
                .contains("0.0100000 s")
                .contains(String.format(java.util.Locale.ROOT, "%.6g s", largest))
                .contains("rk2");
    }

    /** A dome meshed from a scan, 20,909 nodes, without its attachments: ω = 32.717 1/s by a Lanczos iteration. */
    @Test
    void limitOnTheMeasuredDome() throws IOException {
        Path file = Path.of("../shared/bench/dome_20909.obj");
        Assumptions.assumeTrue(Files.exists(file), "needs " + file);
        double[] x = Files.lines(file)
                .filter(line -> line.startsWith("v "))
                .flatMapToDouble(line ->
                        Arrays.stream(line.substring(2).trim().split("\\s+")).mapToDouble(Double::parseDouble))
                .toArray();
        int[] triangles = Files.lines(file)
                .filter(line -> line.startsWith("f "))
                .flatMapToInt(line -> Arrays.stream(line.substring(2).trim().split("\\s+"))
                        .mapToInt(corner -> Integer.parseInt(corner.split("/")[0]) - 1))
                .toArray();
        StabilityLimit limit = StabilityLimit.of(surface(x, triangles));
        assertThat(limit.omegaMax()).isBetween(32.717, 32.717 * MARGIN);
        assertThat(limit.isStable(IntegratorKind.RK2, DT)).isFalse();
    }

    /**
     * 200 s at the published step from a slight shake: midpoint Runge-Kutta blows the shake up, verlet damps it away.
     */
    @Test
    void publishedStepReallyGrows() {
        double[] energy = new double[2];
        IntegratorKind[] kinds = {IntegratorKind.RK2, IntegratorKind.VERLET};
        for (int i = 0; i < 2; i++) {
            ParticleSystem system = paperScene(2);
            Random random = new Random(3);
            Arrays.setAll(system.velocities(), k -> 1e-3 * (2 * random.nextDouble() - 1));
            double before = system.kineticEnergy();
            IntegratorContract.run(kinds[i].create(system), 200, 20_000);
            energy[i] = (system.kineticEnergy() + system.potentialEnergy()) / before;
        }
        assertThat(energy[0]).isGreaterThan(10);
        assertThat(energy[1]).isLessThan(1e-3);
    }

    @Test
    void substepsSplitWhatIsTooLong() {
        StabilityLimit limit = undamped(40);
        assertThat(limit.substeps(IntegratorKind.VERLET, 0.044, 0.9)).isEqualTo(1);
        assertThat(limit.substeps(IntegratorKind.VERLET, 0.046, 0.9)).isEqualTo(2);
        assertThat(limit.substeps(IntegratorKind.VERLET, 0.5, 0.9)).isEqualTo(12);
        assertThat(limit.substeps(IntegratorKind.BACKWARD_EULER, 0.5, 0.9)).isEqualTo(1);
        assertThatThrownBy(() -> limit.substeps(IntegratorKind.RK2, 0.01, 0.9))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("rk2")
                .hasMessageContaining("grows at every step")
                .hasMessageContaining("40");
    }

    /** A spring pulled together to nothing has no direction, hence no K: the bound stands in. */
    @Test
    void stateWithoutStiffnessIsJudgedByTheBound() {
        ParticleSystem system = chain(5);
        System.arraycopy(system.positions(), 3, system.positions(), 6, 3);
        StabilityLimit limit = StabilityLimit.of(system);
        assertThat(limit.omegaMax()).isEqualTo(limit.omegaBound());
        assertThat(limit.largestStep(IntegratorKind.VERLET)).isCloseTo(2 / limit.omegaBound(), within(1e-6));
    }

    /**
     * Backward Euler does not see a wall in its solve: where nodes may lean on one its step is held to ω h of 3
     * (docs/stability.md).
     */
    @Test
    void wallsLimitBackwardEulerAndNoOther() {
        StabilityLimit free = undamped(40);
        StabilityLimit walled = new StabilityLimit(40, 40, 0, 0, 0, true);
        assertThat(free.largestStep(IntegratorKind.BACKWARD_EULER)).isInfinite();
        assertThat(walled.largestStep(IntegratorKind.BACKWARD_EULER)).isCloseTo(3.0 / 40, within(1e-6));
        assertThat(walled.largestStep(IntegratorKind.VERLET)).isEqualTo(free.largestStep(IntegratorKind.VERLET));
        assertThat(StabilityLimit.of(SampleSystems.sheets(5, 5, 1)).contacts()).isTrue();
        assertThat(StabilityLimit.of(chain(5)).contacts()).isFalse();
    }

    @Test
    void systemWithoutForcesHasNoLimit() {
        assertThat(StabilityLimit.of(SampleSystems.oneNode(1)).largestStep(IntegratorKind.RK2))
                .isInfinite();
    }
}
