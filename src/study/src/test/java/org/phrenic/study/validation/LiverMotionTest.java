package org.phrenic.study.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.PresetRun;

/** Numbers of the liver's motion from breaths whose curves are made up. */
class LiverMotionTest {
    private static final List<String> COLUMNS = List.of(
            "breath",
            "dome_right_mm",
            "dome_left_mm",
            "liver_si_mm",
            "liver_ap_mm",
            "liver_lr_mm",
            "liver_top_mm",
            "liver_edge_mm");

    /** A breath of 12 mm; then, if asked, a hold at a height that creeps up by 1 mm a second. */
    private static BreathSeries breath(double heldAt, int heldSamples) {
        List<double[]> rows = new ArrayList<>();
        List<RespiratoryPhase> labels = new ArrayList<>();
        for (int i = 0; i <= 40; i++) {
            double down = -12 * Math.sin(Math.PI * i / 40);
            rows.add(row(0, down));
            labels.add(i < 20 ? RespiratoryPhase.INSPIRATION : RespiratoryPhase.EXPIRATION);
        }
        for (int i = 0; i < heldSamples; i++) {
            rows.add(row(1, heldAt + i * PresetRun.SAMPLE_S));
            labels.add(RespiratoryPhase.HOLD);
        }
        return new BreathSeries(COLUMNS, rows, labels);
    }

    /** The liver goes down by less than the right dome, forward and to the side. */
    private static double[] row(double number, double down) {
        return new double[] {number, down, 0.8 * down, 0.9 * down, 0.3 * down, 0.1 * down, 0.95 * down, 0.65 * down};
    }

    @Test
    void aFreeBreathIsMeasuredFromItsStartToWhereItIsDeepest() {
        LiverMotion.Row row = LiverMotion.row("a body", "quiet", breath(0, 0), PhysiologyTable.shipped());
        assertThat(row.comparedValues()).usingComparatorWithPrecision(1e-9).startsWith(10.8, 3.6, 1.2);
        assertThat(row.domeMm()).isCloseTo(12, within(1e-9));
        assertThat(row.topMm()).isCloseTo(11.4, within(1e-9));
        assertThat(row.edgeMm()).isCloseTo(7.8, within(1e-9));
        assertThat(row.liverCreepMm()).isNaN();
        LiverMotion motion = new LiverMotion(List.of(row), List.of());
        assertThat(motion.outOfRangeCount()).isZero();
        assertThat(motion.table().get(1)).contains("10.8 (5.1 - 17.3)", "3.60 (0.9 - 7.7)", "1.20 (0.4 - 4)");
    }

    /** As large as that of people who go forward, it is none of theirs. */
    @Test
    void aWayBackIsNegativeAndOutOfTheRangeOfWaysForward() {
        BreathSeries forward = breath(0, 0);
        int ap = COLUMNS.indexOf("liver_ap_mm");
        List<double[]> rows = new ArrayList<>();
        List<RespiratoryPhase> labels = new ArrayList<>();
        for (int i = 0; i <= forward.lastRow(0); i++) {
            int at = i;
            double[] row =
                    COLUMNS.stream().mapToDouble(c -> forward.value(c, at)).toArray();
            row[ap] = -row[ap];
            rows.add(row);
            labels.add(i < 20 ? RespiratoryPhase.INSPIRATION : RespiratoryPhase.EXPIRATION);
        }
        LiverMotion.Row row =
                LiverMotion.row("a body", "quiet", new BreathSeries(COLUMNS, rows, labels), PhysiologyTable.shipped());
        assertThat(row.apMm()).isCloseTo(-3.6, within(1e-9));
        assertThat(new LiverMotion(List.of(row), List.of()).outOfRangeCount()).isOne();
    }

