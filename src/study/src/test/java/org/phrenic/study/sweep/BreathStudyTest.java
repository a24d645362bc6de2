package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.SceneObserver;
import org.phrenic.study.BreathSeries;
import org.phrenic.study.body.BodyVariation;
import org.phrenic.study.sweep.index.Bootstrap;
import org.phrenic.study.sweep.index.MorrisEffects;
import org.phrenic.study.sweep.report.SweepReport;
import org.phrenic.study.validation.Reduction;

/** Breaths as runs of a study, and what its file is told when it is wrong. */
class BreathStudyTest {
    private static final String SETTINGS = "settings: {resolution: low, duration_s: 0.06}\n";
    private static final String RESPONSE =
            "responses:\n  - {name: descent, observable: liver_si_mm, reduction: size}\n";

    @TempDir
    private Path folder;

    private static SweepStudy study(String factors, String design, String responses) {
        return SweepStudy.parse("study.yaml", SETTINGS + factors + "design: " + design + "\n" + responses);
    }

    /** The row of a point is what the scenario with the point's values gives by itself. */
    @Test
    void aRunIsTheBreathOfItsScenario() {
        SweepPlan plan = SweepPlan.of(
                study("", "{kind: list, columns: [depth], points: [[1.2]]}", RESPONSE + "series: [liver_si_mm]\n"));
        RunRow usual = RunRow.of(plan.model(), plan.points().get(0));
        Scenario alone = Scenario.defaults().with("resolution=low", "duration_s=0.06", "depth=1.2", "threads=1");
        try (Simulation simulation = Simulation.of(alone, SimulationRun.loadThorax(alone))) {
            SceneObserver observer = new SceneObserver(simulation.scene());
            double start = observer.observe(0).get("liver_si_mm");
            while (simulation.time() < simulation.durationS() - 1e-9) {
                simulation.step();
            }
            assertThat(usual.failure()).isEmpty();
            assertThat(usual.outcome().stateSha256()).isEqualTo(simulation.stateHash());
            assertThat(usual.outcome().series()[0]).hasSize(SweepOutcome.SERIES_POINTS);
            assertThat(usual.outcome().series()[0][0]).isEqualTo(start);
            assertThat(usual.outcome().series()[0][SweepOutcome.SERIES_POINTS - 1])
                    .isEqualTo(observer.observe(simulation.time()).get("liver_si_mm"));
        }
    }

    private static List<Map<String, Object>> scenarios(SweepStudy study) {
        SceneFactors factors = new SceneFactors(study.scenario(), false);
        return SweepPlan.of(study).points().stream()
                .map(point -> factors.scenario(point).toMap())
                .toList();
    }

    /** Executors of a cluster, and whoever starts a study again from its folder, know it by this text alone. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "{key: material, values: [physical, paper, published]}",
                "{key: time_step_s, values: [0.00125, 0.01]}"
            })
    void theTextOfAStudyGivesTheScenariosOfTheStudy(String factor) throws IOException {
        Files.writeString(folder.resolve("base.yaml"), "time_step_s: 0.005\ntendon_stiffness_ratio: 10\n");
        String stated = "tendon_stiffness_ratio: " + Scenario.defaults().get(SheetSprings.TENDON_RATIO);
        for (String settings : List.of(
                "settings: {resolution: low}\n",
                "settings: {resolution: low, " + stated + "}\n",
                "scenario: base.yaml\n")) {
            Path file = Files.writeString(
                    folder.resolve("s.yaml"),
                    settings + "factors:\n  - " + factor + "\ndesign: {kind: grid}\n" + RESPONSE);
            SweepStudy study = SweepStudy.read(file);
            assertThat(scenarios(SweepStudy.parse("again", study.resolved())))
                    .as(settings)
                    .isEqualTo(scenarios(study));
        }
    }

    /** A value that a study states holds in all of its runs, also where it is the default of one material. */
    @Test
    void aMaterialChangesWhatAStudyLeavesOpenAndNothingElse() {
        double shared = Scenario.defaults().get(SheetSprings.TENDON_RATIO);
        String factor = "factors:\n  - {key: material, values: [physical, paper]}\n";
        String stated =
                "settings: {tendon_stiffness_ratio: " + shared + "}\n" + factor + "design: {kind: grid}\n" + RESPONSE;
        assertThat(scenarios(SweepStudy.parse("study.yaml", stated)))
                .extracting(map -> map.get("tendon_stiffness_ratio"))
                .containsExactly(shared, shared);
        assertThat(scenarios(study(factor, "{kind: grid}", RESPONSE)))
                .extracting(map -> map.get("time_step_s"))
                .doesNotHaveDuplicates();
    }

