package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

class ObservableRowsTest {
    private static final long TWO_GB = 2L << 30;

    /** Which it would find out after hours otherwise. */
    @ParameterizedTest
    @ValueSource(strings = {"duration_s=86400", "steps=69120000"})
    void aRunWhoseRowsDoNotFitIsRefusedBeforeItBegins(String length) {
        Scenario day = Scenario.defaults().with(length).with("record_every_s=0.01");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> ObservableRows.require(day, TWO_GB))
                .withMessage("record_every_s: found 0.01 s, with 8640001 rows of observables, expected no more than fit"
                        + " into Java's memory of 2048 MB (java -Xmx8g gives it 8 GB)");
        assertThatCode(() -> ObservableRows.require(day, 4 * TWO_GB)).doesNotThrowAnyException();
        assertThatCode(() -> ObservableRows.require(day.with("record_every_s=0.1"), TWO_GB))
                .doesNotThrowAnyException();
    }

    @Test
    void theUsualRunFits() {
        assertThatCode(() -> ObservableRows.require(Scenario.defaults(), 256L << 20))
                .doesNotThrowAnyException();
    }
}
