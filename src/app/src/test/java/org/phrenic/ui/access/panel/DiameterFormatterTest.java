package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A diameter that is typed is read as every other number of the window. */
class DiameterFormatterTest {
    private final List<String> said = new ArrayList<>();
    private final DiameterFormatter formatter = new DiameterFormatter(5, 50, said::add);

    @ParameterizedTest
    @CsvSource({"'5,0', 5", "12.0, 12", "30 mm, 30", "50, 50"})
    void aPointAndACommaAreDecimal(String typed, int mm) throws Exception {
        assertThat(formatter.stringToValue(typed)).isEqualTo(mm);
        assertThat(said).isEmpty();
        assertThat(formatter.valueToString(mm)).isEqualTo(String.valueOf(mm));
    }

    @ParameterizedTest
    @CsvSource({
        "60, 50, '60 mm is out of range; the largest, 50 mm, is taken.'",
        "'4,5', 5, '4.5 mm is out of range; the smallest, 5 mm, is taken.'"
    })
    void oneOutOfRangeIsTakenAsItsEndAndSaidSo(String typed, int mm, String sentence) throws Exception {
        assertThat(formatter.stringToValue(typed)).isEqualTo(mm);
        assertThat(said).containsExactly(sentence);
    }

    @ParameterizedTest
    @CsvSource({
        "'12,6', 13, '12.6 mm is taken as 13 mm: a target has whole millimetres.'",
        "12.4, 12, '12.4 mm is taken as 12 mm: a target has whole millimetres.'"
    })
    void oneBetweenIsTakenAsTheNearestAndSaidSo(String typed, int mm, String sentence) throws Exception {
        assertThat(formatter.stringToValue(typed)).isEqualTo(mm);
        assertThat(said).containsExactly(sentence);
    }

    @Test
    void whatIsNoNumberIsRefusedInOneSentence() {
        assertThatThrownBy(() -> formatter.stringToValue("large")).isInstanceOf(ParseException.class);
        assertThat(said).containsExactly("Found 'large', expected a diameter from 5 to 50 mm.");
    }
}