    @Test
    void factorsOfTheBodyMakeOneVariationOfIt() {
        List<String> keys = List.of("depth", "body.scale", "body.scale_x", "body.dome_lift_mm");
        assertThat(BodyFactors.variation(new SweepPoint(0, keys, List.of("2", "0.9", "1.1", "-5"))))
                .contains(new BodyVariation(0.9 * 1.1, 0.9, 0.9, 0, 0, -5));
        assertThat(BodyFactors.variation(new SweepPoint(0, List.of("depth"), List.of("1"))))
                .isEmpty();
    }

    @Test
    void aFailingRunIsARowWithItsReason() {
        SweepPlan plan = SweepPlan.of(study("", "{kind: list, columns: [depth], points: [[1]]}", RESPONSE));
        RunRow row = RunRow.of(plan.model(), new SweepPoint(0, List.of("depth"), List.of("1000")));
        assertThat(row.failure()).contains("key 'depth': found 1000, expected");
        assertThat(row.outcome().responses()).containsExactly(Double.NaN);
    }

    /** Such as one that waits for a body while the study ends: its row would be a failed one for ever. */
    @Test
    void aRunOfAnInterruptedStudyIsNoRow() {
        SweepPlan plan = SweepPlan.of(study("", "{kind: list, columns: [depth], points: [[1]]}", RESPONSE));
        SweepPoint failing = new SweepPoint(0, List.of("depth"), List.of("1000"));
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> RunRow.of(plan.model(), failing)).hasMessageContaining("found 1000, expected");
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    /** Each factor is within its limits, the breadth of the body is not. */
    @Test
    void aSizeOfTheBodyBeyondItsLimitsIsAFailedRun() {
        SweepPlan plan = SweepPlan.of(study(
                "", "{kind: list, columns: [body.scale, body.scale_x], points: [[1.2, 1.1], [0.9, 0.8]]}", RESPONSE));
        assertThat(plan.points())
                .extracting(point -> RunRow.of(plan.model(), point).failure())
                .containsExactly(
                        "factors 'body.scale' and 'body.scale_x': found 1.2 times 1.1, expected a product of 0.8 to"
                                + " 1.25",
                        "factors 'body.scale' and 'body.scale_x': found 0.9 times 0.8, expected a product of 0.8 to"
                                + " 1.25");
    }

    /** A table with an empty cell and no reason would pass for a complete study. */
    @Test
    void aResponseThatABreathLacksIsARefusalOrAFailedRun() {
        String creep = RESPONSE.replace("size", "creep");
        refused(
                "",
                "{kind: list, columns: [depth], points: [[1]]}",
                creep,
                "found creep, expected a breath with a hold");
        SweepPlan held = SweepPlan.of(
                study("", "{kind: list, columns: [preset], points: [[quiet], [hold-inspiration]]}", creep));
        assertThat(RunRow.of(held.model(), held.points().get(0)).failure())
                .isEqualTo("response 'descent': found no number, expected a breath with a hold");
        List<String> columns = List.of("breath", "dome_right_mm", "dome_left_mm", "liver_top_mm");
        List<double[]> rows = List.of(new double[] {0, 0, 0, Double.NaN}, new double[] {0, -1, -1, Double.NaN});
        BreathSeries withoutLiver =
                new BreathSeries(columns, rows, Collections.nCopies(2, RespiratoryPhase.INSPIRATION));
        ResponseSpec top = new ResponseSpec("", "liver_top_mm", List.of(), Reduction.SIZE, "", 1, 1);
        assertThatThrownBy(() -> top.valueIn(withoutLiver))
                .hasMessage("response 'liver_top_mm_size': found no number, expected a body that has liver_top_mm");
    }

    /** What is measured on an organ that is not there is unknown: 0 would enter the means and the indices. */
    @Test
    void aResponseThatABodyLacksIsAFailedRun() {
        String points = "{kind: list, columns: [liver, lungs], points: [[false, embedded], [true, 'off']]}";
        String lungs = "  - {name: air, observable: lung_volume_change_ml, reduction: size}\n";
        SweepPlan plan = SweepPlan.of(study("", points, RESPONSE + lungs));
        assertThat(plan.points())
                .extracting(point -> RunRow.of(plan.model(), point).failure())
                .containsExactly(
                        "response 'descent': found no number, expected a body that has liver_si_mm",
                        "response 'air': found no number, expected a body that has lung_volume_change_ml");
    }

    /** A sternum that stands still moves by 0, which is known. */
    @Test
    void aSternumThatStandsStillHasAResponse() {
        String depth = "responses:\n  - {name: forward, observable: ap_change_mm, reduction: size}\n";
        String point = "{kind: list, columns: [sternum, lungs, liver], points: [['off', embedded, false]]}";
        SweepPlan plan = SweepPlan.of(study("", point, depth + "series: [sternum_cranial_mm]\n"));
        RunRow run = RunRow.of(plan.model(), plan.points().get(0));
        assertThat(run.failure()).isEmpty();
        assertThat(run.outcome().responses()).containsExactly(0);
        assertThat(run.outcome().series()[0]).containsOnly(0);
    }

