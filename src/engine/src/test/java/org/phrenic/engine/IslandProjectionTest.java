package org.phrenic.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.constraint.NonInversionPairs;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Constraints put right group by group end where all of them, gone through one after the other in every sweep, end: bit
 * by bit.
 */
class IslandProjectionTest {
    private static final int PAIRS = 700;
    private static final double H = 0.01;
    private static final ContactSurface FLOOR = (node, x, y, z, plane, at) -> {
        plane[at] = 0;
        plane[at + 1] = 0;
        plane[at + 2] = 1;
        plane[at + 3] = 0;
        plane[at + 4] = 0;
    };

    /**
     * Positions and velocities after some steps of a crumpled double layer over a floor: links in a third of its pairs,
     * an order in the others, the floor under all.
     */
    private static double[] crumpled(int threads, int sweeps, UnaryOperator<Constraint> how) {
        Random random = new Random(7);
        double[] rest = new double[6 * PAIRS];
        for (int i = 0; i < PAIRS; i++) {
            rest[6 * i] = rest[6 * i + 3] = random.nextDouble() * 100;
            rest[6 * i + 1] = rest[6 * i + 4] = random.nextDouble() * 100;
            rest[6 * i + 2] = 2;
            rest[6 * i + 5] = 0.5;
        }
        double[] masses = new double[2 * PAIRS];
        Arrays.setAll(masses, i -> 1 + random.nextDouble());
        NodeLayout layout = NodeLayout.morton(rest);
        try (Workers workers = Workers.of(threads)) {
            ParticleSystem system = new ParticleSystem(layout, rest, masses, workers);
            int linked = PAIRS / 3;
            int[] upper = IntStream.range(0, PAIRS).map(i -> 2 * i).toArray();
            int[] lower = IntStream.range(0, PAIRS).map(i -> 2 * i + 1).toArray();
            system.add(how.apply(RigidLinks.gaussSeidel(
                    layout, Arrays.copyOf(upper, linked), Arrays.copyOf(lower, linked), rest, 1e-9, 10)));
            int[] outer = Arrays.copyOfRange(upper, linked, PAIRS);
            int[] inner = Arrays.copyOfRange(lower, linked, PAIRS);
            int[][] ring = new int[outer.length][];
            Arrays.setAll(ring, i -> IntStream.range(i, i + 3)
                    .map(k -> outer[k % outer.length])
                    .toArray());
            double[] least = new double[outer.length];
            Arrays.fill(least, 0.3);
            system.add(how.apply(new NonInversionPairs(layout, outer, inner, ring, least, 0)));
            system.add(how.apply(
                    new SlidingContact(layout, IntStream.range(0, 2 * PAIRS).toArray(), FLOOR, 0)));
            system.setProjectionSweeps(sweeps);
            for (int step = 1; step <= 5; step++) {
                double[] x = system.positions();
                for (int i = 0; i < x.length; i++) {
                    x[i] += 0.6 * random.nextGaussian();
                }
                system.project(H * step, H);
            }
            double[] state = Arrays.copyOf(system.positions(), 2 * rest.length);
            System.arraycopy(system.velocities(), 0, state, rest.length, rest.length);
            return state;
        }
    }

    @Test
    void endsWhereAllInTurnEnd() {
        for (int sweeps : new int[] {1, 2, 3, 6}) {
            assertThat(crumpled(1, sweeps, each -> each))
                    .as("%d sweeps", sweeps)
                    .containsExactly(crumpled(1, sweeps, each -> new InTurn((SeparableConstraint) each)));
        }
    }

    @Test
    void theNumberOfThreadsDoesNotMatter() {
        double[] one = crumpled(1, 3, each -> each);
        assertThat(crumpled(2, 3, each -> each)).containsExactly(one);
        assertThat(crumpled(3, 3, each -> each)).containsExactly(one);
    }

    @Test
    void whatHeldInTheFirstSweepIsLeftOutOfTheOthers() {
        double[] rest = new double[30];
        for (int i = 0; i < 10; i++) {
            rest[3 * i] = i;
        }
        NodeLayout layout = NodeLayout.natural(10);
        try (Workers workers = Workers.of(1)) {
            double[] masses = new double[10];
            Arrays.fill(masses, 1);
            ParticleSystem system = new ParticleSystem(layout, rest, masses, workers);
            // Nodes 0-1, 2-3 ... are pairs; only that of nodes 4 and 5 moves something.
            Counted first = new Counted(new int[] {0, 6, 12, 18, 24}, new int[] {3, 9, 15, 21, 27}, 12);
            Counted second = new Counted(new int[] {0, 12, 24}, new int[] {0, 12, 24}, -1);
            system.add(first);
            system.add(second);
            system.setProjectionSweeps(4);
            system.project(H, H);
            assertThat(first.asked).containsExactly(1, 1, 4, 1, 1);
            assertThat(second.asked).containsExactly(1, 4, 1);
        }
    }

    @Test
    void longChainsArePutRightInTurn() {
        int n = 200;
        assertThat(IslandProjection.of(List.of(new Chain(n, 0), new Chain(n, 1)), n))
                .isEmpty();
        assertThat(IslandProjection.of(List.of(new Chain(n, 0)), n)).isPresent();
    }

    /** The same constraint as one that is put right as a whole. */
    private record InTurn(SeparableConstraint inner, int[] all, int[] moved) implements CoupledConstraint {
        InTurn(SeparableConstraint inner) {
            this(
                    inner,
                    IntStream.range(0, inner.itemNodes()[0].length).toArray(),
                    new int[inner.itemNodes()[0].length]);
        }

        @Override
        public void prepare(ParticleSystem system, double time) {
            inner.prepare(system, time);
        }

        @Override
        public void project(ParticleSystem system, double h) {
            inner.project(system, h, all, 0, all.length, moved);
        }

        @Override
        public double error(ParticleSystem system) {
            return inner.error(system);
        }
    }

    /** Every second pair of neighbours in a row of nodes. */
    private record Chain(int length, int first) implements SeparableConstraint {
        @Override
        public int[][] itemNodes() {
            int[] from = IntStream.range(0, (length - first) / 2)
                    .map(i -> 3 * (2 * i + first))
                    .toArray();
            return new int[][] {
                from,
                Arrays.stream(from).map(i -> Math.min(i + 3, 3 * length - 3)).toArray()
            };
        }

        @Override
        public int project(ParticleSystem system, double h, int[] items, int from, int to, int[] moved) {
            return 0;
        }

        @Override
        public double error(ParticleSystem system) {
            return 0;
        }
    }

    /** Counts how often each item is asked for; one of them says that it moved. */
    private static final class Counted implements SeparableConstraint {
        final int[] asked;
        private final int[] a;
        private final int[] b;
        private final int moving;

        Counted(int[] a, int[] b, int moving) {
            this.a = a;
            this.b = b;
            this.moving = moving;
            asked = new int[a.length];
        }

        @Override
        public int[][] itemNodes() {
            return new int[][] {a, b};
        }

        @Override
        public int project(ParticleSystem system, double h, int[] items, int from, int to, int[] moved) {
            int end = from;
            for (int k = from; k < to; k++) {
                asked[items[k]]++;
                if (a[items[k]] == moving) {
                    moved[end++] = items[k];
                }
            }
            return end - from;
        }

        @Override
        public double error(ParticleSystem system) {
            return 0;
        }
    }
}
