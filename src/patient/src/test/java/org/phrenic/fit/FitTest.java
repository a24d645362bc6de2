package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.JsonWriter;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.file.BadInputException;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.RibRotation;
import org.phrenic.scenario.Scenario;

/**
 * A short form of a fit to a known breath: the sheet alone, three parameters, one generation. {@code phrenic fit
 * --synthetic 5} is the long one.
 */
class FitTest {
    private static final String MESH = "mesh_vertices=1500";

    private static final String[] SHEET_ALONE = {
        "preset=deep", MESH, "lungs=off", "sternum=off", "liver=false", "threads=1"
    };

    private static Scenario base;
    private static Thorax body;
    private static GroundTruth truth;

    @TempDir
    Path folder;

    @BeforeAll
    static void breathe() {
        SyntheticPatient patient = new SyntheticPatient(
                "test",
                "virtual/adult-male",
                1,
                1.05,
                1,
                -0.05,
                List.of(
                        "muscle_activation=0.4",
                        "left_over_right=0.9",
                        "rib_rotation=0.6",
                        "lungs=off",
                        "liver=false"));
        List<String> settings = List.of("anatomy=" + patient.anatomy(), MESH);
        truth = GroundTruth.of(patient, settings, List.of(FitPart.DIAPHRAGM), 1, 1);
        base = Scenario.defaults().with(SHEET_ALONE);
        body = patient.body(settings);
    }

    private static FitSetup setup(int evaluations, int threads) {
        List<FitParameter> parameters = List.of(
                FitParameter.of(Muscle.MUSCLE_ACTIVATION, base),
                FitParameter.of(Muscle.LEFT_OVER_RIGHT, base),
                FitParameter.of(RibRotation.RIB_ROTATION, base));
        return new FitSetup(
                base,
                body,
                truth.targets(),
                parameters,
                new FitSetup.Options(
                        new FitSearch.Settings(1, 6, evaluations, Double.POSITIVE_INFINITY), threads, false));
    }

    @Test
    void findsTheBreathAndTheScenarioDoesItAgain() throws IOException {
        Path journal = folder.resolve("journal.csv");
        // The first breath is too deep: 1, 3 weaker ones, 3 gradients and 4 candidates of a step are 11.
        FitResult result = Fit.run(setup(11, 2), journal, (count, most, best, initial) -> {});
        assertThat(result.reproduced()).isTrue();
        assertThat(result.ratio()).isLessThan(0.35);
        assertThat(result.search().trials()).hasSize(11);
        assertThat(result.bestMm()).isLessThan(result.search().trials()[0]);
        double[] trials = result.search().trials();
        assertThat(Arrays.stream(trials, 7, 11).min().orElseThrow())
                .as("the step goes below all breaths that it follows from")
                .isLessThan(Arrays.stream(trials, 0, 7).min().orElseThrow());

        // Killed while the last evaluations were written.
        String whole = Files.readString(journal);
        Files.writeString(journal, whole.substring(0, whole.length() - 180));
        Path shapes = folder.resolve("journal.shapes");
        byte[] bytes = Files.readAllBytes(shapes);
        Files.write(shapes, Arrays.copyOf(bytes, bytes.length - 99));
        FitResult again = Fit.run(setup(11, 1), journal, (count, most, best, initial) -> {});
        assertThat(again.values()).containsExactly(result.values());
        assertThat(again.search().trials()).containsExactly(result.search().trials());
        assertThat(Files.readString(journal).lines().sorted().toList())
                .isEqualTo(whole.lines().sorted().toList());
        assertThat(shapes).hasSize(bytes.length);
    }

