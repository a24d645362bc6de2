package org.phrenic.access;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.TriangleMesh;

/** A sheet whose rim lies at the height 30 cos(azimuth), with a second ring above it and a dome within. */
class PleuralReflectionTest {
    private static final double X = 5;
    private static final double Y = -7;
    private static final double RADIUS = 100;
    private static final int POINTS = 36;

    private static double rim(double azimuthDeg) {
        return 30 * Math.cos(Math.toRadians(azimuthDeg));
    }

    private static TriangleMesh sheet() {
        double[] p = new double[3 * 3 * POINTS];
        double[][] rings = {{RADIUS, 0}, {0.9 * RADIUS, 40}, {0.5 * RADIUS, -60}};
        int at = 0;
        for (double[] ring : rings) {
            for (int i = 0; i < POINTS; i++) {
                double azimuth = 360 * (i + 0.5) / POINTS;
                p[at++] = X + ring[0] * Math.cos(Math.toRadians(azimuth));
                p[at++] = Y + ring[0] * Math.sin(Math.toRadians(azimuth));
                p[at++] = rim(azimuth) + ring[1];
            }
        }
        return new TriangleMesh(p, new int[] {0, 1, 2});
    }

    /** Points at 5, 15, ... degrees give the rim; between them it is a straight line. */
    @ParameterizedTest
    @ValueSource(doubles = {5, 95, 357.5, 82.5, 277.5})
    void theReflectionLies20MmAboveTheRim(double azimuthDeg) {
        PleuralReflection reflection = new PleuralReflection(sheet());
        double height = rim(azimuthDeg) + 20;
        for (double radius : new double[] {0.4 * RADIUS, RADIUS}) {
            double x = X + radius * Math.cos(Math.toRadians(azimuthDeg));
            double y = Y + radius * Math.sin(Math.toRadians(azimuthDeg));
            assertThat(reflection.isAbove(x, y, height + 1)).isTrue();
            assertThat(reflection.isAbove(x, y, height - 1)).isFalse();
        }
    }
}
