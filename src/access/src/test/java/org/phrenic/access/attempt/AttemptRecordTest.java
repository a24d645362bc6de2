package org.phrenic.access.attempt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.breathing.RespiratoryPhase;

/** What is told of an attempt with several samples of a ball of 20 mm, 90 mm from the entry. */
class AttemptRecordTest {
    private static final double AT_ONCE = 1e6;
    private static final double FRAME_S = 0.02;

    /** A record with samples at these depths on a line through the middle of the target. */
    private static AttemptRecord record(double... depthsMm) {
        BoxAnatomy body = new BoxAnatomy();
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        NeedleInsertion needle = new NeedleInsertion(scene, target, Needle.standard(), NoGoZone.defaults());
        needle.update(body.still(0), RespiratoryPhase.PAUSE);
        needle.place(new double[] {0, 0, -20}, needle.targetNow());
        for (int i = 0; i < depthsMm.length; i++) {
            needle.advance(depthsMm[i], AT_ONCE);
            needle.update(body.still((i + 1) * FRAME_S), RespiratoryPhase.PAUSE);
            needle.sample();
        }
        return needle.record();
    }

    @Test
    void ofSeveralSamplesTheNearestThatHitIsTold() {
        AttemptRecord record = record(60, 84, 88, 70);
        assertThat(record.verdict()).isEqualTo("Hit in 2 of 4 samples");
        assertThat(record.whichSample()).isEqualTo("in the nearest that hit, ");
        assertThat(record.decisive().orElseThrow().hit()).isTrue();
        assertThat(record.decisive().orElseThrow().distanceMm()).isCloseTo(2, within(1e-3));
    }

    @Test
    void ofSeveralSamplesThatMissedTheLastIsTold() {
        AttemptRecord record = record(70, 60);
        assertThat(record.verdict()).isEqualTo("Missed in 2 samples");
        assertThat(record.whichSample()).isEqualTo("in the last, ");
        assertThat(record.decisive().orElseThrow().distanceMm()).isCloseTo(30, within(1e-3));
    }

    @Test
    void oneSampleIsToldAloneAndNoneIsSaid() {
        assertThat(record(88).verdict()).isEqualTo("Hit");
        assertThat(record(60).verdict()).isEqualTo("Missed");
        assertThat(record(60).whichSample()).isEmpty();
        assertThat(record().verdict()).isEqualTo("No sample");
        assertThat(record().decisive()).isEmpty();
    }

    /** The keys of a report: a hit by any sample, the errors of the last. */
    @Test
    void theReportCountsAHitOfAnySampleAndHasTheErrorsOfTheLast() {
        assertThat(record(88, 70).headlines())
                .containsEntry("hit", true)
                .hasEntrySatisfying(
                        "axial_error_mm", mm -> assertThat((double) mm).isCloseTo(20, within(1e-3)));
    }
}
