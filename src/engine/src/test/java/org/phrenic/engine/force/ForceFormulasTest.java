package org.phrenic.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.PrescribedMotion;
import org.phrenic.engine.SampleMotions;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.SphereMeshes;
import org.phrenic.engine.SphereMeshes.TriangleSurface;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** Each field against numbers calculated by hand. */
class ForceFormulasTest {
    private static final double ROUNDING = 1e-12;
    /** Two nodes 5 mm apart along (3, 4, 0). */
    private static final double[] PAIR = {1, 1, 1, 4, 5, 1};

    private static final NodeLayout TWO = NodeLayout.natural(2);

    private static Springs.Builder pair(double rest) {
        return Springs.between(TWO, new int[] {0}, new int[] {1}).stiffness(10).restLengths(new double[] {rest});
    }

    private static double[] forces(ForceField field, double[] x, double[] v) {
        double[] force = new double[x.length];
        field.addForces(x, v, force, 0);
        return force;
    }

    private static void assertForces(double[] found, double... expected) {
        assertThat(found).containsExactly(expected, within(ROUNDING));
    }

    /** Eq. 3: k (l - l0) = 10 (5 - 4) = 10 mN along (0.6, 0.8, 0), pulling together; at l0 = 7, 20 mN apart. */
    @Test
    void springPullsAndPushesAsEquation3() {
        assertForces(forces(pair(4).build(), PAIR, new double[6]), 6, 8, 0, -6, -8, 0);
        assertForces(forces(pair(7).build(), PAIR, new double[6]), -12, -16, 0, 12, 16, 0);
        assertForces(forces(pair(5).build(), PAIR, new double[6]), 0, 0, 0, 0, 0, 0);
        assertThat(pair(4).build().potentialEnergy(PAIR)).isEqualTo(5);
    }

    /**
     * c = 2 and an end that leaves at 3 mm/s along the edge: 6 mN more pull; a motion across the edge costs nothing.
     */
    @Test
    void dashpotActsAlongTheEdgeAlone() {
        Springs springs = pair(5).damping(2).build();
        assertThat(springs.dependsOnVelocity()).isTrue();
        assertForces(forces(springs, PAIR, new double[] {0, 0, 0, 1.8, 2.4, 0}), 3.6, 4.8, 0, -3.6, -4.8, 0);
        assertForces(forces(springs, PAIR, new double[] {0, 0, 0, -0.8, 0.6, 5}), 0, 0, 0, 0, 0, 0);
        assertThat(pair(5).build().dependsOnVelocity()).isFalse();
    }

    /** Activation 0.4, share 0.5: the rest length 5 becomes 4, so 10 mN of pull; with a dashpot as well. */
    @Test
    void activationShortensTheRestLength() {
        for (double c : new double[] {0, 2}) {
            Springs springs =
                    pair(5).contractileShares(new double[] {0.5}).damping(c).build();
            assertForces(forces(springs, PAIR, new double[6]), 0, 0, 0, 0, 0, 0);
            springs.setActivation(0.4);
            assertForces(forces(springs, PAIR, new double[6]), 6, 8, 0, -6, -8, 0);
            assertThat(springs.potentialEnergy(PAIR)).isCloseTo(5, within(ROUNDING));
            assertThat(springs.restLengths()).containsExactly(5);
            springs.setActivation(0);
            assertForces(forces(springs, PAIR, new double[6]), 0, 0, 0, 0, 0, 0);
        }
    }

    @Test
    void springsOfOneBuilderHaveTheirOwnCoefficients() {
        Springs.Builder builder = pair(4).contractileShares(new double[] {0.5});
        Springs first = builder.build();
        Springs second = builder.build();
        first.setCoefficients(new double[] {100}, new double[] {3}, new double[] {0.3});
        assertThat(second.stiffnesses()).containsExactly(10);
        assertThat(second.restLengths()).containsExactly(4);
        assertThat(second.shortenings()).containsExactly(2);
        assertThat(second.potentialEnergy(PAIR)).isEqualTo(5);
        double[] rowSum = new double[2];
        second.addRowSums(PAIR, rowSum, new double[2]);
        assertThat(rowSum).containsOnly(20);
    }

    @Test
    void springsKeepTheEndsTheyWereGiven() {
        int[] a = {0};
        Springs.Builder builder = Springs.between(TWO, a, new int[] {1}).stiffness(10);
        a[0] = 1;
        Springs springs = builder.restLengths(new double[] {4}).build();
        assertThat(springs.callerPairs(TWO)).containsExactly(0, 1);
    }