    /**
     * At expiration the breath before is measured; of the hold of 10 s the first second does not count, so 1 mm a
     * second makes 9.
     */
    @Test
    void ofAHoldAtExpirationTheBreathBeforeAndTheCreepAreMeasured() {
        BreathSeries series = breath(0, 201);
        LiverMotion.Row row = LiverMotion.row("a body", "hold-expiration", series, PhysiologyTable.shipped());
        assertThat(row.comparedValues()).usingComparatorWithPrecision(1e-9).containsExactly(10.8, 3.6, 1.2, 9);
        assertThat(row.liverCreepMm()).isCloseTo(8.1, within(1e-9));
        // No creep is known at expiration; at inspiration 9 mm is more than in anybody.
        LiverMotion motion = new LiverMotion(
                List.of(row, LiverMotion.row("a body", "hold-inspiration", series, PhysiologyTable.shipped())),
                List.of());
        assertThat(row.referenceRanges().get(3)).isEmpty();
        assertThat(motion.table().get(2)).contains("9.00 (0 - 5.6) OUT");
        assertThat(motion.values()).containsEntry("outside", motion.outOfRangeCount());
    }

    /** A liver that is not there has not moved by 0 mm, which would be out of every range. */
    @Test
    void aLiverThatIsNotThereIsNeitherWithinNorOut() {
        List<String> unknown =
                COLUMNS.stream().filter(c -> c.startsWith("liver")).toList();
        LiverMotion.Row row =
                LiverMotion.row("a body", "quiet", breath(0, 0).withUnknown(unknown), PhysiologyTable.shipped());
        LiverMotion motion = new LiverMotion(List.of(row), List.of());
        assertThat(motion.outOfRangeCount()).isZero();
        assertThat(motion.table().get(1).subList(2, 5)).containsOnly("");
        assertThat(motion.table().get(1)).contains("12.0");
        assertThat(MarkdownPage.format(motion.document(Scenario.defaults(), List.of())))
                .doesNotContain("NaN", "OUT");
        assertThat(motion.values().toString()).doesNotContain("NaN");
    }

    /** A check of nothing is no passed check. */
    @Test
    void aBodyWithoutALiverIsRefusedBeforeItBreathes() {
        Scenario without = Scenario.defaults().with("resolution=low", "liver=false");
        PhysiologyTable table = PhysiologyTable.shipped();
        assertThatThrownBy(() -> LiverMotion.of(table, without, List.of("virtual/adult-male"), 1, (c, t, w) -> {}))
                .isInstanceOf(BadInputException.class)
                .hasMessage("found no liver in virtual/adult-male, expected a body with a liver, and liver=true");
    }

    @Test
    void aBreathThatFailedIsNamedAndFailsTheStudy() {
        LiverMotion.Row row = LiverMotion.row("a body", "quiet", breath(0, 0), PhysiologyTable.shipped());
        LiverMotion motion = new LiverMotion(List.of(row), List.of("a body, deep: diverged"));
        assertThat(motion.passes()).isFalse();
        assertThat(motion.values()).containsEntry("failures", motion.failures());
        assertThat(MarkdownPage.format(motion.document(Scenario.defaults(), List.of("Commit 1"))))
                .contains("## Not computed", "- a body, deep: diverged.");
    }

    /** The liver goes forward by a third of its descent, and its top goes down by 0.95 of the dome's. */
    @Test
    void thePageStatesExcursionsSharesAndTheSourcesOfTheRanges() {
        LiverMotion.Row row = LiverMotion.row("a body", "quiet", breath(0, 0), PhysiologyTable.shipped());
        String page = MarkdownPage.format(
                new LiverMotion(List.of(row), List.of()).document(Scenario.defaults(), List.of("Commit 1")));
        assertThat(page)
                .contains("At medium resolution; values out of their range: 0.", "- Commit 1", Disclaimer.TEXT)
                .contains("| a body | quiet | 0.33 | 0.95 |", "liver\\_si\\_quiet: 5.1 - 17.3 mm", "PMC5978939");
    }
}
