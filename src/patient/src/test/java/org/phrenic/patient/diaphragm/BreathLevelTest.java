package org.phrenic.patient.diaphragm;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BreathLevelTest {
    /** There is no T13: the vertebra below T12 is L1. */
    @Test
    void aLevelThatRoundsToTheVertebraBelowT12IsNamedAsThat() {
        assertThat(new BreathLevel(BreathLevel.Mark.DOMES, 12.97, 12.94, 0, 0, 0).stated())
                .isEqualTo("the domes at L1.0 on the right and T12.9 on the left (T8 and T9 at end-expiration)");
        assertThat(new BreathLevel(BreathLevel.Mark.DOMES, 9.37, 13.5, 0, 0, 0).stated())
                .contains("T9.4 on the right", "L1.5 on the left");
    }
}
