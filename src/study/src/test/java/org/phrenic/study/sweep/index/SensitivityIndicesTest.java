package org.phrenic.study.sweep.index;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.study.sweep.design.FactorLevels;
import org.phrenic.study.sweep.design.LatinHypercube;
import org.phrenic.study.sweep.design.MorrisDesign;
import org.phrenic.study.sweep.design.SaltelliDesign;

/** Indices of functions whose indices follow by hand. */
class SensitivityIndicesTest {
    private static final Bootstrap FEW = new Bootstrap(200, 1);

    /** y = 3 u1 + u2 has first-order and total indices 9/10 and 1/10; u3 has none. */
    @Test
    void aSumHasItsSharesOfVarianceAsFirstAndTotalIndices() {
        double[] y = Arrays.stream(new SaltelliDesign(3, 512, 7).points())
                .mapToDouble(u -> 100 + 3 * u[0] + u[1])
                .toArray();
        SobolIndices indices = SobolIndices.of(y, 3, FEW);
        double[] expected = {0.9, 0.1, 0};
        for (int f = 0; f < 3; f++) {
            assertThat(indices.first().get(f).value()).isCloseTo(expected[f], within(0.02));
            assertThat(indices.total().get(f).value()).isCloseTo(expected[f], within(0.02));
            for (Estimate index :
                    List.of(indices.first().get(f), indices.total().get(f))) {
                assertThat(expected[f]).isBetween(index.low(), index.high());
            }
        }
        assertThat(indices.samples()).isEqualTo(512);
    }

    /** y = (u1 - 1/2)(u2 - 1/2) is interaction alone: first order 0, total 1. */
    @Test
    void aProductHasNoFirstOrderButAllOfTheTotalIndices() {
        double[] y = Arrays.stream(new SaltelliDesign(2, 1024, 7).points())
                .mapToDouble(u -> (u[0] - 0.5) * (u[1] - 0.5))
                .toArray();
        SobolIndices indices = SobolIndices.of(y, 2, FEW);
        for (int f = 0; f < 2; f++) {
            assertThat(indices.first().get(f).value()).isCloseTo(0, within(0.05));
            assertThat(indices.total().get(f).value()).isCloseTo(1, within(0.08));
        }
    }

    @Test
    void aFailedRunTakesItsSampleAlone() {
        double[][] points = new SaltelliDesign(2, 64, 1).points();
        double[] y = Arrays.stream(points).mapToDouble(u -> u[0]).toArray();
        y[5] = Double.NaN;
        y[6] = Double.NaN;
        y[200] = Double.NaN;
        SobolIndices indices = SobolIndices.of(y, 2, FEW);
        assertThat(indices.samples()).isEqualTo(62);
        assertThat(indices.left()).isEqualTo(2);
        assertThat(indices.first().get(0).value()).isCloseTo(1, within(0.05));
    }

    /** Elementary effects of a linear function are its coefficients, without scatter. */
    @Test
    void elementaryEffectsOfALinearFunctionAreItsCoefficients() {
        FactorLevels four = new FactorLevels(4, FactorLevels.Spacing.ENDS);
        double[][] points = new MorrisDesign(List.of(four, four, four), 8, 9).points();
        double[] y =
                Arrays.stream(points).mapToDouble(u -> 5 - 2 * u[0] + 4 * u[1]).toArray();
        y[2] = Double.NaN;
        double[][] changes = new double[points.length][3];
        for (int p = 1; p < points.length; p++) {
            for (int f = 0; f < 3; f++) {
                changes[p][f] = points[p][f] - points[p - 1][f];
            }
        }
        MorrisEffects effects = MorrisEffects.of(changes, y, FEW);
        double[] expected = {-2, 4, 0};
        for (int f = 0; f < 3; f++) {
            assertThat(effects.mu().get(f).value()).isCloseTo(expected[f], within(1e-12));
            assertThat(effects.muStar().get(f).value()).isCloseTo(Math.abs(expected[f]), within(1e-12));
            assertThat(effects.sigma().get(f).value()).isCloseTo(0, within(1e-12));
        }
    }