    /** A spring without length at rest pulls its ends together, and leaves them alone where they are in one place. */
    @Test
    void endsOfASpringWithoutLengthMayCoincide() {
        for (double c : new double[] {0, 2}) {
            for (boolean contractile : new boolean[] {false, true}) {
                Springs.Builder builder = pair(0).damping(c);
                Springs springs = (contractile ? builder.contractileShares(new double[] {1}) : builder).build();
                springs.setActivation(0.4);
                assertForces(forces(springs, PAIR, new double[6]), 30, 40, 0, -30, -40, 0);
                double[] one = {1, 2, 3, 1, 2, 3};
                assertForces(forces(springs, one, new double[] {1, 0, 0, 0, 2, 0}), 0, 0, 0, 0, 0, 0);
                double[] out = new double[6];
                springs.addStiffness(one, new double[] {1, 0, 0, 0, 2, 0}, out, 0);
                assertForces(out, 10, -20, 0, -10, 20, 0);
            }
        }
        Springs changed = pair(4).build();
        changed.setCoefficients(new double[] {10}, new double[] {0}, null);
        assertForces(forces(changed, new double[6], new double[6]), 0, 0, 0, 0, 0, 0);
    }

    /** 1 mm up against a spring of 1 N/m and with 5 mN: 0.5 - 5 µJ. */
    @Test
    void energyOfAttachmentsHoldsTheirConstantForce() {
        NodeLayout layout = NodeLayout.natural(1);
        Attachments springs =
                new Attachments(layout, new int[] {0}, new double[] {1}, 0, PrescribedMotion.stationary(new double[3]));
        springs.setCoefficients(new double[] {1}, new double[] {0, 0, 5});
        assertThat(springs.potentialEnergy(new double[] {0, 0, 1}) - springs.potentialEnergy(new double[3]))
                .isCloseTo(-4.5, within(ROUNDING));
    }

    /**
     * Pressure on a closed surface adds up to nothing, and pushes each node of a sphere straight inward with p A / n on
     * average.
     */
    @Test
    void pressureOnAClosedSurfaceHasNoResultant() {
        double radius = 50;
        TriangleSurface sphere = SphereMeshes.sphere(radius, 3);
        int n = sphere.vertexCount();
        NodeLayout layout = NodeLayout.natural(n);
        FacePressure pressure =
                new FacePressure(layout, sphere.triangles(), SampleSystems.masses(sphere.triangleCount(), 1));
        pressure.setPressure(0.8);
        double[] force = forces(pressure, sphere.positions(), new double[3 * n]);
        double[] sum = new double[3];
        double inward = 0;
        for (int i = 0; i < n; i++) {
            double radial = 0;
            double squared = 0;
            for (int axis = 0; axis < 3; axis++) {
                double f = force[3 * i + axis];
                sum[axis] += f;
                radial += f * sphere.positions()[3 * i + axis] / radius;
                squared += f * f;
            }
            // Straight inward within the angle that a corner of the faceted sphere makes.
            assertThat(-radial / Math.sqrt(squared)).isGreaterThan(0.99);
            inward -= radial;
        }
        assertThat(sum).containsExactly(new double[3], within(1e-9));
        // p times 4 π r², less what the facets cut off.
        assertThat(inward).isCloseTo(0.8 * 4 * Math.PI * radius * radius, within(0.03 * inward));
    }

    /**
     * On a surface of many blocks in Morton order: each triangle and each edge by itself, summed in the caller's order.
     */
    @Test
    void manyBlocksAddUpToTheSumOverTrianglesAndEdges() {
        TriangleSurface sphere = SphereMeshes.sphere(50, 5);
        double[] x = sphere.positions();
        int n = sphere.vertexCount();
        NodeLayout layout = NodeLayout.morton(x);
        assertThat(layout.blockCount()).isGreaterThan(6);
        double[] v = new Random(2).doubles(3 * n, -5, 5).toArray();
        double[] weight =
                new Random(3).doubles(sphere.triangleCount(), 0.5, 1.5).toArray();
        double[] more = new Random(5).doubles(sphere.triangleCount(), -1, 1).toArray();
        FacePressure pressure = new FacePressure(layout, sphere.triangles(), weight, more);
        pressure.setPressure(0.3);
        assertSum(pressure, layout, x, v, pressureForces(sphere, 0.3, weight, 0, more));
        pressure.setSecondaryPressure(0.2);
        assertSum(pressure, layout, x, v, pressureForces(sphere, 0.3, weight, 0.2, more));
        pressure.setPressure(0);
        assertSum(pressure, layout, x, v, pressureForces(sphere, 0, weight, 0.2, more));
        int[][] edges = SampleSystems.edgesOf(sphere.triangles());
        double[] rest = new Random(4).doubles(edges[0].length, 0.5, 3).toArray();
        for (double c : new double[] {0, 0.4}) {
            for (double activation : new double[] {0, 0.25}) {
                Springs springs = Springs.between(layout, edges[0], edges[1])
                        .stiffness(7)
                        .restLengths(rest)
                        .contractileShares(rest)
                        .damping(c)
                        .build();
                springs.setActivation(activation);
                assertSum(springs, layout, x, v, springForces(edges, x, v, rest, c, activation));
            }
        }
    }

