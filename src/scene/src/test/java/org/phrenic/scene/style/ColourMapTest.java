package org.phrenic.scene.style;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Colours that can be read as numbers. */
class ColourMapTest {
    private static final int STEPS = 256;
    /** Rounding to 8 bits a channel moves lightness by this much, of 100. */
    private static final double ROUNDING = 0.5;

    /** CIE lightness of an sRGB colour, 0 to 100. */
    private static double lightness(float r, float g, float b) {
        double y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
        return y > 0.008856 ? 116 * Math.cbrt(y) - 16 : 903.3 * y;
    }

    private static double linear(double c) {
        return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
    }

    private static double[] lightness(ColourMap map) {
        float[] table = map.table(STEPS);
        double[] values = new double[STEPS];
        for (int i = 0; i < STEPS; i++) {
            values[i] = lightness(table[3 * i], table[3 * i + 1], table[3 * i + 2]);
        }
        return values;
    }

    @Test
    void magnitudesGrowLighterInEqualSteps() {
        double[] l = lightness(ColourMap.VIRIDIS);
        for (int i = 1; i < STEPS; i++) {
            assertThat(l[i] - l[i - 1]).as("step %d", i).isPositive();
        }
        assertThat(l[STEPS / 2] - l[0]).isCloseTo(l[STEPS - 1] - l[STEPS / 2], within(6.0));
    }

    @Test
    void signedValuesGrowDarkerFromTheMiddleAlikeOnBothSides() {
        double[] l = lightness(ColourMap.COOL_WARM);
        for (int i = 1; i < STEPS; i++) {
            double step = l[i] - l[i - 1];
            assertThat(i <= STEPS / 2 - 1 ? step : -step).as("step %d", i).isGreaterThan(-ROUNDING);
        }
        for (int i = 0; i < STEPS / 2; i++) {
            assertThat(l[i]).isCloseTo(l[STEPS - 1 - i], within(5.0));
        }
    }

    @Test
    void valuesBeyondTheRangeHaveTheColourOfItsEnd() {
        ColourScale scale = ColourScale.sequential(20, "mm");
        assertThat(scale.rgb(-5)).isEqualTo(scale.rgb(0)).isEqualTo(0x440154);
        assertThat(scale.rgb(25)).isEqualTo(scale.rgb(20)).isEqualTo(0xfde725);
        assertThat(scale.fraction(5)).isEqualTo(0.25);
        assertThat(ColourScale.diverging(3, "%").rgb(0)).isEqualTo(0xdddddd);
    }

    @Test
    void aRangeThatIsNoneIsRefusedInOneSentence() {
        ColourScale scale = ColourScale.sequential(20, "mm");
        assertThatThrownBy(() -> scale.withRange(5, 3))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("colour scale: found 5 to 3, expected the smaller number first");
        assertThatThrownBy(() -> scale.withRange(3, 3)).hasMessageContaining("smaller number first");
        assertThatThrownBy(() -> scale.withRange(0, Double.NaN)).hasMessageContaining("finite");
        assertThatThrownBy(() -> scale.withRange(-Double.MAX_VALUE, Double.MAX_VALUE))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
