package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.phrenic.access.attempt.TargetingError;

class RehearsalReportTest {
    /** The tip 3 mm beyond the middle of the target and 4 mm beside it. */
    @Test
    void theHeadlineTellsWhatIsAlongTheNeedleFromWhatIsAside() {
        TargetingError sample = new TargetingError(-3, 4, true, OptionalDouble.empty());
        assertThat(RehearsalReport.place(sample)).isEqualTo("-3.0 mm along the needle, 4.0 mm aside");
    }
}
