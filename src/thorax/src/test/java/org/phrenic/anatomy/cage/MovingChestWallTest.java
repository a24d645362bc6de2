package org.phrenic.anatomy.cage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SurfaceSamples;

/** A cylinder of 110 mm radius in the rib cage of the virtual adult male stands for lungs and diaphragm. */
class MovingChestWallTest {
    private static final double RADIUS_MM = 110;
    private static final double GRID_MM = 1;

    private static RibCage cage;
    private static SkinningWeights bones;
    private static double low;
    private static MovingChestWall wall;

    @BeforeAll
    static void make() throws IOException {
        Thorax male = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        cage = RibCage.of(male, RibAxisTable.preset(RibAxisTable.WILSON_CT), true);
        bones = SkinningWeights.of(male, cage);
        low = male.find("rib_09_R").orElseThrow().mesh().bounds()[2];
        wall = aboutACylinder();
    }

    /** Carried by ribs whose amplitude is the time in seconds. */
    private static MovingChestWall aboutACylinder() {
        double[] contents = new double[3 * 200 * 60];
        int c = 0;
        for (int i = 0; i < 200; i++) {
            for (int j = 0; j < 60; j++) {
                contents[c++] = RADIUS_MM * Math.cos(2 * Math.PI * i / 200);
                contents[c++] = RADIUS_MM * Math.sin(2 * Math.PI * i / 200);
                contents[c++] = low + 3 * j;
            }
        }
        return new MovingChestWall(
                contents,
                0,
                0,
                bones,
                new RibCagePose(cage, (t, out) -> {
                    out[0] = t;
                    out[1] = 1;
                }),
                Workers.of(1));
    }

    private static double[] plane(ContactSurface surface, double time, double x, double y, double z) {
        double[] plane = new double[5];
        surface.prepare(time);
        surface.tangentPlane(0, x, y, z, plane, 0);
        return plane;
    }

    @Test
    void depthIsPositiveInsideAndNegativeOutside() {
        for (int turn = 0; turn < 12; turn++) {
            double cos = Math.cos(turn * Math.PI / 6);
            double sin = Math.sin(turn * Math.PI / 6);
            assertThat(wall.depth(90 * cos, 90 * sin, low + 60)).isCloseTo(20, within(GRID_MM));
            assertThat(wall.depth(118 * cos, 118 * sin, low + 60)).isCloseTo(-8, within(GRID_MM));
            assertThat(wall.outwardComponent(90 * cos, 90 * sin, cos, sin)).isCloseTo(1, within(1e-9));
            assertThat(wall.outwardComponent(90 * cos, 90 * sin, -sin, cos)).isCloseTo(0, within(1e-9));
        }
    }

    @Test
    void planesLookInwardAndNodesInsideLieOnTheirAllowedSide() {
        for (int turn = 0; turn < 24; turn++) {
            double x = 100 * Math.cos(turn * Math.PI / 12);
            double y = 100 * Math.sin(turn * Math.PI / 12);
            double z = low + 70;
            double[] p = plane(wall.limitingContact(new double[] {x, y, z}, new double[1]), 0, x, y, z);
            assertThat(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).isCloseTo(1, within(1e-12));
            assertThat((p[0] * x + p[1] * y) / 100).as("inward").isLessThan(-0.95);
            double gap = p[0] * x + p[1] * y + p[2] * z - p[3];
            assertThat(gap).isCloseTo(10, within(GRID_MM));
        }
    }

    @Test
    void aNodeBeyondTheEnvelopeAtRestIsNotPushedIn() {
        double[] node = {114, 0, low + 70};
        double[] p = plane(wall.limitingContact(node, new double[1]), 0, node[0], node[1], node[2]);
        assertThat(p[0] * node[0] + p[1] * node[1] + p[2] * node[2] - p[3]).isCloseTo(0, within(1e-6));
    }

    @Test
    void aNodeOfTheFaceBehindIsStoppedThatMuchFartherIn() {
        double[] node = {0, 100, low + 70};
        double inset = 2;
        double[] p = plane(wall.limitingContact(node, new double[] {inset}), 0, node[0], node[1], node[2]);
        assertThat(gap(p, node)).isCloseTo(10 - inset, within(GRID_MM));
    }

    @Test
    void anAdheringNodeKeepsItsDistanceWhateverItIs() {
        for (double r : new double[] {104, 110, 113}) {
            double[] node = {0, -r, low + 70};
            double[] p = plane(wall.slidingContact(node), 0, node[0], node[1], node[2]);
            assertThat(p[0] * node[0] + p[1] * node[1] + p[2] * node[2] - p[3]).isCloseTo(0, within(1e-6));
        }
    }

