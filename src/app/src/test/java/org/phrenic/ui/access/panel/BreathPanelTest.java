package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.access.plan.BreathEvent;

/** Which hold the buttons show. */
class BreathPanelTest {
    private static final Optional<BreathEvent.Kind> EXPIRATION = Optional.of(BreathEvent.Kind.END_EXPIRATION);
    private static final Optional<BreathEvent.Kind> INSPIRATION = Optional.of(BreathEvent.Kind.END_INSPIRATION);

    @Test
    void aHoldIsShownWhileItWaitsAndWhileItLasts() {
        assertThat(BreathPanel.endOfHold("end-expiration", false, Optional.empty()))
                .isEqualTo(EXPIRATION);
        assertThat(BreathPanel.endOfHold("", true, EXPIRATION)).isEqualTo(EXPIRATION);
        assertThat(BreathPanel.endOfHold("", false, EXPIRATION)).isEmpty();
    }

    @Test
    void aHoldAtTheOtherEndTakesTheFormersPlace() {
        assertThat(BreathPanel.endOfHold("end-inspiration", true, EXPIRATION)).isEqualTo(INSPIRATION);
    }

    @Test
    void aHoldElsewhereIsAtNoEnd() {
        assertThat(BreathPanel.endOfHold("", true, Optional.empty())).isEmpty();
    }
}