    @Test
    void distancesAreThoseOfACompareAndPairsGoWithTheSurface() {
        FitTarget target = truth.targets().get(0);
        try (InspiratoryHold breath =
                new InspiratoryHold(base, body, setup(1, 1).parameters())) {
            int sheet = 0;
            while (!FitPart.DIAPHRAGM.matches(breath.surfaces().surfaces().get(sheet))) {
                sheet++;
            }
            TriangleMesh rest = breath.surfaces().surfaces().get(sheet).rest();
            TargetDistance distance = new TargetDistance(target, breath.surfaces());
            DistanceSummary compared =
                    SurfaceComparison.of(rest, target.surface()).byArea();
            assertThat(distance.atRest(FitHalf.ALL).mean()).isCloseTo(compared.mean(), offset(1e-9));
            assertThat(distance.mean(rest.positions(), FitHalf.EVEN))
                    .isCloseTo(distance.atRest(FitHalf.EVEN).mean(), offset(1e-9));
            assertThat(distance.atRest(FitHalf.ALL).summary().percentile95())
                    .isCloseTo(compared.percentile95(), offset(1e-9));
            assertThat(weight(distance, FitHalf.EVEN) + weight(distance, FitHalf.ODD))
                    .isCloseTo(weight(distance, FitHalf.ALL), offset(1e-6));

            breath.breatheIn(new double[] {0.3, 1, 0.5});
            double[] from = Arrays.copyOf(rest.positions(), 300);
            double[] to = Arrays.copyOf(breath.mesh(sheet).positions(), 300);
            // Off the surface, a point keeps its way from it.
            from[0] += 0.5;
            to[0] += 0.5;
            TargetDistance pairs =
                    new TargetDistance(FitTarget.ofPointPairs(FitPart.DIAPHRAGM, from, to), breath.surfaces());
            assertThat(pairs.atRest(FitHalf.ALL).mean()).isGreaterThan(0.1);
            assertThat(pairs.of(breath, FitHalf.ALL).mean()).isCloseTo(0, offset(0.02));
        }
    }

    /** A surface in centimetres or in the axes of another program would be fitted to for an hour. */
    @Test
    void refusesATargetInAnotherUnitOrOtherAxes() {
        TriangleMesh surface = truth.targets().get(0).surface();
        double[] centimetres =
                Arrays.stream(surface.positions()).map(x -> 0.1 * x).toArray();
        double[] aside = surface.positions().clone();
        for (int i = 0; i < aside.length; i += 3) {
            aside[i] += 500;
        }
        double[] from = Arrays.copyOf(aside, 30);
        try (InspiratoryHold breath =
                new InspiratoryHold(base, body, setup(1, 1).parameters())) {
            for (FitTarget wrong : List.of(
                    FitTarget.of(FitPart.DIAPHRAGM, surface.withPositions(centimetres)),
                    FitTarget.of(FitPart.DIAPHRAGM, surface.withPositions(aside)),
                    FitTarget.ofPointPairs(FitPart.DIAPHRAGM, from, from))) {
                assertThatThrownBy(() -> new TargetDistance(wrong, breath.surfaces()))
                        .isInstanceOf(BadInputException.class)
                        .hasMessageStartingWith("target " + wrong.name() + ": found it ")
                        .hasMessageContaining("expected mm in the axes of the body");
            }
        }
    }

    private static double weight(TargetDistance distance, FitHalf half) {
        FitDistances d = distance.atRest(half);
        return Arrays.stream(d.modelWeights()).sum()
                + Arrays.stream(d.targetWeights()).sum();
    }

    /** A target that is the body at end-expiration leaves nothing to compare with. */
    @Test
    void aDistanceOfZeroBeforeHasNoRatio() {
        FitDistances none = new FitDistances(null, new double[] {0}, new double[] {1}, new double[0], new double[0]);
        FitDistances left = new FitDistances(null, new double[] {2}, new double[] {1}, new double[0], new double[0]);
        for (FitDistances residual : List.of(none, left)) {
            FitResult result = new FitResult(
                    setup(1, 1),
                    new double[] {0.4, 1, 0.5},
                    residual.mean(),
                    none.mean(),
                    2,
                    List.of(new FitResult.TargetResult(truth.targets().get(0), none, residual, null, null, null)),
                    Optional.empty(),
                    List.of(),
                    Map.of(),
                    base,
                    true,
                    new FitResult.Search(new double[] {2}, "it was told to", List.of(), List.of(), Double.NaN, 1));
            FitReport report = new FitReport(result);
            assertThat(JsonWriter.format(report.values())).contains("\"ratio\": null");
            assertThat(report.summary()).contains(" mm. 3 parameters").doesNotContain("a ratio", "NaN", "Infinity");
            assertThat(report.distances()).allSatisfy(row -> assertThat(row).endsWith(""));
        }
    }

    private static FitParameter greatestActivation(Scenario scenario) {
        double most = scenario.get(Muscle.MUSCLE_ACTIVATION);
        return new FitParameter(Muscle.MUSCLE_ACTIVATION, 0.1, most, most);
    }

