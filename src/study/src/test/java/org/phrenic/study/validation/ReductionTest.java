package org.phrenic.study.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.Sensitivity;

/** Every reduction on curves whose answer is plain from how they were made ({@link SyntheticBreath}). */
class ReductionTest {
    private static final Offset<Double> ROUNDING = within(1e-9);

    private static double reduce(String name, BreathSeries series, String observables, String against, double share) {
        return Reduction.of(name).orElseThrow().of(series, series, List.of(observables.split(" ")), against, share);
    }

    @ParameterizedTest
    @CsvSource({
        "start, x, '', 100",
        "end, x, '', 80",
        "rise, x, '', -20",
        "fall, x, '', 20",
        "size, x, '', 20",
        "size, y, '', 500",
        "percent_fall, x, '', 20",
        "percent_fall, z, '', 12.5",
        "ratio, x, y, 0.04",
        "slope, x, y, 0.04",
        "at_share, x, y, 12", // 0.6 of the way of x
        "at_share, y, x, 300",
        "hysteresis, x, y, 4",
        "order, x z, '', 15", // sizes 20 and 5
        "order, z x, '', -15",
    })
    void aReductionOfAWholeBreath(String name, String observables, String against, double expected) {
        assertThat(reduce(name, SyntheticBreath.breath(), observables, against, 0.6))
                .isEqualTo(expected, ROUNDING);
    }

    @Test
    void ofARunWithAHoldOnlyTheHeldBreathCounts() {
        BreathSeries hold = SyntheticBreath.hold();
        assertThat(reduce("fall", hold, "x", "", 1)).isEqualTo(60, ROUNDING);
        assertThat(reduce("creep", hold, "x", "", 1)).isEqualTo(3, ROUNDING);
        assertThat(reduce("creep", hold, "y", "", 1)).isEqualTo(-50, ROUNDING);
        assertThat(hold.breathCount()).isEqualTo(1);
    }

    @Test
    void whatTheCurvesDoNotHaveIsNoNumber() {
        BreathSeries breath = SyntheticBreath.breath();
        assertThat(reduce("creep", breath, "x", "", 1)).isNaN();
        double never = Reduction.AT_SHARE.of(breath, SyntheticBreath.hold(), List.of("x"), "y", 0.6);
        assertThat(never).as("y reaches 500, 0.6 of the other's 2000 is 1200").isNaN();
    }

    @Test
    void aRatioMayBeToAnotherPreset() {
        double ratio = Reduction.RATIO.of(SyntheticBreath.breath(), SyntheticBreath.hold(), List.of("x"), "x", 1);
        assertThat(ratio).isEqualTo(20.0 / 60, ROUNDING);
    }

    @Test
    void effectsAreInPerCentPerPerCent() {
        // From 9 to 11 about 10 is a fifth; the observable goes from 16 to 24 about 20, two fifths; the other stands at
        // nothing.
        double[] effects = Sensitivity.effects(new double[] {20, 0}, new double[] {16, 1}, new double[] {24, 2}, 0.2);
        assertThat(effects[0]).isEqualTo(2, ROUNDING);
        assertThat(effects[1]).isNaN();
    }
}
