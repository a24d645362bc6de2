package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumbersTest {
    @ParameterizedTest
    @CsvSource({
        "300, 4, 300",
        "10000, 4, 10000",
        "99.6, 2, 100",
        "100, 2, 100",
        "123456, 4, 123500",
        "0.02, 4, 0.02",
        "0.12345, 4, 0.1235",
        "0.00005, 4, 5e-5",
        "0.00001, 6, 1e-5",
        "-0.00002345, 3, -2.35e-5",
        "12345678, 4, 1.235e7",
        "0, 4, 0",
        "-0.0, 4, 0",
        "NaN, 4, NaN",
        "-Infinity, 4, -Infinity"
    })
    void aTrimmedNumberHasNoZerosThatSayNothing(double value, int digits, String text) {
        assertThat(Numbers.trimmed(value, digits)).isEqualTo(text);
    }
}
