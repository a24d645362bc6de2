package org.phrenic.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ConsoleProgressTest {
    private static final long SECOND = 1_000_000_000L;

    @Test
    void timeLeftIsTheMeanTimeOfAnItemForEachThatIsLeft() {
        assertThat(ConsoleProgress.timeLeft(30 * SECOND, 3, 7)).isEqualTo(" (about 40 s left)");
        assertThat(ConsoleProgress.timeLeft(660 * SECOND, 3, 182)).isEqualTo(" (about 656 min left)");
    }

    /** 900 of 1000 were done before. */
    @Test
    void whatWasDoneBeforeTookNoTimeOfThisProcess() {
        assertThat(ConsoleProgress.timeLeft(10 * SECOND, 901 - 900, 1000 - 900)).isEqualTo(" (about 17 min left)");
    }

    @Test
    void nothingIsEstimatedFromTheFirstSecondsNorAfterTheLastItem() {
        assertThat(ConsoleProgress.timeLeft(9 * SECOND, 3, 7)).isEmpty();
        assertThat(ConsoleProgress.timeLeft(60 * SECOND, 7, 7)).isEmpty();
    }
}
