package org.phrenic.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class HarmonicFieldTest {
    private static final double SOLVED = 1e-7;

    @Test
    void betweenTheRimsOfATubeItRisesEvenlyAndItsGradientRunsAlongTheAxis() {
        double height = 12;
        int around = 20;
        int along = 10;
        TriangleMesh tube = Shapes.tube(3, height, around, along);
        int[] fixed = new int[2 * around];
        double[] given = new double[2 * around];
        for (int i = 0; i < around; i++) {
            fixed[2 * i] = i * (along + 1);
            fixed[2 * i + 1] = i * (along + 1) + along;
            given[2 * i + 1] = 1;
        }
        HarmonicField field = HarmonicField.solve(tube, new MeshTopology(tube), fixed, given);
        // The weights of a right-angled triangle's hypotenuse are zero but for their floor of 1e-3, by symmetry without
        // effect.
        for (int v = 0; v < tube.vertexCount(); v++) {
            assertThat(field.values()[v]).isCloseTo(tube.z(v) / height, within(SOLVED));
        }
        double[] gradients = field.gradients();
        for (int t = 0; t < tube.triangleCount(); t++) {
            assertThat(gradients[3 * t]).isCloseTo(0, within(SOLVED));
            assertThat(gradients[3 * t + 1]).isCloseTo(0, within(SOLVED));
            assertThat(gradients[3 * t + 2]).isCloseTo(1 / height, within(SOLVED));
        }
    }

    @Test
    void onASphereBetweenTwoCapsItIsTheLogarithmOfTheHalfAnglesTangent() {
        TriangleMesh sphere = Shapes.sphere(10, 5);
        int count = sphere.vertexCount();
        int[] caps = java.util.stream.IntStream.range(0, count)
                .filter(v -> Math.abs(sphere.z(v)) > 8)
                .toArray();
        double[] exact = new double[count];
        for (int v = 0; v < count; v++) {
            // On the unit sphere, artanh(cos theta) = -ln tan(theta / 2) solves Laplace's equation away from the poles.
            double c = Math.max(-0.999, Math.min(0.999, sphere.z(v) / 10));
            exact[v] = 0.5 * Math.log((1 + c) / (1 - c));
        }
        double[] given =
                java.util.Arrays.stream(caps).mapToDouble(v -> exact[v]).toArray();
        HarmonicField field = HarmonicField.solve(sphere, new MeshTopology(sphere), caps, given);
        for (int v = 0; v < count; v++) {
            assertThat(field.values()[v]).isCloseTo(exact[v], within(2e-3));
        }
    }

    @Test
    void itKeepsWithinWhatIsGivenAndRepeatsToTheBit() {
        TriangleMesh torus = Shapes.torus(10, 3, 40, 20);
        MeshTopology topology = new MeshTopology(torus);
        int[] fixed = {0, 399, 555};
        double[] given = {-1, 2, 0.5};
        double[] first = HarmonicField.solve(torus, topology, fixed, given).values();
        assertThat(HarmonicField.solve(torus, topology, fixed, given).values()).containsExactly(first);
        for (double value : first) {
            assertThat(value).isBetween(-1 - SOLVED, 2 + SOLVED);
        }
    }

    @Test
    void valuesWithoutVerticesAreRefused() {
        TriangleMesh box = Shapes.box(1, 1, 1);
        assertThatThrownBy(() -> HarmonicField.solve(box, new MeshTopology(box), new int[] {1}, new double[2]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("1 fixed vertices and 2 values");
    }
}
