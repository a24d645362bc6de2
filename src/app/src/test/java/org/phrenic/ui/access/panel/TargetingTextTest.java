package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.phrenic.access.attempt.TargetingError;

/** An axial error is positive where the middle of the target lies deeper than the tip. */
class TargetingTextTest {
    private static final TargetingError SHORT = new TargetingError(12, 5, false, OptionalDouble.empty());
    private static final TargetingError DEEP = new TargetingError(-12, 5, false, OptionalDouble.empty());

    @Test
    void theNeedlePanelSaysHowFarThereIsToGo() {
        assertThat(NeedlePanel.text(SHORT)).isEqualTo("Tip to target 13.0 mm: 12.0 to go, 5.0 aside");
        assertThat(NeedlePanel.text(DEEP)).isEqualTo("Tip to target 13.0 mm: 12.0 too deep, 5.0 aside");
    }

    @Test
    void theCardSaysWhetherTheSampleWasShortOrDeep() {
        assertThat(ReportCard.place(SHORT)).contains("13.0 mm from the middle", "12.0 mm short of it, 5.0 mm aside");
        assertThat(ReportCard.place(DEEP)).contains("12.0 mm too deep, 5.0 mm aside");
    }
}
