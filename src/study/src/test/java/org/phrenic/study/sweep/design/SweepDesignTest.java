package org.phrenic.study.sweep.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.study.sweep.design.FactorLevels.Spacing;

/** Each design has the property for which it is used. */
class SweepDesignTest {
    @Test
    void aGridHasAllCombinationsWithTheLastFactorFastest() {
        double[][] points =
                new FullGrid(List.of(new FactorLevels(2, Spacing.LISTED), new FactorLevels(3, Spacing.ENDS))).points();
        assertThat(points)
                .isDeepEqualTo(new double[][] {{0.25, 0}, {0.25, 0.5}, {0.25, 1}, {0.75, 0}, {0.75, 0.5}, {0.75, 1}});
    }

    @Test
    void aLatinHypercubeHasOnePointInEachIntervalOfEachFactor() {
        int n = 17;
        double[][] points = new LatinHypercube(4, n, 3).points();
        for (int f = 0; f < 4; f++) {
            int factor = f;
            assertThat(Arrays.stream(points)
                            .mapToInt(u -> (int) (u[factor] * n))
                            .sorted()
                            .toArray())
                    .isEqualTo(java.util.stream.IntStream.range(0, n).toArray());
        }
        assertThat(new LatinHypercube(4, n, 3).points()).isDeepEqualTo(points);
        assertThat(new LatinHypercube(4, n, 4).points()[0]).isNotEqualTo(points[0]);
    }

    @Test
    void eachMixedPointOfSaltellisSamplingHasOneCoordinateOfB() {
        int k = 5;
        double[][] points = new SaltelliDesign(k, 16, 1).points();
        assertThat(points).hasDimensions(16 * (k + 2), k);
        for (int s = 0; s < 16; s++) {
            double[] a = points[s * (k + 2)];
            double[] b = points[s * (k + 2) + 1];
            for (int f = 0; f < k; f++) {
                double[] expected = a.clone();
                expected[f] = b[f];
                assertThat(points[s * (k + 2) + 2 + f]).isEqualTo(expected);
                assertThat(a[f]).isBetween(0.0, 1.0).isNotEqualTo(b[f]);
            }
        }
    }

    /** A Sobol' sequence of 2^m points has equally many in each half of each coordinate; a shift changes few. */
    @Test
    void theRowsOfAAreEvenlySpread() {
        double[][] points = new SaltelliDesign(3, 64, 2).points();
        for (int f = 0; f < 3; f++) {
            double sum = 0;
            for (int s = 0; s < 64; s++) {
                sum += points[s * 5][f];
            }
            assertThat(sum / 64).isBetween(0.48, 0.52);
        }
    }

    /** The index of a factor is right only if its columns in A and B have nothing in common. */
    @ParameterizedTest
    @ValueSource(ints = {3, 6, 15})
    void theColumnsOfAFactorAreNotCorrelated(int k) {
        double[][] points = new SaltelliDesign(k, 64, 1).points();
        for (int f = 0; f < k; f++) {
            double sum = 0;
            for (int s = 0; s < 64; s++) {
                sum += (points[s * (k + 2)][f] - 0.5) * (points[s * (k + 2) + 1][f] - 0.5);
            }
            assertThat(12 * sum / 64).isBetween(-0.2, 0.2);
        }
    }

    @Test
    void aMorrisTrajectoryMovesEachFactorOnceByTheStepAndStaysOnTheGrid() {
        List<FactorLevels> four = Collections.nCopies(6, new FactorLevels(4, Spacing.ENDS));
        double[][] points = new MorrisDesign(four, 10, 5).points();
        assertThat(points).hasDimensions(70, 6);
        for (int t = 0; t < 10; t++) {
            double[] moved = new double[6];
            for (int p = 1; p <= 6; p++) {
                for (int f = 0; f < 6; f++) {
                    moved[f] += Math.abs(points[t * 7 + p][f] - points[t * 7 + p - 1][f]);
                    assertThat(points[t * 7 + p][f]).isBetween(0.0, 1.0);
                }
            }
            assertThat(moved)
                    .containsExactly(
                            new double[] {2 / 3.0, 2 / 3.0, 2 / 3.0, 2 / 3.0, 2 / 3.0, 2 / 3.0},
                            org.assertj.core.api.Assertions.within(1e-15));
        }
        assertThatThrownBy(() -> new MorrisDesign(List.of(new FactorLevels(3, Spacing.ENDS)), 1, 0))
                .hasMessageContaining("an even number");
    }

    /** Levels at the ends would be a distribution's limits, and three values between them would not be alike. */
    @Test
    void aMorrisTrajectoryReachesListedValuesAndMiddlesEquallyOften() {
        List<FactorLevels> factors = List.of(new FactorLevels(4, Spacing.MIDDLES), new FactorLevels(3, Spacing.LISTED));
        double[][] points = new MorrisDesign(factors, 4000, 5).points();
        for (int f = 0; f < 2; f++) {
            int factor = f;
            int n = factors.get(f).count();
            int[] times = new int[n];
            Arrays.stream(points).forEach(u -> times[(int) (u[factor] * n)]++);
            assertThat(Arrays.stream(times).boxed())
                    .allSatisfy(t -> assertThat((double) t * n / points.length).isBetween(0.95, 1.05));
            assertThat(Arrays.stream(points).map(u -> u[factor] * n - 0.5))
                    .allSatisfy(level -> assertThat(level % 1).isZero());
        }
        for (int p = 0; p < points.length; p += 3) {
            assertThat(points[p + 2][1]).isNotEqualTo(points[p][1]);
            assertThat(Math.abs(points[p + 2][0] - points[p][0])).isEqualTo(0.5);
        }
    }
}
