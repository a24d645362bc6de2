package org.phrenic.simulation.observe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

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

    @Test
    void anOrganUnderTheSheetGoesDownWithItAndThePelvisStands() {
        double[] organ = {0, 0, -5, 0, 0, -60, 0, 0, -150, 0, 0, -260};
        OrganMotion motion = new OrganMotion(organ, sheet(0));
        assertThat(motion.at(sheet(0))).containsExactly(organ);
        double[] now = motion.at(sheet(-15));
        assertThat(now[2]).isCloseTo(-20, within(1e-9));
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
        double[] now = new OrganMotion(organ, sheet(0)).at(tilted);
        assertThat(now[2]).isCloseTo(-18, within(0.5));
        assertThat(now[5]).isCloseTo(-2, within(0.5));
    }
}
