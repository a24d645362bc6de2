package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers in charts and fields are those of the files, in every locale. */
@Isolated
class NumberLocaleTest {
    private Locale before;

    @BeforeEach
    void remember() {
        before = Locale.getDefault(Locale.Category.FORMAT);
    }

    @AfterEach
    void restore() {
        Locale.setDefault(Locale.Category.FORMAT, before);
    }

    @ParameterizedTest
    @ValueSource(strings = {"de-DE", "ar-EG", "hi-IN-u-nu-deva", "tr-TR", "th-TH-u-nu-thai"})
    void numbersHaveAPointAndPlainDigits(String tag) {
        Locale.setDefault(Locale.Category.FORMAT, Locale.forLanguageTag(tag));
        Phrenic.writeNumbersAsInFiles();

        assertThat(new NumberTickUnitSource().getCeilingTickUnit(0.5).valueToString(1.5))
                .isEqualTo("1.5");
        JSpinner field = new JSpinner(new SpinnerNumberModel(2.5, 0, 5, 0.5));
        assertThat(((JSpinner.DefaultEditor) field.getEditor()).getTextField().getText())
                .isEqualTo("2.5");
        assertThat(String.format("%.1f", 1.5)).isEqualTo("1.5");
    }
}