    /** A third of pressure times area on each corner, inward, triangle by triangle. */
    private static double[] pressureForces(
            TriangleSurface sphere, double p1, double[] weight, double p2, double[] more) {
        double[] x = sphere.positions();
        double[] expected = new double[x.length];
        for (int t = 0; t < sphere.triangleCount(); t++) {
            int[] corner = Arrays.copyOfRange(sphere.triangles(), 3 * t, 3 * t + 3);
            for (int axis = 0; axis < 3; axis++) {
                int p = (axis + 1) % 3;
                int q = (axis + 2) % 3;
                double doubleArea = (x[3 * corner[1] + p] - x[3 * corner[0] + p])
                                * (x[3 * corner[2] + q] - x[3 * corner[0] + q])
                        - (x[3 * corner[1] + q] - x[3 * corner[0] + q]) * (x[3 * corner[2] + p] - x[3 * corner[0] + p]);
                for (int c : corner) {
                    expected[3 * c + axis] -= (p1 * weight[t] + p2 * more[t]) * doubleArea / 6;
                }
            }
        }
        return expected;
    }

    /** Eq. 3 edge by edge, the share of each edge being as large as its rest length. */
    private static double[] springForces(
            int[][] edges, double[] x, double[] v, double[] rest, double c, double activation) {
        double[] force = new double[x.length];
        for (int e = 0; e < rest.length; e++) {
            int a = 3 * edges[0][e];
            int b = 3 * edges[1][e];
            double[] d = {x[b] - x[a], x[b + 1] - x[a + 1], x[b + 2] - x[a + 2]};
            double l = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            double rate = 0;
            for (int axis = 0; axis < 3; axis++) {
                rate += (v[b + axis] - v[a + axis]) * d[axis] / l;
            }
            double pull = 7 * (l - rest[e] * (1 - activation * rest[e])) + c * rate;
            for (int axis = 0; axis < 3; axis++) {
                force[a + axis] += pull * d[axis] / l;
                force[b + axis] -= pull * d[axis] / l;
            }
        }
        return force;
    }

    private static void assertSum(ForceField field, NodeLayout layout, double[] x, double[] v, double[] expected) {
        double[] force = new double[x.length];
        for (int block = 0; block < layout.blockCount(); block++) {
            field.addForces(layout.toInternal(x), layout.toInternal(v), force, block);
        }
        double[] found = new double[x.length];
        layout.toCaller(force, found);
        double off = 0;
        for (int i = 0; i < found.length; i++) {
            off = Math.max(off, Math.abs(found[i] - expected[i]));
        }
        assertThat(off).isLessThan(1e-10);
    }

    /** A sheet of 12 mm x 9 mm at 0.5 kPa with weights 2: 108 mN down on the face that is seen from above. */
    @Test
    void pressureOnAPlanePatchIsPressureTimesArea() {
        double[] x = new double[3 * 20];
        for (int i = 0; i < 20; i++) {
            x[3 * i] = 3 * (i % 5);
            x[3 * i + 1] = 3 * (i / 5);
        }
        int[] triangles = SampleSystems.sheetTriangles(5, 4);
        FacePressure pressure =
                new FacePressure(NodeLayout.natural(20), triangles, SampleSystems.masses(triangles.length / 3, 2));
        assertThat(forces(pressure, x, x)).containsOnly(0);
        pressure.setPressure(0.5);
        double[] force = forces(pressure, x, x);
        double sum = 0;
        for (int i = 0; i < 60; i++) {
            sum += i % 3 == 2 ? force[i] : 0;
            assertThat(i % 3 == 2 || force[i] == 0).isTrue();
        }
        assertThat(sum).isCloseTo(-108, within(1e-10));
    }

