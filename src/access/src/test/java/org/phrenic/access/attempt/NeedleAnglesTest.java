package org.phrenic.access.attempt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.mesh.Vectors;

class NeedleAnglesTest {
    /** However steep the needle stands, it leans aside by the tilt, and the two directions are at a right angle. */
    @ParameterizedTest
    @CsvSource({"0, 0", "30, 45", "-170, 60", "90, -75", "10, 88"})
    void aNeedleIsTiltedByAsMuchAsIsSaid(double axialDeg, double cranialDeg) {
        NeedleAngles angles = new NeedleAngles(axialDeg, cranialDeg);
        double[] from = angles.direction();
        double[] level = angles.tilted(3, 0).direction();
        double[] head = angles.tilted(0, 3).direction();
        double[] both = angles.tilted(3, -4).direction();
        assertThat(Vectors.angleDeg(from, level)).isCloseTo(3, within(1e-9));
        assertThat(Vectors.angleDeg(from, head)).isCloseTo(3, within(1e-9));
        assertThat(Vectors.angleDeg(from, both)).isCloseTo(5, within(1e-9));
        assertThat(level[2]).as("level").isCloseTo(from[2] * StrictMath.cos(StrictMath.toRadians(3)), within(1e-12));
        assertThat(Vectors.dot(Vectors.subtract(level, from), Vectors.subtract(head, from)))
                .as("at a right angle but for the bend of the sphere")
                .isCloseTo(0, within(1e-5));
    }

    @Test
    void aTiltGoesWhereATurnOfTheSameSignGoes() {
        NeedleAngles back = new NeedleAngles(0, 0);
        assertThat(back.tilted(3, 0).axialDeg()).isCloseTo(back.turned(3, 0).axialDeg(), within(1e-9));
        assertThat(back.tilted(0, 3).cranialDeg()).isCloseTo(back.turned(0, 3).cranialDeg(), within(1e-9));
        assertThat(back.tilted(0, 0)).isEqualTo(back);
    }
}
