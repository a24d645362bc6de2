package org.phrenic.engine.kinematics;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class HelicalBodyTest {
    private static final Offset<Double> EXACT = Offset.offset(1e-10);

    /** Central differences over 1e-5 s of motions of some 100 mm/s. */
    private static final Offset<Double> DIFFERENCED = Offset.offset(1e-5);

    private static final HelicalAxis AXIS =
            HelicalAxis.through(new double[] {-0.8, 0.5, 0.2}, new double[] {-25, 60, 1300}, 0.28, 2.5);

    private final double[] rest = new Random(5).doubles(30, -150, 150).toArray();

    @Test
    void restIsLeftExactlyAlone() {
        assertThat(moved(0)).isEqualTo(rest);
    }

    @Test
    void posesAreThoseOfTheHelicalAxis() {
        for (double s : new double[] {-0.1, 0.3, 1, 1.2}) {
            double[] expected = rest.clone();
            AXIS.motion(s).apply(expected);
            assertThat(moved(s)).containsExactly(expected, EXACT);
        }
    }

    @Test
    void velocitiesAreTheDerivativesOfThePositions() {
        double s = 0.4;
        double rate = 0.7;
        double dt = 1e-5;
        double[] twist = new double[HelicalBody.TWIST_LENGTH];
        new HelicalBody(AXIS).twist(rate, twist);
        double[] velocities = new double[rest.length];
        double[] moved = moved(s);
        for (int i = 0; i < rest.length; i += 3) {
            velocities[i] = twist[1] * moved[i + 2] - twist[2] * moved[i + 1] + twist[3];
            velocities[i + 1] = twist[2] * moved[i] - twist[0] * moved[i + 2] + twist[4];
            velocities[i + 2] = twist[0] * moved[i + 1] - twist[1] * moved[i] + twist[5];
        }
        double[] before = moved(s - rate * dt);
        double[] after = moved(s + rate * dt);
        for (int i = 0; i < rest.length; i++) {
            assertThat(velocities[i]).isCloseTo((after[i] - before[i]) / (2 * dt), DIFFERENCED);
        }
    }

    @Test
    void onlyTheNamedPointsAreWritten() {
        double[] pose = new double[HelicalBody.POSE_LENGTH];
        new HelicalBody(AXIS).pose(1, pose);
        double[] out = new double[9];
        HelicalBody.transformPoints(pose, rest, 4, out, 1, 1);
        assertThat(out).startsWith(0, 0, 0).endsWith(0, 0, 0);
        assertThat(out[3]).isEqualTo(moved(1)[12]);
    }

    private double[] moved(double s) {
        double[] pose = new double[HelicalBody.POSE_LENGTH];
        new HelicalBody(AXIS).pose(s, pose);
        double[] out = new double[rest.length];
        HelicalBody.transformPoints(pose, rest, 0, out, 0, rest.length / 3);
        return out;
    }
}
