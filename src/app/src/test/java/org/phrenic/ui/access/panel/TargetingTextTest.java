package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.api.Test;
import org.phrenic.access.Needle;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.ui.access.SampledAttempts;
import org.phrenic.ui.session.EventThread;

/** An axial error is positive where the middle of the target lies deeper than the tip. */
class TargetingTextTest {
    private static final TargetingError SHORT = new TargetingError(12, 5, false, 0, OptionalDouble.empty());
    private static final TargetingError DEEP = new TargetingError(-12, 5, false, 0, OptionalDouble.empty());

    @Test
    void theNeedlePanelSaysHowFarThereIsToGo() {
        assertThat(NeedlePanel.text(SHORT)).isEqualTo("Tip to target 13.0 mm");
        assertThat(NeedlePanel.parts(SHORT)).isEqualTo("12.0 mm to go, 5.0 mm aside");
        assertThat(NeedlePanel.parts(DEEP)).isEqualTo("12.0 mm too deep, 5.0 mm aside");
    }

    /** The tip of a needle that throws 20 mm is in the middle of the target. */
    @Test
    void theNeedlePanelSaysThatItMeasuresACoreFromItsMiddle() {
        TargetingError core = new TargetingError(-10, 0, true, 20, OptionalDouble.of(5));
        assertThat(NeedlePanel.text(core)).isEqualTo("Middle of the core to target 10.0 mm, 5.0 mm of the core in it");
        assertThat(NeedlePanel.parts(core)).isEqualTo("10.0 mm too deep, 0.0 mm aside");
    }

    @Test
    void theCardSaysWhetherTheSampleWasShortOrDeep() {
        assertThat(ReportCard.place(SHORT)).contains("13.0 mm from the middle", "12.0 mm short of it, 5.0 mm aside");
        assertThat(ReportCard.place(DEEP)).contains("12.0 mm too deep, 5.0 mm aside");
    }

    @Test
    void theCardTellsOfTheSampleThatHit() {
        TargetingError hit = new TargetingError(3, 4, true, 0, OptionalDouble.empty());
        assertThat(ReportCard.sampleText(SampledAttempts.record(hit, SHORT)))
                .startsWith("In the nearest that hit, the tip was 5.0 mm from");
        assertThat(ReportCard.sampleText(SampledAttempts.record(DEEP, SHORT)))
                .startsWith("In the last, the tip was 13.0 mm from");
        assertThat(ReportCard.sampleText(SampledAttempts.record(SHORT))).startsWith("The tip was 13.0 mm from");
        assertThat(ReportCard.sampleText(SampledAttempts.record())).contains("without a sample");
    }

    /** Bone has ended the core of a needle that cuts 22 mm. */
    @Test
    void theCardStatesTheCoreAsLongAsItIs() {
        for (double mm : new double[] {10.4, 22}) {
            TargetingError hit = new TargetingError(3, 4, true, mm, OptionalDouble.of(10.4));
            assertThat(ReportCard.sampleText(SampledAttempts.record(new Needle(18, 150, 22), hit)))
                    .endsWith(" Of the core of " + (mm == 22 ? "22" : "10.4") + " mm, 10.4 mm lay in it.");
        }
    }

    @Test
    void theForcesAreToldWithTheirLayer() {
        NeedleLoad load = new NeedleLoad("capsule", 1.34, 0, 0.42, 0, false);
        assertThat(NeedlePanel.text(load)).isEqualTo("1.3 N from the capsule, 0.4 N aside");
        assertThat(NeedlePanel.text(NeedleLoad.NONE)).isEmpty();
    }

    @Test
    void aNumberStaysOnTheLineOfItsUnit() {
        WrappingLabel label = WrappingLabel.normal("Measures");
        label.setTextIfChanged("The target moved 13.2 mm, below rib 9, in 4 small steps");
        assertThat(label.getText()).isEqualTo("The target moved 13.2 mm, below rib 9, in 4 small steps");
        assertThat(label.getAccessibleContext().getAccessibleName()).isEqualTo("Measures");
        String shown = EventThread.get(() -> {
            try {
                return label.getDocument().getText(0, label.getDocument().getLength());
            } catch (BadLocationException e) {
                throw new IllegalStateException(e);
            }
        });
        assertThat(shown).contains("13.2\u00a0mm", "rib\u00a09", "4 small");
    }
}
