package org.phrenic.engine.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class RigidMotionTest {
    /** mm over coordinates of some hundred mm: what the helical axis is promised to. */
    private static final Offset<Double> CLEAN = Offset.offset(1e-10);

    private static final double[] PLANAR = {0, 0, 0, 100, 0, 0, 0, 80, 0, 30, 40, 0};

    @Property(tries = 300, seed = "1975")
    void fitFindsTheMotionOfCleanPoints(
            @ForAll @DoubleRange(min = -1, max = 1) double x,
            @ForAll @DoubleRange(min = -1, max = 1) double y,
            @ForAll @DoubleRange(min = -3.14, max = 3.14) double angle,
            @ForAll @DoubleRange(min = -300, max = 300) double shift) {
        RigidMotion motion = HelicalAxis.through(
                        new double[] {x, y, 0.3}, new double[] {shift, 40, -70}, angle, 0.1 * shift)
                .motion();
        double[] from = cloud(12, 7);
        double[] to = from.clone();
        motion.apply(to);

        RigidMotion found = RigidMotion.fit(from, to);

        assertThat(found.rms(from, to)).isCloseTo(0, CLEAN);
        assertThat(found.after(motion.inverse()).rms(to, to)).isCloseTo(0, CLEAN);
    }

    @Test
    void pointsInOnePlaneAreTurnedNotReflected() {
        RigidMotion motion = HelicalAxis.through(new double[] {1, 2, 3}, new double[] {5, 6, 7}, 2.9, 4)
                .motion();
        double[] to = PLANAR.clone();
        motion.apply(to);

        RigidMotion found = RigidMotion.fit(PLANAR, to);

        assertThat(found.apply(10, 20, 30)[2]).isCloseTo(motion.apply(10, 20, 30)[2], CLEAN);
    }

    @Test
    void mirroredPointsStillGiveAProperRotation() {
        double[] from = cloud(20, 3);
        double[] mirrored = from.clone();
        for (int i = 0; i < mirrored.length; i += 3) {
            mirrored[i] = -mirrored[i];
        }
        RigidMotion found = RigidMotion.fit(from, mirrored);

        // of() refuses reflections
        double[] rotation = new double[9];
        for (int i = 0; i < 9; i++) {
            rotation[i] = found.rotation(i / 3, i % 3);
        }
        assertThat(RigidMotion.of(rotation, new double[3])).isNotNull();
    }

    @Test
    void inverseAndCompositionUndoEachOther() {
        RigidMotion a = HelicalAxis.through(new double[] {1, -2, 3}, new double[] {5, 60, 7}, 0.7, 4)
                .motion();
        RigidMotion b = RigidMotion.translation(3, 4, 5);
        double[] points = cloud(5, 1);
        double[] moved = points.clone();
        a.after(b).apply(moved);
        double[] byHand = points.clone();
        b.apply(byHand);
        a.apply(byHand);
        assertThat(moved).containsExactly(byHand, CLEAN);

        a.after(b).inverse().apply(moved);
        assertThat(moved).containsExactly(points, CLEAN);
        assertThat(RigidMotion.identity().rms(points, points)).isZero();
    }

    @Test
    void badPointsAreRefusedInOneSentence() {
        double[] line = {0, 0, 0, 1, 1, 1, 2, 2, 2, 5, 5, 5};
        double[] nan = PLANAR.clone();
        nan[4] = Double.NaN;
        double[] two = {0, 0, 0, 1, 1, 1};
        assertThatThrownBy(() -> RigidMotion.fit(two, two)).hasMessage("rigid fit: 2 points, expected at least 3");
        assertThatThrownBy(() -> RigidMotion.fit(PLANAR, two))
                .hasMessage("rigid fit: 12 and 6 coordinates, expected the same multiple of 3 in both");
        assertThatThrownBy(() -> RigidMotion.fit(line, PLANAR))
                .hasMessage("rigid fit: the 4 points of 'from' lie on one line, expected at least 3 that do not");
        assertThatThrownBy(() -> RigidMotion.fit(PLANAR, nan))
                .hasMessage("rigid fit: point 1 of 'to' holds NaN, expected finite coordinates");
        assertThatThrownBy(() -> RigidMotion.of(new double[] {-1, 0, 0, 0, 1, 0, 0, 0, 1}, new double[3]))
                .hasMessageContaining("a reflection");
        assertThatThrownBy(() -> RigidMotion.of(new double[] {2, 0, 0, 0, 1, 0, 0, 0, 1}, new double[3]))
                .hasMessageContaining("expected 1 of an orthonormal matrix");
    }

    private static double[] cloud(int count, long seed) {
        Random random = new Random(seed);
        return random.doubles(3L * count, -150, 150).toArray();
    }
}
