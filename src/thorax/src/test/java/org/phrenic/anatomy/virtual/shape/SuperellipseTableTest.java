package org.phrenic.anatomy.virtual.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class SuperellipseTableTest {
    /** What the class states: a micrometre on a wall 150 mm away. */
    private static final double STATED = 6e-6;

    @Test
    void agreesWithPowersToAMicrometreOfTheWall() {
        SuperellipseTable table = new SuperellipseTable(2.25, 2.7);
        for (double n = 2.25; n <= 2.7; n += 0.0137) {
            for (double m = 0; m <= 1; m += 0.00173) {
                double power = StrictMath.pow(m, n);
                assertThat(table.power(m, n)).isCloseTo(power, within(STATED));
                assertThat(table.root(m, n)).isCloseTo(StrictMath.pow(1 + power, -1 / n), within(STATED));
            }
        }
    }

    @Test
    void holdsOneExponentAlone() {
        SuperellipseTable table = new SuperellipseTable(2.5, 2.5);
        assertThat(table.power(0.5, 2.5)).isCloseTo(StrictMath.pow(0.5, 2.5), within(STATED));
    }
}
