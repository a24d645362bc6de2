package org.phrenic.anatomy.cage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Side;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.file.BadInputException;

class RibAxisTableTest {
    private static final String HEADER = "rib,pump_deg,bucket_deg,swing_deg,slide_mm,angle_deg,confidence,source\n";

    /** Wilson et al. 1987: 17.0 degrees at rib 3 falling to 12.2 at rib 7; our table stays within 1.5 of that. */
    @Test
    void measuredAnglesStayCloseToWilson() {
        RibAxisTable table = RibAxisTable.preset(RibAxisTable.WILSON_CT);
        double[] wilson = {17.0, 15.8, 14.6, 13.4, 12.2};
        for (int level = 3; level <= 7; level++) {
            assertThat(table.row(level).angleDeg()).isCloseTo(wilson[level - 3], within(1.5));
        }
    }

    /** Beyer et al. 2016: the range of motion decreases gradually with level. */
    @Test
    void anglesFallWithLevel() {
        for (String name : new String[] {RibAxisTable.WILSON_CT, RibAxisTable.NECK}) {
            RibAxisTable table = RibAxisTable.preset(name);
            for (int level = 3; level <= 11; level++) {
                // half a degree: the least-squares table is flat from rib 9 to 10
                assertThat(table.row(level + 1).angleDeg())
                        .as(name + " rib " + (level + 1))
                        .isLessThan(table.row(level).angleDeg() + 0.6);
            }
        }
    }

    @Test
    void axisPassesThroughTheHeadAndRaisesTheFront() {
        HelicalAxis axis = RibAxisTable.preset(RibAxisTable.NECK).axis(5, Side.RIGHT, new double[] {-18, 54, 1360});
        assertThat(axis.motion().apply(-18, 54, 1360)).containsExactly(new double[] {-18, 54, 1360}, within(1e-9));
        double[] tip = axis.motion().apply(-83, -100, 1246);
        assertThat(tip[2]).isGreaterThan(1246);
        assertThat(tip[1]).isLessThan(-100);
        assertThat(Math.toDegrees(axis.angle())).isCloseTo(14.6, within(0.1));
    }

    @Test
    void leftMirrorsRight() {
        RibAxisTable table = RibAxisTable.preset(RibAxisTable.WILSON_CT);
        double[] right =
                table.axis(7, Side.RIGHT, new double[] {-18, 60, 0}).motion().apply(-110, -80, -130);
        double[] left =
                table.axis(7, Side.LEFT, new double[] {18, 60, 0}).motion().apply(110, -80, -130);
        assertThat(left).containsExactly(new double[] {-right[0], right[1], right[2]}, within(1e-9));
    }

    /**
     * Motion of a bucket handle: inspiration raises a point lateral to the head of a rib, on both sides, at all levels.
     */
    @ParameterizedTest
    @ValueSource(strings = {RibAxisTable.WILSON_CT, RibAxisTable.NECK})
    void everyRibRaisesItsLateralArc(String name) {
        RibAxisTable table = RibAxisTable.preset(name);
        for (int level = 1; level <= 12; level++) {
            for (int outward : new int[] {-1, 1}) {
                Side side = outward < 0 ? Side.RIGHT : Side.LEFT;
                double[] beside = {outward * 118, 54, 0};
                double[] head = {outward * 18, 54, 0};
                assertThat(table.axis(level, side, head).motion().apply(beside[0], beside[1], beside[2])[2])
                        .as("rise of the arc of rib %d, %s, mm", level, side)
                        .isGreaterThan(3);
            }
        }
    }

    /** Upper ribs swing forward, lower ones open outward like calipers; from rib 3 to 10 the swing falls with level. */
    @Test
    void measuredRibsSwingOutwardTheMoreTheLowerTheyLie() {
        RibAxisTable table = RibAxisTable.preset(RibAxisTable.WILSON_CT);
        for (int level = 3; level < 10; level++) {
            assertThat(table.row(level + 1).swingDeg())
                    .as("rib " + (level + 1))
                    .isLessThan(table.row(level).swingDeg());
        }
        assertThat(table.row(3).swingDeg()).isPositive();
        assertThat(table.row(12).swingDeg()).isNegative();
    }

    @Test
    void badTablesAreRefusedInOneSentence() {
        assertThatThrownBy(() -> RibAxisTable.preset("axes-none"))
                .hasMessage("rib axes: no table 'axes-none', expected 'axes-wilson-ct' or 'axes-neck'");
        refused("1,3,4,0,0,five,good,x\n", "t.csv: line 2, column 'angle_deg': found 'five', expected a number");
        refused(
                "1,3,4,0,0,7,good,x\n",
                "t.csv: line 2, column 'angle_deg': found 7.0, expected the length of pump, bucket and swing, 5.0");
        refused("13,3,4,0,0,5,good,x\n", "t.csv: line 2, column 'rib': found 13.0, expected 1 to 12");
        refused("1,3,4,0,0,5,good,x\n", "t.csv: found no line for rib 2, expected ribs 1 to 12");
        refused(
                "1,3,4,0,0,5,good,x\n1,3,4,0,0,5,good,x\n",
                "t.csv: line 3, column 'rib': found rib 1 a second time, expected it once");
        assertThatThrownBy(() -> RibAxisTable.parse("t.csv", "rib,pump\n1,2\n"))
                .hasMessageStartingWith("t.csv: line 1: found columns rib, pump, expected a column 'pump_deg'");
    }

    private static void refused(String lines, String message) {
        assertThatThrownBy(() -> RibAxisTable.parse("t.csv", HEADER + lines))
                .isInstanceOf(BadInputException.class)
                .hasMessage(message);
    }
}
