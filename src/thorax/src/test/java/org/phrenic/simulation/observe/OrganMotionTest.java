package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;

class OrganMotionTest {
    /** A plane sheet of 200 x 200 mm at z = 0, points 10 mm apart. */
    private static double[] sheet(double z) {
        double[] p = new double[3 * 441];
        for (int i = 0; i < 441; i++) {
            p[3 * i] = 10 * (i % 21) - 100;
            p[3 * i + 1] = 10 * (i / 21) - 100;
            p[3 * i + 2] = z;
        }
        return p;
    }

    private static double[] moved(double[] organ, double[] sheetNow) {
        OrganCarriers carriers = new OrganCarriers(24);
        int sheet = carriers.addMoving(sheet(0), v -> true);
        OrganMotion motion = new OrganMotion(organ, carriers, OrganMotion.Hold.SLIDING);
        carriers.update(sheet, sheetNow);
        return motion.now();
    }

    @Test
    void anOrganUnderTheSheetGoesDownWithItAndThePelvisStands() {
        double[] organ = {0, 0, -5, 0, 0, -60, 0, 0, -150, 0, 0, -260};
        assertThat(moved(organ, sheet(0))).containsExactly(organ);
        double[] now = moved(organ, sheet(-15));
        assertThat(now[2]).isCloseTo(-20, within(1e-5));
        assertThat(now[5]).isBetween(-75.0, -70.0);
        assertThat(now[8]).isBetween(-164.0, -151.0);
        assertThat(now[11]).isEqualTo(-260);
        assertThat(now[0]).isZero();
    }

    @Test
    void aPointFollowsThePartOfTheSheetThatIsNear() {
        double[] organ = {-80, 0, -10, 80, 0, -10};
        double[] tilted = sheet(0);
        for (int i = 0; i < tilted.length; i += 3) {
            tilted[i + 2] = 0.1 * tilted[i];
        }
        double[] now = moved(organ, tilted);
        assertThat(now[2]).isCloseTo(-18, within(0.5));
        assertThat(now[5]).isCloseTo(-2, within(0.5));
    }

    @Test
    void anOrganThatSlidesAlongAPlateGoesDownButStaysBesideItAndAFixedOneStays() {
        OrganCarriers carriers = new OrganCarriers(24);
        int sheet = carriers.addMoving(sheet(0), v -> true);
        carriers.addStill(sheet(-60), 2000);
        double[] organ = new double[3 * 60];
        for (int i = 0; i < 60; i++) {
            organ[3 * i + 2] = -i;
        }
        OrganMotion sliding = new OrganMotion(organ, carriers, OrganMotion.Hold.SLIDING);
        OrganMotion fixed = new OrganMotion(organ, carriers, OrganMotion.Hold.FIXED);
        double[] moved = sheet(-20);
        for (int i = 0; i < moved.length; i += 3) {
            moved[i + 1] -= 10;
        }
        carriers.update(sheet, moved);
        double[] slid = sliding.now();
        assertThat(slid[1]).isCloseTo(-10, within(1e-4));
        assertThat(slid[3 * 59 + 1]).isCloseTo(0, within(0.01));
        assertThat(slid[3 * 59 + 2]).isLessThan(-59 - 15);
        double[] held = fixed.now();
        for (int i = 1; i < 60; i++) {
            assertThat(held[3 * i + 2]).isLessThan(held[3 * i - 1]).isGreaterThan(-60);
        }
    }

    /** A ball between two sheets of which the lower one goes down: carried, it is half as large again. */
    @Test
    void anOrganThatKeepsItsVolumeStaysWithinWhereItIsCarriedAndOnItsLowerPart() {
        TriangleMesh ball = Shapes.sphere(30, 3);
        OrganCarriers carriers = new OrganCarriers(24);
        int floor = carriers.addMoving(sheet(-35), v -> true);
        carriers.addMoving(sheet(35), v -> true);
        OrganMotion carried = new OrganMotion(ball.positions(), carriers, OrganMotion.Hold.SLIDING);
        OrganMotion keeping = new OrganMotion(ball.positions(), carriers, OrganMotion.Hold.SLIDING).keepingVolume(ball);
        carriers.update(floor, sheet(-75));
        TriangleMesh large = ball.withPositions(carried.now().clone());
        TriangleMesh kept = ball.withPositions(keeping.now().clone());
        double volume = MeshMeasure.signedVolume(ball);
        assertThat(MeshMeasure.signedVolume(large)).isGreaterThan(1.4 * volume);
        assertThat(MeshMeasure.signedVolume(kept)).isCloseTo(volume, within(1e-6 * volume));
        TriangleTree outside = new TriangleTree(large);
        for (int v = 0; v < kept.vertexCount(); v++) {
            assertThat(outside.isInside(kept.x(v), kept.y(v), kept.z(v))).isTrue();
        }
        assertThat(kept.bounds()[2] - large.bounds()[2]).as("it goes down").isBetween(0.0, 6.0);
        assertThat(large.bounds()[5] - kept.bounds()[5]).isGreaterThan(8);
        carriers.update(floor, sheet(-25));
        assertThat(keeping.now()).as("not enlarged").isEqualTo(carried.now());
    }
}
