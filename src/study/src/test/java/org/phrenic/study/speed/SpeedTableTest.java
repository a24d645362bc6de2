package org.phrenic.study.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;

/** What is made of a table of speeds. */
class SpeedTableTest {
    private static SpeedTable of(double[] perS) {
        return new SpeedTable(Arrays.stream(Resolution.values())
                .map(r -> new SpeedTable.Row(r, SpeedCase.HETEROGENEOUS, r.vertices(), List.of(perS[r.ordinal()])))
                .toList());
    }

    @Test
    void timeThatIsProportionalToTheVerticesHasTheExponentOne() {
        double[] perS = Arrays.stream(Resolution.values())
                .mapToDouble(r -> 1e7 / r.vertices())
                .toArray();
        assertThat(of(perS).exponent(SpeedCase.HETEROGENEOUS).orElseThrow()).isCloseTo(1, within(1e-12));
    }

    @Test
    void timeThatGrowsAsTheSquareHasTheExponentTwo() {
        double[] perS = Arrays.stream(Resolution.values())
                .mapToDouble(r -> 1e12 / r.vertices() / r.vertices())
                .toArray();
        assertThat(of(perS).exponent(SpeedCase.HETEROGENEOUS).orElseThrow()).isCloseTo(2, within(1e-12));
    }

    @Test
    void thePapersRibsCostThirteenToNineteenPercent() {
        // 9.68 / 8.13, 11.76 / 10.41, 14.70 / 12.79, by hand.
        SpeedTable printed = SpeedTable.published();
        assertThat(printed.overheadPercent(Resolution.HIGH, SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY))
                .isCloseTo(19.07, within(0.01));
        assertThat(printed.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY))
                .containsExactly(new double[] {12.97, (19.07 + 12.97 + 14.93) / 3, 19.07}, within(0.01));
    }

    @Test
    void casesAreComparedTrialByTrialSoThatALoadOnBothCancels() {
        // The machine halves its speed from the second trial on; one case always takes a tenth longer.
        SpeedTable table = new SpeedTable(List.of(
                new SpeedTable.Row(Resolution.LOW, SpeedCase.HETEROGENEOUS, 100, List.of(100.0, 50.0, 50.0)),
                new SpeedTable.Row(Resolution.LOW, SpeedCase.HOMOGENEOUS, 100, List.of(110.0, 55.0, 55.0))));
        assertThat(table.overheadPercent(Resolution.LOW, SpeedCase.HETEROGENEOUS, SpeedCase.HOMOGENEOUS))
                .isCloseTo(10, within(1e-9));
        assertThat(table.resolutions()).containsExactly(Resolution.LOW);
        assertThat(table.row(Resolution.LOW, SpeedCase.HETEROGENEOUS).stepsPerS())
                .isEqualTo(50);
    }
}
