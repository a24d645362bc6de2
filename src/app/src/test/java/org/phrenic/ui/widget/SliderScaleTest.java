package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.model.material.TissueMass;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;

class SliderScaleTest {
    private static SliderScale scaleOf(Parameter parameter) {
        double usual = Materials.PHYSICAL.defaultOf(parameter, Scenario.defaults());
        return SliderScale.of(
                parameter.minimum(),
                parameter.maximum(),
                Double.isNaN(usual) ? Materials.PAPER.defaultOf(parameter, Scenario.defaults()) : usual);
    }

    @ParameterizedTest
    @MethodSource("org.phrenic.model.material.Materials#parameters")
    void everyPlaceOfTheSliderIsTheOneItsValueGoesBackTo(Parameter parameter) {
        SliderScale scale = scaleOf(parameter);
        double before = Double.NEGATIVE_INFINITY;
        for (int place = 0; place <= SliderScale.POSITIONS; place++) {
            double value = scale.valueAt(place);
            assertThat(value)
                    .isBetween(parameter.minimum(), parameter.maximum())
                    .isGreaterThan(before);
            assertThat(scale.positionOf(value)).isEqualTo(place);
            before = value;
        }
        assertThat(scale.valueAt(0)).isEqualTo(parameter.minimum());
        assertThat(scale.valueAt(SliderScale.POSITIONS)).isEqualTo(parameter.maximum());
    }

    @Test
    void wideRangesAreLogarithmic() {
        assertThat(scaleOf(SheetSprings.MUSCLE_STIFFNESS).isLogarithmic()).isTrue();
        assertThat(scaleOf(SheetSprings.MUSCLE_STIFFNESS).positionOf(300)).isEqualTo(SliderScale.POSITIONS / 2);
        assertThat(scaleOf(Muscle.LEFT_OVER_RIGHT).isLogarithmic()).isFalse();
        SliderScale step = SliderScale.of(1e-5, 0.1, 0.001);
        assertThat(step.positionOf(1e-3)).isEqualTo(SliderScale.POSITIONS / 2);
    }

    @Test
    void aSmallValueInUseOfARangeFromZeroCanBeReached() {
        // Damping of the paper: 0.02 of 0 to 100; on a linear slider it would be all but zero.
        SliderScale damping = scaleOf(TissueMass.DAMPING);
        assertThat(damping.valueAt(0)).isZero();
        assertThat(damping.positionOf(0.02)).isBetween(100, 300);
        assertThat(damping.valueAt(damping.positionOf(0.02))).isCloseTo(0.02, withPercentage(2));
    }

    @Test
    void whatIsOutOfRangeStandsAtTheEnd() {
        SliderScale scale = SliderScale.of(2, 150, 15);
        assertThat(scale.positionOf(-5)).isZero();
        assertThat(scale.positionOf(1e6)).isEqualTo(SliderScale.POSITIONS);
    }
}
