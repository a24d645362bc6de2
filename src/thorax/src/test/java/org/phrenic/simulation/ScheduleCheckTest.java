package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatNoException;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/** Changes of a scenario that are refused before it runs, which takes long. */
class ScheduleCheckTest {
    private static Scenario changed(String setting, String... changes) {
        return Scenario.defaults()
                .with("duration_s=60", setting)
                .withChanges(Arrays.stream(changes).map(ScheduledChange::parse).toList());
    }

    /** A sniff rests for 0.7 of its period, and a cough takes 0.15 of it and 1 s. */
    @ParameterizedTest
    @CsvSource({
        "inspiratory_fraction=0.4, 40000:preset=sniff, preset sniff with inspiratory_fraction 0.4",
        "preset=cough, 4000:rate_per_min=60, preset cough with rate_per_min 60"
    })
    void aChangeThatGivesAnImpossibleBreathIsNamed(String setting, String change, String breath) {
        Scenario impossible = changed(setting, "10:depth=0.9", change);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> ScheduleCheck.require(impossible))
                .withMessageStartingWith("--change " + change + ": " + breath + ": ")
                .withMessageContaining("expected");
    }

    @Test
    void theChangesOfOneStepAreMadeTogether() {
        assertThatNoException()
                .isThrownBy(() -> ScheduleCheck.require(
                        changed("inspiratory_fraction=0.4", "9:preset=sniff", "9:inspiratory_fraction=0.2")));
    }
}
