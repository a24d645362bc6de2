package org.phrenic.engine.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class SaturatingAmplitudeTest {
    private static final Offset<Double> ROUNDING = Offset.offset(1e-14);
    private static final Offset<Double> DIFFERENCED = Offset.offset(1e-6);

    private final SaturatingAmplitude amplitude = SaturatingAmplitude.DEFAULT;

    @Test
    void itGoesFromRestToTheFullTurn() {
        assertThat(amplitude.at(0)).isZero();
        assertThat(amplitude.at(1)).isCloseTo(1, ROUNDING);
    }

    /** (1 - e^-1) / (1 - e^-2) = 0.7311: most of the turn comes in the first half, as Beyer 2016 measured. */
    @Test
    void mostOfTheTurnComesInTheFirstHalf() {
        assertThat(amplitude.at(0.5)).isCloseTo(0.7311, Offset.offset(1e-4));
    }

    @Test
    void volumeIsTheInverse() {
        for (double turn : new double[] {-0.2, 0, 1.0 / 6, 0.5, 1}) {
            assertThat(amplitude.at(amplitude.volume(turn))).isCloseTo(turn, ROUNDING);
        }
        assertThatThrownBy(() -> amplitude.volume(1.1))
                .hasMessage("saturating amplitude: turn 1.1, expected at most 1");
    }

    @Test
    void slopeIsTheDerivativeAndContinuousAtRest() {
        double h = 1e-6;
        for (double v : new double[] {-0.3, -h, 0, h, 0.2, 1, 1.1}) {
            double difference = (amplitude.at(v + h) - amplitude.at(v - h)) / (2 * h);
            assertThat(amplitude.slope(v)).isCloseTo(difference, Offset.offset(1e-5));
        }
        assertThat(amplitude.slope(-1e-9)).isCloseTo(amplitude.slope(1e-9), DIFFERENCED);
    }

    @Test
    void constantsThatAreNoneAreRefused() {
        assertThatThrownBy(() -> new SaturatingAmplitude(0))
                .hasMessage("saturating amplitude: constant 0.0, expected a number above 0");
    }
}
