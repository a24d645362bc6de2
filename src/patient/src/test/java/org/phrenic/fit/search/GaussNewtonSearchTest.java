package org.phrenic.fit.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.SheetSprings;

/** The search that goes down by what each parameter does, on shapes that need no breath. */
class GaussNewtonSearchTest {
    private static final double[] WHERE = {0.3, 0.8, 0.45};

    /** A shape of four numbers, somewhat bent in its three parameters. */
    private static float[] shape(double[] u) {
        return new float[] {
            (float) (10 * u[0] + 3 * u[1]),
            (float) (8 * u[1] * u[1]),
            (float) (20 * u[2] - 5 * u[0]),
            (float) (4 * u[0] * u[2])
        };
    }

    private static double distance(float[] a, float[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += Math.abs(a[i] - b[i]) / a.length;
        }
        return sum;
    }

    /** Newton's step for squared distances, held within reach. */
    private static List<double[]> ways(LinearShapeModel body, double reach, double[][] tries) {
        double[] now = new double[body.length()];
        body.predict(body.centre(), now);
        float[] aim = shape(WHERE);
        List<double[]> ways = new ArrayList<>();
        for (double[] way : tries) {
            int n = body.centre().length;
            double[][] a = new double[n][n];
            double[] b = new double[n];
            double[] low = new double[n];
            double[] high = new double[n];
            for (int k = 0; k < n; k++) {
                for (int i = 0; i < now.length; i++) {
                    b[k] += body.derivative(k)[i] * (now[i] - aim[i]);
                    for (int j = 0; j < n; j++) {
                        a[k][j] += body.derivative(k)[i] * body.derivative(j)[i];
                    }
                }
                a[k][k] += 1e-9;
                low[k] = Math.max(-way[0] * reach, -body.centre()[k]);
                high[k] = Math.min(way[0] * reach, 1 - body.centre()[k]);
            }
            double[] to = BoxConstrainedQuadratic.minimize(a, b, low, high);
            for (int k = 0; k < n; k++) {
                to[k] += body.centre()[k];
            }
            ways.add(to);
        }
        return ways;
    }

    @Test
    void startsFromTheBestOfSeveralPointsWhereTheFirstIsBeyondTheLimit() {
        List<double[]> others = List.of(new double[] {0.5, 0.5, 0.5}, WHERE.clone(), new double[] {0, 0, 0});
        for (boolean beyond : new boolean[] {true, false}) {
            double[] start = {0.9, 0.2, 0.9};
            double value = distance(shape(start), shape(WHERE));
            List<Evaluation> trials = new GaussNewtonSearch(
                            3,
                            (first, points) -> first > 3
                                    ? List.of()
                                    : points.stream()
                                            .map(p -> new Evaluation(p, distance(shape(p), shape(WHERE)), shape(p)))
                                            .toList(),
                            GaussNewtonSearchTest::ways)
                    .run(start, others, beyond ? value / 2 : 2 * value);
            assertThat(trials).hasSize(4);
            assertThat(trials.stream().anyMatch(e -> e.value() == 0)).isEqualTo(beyond);
        }
    }

    @Test
    void comesDownInFewBreaths() {
        List<Evaluation> trials = new GaussNewtonSearch(
                        3,
                        (first, points) -> points.stream()
                                .map(p -> new Evaluation(p, distance(shape(p), shape(WHERE)), shape(p)))
                                .toList(),
                        GaussNewtonSearchTest::ways)
                .run(new double[] {0.9, 0.2, 0.9});
        assertThat(trials.get(0).value()).isGreaterThan(4);
        assertThat(trials.stream()
                        .limit(20)
                        .mapToDouble(Evaluation::value)
                        .min()
                        .orElseThrow())
                .isLessThan(0.05);
    }

