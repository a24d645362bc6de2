package org.phrenic.ui.chart;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SampleRingBufferTest {
    private static final double STEP_S = 0.02;

    private static SampleRingBuffer filled(int capacity, int samples) {
        SampleRingBuffer ring = new SampleRingBuffer(2, capacity);
        for (int i = 0; i < samples; i++) {
            ring.add(i * STEP_S, new double[] {i, -i});
        }
        return ring;
    }

    @Test
    void theOldestMakesWayForTheNewest() {
        SampleRingBuffer ring = filled(10, 25);
        assertThat(ring.size()).isEqualTo(10);
        assertThat(ring.value(0, 0)).isEqualTo(15);
        assertThat(ring.value(1, 9)).isEqualTo(-24);
        assertThat(ring.time(9)).isEqualTo(24 * STEP_S);
    }

    @Test
    void aSampleThatIsNotLaterBeginsANewRecord() {
        SampleRingBuffer ring = filled(10, 25);
        ring.add(0, new double[] {7, 7});
        assertThat(ring.size()).isOne();
        assertThat(ring.value(0, 0)).isEqualTo(7);
    }

    @Test
    void missingValuesAreNoValues() {
        SampleRingBuffer ring = new SampleRingBuffer(2, 4);
        ring.add(0, new double[] {1});
        assertThat(ring.value(1, 0)).isNaN();
        ring.set(1, 0, 3);
        assertThat(ring.value(1, 0)).isEqualTo(3);
        ring.clearColumn(1);
        assertThat(ring.value(1, 0)).isNaN();
    }

    @Test
    void aTimeIsFoundAcrossTheSeamOfTheRing() {
        SampleRingBuffer ring = filled(10, 25);
        assertThat(ring.nearest(20.3 * STEP_S)).isEqualTo(5);
        assertThat(ring.nearest(20.7 * STEP_S)).isEqualTo(6);
        assertThat(ring.nearest(-1)).isZero();
        assertThat(ring.nearest(99)).isEqualTo(9);
        assertThat(new SampleRingBuffer(1, 3).nearest(0)).isEqualTo(-1);
    }

    @Test
    void aCurveInFewPointsKeepsItsPeaksAndItsOrder() {
        SampleRingBuffer ring = new SampleRingBuffer(1, 5000);
        for (int i = 0; i < 5000; i++) {
            // One sample in five thousand stands out, up and down.
            ring.add(i * STEP_S, new double[] {i == 1234 ? 50 : i == 3456 ? -70 : Math.sin(0.01 * i)});
        }
        double[] x = new double[200];
        double[] y = new double[200];
        int count = ring.curve(0, 0, 1e9, x, y);
        assertThat(count).isEqualTo(200);
        assertThat(x).isSorted();
        assertThat(y).contains(50, -70);
    }

    @Test
    void aCurveThatFitsIsDrawnSampleBySampleWithOneBeyondEachEnd() {
        SampleRingBuffer ring = filled(100, 50);
        double[] x = new double[40];
        double[] y = new double[40];
        int count = ring.curve(0, 9.5 * STEP_S, 19.5 * STEP_S, x, y);
        assertThat(count).isEqualTo(12);
        assertThat(x[0]).isEqualTo(9 * STEP_S);
        assertThat(x[count - 1]).isEqualTo(20 * STEP_S);
    }
}
