package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumberFormatsTest {
    @ParameterizedTest
    @CsvSource({
        "300, 300",
        "0.64, 0.64",
        "0.1666666, 0.1667",
        "0, 0",
        "-0.0, 0",
        "-12.3456, -12.35",
        "123456, 123500",
        "0.00001, 1e-5",
        "-0.00002345, -2.345e-5",
        "0.001, 0.001",
        "12345678, 1.235e7",
        "NaN, -"
    })
    void aNumberHasFourDigitsAndNoZerosThatSayNothing(double value, String text) {
        assertThat(NumberFormats.format(value)).isEqualTo(text);
    }

    @Test
    void aPlainNumberHasNoUnit() {
        assertThat(NumberFormats.withUnit(450, "N/m")).isEqualTo("450 N/m");
        assertThat(NumberFormats.withUnit(1.12, "1")).isEqualTo("1.12");
    }

    @Test
    void aChangingNumberKeepsItsWidthAndHasNoNegativeZero() {
        assertThat(NumberFormats.fixedDecimals(-12.04, 1)).isEqualTo("-12.0");
        assertThat(NumberFormats.fixedDecimals(-0.01, 1)).isEqualTo("0.0");
    }

    @ParameterizedTest
    @CsvSource({
        "450, N/m, 450",
        "0.5, 1, 0.5",
        "' 450 N/m', N/m, 450",
        "450N/m, N/m, 450",
        "15/min, 1/min, 15",
        "15 1/min, 1/min, 15",
        "1e-3, s, 0.001",
        "1e-3 s, s, 0.001",
        "5., mm, 5",
        "1.5 kg/m\u00b2, kg/m^2, 1.5",
        "'2 N s/m', N s/m, 2",
        "-2.5, mm, -2.5"
    })
    void whatIsTypedMayCarryItsUnit(String typed, String unit, double value) {
        assertThat(NumberFormats.parse(typed, unit)).hasValue(value);
    }

    @ParameterizedTest
    @CsvSource({"0.4 kN/m, N/m", "5 cm, mm", "3 MN, mN", "2 mm, 1", "5 %, mm", "5 5, mm"})
    void anotherUnitIsRefused(String typed, String unit) {
        assertThat(NumberFormats.parse(typed, unit)).isEmpty();
    }

    @Test
    void aDecimalCommaIsAPoint() {
        assertThat(NumberFormats.parse("0,5", "mm")).hasValue(0.5);
        assertThat(NumberFormats.parse("0,125", "mm")).hasValue(0.125);
        assertThat(NumberFormats.parse("12,5 mm", "mm")).hasValue(12.5);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "abc", "NaN", "Infinity", "1..2", "1e999", "--3", "1,000", "-12,500", "1,000.5", "1 000"})
    void whatIsNoNumberIsRefused(String typed) {
        assertThat(NumberFormats.parse(typed, "N/m")).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1,000 | Found '1,000', expected a number from 30 to 3000 N/m, written without a comma between thousands.",
                "450 kPa | Found '450 kPa', expected a number from 30 to 3000 N/m, written in N/m.",
                "stiff | Found 'stiff', expected a number from 30 to 3000 N/m."
            })
    void aRefusalSaysHowToWriteTheNumber(String typed, String sentence) {
        assertThat(NumberFormats.parse(typed, "N/m")).isEmpty();
        assertThat(NumberFormats.refusal(typed, "30 to 3000 N/m", "N/m")).isEqualTo(sentence);
    }
}