    /** First toward the more distant bound, then away from it, so that the bend of the shape evens out. */
    @Test
    void theSecondFiniteDifferencesGoTheOppositeWay() {
        List<double[]> starts = new ArrayList<>();
        List<List<double[]>> differences = new ArrayList<>();
        List<Evaluation> known = new ArrayList<>();
        new GaussNewtonSearch(
                        3,
                        (first, points) -> {
                            if (first > 0 && points.size() == 3) {
                                differences.add(points);
                                starts.add(known.stream()
                                        .min(Comparator.comparingDouble(Evaluation::value))
                                        .orElseThrow()
                                        .point());
                            }
                            List<Evaluation> batch = points.stream()
                                    .map(p -> new Evaluation(p, distance(shape(p), shape(WHERE)), shape(p)))
                                    .toList();
                            known.addAll(batch);
                            return batch;
                        },
                        GaussNewtonSearchTest::ways)
                .run(new double[] {0.9, 0.2, 0.9});
        assertThat(differences).hasSizeGreaterThan(1);
        for (int round = 0; round < 2; round++) {
            double[] start = starts.get(round);
            for (int k = 0; k < 3; k++) {
                double toFarBound = start[k] < 0.5 ? 1 : -1;
                double way = differences.get(round).get(k)[k] - start[k];
                assertThat(Math.signum(way)).isEqualTo(round == 0 ? toFarBound : -toFarBound);
            }
        }
    }

    /** A breath that fails is repeated with less drive, thus at another point than was asked for. */
    @Test
    void aBreathWithLessDriveTeachesWhatItsOwnPointDoes() {
        List<double[]> learnt = new ArrayList<>();
        new GaussNewtonSearch(
                        2,
                        (first, points) -> IntStream.range(0, points.size())
                                .mapToObj(k -> first > 0 && k == 0 ? halfWay(points.get(k)) : linear(points.get(k), 1))
                                .toList(),
                        (body, reach, tries) -> {
                            learnt.add(body.derivative(0).clone());
                            learnt.add(body.derivative(1).clone());
                            return List.of();
                        })
                .run(new double[] {0.2, 0.3});
        assertThat(learnt.get(0)).containsExactly(new double[] {10, 0}, offset(1e-3));
        assertThat(learnt.get(1)).containsExactly(new double[] {3, 8}, offset(1e-3));
    }

    private static Evaluation halfWay(double[] asked) {
        return linear(new double[] {(0.2 + asked[0]) / 2, asked[1]}, 0.5);
    }

    private static Evaluation linear(double[] u, double drive) {
        float[] shape = {(float) (10 * u[0] + 3 * u[1]), (float) (8 * u[1])};
        return new Evaluation(u, 1, shape, drive, drive < 1 ? "diverged" : "");
    }

    @Test
    void endsWhereAskedToAndWithoutShapes() {
        assertThat(new GaussNewtonSearch(3, (first, points) -> List.of(), GaussNewtonSearchTest::ways).run(WHERE))
                .isEmpty();
        assertThat(new GaussNewtonSearch(
                                3, (first, points) -> List.of(new Evaluation(WHERE, 1000)), GaussNewtonSearchTest::ways)
                        .run(WHERE))
                .hasSize(1);
    }

    @Test
    void learnsTheShapeOfABreath() {
        LinearShapeModel body = new LinearShapeModel(3);
        body.recentre(WHERE, shape(WHERE));
        double[] place = {0.5, 0.7, 0.2};
        body.broydenUpdate(place, shape(place));
        double[] expected = new double[4];
        body.predict(place, expected);
        for (int i = 0; i < 4; i++) {
            assertThat(expected[i]).isCloseTo(shape(place)[i], offset(1e-5));
        }
    }

    @Test
    void aStrengthGoesWithTheMeanOfItsSides() {
        SearchSpace space = new SearchSpace(List.of(
                new FitParameter(Muscle.MUSCLE_ACTIVATION, 0.1, 0.8, 0.6),
                new FitParameter(Muscle.LEFT_OVER_RIGHT, 0.5, 2, 1.12),
                new FitParameter(SheetSprings.MUSCLE_STIFFNESS, 100, 450, 300)));
        double[] start = space.values(space.startPoint());
        assertThat(start[0]).isCloseTo(0.6, offset(1e-9));
        assertThat(start[1]).isCloseTo(1.12, offset(1e-9));
        // The right side alone is what the stronger side gives it: it falls evenly through a ratio of 1.
        double[] right = new double[3];
        for (int i = 0; i < 3; i++) {
            double[] u = {0.5, 0.45 + 0.05 * i, 0.5};
            double[] v = space.values(u);
            right[i] = StrictMath.log(v[0] * Math.min(1, 1 / v[1]));
        }
        assertThat(right[0] - right[1]).isCloseTo(right[1] - right[2], offset(1e-9));
        assertThat(Arrays.stream(right).distinct().count()).isEqualTo(3);
    }
}
