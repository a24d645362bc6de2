package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BreathEventTest {
    @Test
    void anEventHasTheNumberOfItsBreathOrNone() {
        assertThat(BreathEvent.parse("end-expiration of breath 3").breath()).hasValue(3);
        assertThat(BreathEvent.parse(" hold ").breath()).isEmpty();
    }

    /** Breaths are numbered from 1. */
    @ParameterizedTest
    @ValueSource(
            strings = {"hold of breath 0", "hold of breath -1", "hold of breath", "sigh", "hold of breath 12345678"})
    void whatIsNoEventIsRefusedWithWhatIsExpected(String text) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BreathEvent.parse(text))
                .withMessageContaining("found '" + text + "', expected seconds or one of");
    }
}