    /**
     * The profile (1 - q²)²: 1 and level at the centre, 9/16 at half the radius, 0 and level at the radius and beyond.
     */
    @Test
    void fallOffIsSmooth() {
        assertThat(FallOff.at(0, 20)).isEqualTo(1);
        assertThat(FallOff.at(10, 20)).isEqualTo(9.0 / 16);
        assertThat(FallOff.at(20, 20)).isZero();
        assertThat(FallOff.at(30, 20)).isZero();
        double e = 1e-4;
        assertThat(FallOff.at(e, 20)).isCloseTo(1, within(1e-9));
        assertThat(FallOff.at(20 - e, 20)).isCloseTo(0, within(1e-9));
        double before = 0;
        for (int i = 0; i <= 3000; i++) {
            double slope = (FallOff.at(0.01 * i + e, 20) - FallOff.at(0.01 * i, 20)) / e;
            // The slope's own slope is at most 8/r² = 0.02 a mm².
            assertThat(slope).isCloseTo(before, within(0.02 * 0.0102));
            before = slope;
        }
    }

    /** Line at (10, 0), radius 8: nodes on it, 4 mm off, and outside; 3 mN down x (1, 9/16, 0). */
    @Test
    void actionLinePullsDownWithinItsRadius() {
        double[] x = {10, 0, 5, 10, 4, -70, 18, 0, 0, 10, 1, 0};
        ActionLine line = new ActionLine(NodeLayout.natural(4), new int[] {0, 1, 2}, x, 10, 0, 8);
        line.setForce(3);
        assertForces(forces(line, x, x), 0, 0, -3, 0, 0, -27.0 / 16, 0, 0, 0, 0, 0, 0);
        line.setForce(-3);
        assertThat(forces(line, x, x)[2]).isEqualTo(3);
        // The profile belongs to the tissue: it moves with it.
        double[] shifted = x.clone();
        shifted[0] += 100;
        assertThat(forces(line, shifted, x)[2]).isEqualTo(3);
    }

    /** F = -k (x - a) - c (v - a'): k = 4, factor 0.5, c = 0.1 k. */
    @Test
    void attachmentPullsTowardItsAnchor() {
        Attachments attachments = new Attachments(
                TWO, new int[] {1}, new double[] {4}, 0.1, SampleMotions.swinging(new double[] {4, 5, 0}, 0, 2, 3));
        attachments.setStiffnessFactor(0.5);
        attachments.prepare(0);
        double[] v = {0, 0, 0, 1, 0, 0};
        // Anchor at (4, 5, 0) with 6 mm/s along x: spring (0, 0, -2), dashpot 0.2 (6 - 1).
        assertForces(forces(attachments, PAIR, v), 0, 0, 0, 1, 0, -2);
        assertThat(attachments.potentialEnergy(PAIR)).isEqualTo(1);
    }

    /**
     * Nodes of a string whose attachments fade out smoothly follow a slow anchor by as much as they are held, without a
     * step between neighbours.
     */
    @Test
    void attachedNodesFollowTheirAnchorsSmoothly() {
        int n = 21;
        double[] x = new double[3 * n];
        double[] k = new double[n];
        int[] nodes = new int[n];
        int[] a = new int[n - 1];
        int[] b = new int[n - 1];
        for (int i = 0; i < n; i++) {
            x[3 * i] = i;
            nodes[i] = i;
            k[i] = 40 * FallOff.at(i, 12);
            if (i > 0) {
                a[i - 1] = i - 1;
                b[i - 1] = i;
            }
        }
        NodeLayout layout = NodeLayout.natural(n);
        ParticleSystem system = new ParticleSystem(layout, x, SampleSystems.masses(n, 0.01), Workers.of(1));
        double[] stretched = new double[n - 1];
        Arrays.fill(stretched, 0.5);
        system.add(Springs.between(layout, a, b)
                .stiffness(15)
                .restLengths(stretched)
                .build());
        system.add(new Attachments(layout, nodes, k, 0, SampleMotions.swinging(x, 1, 2, Math.PI / 2)));
        system.setViscosity(0.3);
        system.fix(n - 1);
        Integrator integrator = IntegratorKind.VERLET.create(system);
        for (int i = 0; i < 1000; i++) {
            integrator.step(i * 0.001, 0.001);
        }
        double[] y = new double[n];
        for (int i = 0; i < n; i++) {
            y[i] = system.positions()[3 * i + 1];
        }
        assertThat(y[0]).isCloseTo(2, within(0.05));
        for (int i = 1; i < n; i++) {
            assertThat(y[i - 1] - y[i]).as("node %s", i).isBetween(-0.01, 0.35);
        }
        assertThat(y[n - 1]).isZero();
    }
}
