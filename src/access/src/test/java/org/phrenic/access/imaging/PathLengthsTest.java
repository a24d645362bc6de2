package org.phrenic.access.imaging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/** Lengths of rays inside bodies that are known in closed form, or summed triangle by triangle. */
class PathLengthsTest {
    private static final double[] ORIGIN = {0, 0, 0};

    private static CArm arm(double leftOblique, double cranial) {
        return new CArm(ORIGIN, leftOblique, cranial, 1000, 700, new CArm.Detector(300, 96, 80));
    }

    private static double[] lengths(TriangleMesh mesh, CArm arm, int threads) {
        PathLengths lengths = new PathLengths(arm, threads);
        lengths.add(mesh, 1);
        return lengths.values();
    }

    private static TriangleMesh moved(TriangleMesh mesh, double x, double y, double z) {
        double[] p = mesh.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] += x;
            p[i + 1] += y;
            p[i + 2] += z;
        }
        return mesh.withPositions(p);
    }

    /** A ray at an angle to the axis passes a slab of thickness d on d / cos(angle). */
    @Test
    void slabIsPassedOnItsThicknessOverTheCosine() {
        CArm arm = arm(0, 0);
        double[] lengths = lengths(moved(Shapes.box(1000, 40, 1000), -500, -10, -500), arm, 1);
        for (int row = 0; row < arm.rows(); row++) {
            for (int column = 0; column < arm.columns(); column++) {
                double expected = 40 * Vectors.length(arm.ray(column, row)) / arm.sourceDetectorMm();
                double found = lengths[row * arm.columns() + column];
                assertThat(found).isCloseTo(expected, within(1e-9));
                assertThat(Math.exp(-0.02 * found)).isCloseTo(Math.exp(-0.02 * expected), within(1e-9));
            }
        }
    }

    /** Chord of a ray in a sphere. The inscribed mesh of edges 1.2 mm lies up to 0.004 mm inside. */
    @Test
    void sphereIsPassedOnItsChord() {
        CArm arm = arm(25, -15);
        double[] centre = {12, -7, 9};
        double[] lengths = lengths(moved(Shapes.sphere(60, 6), centre[0], centre[1], centre[2]), arm, 2);
        int inside = 0;
        for (int row = 0; row < arm.rows(); row++) {
            for (int column = 0; column < arm.columns(); column++) {
                double off = Vectors.distanceToLine(centre, arm.source(), Vectors.normalize(arm.ray(column, row)));
                double chord = off < 60 ? 2 * Math.sqrt(60 * 60 - off * off) : 0;
                if (off < 59) {
                    assertThat(lengths[row * arm.columns() + column]).isCloseTo(chord, within(0.05));
                    inside++;
                } else if (off > 60) {
                    assertThat(lengths[row * arm.columns() + column]).isCloseTo(0, within(1e-9));
                }
            }
        }
        assertThat(inside).isGreaterThan(1000);
    }

    /**
     * Beer-Lambert through a ball of water of 60 mm, rays within 0.8 of its radius. The transmission is exact for the
     * polyhedron; its distance from the ball's is the sagitta of the faces, of order 2: a quarter at half the edges.
     */
    @Test
    void transmissionOfTheSphereConvergesWithTheSquareOfTheEdges() {
        double coarse = worstTransmission(60, 4);
        double middle = worstTransmission(60, 5);
        double fine = worstTransmission(60, 6);
        assertThat(coarse / middle).isBetween(3.6, 4.4);
        assertThat(middle / fine).isBetween(3.6, 4.4);
        assertThat(fine).isLessThan(1e-4);
    }

    /** A ball 6 mm wide on a mesh of edges 0.03 mm: lengths wrong by 5e-5 of themselves would be off by 6e-6. */
    @Test
    void transmissionOfAFineSphereIsThatOfBeerAndLambertWithinFourMillionths() {
        assertThat(worstTransmission(3, 7)).isLessThan(4e-6);
    }

    /** Greatest error of exp(-0.02 L) over the rays within 0.8 of a sphere's radius. */
    private static double worstTransmission(double radius, int halvings) {
        CArm arm = new CArm(ORIGIN, 25, -15, 1000, 700, new CArm.Detector(3 * radius, 96, 96));
        double[] lengths = lengths(Shapes.sphere(radius, halvings), arm, 1);
        double worst = 0;
        int rays = 0;
        for (int row = 0; row < arm.rows(); row++) {
            for (int column = 0; column < arm.columns(); column++) {
                double off = Vectors.distanceToLine(ORIGIN, arm.source(), Vectors.normalize(arm.ray(column, row)));
                if (off < 0.8 * radius) {
                    double expected = Math.exp(-0.04 * Math.sqrt(radius * radius - off * off));
                    double found = Math.exp(-0.02 * lengths[row * arm.columns() + column]);
                    worst = Math.max(worst, Math.abs(found - expected));
                    rays++;
                }
            }
        }
        assertThat(rays).isGreaterThan(1000);
        return worst;
    }

    /** The same polyhedron, each ray cut with each triangle on its own (Moeller and Trumbore 1997). */
    @Test
    void transmissionIsThatOfRaysCutWithEachTriangle() {
        CArm arm = arm(-40, 20);
        TriangleMesh mesh = moved(Shapes.sphere(55, 2), 3.1, 2.3, -1.7);
        double[] lengths = lengths(mesh, arm, 1);
        for (int row = 0; row < arm.rows(); row += 3) {
            for (int column = 0; column < arm.columns(); column += 3) {
                double expected = brute(mesh, arm.source(), Vectors.normalize(arm.ray(column, row)));
                double found = lengths[row * arm.columns() + column];
                assertThat(Math.exp(-0.02 * found)).isCloseTo(Math.exp(-0.02 * expected), within(1e-9));
            }
        }
    }

    private static double brute(TriangleMesh mesh, double[] source, double[] ray) {
        double sum = 0;
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i += 3) {
            double[] a = {mesh.x(t[i]), mesh.y(t[i]), mesh.z(t[i])};
            double[] ab = Vectors.subtract(Vectors.of(mesh.x(t[i + 1]), mesh.y(t[i + 1]), mesh.z(t[i + 1])), a);
            double[] ac = Vectors.subtract(Vectors.of(mesh.x(t[i + 2]), mesh.y(t[i + 2]), mesh.z(t[i + 2])), a);
            double[] p = Vectors.cross(ray, ac);
            double det = Vectors.dot(ab, p);
            double[] from = Vectors.subtract(source, a);
            double u = Vectors.dot(from, p) / det;
            double[] q = Vectors.cross(from, ab);
            double v = Vectors.dot(ray, q) / det;
            if (u >= 0 && v >= 0 && u + v <= 1) {
                // det = -normal . ray: positive where the ray enters.
                sum -= Math.signum(det) * Vectors.dot(ac, q) / det;
            }
        }
        return sum;
    }

    @Test
    void bitsDoNotDependOnTheNumberOfThreads() {
        TriangleMesh mesh = Shapes.sphere(70, 4);
        double[] one = lengths(mesh, arm(10, 10), 1);
        assertThat(lengths(mesh, arm(10, 10), 2)).isEqualTo(one);
        assertThat(lengths(mesh, arm(10, 10), 7)).isEqualTo(one);
    }

    /** Brightest pixel of a small ball: column, row. */
    private static int[] seen(double x, double y, double z, double leftOblique, double cranial) {
        CArm arm = arm(leftOblique, cranial);
        double[] lengths = lengths(moved(Shapes.sphere(6, 3), x, y, z), arm, 1);
        int best = 0;
        for (int i = 1; i < lengths.length; i++) {
            best = lengths[i] > lengths[best] ? i : best;
        }
        double[] expected = arm.project(x, y, z);
        assertThat(best % arm.columns()).isCloseTo((int) Math.round(expected[0]), within(1));
        assertThat(best / arm.columns()).isCloseTo((int) Math.round(expected[1]), within(1));
        return new int[] {best % arm.columns(), best / arm.columns()};
    }

    /** LPS: +x is the patient's left, +y the back, +z the head. */
    @Test
    void theImageIsSeenFromTheFrontAndTurnsWithTheDetector() {
        assertThat(seen(60, 0, 0, 0, 0)[0]).as("left, on the reader's right").isGreaterThan(60);
        assertThat(seen(0, 0, 60, 0, 0)[1]).as("head, on top").isLessThan(25);
        assertThat(seen(0, -60, 0, 45, 0)[0])
                .as("LAO: the front moves to the reader's left")
                .isLessThan(35);
        assertThat(seen(0, -60, 0, 0, 40)[1])
                .as("cranial: the front moves down")
                .isGreaterThan(52);
    }

    @Test
    void sourceInsideTheBodyIsRefused() {
        assertThatThrownBy(() -> lengths(Shapes.sphere(750, 2), arm(0, 0), 1))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("0.000/0.000 (LAO/cranial): found the source inside");
    }

    /** A body of 2.4 m along z, whose feet lie behind the plane of the source and far below the picture. */
    @Test
    void whatLiesBehindTheSourceAndOutOfThePictureIsLeftOut() {
        CArm arm = arm(0, 45);
        double[] p = Shapes.sphere(60, 5).positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] *= 20;
        }
        TriangleMesh body = Shapes.sphere(60, 5).withPositions(p);
        assertThat(arm.project(0, 0, -1200)[2]).isNegative();
        double[] lengths = lengths(body, arm, 2);
        int inside = 0;
        for (int row = 0; row < arm.rows(); row += 3) {
            for (int column = 0; column < arm.columns(); column += 3) {
                double expected = brute(body, arm.source(), Vectors.normalize(arm.ray(column, row)));
                assertThat(lengths[row * arm.columns() + column]).isCloseTo(expected, within(1e-6));
                inside += expected > 50 ? 1 : 0;
            }
        }
        assertThat(inside).isGreaterThan(200);
    }

    @Test
    void whatLiesWhollyBehindTheSourceAddsNothing() {
        CArm arm = arm(0, 0);
        double[] source = arm.source();
        double[] behind = Vectors.addScaled(source, arm.axis(), -100);
        assertThat(lengths(moved(Shapes.sphere(60, 2), behind[0], behind[1], behind[2]), arm, 1))
                .containsOnly(0);
        double[] about = Vectors.addScaled(source, arm.axis(), -59);
        assertThatThrownBy(() -> lengths(moved(Shapes.sphere(60, 4), about[0], about[1], about[2]), arm, 1))
                .hasMessageContaining("found the source inside");
    }

    /** A plate beside the source that reaches into the picture. */
    @Test
    void aTriangleThatTheDetectorSeesMayNotReachBehindTheSource() {
        TriangleMesh plate = moved(Shapes.box(1000, 2000, 10), -500, -1000, 10);
        assertThatThrownBy(() -> lengths(plate, arm(0, 0), 1)).isInstanceOf(BadInputException.class);
    }
}