    /** Pairs of points give no linear model, so that what a parameter does takes a breath. */
    @Test
    void whatAParameterDoesIsSeenWhenTheBestBreathIsAndLeavesTheLandmarksToIt() {
        Scenario withLungs = Scenario.defaults().with("preset=deep", MESH, "sternum=off", "liver=false", "threads=1");
        FitParameter parameter = greatestActivation(withLungs);
        double[] values = {parameter.start()};
        double[] less = {parameter.fromUnit(0.95)};
        double[] inside = body.find("lung_R").orElseThrow().mesh().centre();
        Landmarks landmarks = new Landmarks(inside, inside, RigidMotion.identity());
        try (InspiratoryHold breath = new InspiratoryHold(withLungs, body, List.of(parameter))) {
            int sheet = 0;
            while (!FitPart.DIAPHRAGM.matches(breath.surfaces().surfaces().get(sheet))) {
                sheet++;
            }
            double[] from = breath.surfaces().surfaces().get(sheet).rest().positions();
            FitTarget pairs = FitTarget.ofPointPairs(FitPart.DIAPHRAGM, from, from);
            FitSetup setup = new FitSetup(
                    withLungs,
                    body,
                    List.of(pairs),
                    List.of(parameter),
                    new FitSetup.Options(
                            FitHalf.ALL,
                            TargetAlignment.NONE.sentence(),
                            new FitSearch.Settings(1, 1),
                            1,
                            true,
                            Optional.of(landmarks)));
            FitResult result = Fit.run(setup, folder.resolve("journal.csv"), (count, most, best, initial) -> {});
            FitResult.Effect effect = result.sensitivity().get(0);
            assertThat(effect.aboveMm()).isNaN();
            assertThat(effect.step()).isEqualTo(values[0] - less[0]).isPositive();

            TargetDistance distance = new TargetDistance(pairs, breath.surfaces());
            breath.breatheIn(less);
            assertThat(effect.belowMm())
                    .isEqualTo(distance.of(breath, FitHalf.ALL).mean());
            breath.breatheIn(values);
            assertThat(result.values()).containsExactly(values);
            assertThat(result.bestMm())
                    .isEqualTo(distance.of(breath, FitHalf.ALL).mean());
            assertThat(result.landmarks().orElseThrow().fitted().mean())
                    .isEqualTo(landmarks.errors(breath).fitted().mean());
        }
    }

    @Test
    void breathsThatFailedAreSaidToHaveAndHaveNoDistance() {
        FitDistances left = new FitDistances(null, new double[] {2}, new double[] {1}, new double[0], new double[0]);
        FitParameter parameter = greatestActivation(base);
        FitSetup setup = new FitSetup(
                base, body, truth.targets(), List.of(parameter), setup(1, 1).options());
        FitReport report = new FitReport(new FitResult(
                setup,
                new double[] {parameter.start()},
                left.mean(),
                4,
                Double.NaN,
                List.of(new FitResult.TargetResult(truth.targets().get(0), left, left, null, null, null)),
                Optional.empty(),
                List.of(new FitResult.Effect(parameter, 0.02, Double.POSITIVE_INFINITY, Double.NaN)),
                Map.of(),
                base,
                true,
                new FitResult.Search(new double[] {2}, "it was told to", List.of(), List.of(), Double.NaN, 1)));
        assertThat(report.summary())
                .contains("went from 4.00 mm (body at end-expiration; the breath with the initial parameters failed)")
                .doesNotContain("NaN");
        assertThat(report.parameters().get(0)).endsWith("failed", "bound");
        assertThat(JsonWriter.format(report.values()))
                .contains(
                        "\"untuned_mean_mm\": null", "\"with_a_step_less_mm\": null", "\"with_a_step_more_mm\": null");
    }

    @Test
    void refusesATargetThatTheBodyDoesNotHave() {
        FitTarget liver = FitTarget.of(FitPart.LUNGS, truth.targets().get(0).surface());
        FitSetup wrong = new FitSetup(
                base,
                body,
                List.of(liver),
                setup(1, 1).parameters(),
                new FitSetup.Options(new FitSearch.Settings(1, 1), 1, true));
        assertThatThrownBy(() -> Fit.run(wrong, folder.resolve("journal.csv"), (count, most, best, initial) -> {}))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found no lungs that moves in the body");
        assertThat(folder.resolve("journal.csv")).doesNotExist();
    }
}