    /**
     * The lateral wall goes out by the bucket handle, the front by the pump handle (physiology A1): 4 to 10 mm at full
     * inspiration.
     */
    @Test
    void theWallGoesOutWithTheRibs() {
        for (double[] side : List.of(new double[] {-100, 0}, new double[] {100, 0}, new double[] {0, -100})) {
            double[] node = {side[0], side[1], low + 70};
            ContactSurface felt = wall.limitingContact(node, new double[1]);
            double[] before = plane(felt, 0, node[0], node[1], node[2]);
            double[] after = plane(felt, 1, node[0], node[1], node[2]);
            double growth = gap(after, node) - gap(before, node);
            assertThat(growth).as("at " + side[0] + ", " + side[1]).isBetween(1.0, 25.0);
            assertThat(before[4]).as("the wall recedes from the node").isNegative();
        }
    }

    private static double gap(double[] p, double[] x) {
        return p[0] * x[0] + p[1] * x[1] + p[2] * x[2] - p[3];
    }

    @Test
    void theWallsSpeedIsThatOfItsPlane() {
        double[] node = {-100, 10, low + 60};
        ContactSurface felt = wall.limitingContact(node, new double[1]);
        double h = 1e-3;
        double[] at = plane(felt, 0.3, node[0], node[1], node[2]);
        double rate = (gap(plane(felt, 0.3 - h, node[0], node[1], node[2]), node)
                        - gap(plane(felt, 0.3 + h, node[0], node[1], node[2]), node))
                / (2 * h);
        // The gap also changes as the wall slides along the node; on a cylinder that is little.
        assertThat(at[4]).isCloseTo(rate, within(0.15 * Math.abs(rate) + 0.5));
    }

    /**
     * A lung that slides down a wall that the ribs have carried away must not be shaken as it comes from cell to cell.
     */
    @Test
    void theWallChangesSmoothlyFromPlaceToPlaceWhileItIsCarried() {
        double step = 0.2;
        double[] start = {-100, 20, low + 40};
        ContactSurface felt = wall.slidingContact(start);
        double before = Double.NaN;
        for (int i = 0; i < 300; i++) {
            double[] x = {start[0] + 0.5 * step * i, start[1] - 0.3 * step * i, start[2] + 0.3 * step * i};
            double r = Math.hypot(x[0], x[1]);
            x[0] *= 100 / r;
            x[1] *= 100 / r;
            double gap = gap(plane(felt, 1, x[0], x[1], x[2]), x);
            if (i > 0) {
                assertThat(Math.abs(gap - before)).as("at place %d", i).isLessThan(0.3 * step);
            }
            before = gap;
        }
    }

    /** The outer one of two surfaces is the wall wherever both are, however coarse its triangles. */
    @Test
    void noCellTakesWhatLiesBehindForTheWall() {
        SurfaceSamples samples = new SurfaceSamples(MovingChestWall.MAX_SPACING_MM);
        samples.add(cylinder(RADIUS_MM, 24));
        samples.add(cylinder(70, 200));
        MovingChestWall coarse = new MovingChestWall(
                samples.points(), 0, 0, bones, new RibCagePose(cage, (t, out) -> {}), Workers.of(1));
        // A chord of a 24th of the circle lies up to 0.94 mm inside it.
        double inside = RADIUS_MM * (1 - Math.cos(Math.PI / 24));
        for (int turn = 0; turn < 360; turn++) {
            double cos = Math.cos(Math.toRadians(turn));
            double sin = Math.sin(Math.toRadians(turn));
            for (int up = 10; up < 110; up++) {
                assertThat(coarse.depth(100 * cos, 100 * sin, low + up)).isBetween(10 - inside - GRID_MM, 10 + GRID_MM);
            }
        }
    }

    private static TriangleMesh cylinder(double radius, int sides) {
        double[] p = new double[6 * sides];
        int[] t = new int[6 * sides];
        for (int i = 0; i < sides; i++) {
            for (int end = 0; end < 2; end++) {
                int v = 3 * (2 * i + end);
                p[v] = radius * Math.cos(2 * Math.PI * i / sides);
                p[v + 1] = radius * Math.sin(2 * Math.PI * i / sides);
                p[v + 2] = low + 120 * end;
            }
            int a = 2 * i;
            int b = 2 * ((i + 1) % sides);
            System.arraycopy(new int[] {a, b, a + 1, b, b + 1, a + 1}, 0, t, 6 * i, 6);
        }
        return new TriangleMesh(p, t);
    }
}