    /** A curve without a point would be drawn without a reason. */
    @Test
    void aSeriesThatABodyLacksIsAFailedRun() {
        String dome = RESPONSE.replace("liver_si_mm", "dome_right_mm");
        String point = "{kind: list, columns: [liver], points: [[false]]}";
        for (String series : List.of("liver_si_mm", "liver_top_mm")) {
            SweepPlan plan = SweepPlan.of(study("", point, dome + "series: [" + series + "]\n"));
            assertThat(RunRow.of(plan.model(), plan.points().get(0)).failure())
                    .isEqualTo("series '" + series + "': found no number, expected a body that has " + series);
        }
    }

    @Test
    void bodiesOfATableOfPointsAreTakenFromItsFolder() throws IOException {
        Path tables = Files.createDirectories(folder.resolve("tables/bodies/one"))
                .resolve("../..")
                .normalize();
        Files.writeString(tables.resolve("p.csv"), "anatomy,depth\nbodies/one,1\nvirtual/adult-male,1\n");
        Path study =
                Files.writeString(folder.resolve("s.yaml"), "design: {kind: list, file: tables/p.csv}\n" + RESPONSE);
        String body = tables.resolve("bodies/one").toString();
        SweepPlan plan = SweepPlan.of(SweepStudy.read(study));
        assertThat(plan.points().get(0).values()).containsExactly(body, "1");
        assertThat(plan.points().get(1).values()).containsExactly("virtual/adult-male", "1");
        assertThat(plan.study().factors().get(0).values()).containsExactly(body, "virtual/adult-male");
    }

    /** What the working directory of one session has, another session or machine that goes on may lack. */
    @Test
    void bodiesAndRecordingsAreNotTakenFromTheWorkingDirectory() throws IOException {
        assertThat(Path.of("data")).isDirectory();
        String body = "found no folder '" + folder.resolve("data") + "', expected";
        String recording = "found no file '" + folder.resolve("README.md") + "', expected a CSV file";
        assertThat(Path.of("README.md")).isRegularFile();
        for (List<String> bad : List.of(
                List.of("factors:\n  - {key: anatomy, values: [data]}\ndesign: {kind: grid}\n", body),
                List.of("design: {kind: list, columns: [anatomy], points: [[data]]}\n", body),
                List.of("factors:\n  - {key: trace, values: [none, README.md]}\ndesign: {kind: grid}\n", recording))) {
            Path study = Files.writeString(folder.resolve("s.yaml"), bad.get(0) + RESPONSE);
            assertThatThrownBy(() -> SweepStudy.read(study))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining(bad.get(1));
        }
    }

    @Test
    void valuesFollowTheDistributionOfTheirFactor() {
        SweepPlan plan = SweepPlan.of(study(
                "factors:\n  - {key: depth, normal: [1, 0.1], range: [0.9, 1.2]}\n"
                        + "  - {key: anatomy, values: [virtual/adult-male, virtual/adult-female]}\n"
                        + "  - {key: body.scale, range: [0.8, 1.25], log: true}\n",
                "{kind: latin_hypercube, samples: 200}",
                RESPONSE));
        double[] depth = plan.numbers(0);
        assertThat(Arrays.stream(depth).boxed()).allMatch(v -> v >= 0.9 && v <= 1.2);
        // Median of a normal distribution cut at -1 and 2 standard deviations.
        assertThat(Arrays.stream(depth).sorted().toArray()[100]).isBetween(1.01, 1.03);
        assertThat(plan.numbers(1))
                .satisfies(v -> assertThat(Arrays.stream(v).sum()).isEqualTo(100));
        assertThat(Arrays.stream(plan.numbers(2)).filter(v -> v < 1).count()).isEqualTo(100);
        assertThat(new SweepReport(new SweepResults(plan, List.of()), 0, 1).html())
                .contains("normal, mean 1.0, SD 0.1, cut at 0.9 and 1.2", "0.8 to 1.25, log");
        assertThat(SweepStudy.parse("study.yaml", plan.study().resolved()).resolved())
                .isEqualTo(plan.study().resolved());
    }

