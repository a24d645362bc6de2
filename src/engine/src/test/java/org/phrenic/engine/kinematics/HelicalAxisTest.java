package org.phrenic.engine.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class HelicalAxisTest {
    private static final Offset<Double> EXACT = Offset.offset(1e-10);

    @Property(tries = 500, seed = "1975")
    void axisOfItsOwnMotionIsItself(
            @ForAll @DoubleRange(min = -1, max = 1) double height,
            @ForAll @DoubleRange(min = 0, max = 6.28) double longitude,
            @ForAll @DoubleRange(min = 0.01, max = 3.13) double angle,
            @ForAll @DoubleRange(min = -10, max = 10) double slide,
            @ForAll @DoubleRange(min = -300, max = 300) double place) {
        double[] point = {place, 120, -0.5 * place};
        HelicalAxis axis = HelicalAxis.through(direction(height, longitude), point, angle, slide);

        HelicalAxis found = HelicalAxis.of(axis.motion(), point);

        assertThat(found.angle()).isCloseTo(angle, EXACT);
        assertThat(found.slide()).isCloseTo(slide, EXACT);
        assertThat(found.directionX()).isCloseTo(axis.directionX(), EXACT);
        assertThat(found.directionY()).isCloseTo(axis.directionY(), EXACT);
        assertThat(found.directionZ()).isCloseTo(axis.directionZ(), EXACT);
        assertThat(found.pointX()).isCloseTo(point[0], EXACT);
        assertThat(found.pointY()).isCloseTo(point[1], EXACT);
        assertThat(found.pointZ()).isCloseTo(point[2], EXACT);
    }

    @Property(tries = 500, seed = "1975")
    void motionOfItsAxisIsItselfAtEveryAngle(
            @ForAll @DoubleRange(min = -1, max = 1) double height,
            @ForAll @DoubleRange(min = 0, max = 6.28) double longitude,
            @ForAll @DoubleRange(min = 0, max = 12) double smallness,
            @ForAll boolean nearHalfTurn,
            @ForAll @DoubleRange(min = -10, max = 10) double slide) {
        double small = Math.pow(10, -smallness);
        double angle = nearHalfTurn ? Math.PI - small : small;
        RigidMotion motion = HelicalAxis.through(
                        direction(height, longitude), new double[] {30, 120, -60}, angle, slide)
                .motion();
        RigidMotion back = HelicalAxis.of(motion).motion();

        for (int i = 0; i < 3; i++) {
            assertThat(back.translation(i)).isCloseTo(motion.translation(i), EXACT);
            for (int j = 0; j < 3; j++) {
                assertThat(back.rotation(i, j)).isCloseTo(motion.rotation(i, j), EXACT);
            }
        }
    }

    @Test
    void motionWithoutATurnIsASlide() {
        HelicalAxis axis = HelicalAxis.of(RigidMotion.translation(0, 3, -4), new double[] {1, 2, 3});
        assertThat(axis.angle()).isZero();
        assertThat(axis.slide()).isEqualTo(5);
        assertThat(axis.motion().apply(10, 10, 10)).containsExactly(new double[] {10, 13, 6}, EXACT);
        assertThat(HelicalAxis.of(RigidMotion.identity()).slide()).isZero();
    }

    @Test
    void halfOfTheMotionTwiceIsTheWhole() {
        HelicalAxis axis = HelicalAxis.through(new double[] {-0.8, 0.5, 0.2}, new double[] {-25, 60, 10}, 0.25, 1.5);
        double[] twice = {-40, -90, -30};
        axis.motion(0.5).apply(twice);
        axis.motion(0.5).apply(twice);
        assertThat(twice).containsExactly(axis.motion().apply(-40, -90, -30), EXACT);
        assertThat(axis.motion(0).apply(-40, -90, -30)).containsExactly(-40, -90, -30);
    }

    @Test
    void pointIsTheNearestToTheOriginUnlessAsked() {
        HelicalAxis axis = HelicalAxis.through(new double[] {1, 1, 0}, new double[] {7, 3, 9}, 0.3, 2);
        HelicalAxis found = HelicalAxis.of(axis.motion());
        assertThat(found.pointX()).isCloseTo(2, EXACT);
        assertThat(found.pointY()).isCloseTo(-2, EXACT);
        assertThat(found.pointZ()).isCloseTo(9, EXACT);
    }

    @Test
    void mirroredScrewMovesMirroredPoints() {
        HelicalAxis axis = HelicalAxis.through(new double[] {-0.8, 0.5, 0.2}, new double[] {-25, 60, 10}, 0.25, 1.5);
        double[] right = axis.motion().apply(-90, -40, 20);
        double[] left = axis.mirroredX().motion().apply(90, -40, 20);
        assertThat(left).containsExactly(new double[] {-right[0], right[1], right[2]}, EXACT);
    }

    /** Woltring 1985: the same noise in the points tilts the axis {@code 1 / (2 sin(theta / 2))} times as much. */
    @Test
    void noiseTiltsTheAxisMoreTheSmallerTheTurn() {
        double large = meanTilt(0.30);
        double small = meanTilt(0.03);
        double expected = Math.sin(0.15) / Math.sin(0.015);
        // The mean of 400 fits scatters by a few per cent.
        assertThat(small / large).isCloseTo(expected, Offset.offset(0.15 * expected));
        // 0.2 mm on 20 points 150 mm apart: a few degrees at the turn of a tidal breath
        assertThat(Math.toDegrees(small)).isBetween(0.1, 5.0);
    }

    /** Nine digits of a direction from a table. */
    @Test
    void aDirectionRoundedToNineDigitsHasAMotion() {
        HelicalAxis axis = new HelicalAxis(0.577350269, 0.577350269, 0.577350269, 0, 0, 0, 3, 0);
        assertThat(axis.directionX()).isCloseTo(1 / Math.sqrt(3), within(1e-15));
        assertThat(HelicalAxis.of(axis.motion()).angle()).isCloseTo(3, within(1e-9));
    }

    @Test
    void directionsWithoutLengthAreRefused() {
        assertThatThrownBy(() -> HelicalAxis.through(new double[3], new double[3], 1, 0))
                .hasMessage("helical axis: direction (0.0, 0.0, 0.0) has no length, expected one to turn about");
        assertThatThrownBy(() -> new HelicalAxis(2, 0, 0, 0, 0, 0, 1, 0))
                .hasMessage("helical axis: direction of length 2.0, expected 1");
        assertThatThrownBy(() -> new HelicalAxis(1, 0, 0, Double.NaN, 0, 0, 1, 0))
                .hasMessageContaining("expected finite numbers");
    }

    /** Mean angle in rad between the true axis and those of noisy fits. */
    private static double meanTilt(double angle) {
        double noise = 0.2;
        Random random = new Random(20090101);
        HelicalAxis axis = HelicalAxis.through(new double[] {-0.8, 0.5, 0.2}, new double[] {-25, 60, 10}, angle, 0);
        double sum = 0;
        int fits = 400;
        for (int n = 0; n < fits; n++) {
            double[] from = random.doubles(60, -75, 75).toArray();
            double[] to = from.clone();
            axis.motion().apply(to);
            for (int i = 0; i < to.length; i++) {
                to[i] += noise * random.nextGaussian();
            }
            HelicalAxis found = HelicalAxis.of(RigidMotion.fit(from, to));
            double cosine = found.directionX() * axis.directionX()
                    + found.directionY() * axis.directionY()
                    + found.directionZ() * axis.directionZ();
            sum += Math.acos(Math.min(1, cosine));
        }
        return sum / fits;
    }

    private static double[] direction(double height, double longitude) {
        double radius = Math.sqrt(1 - height * height);
        return new double[] {radius * Math.cos(longitude), radius * Math.sin(longitude), height};
    }
}
