package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Hidden settings of known breaths. */
class KnownBreathTest {
    /** 60 uniform draws leave less than a tenth of their interval empty at an end, but for one seed of 500. */
    @ParameterizedTest
    @CsvSource({"0, 0.4, 0.75", "1, 0.5, 1.3", "2, 0.8, 1.3", "3, 0.7, 1.4"})
    void successiveSeedsCoverTheRangeOfEverySetting(int place, double low, double high) {
        double[] drawn = IntStream.rangeClosed(1, 60)
                .mapToDouble(seed -> value(seed, 1, place))
                .sorted()
                .toArray();
        double tenth = (high - low) / 10;
        assertThat(drawn[0]).isBetween(low - 0.0005, low + tenth);
        assertThat(drawn[59]).isBetween(high - tenth, high + 0.0005);
    }

    @Test
    void aGentlerAttemptHasTheSameSettingsWithLessDrive() {
        assertThat(value(7, 0.4, 0)).isCloseTo(0.4 * value(7, 1, 0), within(0.001));
        assertThat(value(7, 0.4, 1)).isCloseTo(0.4 * value(7, 1, 1), within(0.001));
        assertThat(value(7, 0.4, 2)).isEqualTo(value(7, 1, 2));
        assertThat(value(7, 0.4, 3)).isEqualTo(value(7, 1, 3));
    }

    private static double value(long seed, double drive, int place) {
        String setting = KnownBreath.hiddenSettings(seed, drive).get(place);
        return Double.parseDouble(setting.substring(setting.indexOf('=') + 1));
    }
}