    /** The effect of a factor whose range moves a response by 1 is 1, whatever its values are. */
    @Test
    void aMorrisEffectIsTheChangeOverTheRangeOrBetweenTwoNames() {
        SweepPlan plan = SweepPlan.of(study(
                "factors:\n  - {key: depth, range: [0.9, 1.2]}\n"
                        + "  - {key: anatomy, values: [virtual/adult-male, virtual/adult-female]}\n"
                        + "  - {key: body.scale, values: [0.9, 1, 1.1]}\n"
                        + "  - {key: preset, values: [quiet, deep, sniff]}\n",
                "{kind: morris, samples: 500}",
                RESPONSE));
        double[] expected = {1, 1, 1, 2 / 3.0};
        double[][] changes = plan.changes().orElseThrow();
        for (int f = 0; f < expected.length; f++) {
            double[] numbers = plan.numbers(f);
            double least = Arrays.stream(numbers).min().orElseThrow();
            double range = Arrays.stream(numbers).max().orElseThrow() - least;
            double[] response =
                    Arrays.stream(numbers).map(v -> (v - least) / range).toArray();
            MorrisEffects effects = MorrisEffects.of(changes, response, Bootstrap.USUAL);
            assertThat(effects.muStar().get(f).value()).as("factor %d", f).isCloseTo(expected[f], within(0.03));
            assertThat(effects.mu().get(f).value()).as("factor %d", f).isCloseTo(expected[f], within(0.03));
        }
    }

    /** The ends of a normal distribution's coordinate are its cuts, which a parameter may not survive. */
    @Test
    void levelsOfANormalDistributionAreNotItsCuts() {
        String factor = "factors:\n  - {key: rib_rotation, normal: [1, 0.15]}\n";
        for (String design : List.of("{kind: grid}", "{kind: morris, samples: 50}")) {
            SweepPlan plan = SweepPlan.of(study(factor, design, RESPONSE));
            assertThat(plan.numbers(0)).hasSizeGreaterThan(4);
            for (double value : plan.numbers(0)) {
                assertThat(value).isBetween(1 - 2 * 0.15, 1 + 2 * 0.15);
            }
        }
    }

    /** Far beyond its bound a distribution lies at this bound, not at the other one. */
    @Test
    void aDistributionBeyondItsRangeLiesAtTheNearBound() {
        String design = "{kind: latin_hypercube, samples: 8}";
        assertThat(SweepPlan.of(study("factors:\n  - {key: depth, normal: [2.1, 0.01]}\n", design, RESPONSE))
                        .numbers(0))
                .containsOnly(2);
        assertThat(SweepPlan.of(study("factors:\n  - {key: depth, normal: [-0.2, 0.01]}\n", design, RESPONSE))
                        .numbers(0))
                .containsOnly(0);
    }

    @Test
    void aWrongStudyIsToldInOneSentenceWithFileLineAndKey() {
        String grid = "{kind: grid}";
        refused("factors:\n  - {key: depht, range: [1, 2]}\n", grid, RESPONSE, "line 3", "did you mean 'depth'?");
        refused("factors:\n  - {key: depth, range: [0, 99]}\n", grid, RESPONSE, "line 3", "found 99.0, expected");
        refused("factors:\n  - {key: depth}\n", grid, RESPONSE, "line 3", "expected range, normal or values");
        refused("factors:\n  - {key: threads, values: [1, 2]}\n", grid, RESPONSE, "line 3", "unknown factor");
        refused("factors:\n  - {key: preset, values: [quiet, loud]}\n", grid, RESPONSE, "line 3", "loud");
        refused("factors:\n  - {key: body.barrel, values: [2]}\n", grid, RESPONSE, "line 3", "expected 0.0 to 0.25");
        String good = "factors:\n  - {key: depth, values: [1]}\n";
        refused(good, "{kind: cube}", RESPONSE, "line 4", "key 'design.kind'", "grid");
        refused(good, "{kind: list}", RESPONSE, "line 4", "neither file nor points");
        refused(good, grid, "", "found no response");
        refused(good, grid, RESPONSE.replaceFirst("name: \\w+", "name: failure"), "columns of the journal");
        refused(good, grid, RESPONSE.replace("liver_si_mm", "liver_sl_mm"), "did you mean 'liver_si_mm'?");
        refused(good, grid, RESPONSE.replace("size", "ratio"), "line 6", "expected against");
    }

    @Test
    void aTableOfPointsWithoutARowIsNamed() throws IOException {
        Path study = Files.writeString(folder.resolve("s.yaml"), "design: {kind: list, file: p.csv}\n" + RESPONSE);
        Files.writeString(folder.resolve("p.csv"), "depth\n");
        assertThatThrownBy(() -> SweepStudy.read(study))
                .isInstanceOf(BadInputException.class)
                .hasMessage(folder.resolve("p.csv") + ": found no row, expected a point a line");
    }

    private static void refused(String factors, String design, String responses, String... parts) {
        assertThatThrownBy(() -> study(factors, design, responses))
                .isInstanceOf(BadInputException.class)
                .message()
                .startsWith("study.yaml: ")
                .contains(parts)
                .doesNotContain("\n");
    }
}