    @Test
    void aResponseCurveFollowsItsFactorAndNotTheOthers() {
        double[][] points = new LatinHypercube(2, 400, 1).points();
        double[] y = Arrays.stream(points).mapToDouble(u -> 10 * u[0]).toArray();
        y[17] = Double.NaN;
        ResponseCurve steep =
                ResponseCurve.of(Arrays.stream(points).mapToDouble(u -> u[0]).toArray(), y);
        ResponseCurve flat =
                ResponseCurve.of(Arrays.stream(points).mapToDouble(u -> u[1]).toArray(), y);
        assertThat(steep.at()).hasSize(ResponseCurve.MOST_BINS);
        for (int b = 0; b < steep.at().length; b++) {
            assertThat(steep.mean()[b]).isCloseTo(10 * steep.at()[b], within(1e-9));
        }
        assertThat(Arrays.stream(steep.count()).sum()).isEqualTo(399);
        assertThat(steep.extremes()[1] - steep.extremes()[0]).isCloseTo(8.75, within(0.1));
        assertThat(flat.extremes()[1] - flat.extremes()[0]).isLessThan(2);
    }

    @Test
    void theBandOfACurveIsTheStandardDeviationWithinEachBin() {
        ResponseCurve curve = ResponseCurve.of(new double[] {0, 0, 1}, new double[] {0, 2, 5});
        assertThat(curve.deviation()).containsExactly(Math.sqrt(2), 0);
    }

    /** Ten bodies, each at the same five depths: a bin that had a part of a body's runs would have other depths. */
    @Test
    void inABalancedGridTheCurveOfAFactorWithoutEffectIsFlat() {
        double[] body = new double[50];
        double[] depth = new double[50];
        for (int run = 0; run < body.length; run++) {
            body[run] = run / 5;
            depth[run] = run % 5;
        }
        ResponseCurve flat = ResponseCurve.of(body, depth);
        assertThat(flat.mean()).hasSize(ResponseCurve.MOST_BINS).containsOnly(2);
        assertThat(Arrays.stream(flat.count()).boxed())
                .allMatch(count -> count % 5 == 0)
                .hasSize(ResponseCurve.MOST_BINS);
        assertThat(Arrays.stream(flat.count()).sum()).isEqualTo(50);
    }

    /** A normal distribution that is cut has many runs at its cut. */
    @Test
    void manyRunsOfOneValueLieInOneBin() {
        double[] factor = new double[100];
        for (int run = 90; run < factor.length; run++) {
            factor[run] = run;
        }
        double[] response = Arrays.stream(factor).map(value -> value * 2).toArray();
        ResponseCurve curve = ResponseCurve.of(factor, response);
        assertThat(curve.count()).containsExactly(90, 10);
        assertThat(curve.mean()).containsExactly(0, 189);
        assertThat(ResponseCurve.of(new double[0], new double[0]).at()).isEmpty();
    }

    /** The mean of n equal draws scatters by sd / sqrt n: 95 % of it is 1.96 times as wide on both sides. */
    @Test
    void theIntervalOfAMeanIsThatOfItsStandardError() {
        double[] values = new LatinHypercube(1, 400, 1).points().length == 400
                ? Arrays.stream(new LatinHypercube(1, 400, 1).points())
                        .mapToDouble(u -> u[0])
                        .toArray()
                : new double[0];
        Estimate mean = Bootstrap.USUAL.of(400, chosen -> Arrays.stream(chosen)
                .mapToDouble(i -> values[i])
                .average()
                .orElseThrow());
        double half = 1.96 * Math.sqrt(1 / 12.0 / 400);
        assertThat(mean.value()).isCloseTo(0.5, within(0.001));
        assertThat(mean.high() - mean.low()).isCloseTo(2 * half, within(0.2 * half));
        assertThat(Bootstrap.USUAL.of(2, chosen -> 1).low()).isNaN();
    }
}
