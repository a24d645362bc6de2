package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.MovingLeastSquares;

class SlidingElasticSolidTest {
    private static final TriangleMesh SPHERE = Shapes.sphere(1, 4);
    private static final double[] INSIDE = {12, -20, 30};

    /** An ellipsoid with half axes of 40, 60 and 100 mm; each point of the unit sphere is moved along it first. */
    private static TriangleMesh ellipsoid(UnaryOperator<double[]> alongSphere, double longer) {
        double[] p = SPHERE.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            double[] s = alongSphere.apply(new double[] {p[i], p[i + 1], p[i + 2]});
            p[i] = 40 * s[0];
            p[i + 1] = 60 * s[1];
            p[i + 2] = 100 * longer * s[2];
        }
        return SPHERE.withPositions(p);
    }

    @Test
    void followsAShiftOfTheWholeBody() {
        TriangleMesh rest = ellipsoid(s -> s, 1);
        double[] p = rest.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i] += 3;
            p[i + 1] -= 12;
            p[i + 2] += 7;
        }
        double[] to = new SlidingElasticSolid(rest, rest.withPositions(p)).moved(INSIDE);
        assertThat(to[0] - INSIDE[0]).isCloseTo(3, offset(0.1));
        assertThat(to[1] - INSIDE[1]).isCloseTo(-12, offset(0.1));
        assertThat(to[2] - INSIDE[2]).isCloseTo(7, offset(0.1));
    }

    /**
     * Vertices that slide along a surface which keeps its shape carry what is attached to them; a solid lags behind.
     */
    @Test
    void isCarriedLessByVerticesThatSlideAlongAStillSurface() {
        TriangleMesh rest = ellipsoid(s -> s, 1);
        double turn = Math.toRadians(15);
        TriangleMesh slid = ellipsoid(
                s -> new double[] {
                    s[0], Math.cos(turn) * s[1] - Math.sin(turn) * s[2], Math.sin(turn) * s[1] + Math.cos(turn) * s[2]
                },
                1);
        double[] to = new SlidingElasticSolid(rest, slid).moved(INSIDE);
        double[] attached = MovingLeastSquares.position(
                MovingLeastSquares.coefficients(rest.positions(), INSIDE), slid.positions());
        assertThat(distance(attached)).isGreaterThan(8);
        assertThat(distance(to)).isLessThan(0.75 * distance(attached));
    }

    /**
     * A body that becomes a tenth longer carries a point at half its depth and three tenths of its height up by 3 mm.
     */
    @Test
    void stretchesWithItsSurface() {
        double[] to =
                new SlidingElasticSolid(ellipsoid(s -> s, 1), ellipsoid(s -> s, 1.1)).moved(new double[] {12, 0, 30});
        assertThat(to[2] - 30).isCloseTo(3, offset(0.6));
        assertThat(to[1]).isBetween(-1.35, 0.0);
    }

    /** An airway leaves a hole in the surface of a lung. */
    @Test
    void isMovedByASurfaceWithAHoleAsByAClosedOne() {
        TriangleMesh rest = ellipsoid(s -> s, 1);
        TriangleMesh now = ellipsoid(s -> s, 1.1);
        double[] expected = new SlidingElasticSolid(rest, now).moved(INSIDE);
        int[] open = Arrays.copyOf(rest.triangles(), rest.triangles().length - 3);
        double[] to = new SlidingElasticSolid(
                        new TriangleMesh(rest.positions(), open), new TriangleMesh(now.positions(), open))
                .moved(INSIDE);
        assertThat(to).containsExactly(expected, offset(0.1));
    }

    /**
     * A long box whose walls let the inside slide grows by a fifth. Between its walls strain is along y alone, so that
     * the middle goes forward by (1 + nu) / (1 - nu) s L / 8 where the free strain is s y / L, s 1.5 times the mean
     * strain. Ties along the walls hold some of it back.
     */
    @Test
    void carriesTheMiddleForwardAsTheBackExpandsMost() {
        TriangleMesh rest = box(1);
        double s = 1.5 * (Math.cbrt(1.2) - 1);
        double free = 1.3 / 0.7 * s * 120 / 8;
        double[] to = new SlidingElasticSolid(rest, box(1.2)).moved(new double[3]);
        assertThat(to[1]).isBetween(-free, -0.6 * free);
        assertThat(to[0]).isCloseTo(0, offset(0.2));
        assertThat(to[2]).isCloseTo(0, offset(0.2));
    }

    /** A box of 60, 120 and 200 mm about the origin. */
    private static TriangleMesh box(double longer) {
        double[] p = SPHERE.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            double most = Math.max(Math.abs(p[i]), Math.max(Math.abs(p[i + 1]), Math.abs(p[i + 2])));
            p[i] *= 30 / most;
            p[i + 1] *= 60 / most;
            p[i + 2] *= 100 * longer / most;
        }
        return SPHERE.withPositions(p);
    }

    private static double distance(double[] to) {
        return Math.sqrt(
                Math.pow(to[0] - INSIDE[0], 2) + Math.pow(to[1] - INSIDE[1], 2) + Math.pow(to[2] - INSIDE[2], 2));
    }
}
