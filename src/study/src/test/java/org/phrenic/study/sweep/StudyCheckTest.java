package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;

/** What a study cannot compute or write is told before its first run. */
class StudyCheckTest {
    private static final String DEPTHS = "factors:\n  - {key: depth, values: [1, 1.2]}\n";
    private static final String GRID = "design: {kind: grid}\n";
    private static final String RESPONSE = "responses:\n  - {observable: liver_si_mm, reduction: size}\n";
    private static final String CREEP = RESPONSE.replace("size", "creep");

    @TempDir
    private Path folder;

    private static void refused(String study, String... parts) {
        assertThatThrownBy(() -> SweepStudy.parse("study.yaml", study))
                .isInstanceOf(BadInputException.class)
                .message()
                .startsWith("study.yaml: ")
                .contains(parts)
                .doesNotContain("\n");
    }

    /** A journal whose names are read otherwise than they were written would lose all runs at the end. */
    @ParameterizedTest
    @ValueSource(
            strings = {"'rise; mm'", "' rise'", "'rise '", "\"rise\\tmm\"", "series dome_right_mm", "machine", "wall_s"
            })
    void aResponseIsAColumnThatCanBeReadAgain(String name) {
        String response = "responses:\n  - {name: " + name + ", observable: dome_right_mm, reduction: rise}\n";
        refused(DEPTHS + GRID + response + "series: [dome_right_mm]\n", "line 4, key 'responses': found ", " name ");
    }

    @Test
    void aResponseIsNotCalledAsATraitOfThePersons() {
        String response = "responses:\n  - {name: age_y, observable: dome_right_mm, reduction: rise}\n";
        refused("cohort: {persons: 2}\n" + GRID + response, "found the name 'age_y', expected another than");
        assertThat(SweepStudy.parse("study.yaml", DEPTHS + GRID + response)
                        .newModel()
                        .responses())
                .containsExactly("age_y");
    }

    /** The response of the first observable would pass for one of both, and a share would change nothing. */
    @Test
    void whatAReductionDoesNotReadIsRefused() {
        String two = "observables: [liver_si_mm, liver_ap_mm], reduction: ";
        String both = "responses:\n  - {observable: liver_si_mm, reduction: size}\n  - {" + two + "size}\n";
        refused(DEPTHS + GRID + both, "line 6", "found 2 observables with the reduction size", "expected a response");
        String share = RESPONSE.replace("size", "size, share: 0.5");
        refused(DEPTHS + GRID + share, "line 5", "found a share with the reduction size", "expected it with at_share");
        for (String read : List.of(
                two + "order",
                "observables: [liver_si_mm], reduction: size, share: 1",
                "observable: liver_si_mm, against: dome_right_mm, reduction: at_share, share: 0.5")) {
            String responses = "responses:\n  - {" + read + "}\n";
            assertThat(SweepStudy.parse("study.yaml", DEPTHS + GRID + responses).responses())
                    .hasSize(1);
        }
        assertThat(SweepStudy.parseWithoutBodies(Path.of("merged", "study.yaml"), DEPTHS + GRID + both)
                        .responses())
                .hasSize(2);
    }

    /** Such as 50 for 50 %: no run of the study would have the response. */
    @ParameterizedTest
    @ValueSource(strings = {"50.0", "1.5", "0.0", "-0.5"})
    void aShareThatNoBreathHasIsRefusedBeforeAnyRun(String share) {
        refused(
                DEPTHS + GRID + "responses:\n  - {observable: liver_si_mm, against: dome_right_mm, "
                        + "reduction: at_share, share: " + share + "}\n",
                "line 5, key 'responses[0]': found the share " + share + ", expected more than 0 to 1");
    }

    @Test
    void aDesignOfTooManyRunsIsRefusedWithTheirNumberAsFarAsItIsCounted() {
        String two = "factors:\n  - {key: chest_share, range: [0.4, 0.6], levels: 10000}\n"
                + "  - {key: left_over_right, range: [0.8, 1.4], levels: 10000}\n";
        refused(two + GRID + RESPONSE, "found a design of 100000000 runs, expected 1 to 1000000");
        String four = two + "  - {key: muscle_activation, range: [0.6, 0.8], levels: 10000}\n"
                + "  - {key: greatest_pressure_kpa, range: [1.2, 2.4], levels: 10000}\n";
        refused(four + GRID + RESPONSE, "found a design of at least 1099511627776 runs, expected 1 to 1000000");
    }

    @Test
    void creepIsRefusedUnlessABreathOfTheStudyHasAHold() {
        String told = "found creep, expected a breath with a hold";
        refused("factors:\n  - {key: preset, values: [quiet, deep]}\n" + GRID + CREEP, told);
        refused("factors:\n  - {key: hold, values: [false, false]}\n" + GRID + CREEP, told);
        refused("design: {kind: list, columns: [depth, preset], points: [[1, quiet], [1.2, deep]]}\n" + CREEP, told);
        // Its closed glottis is no hold that a breath ends with.
        refused("settings: {preset: cough}\n" + DEPTHS + GRID + CREEP, told);
        refused("settings: {changes: [\"1600:preset=hold-inspiration\"]}\n" + DEPTHS + GRID + CREEP, told);
        String held = "settings: {preset: hold-inspiration}\n";
        refused("settings: {changes: [\"1600:hold=false\"]}\n" + DEPTHS + GRID + CREEP, told);
        refused(held + "factors:\n  - {key: preset, values: [quiet, deep]}\n" + GRID + CREEP, told);
        for (String study : List.of(
                held + DEPTHS + GRID,
                "settings: {changes: [\"1600:hold=true\"]}\n" + DEPTHS + GRID,
                "factors:\n  - {key: preset, values: [quiet, hold-inspiration]}\n" + GRID,
                "factors:\n  - {key: preset, values: [quiet, deep]}\n  - {key: hold, values: [false, true]}\n" + GRID,
                "design: {kind: list, columns: [depth, preset], points: [[1, quiet], [1, hold-inspiration]]}\n")) {
            assertThat(SweepStudy.parse("study.yaml", study + CREEP).factors()).isNotEmpty();
        }
    }

    /** The refused combination is a failed run, as with every other response. */
    @ParameterizedTest
    @ValueSource(strings = {"[cough, hold-inspiration]", "[hold-inspiration, cough]"})
    void creepIsComputedBesideACombinationThatIsRefused(String presets) {
        String rate = "settings: {rate_per_min: 60}\n";
        String study = rate + "factors:\n  - {key: preset, values: " + presets + "}\n" + GRID + CREEP;
        SweepPlan plan = SweepPlan.of(SweepStudy.parse("study.yaml", study));
        SweepPoint cough = plan.points().get(presets.startsWith("[cough") ? 0 : 1);
        assertThat(RunRow.of(plan.model(), cough).failure()).startsWith("preset cough with rate_per_min 60");
    }

    @Test
    void pointsAreStatedOnceAndInAListOnly() throws IOException {
        Files.writeString(folder.resolve("p.csv"), "depth\n1\n");
        for (List<String> bad : List.of(
                List.of("{kind: list, file: p.csv, columns: [depth]}", "found columns besides a file"),
                List.of("{kind: list, file: p.csv, points: [[]]}", "found points besides a file"),
                List.of("{kind: grid, columns: [depth]}", "found columns in a design of kind grid"),
                List.of("{kind: sobol, columns: [depth]}", "found columns in a design of kind sobol"))) {
            String factors = bad.get(0).contains("list") ? "" : DEPTHS;
            Path study =
                    Files.writeString(folder.resolve("s.yaml"), factors + "design: " + bad.get(0) + "\n" + RESPONSE);
            assertThatThrownBy(() -> SweepStudy.read(study))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("key 'design'")
                    .hasMessageContaining(bad.get(1) + ", expected");
        }
    }

    /** The stated body would be used in no run. */
    @Test
    void personsAndAStatedBodyAreRefused() throws IOException {
        String cohort = "cohort: {persons: 2}\n" + GRID + RESPONSE;
        String told = "found the body 'virtual/adult-female' with persons, who have bodies of their own, expected none";
        refused("settings: {anatomy: virtual/adult-female}\n" + cohort, "line 1, key 'settings': " + told);
        Files.writeString(folder.resolve("woman.yaml"), "anatomy: virtual/adult-female\n");
        Path study = Files.writeString(folder.resolve("s.yaml"), "scenario: woman.yaml\n" + cohort);
        assertThatThrownBy(() -> SweepStudy.read(study)).hasMessageContaining("line 1, key 'scenario': " + told);
        // As in a scenario that a run writes, which states all settings.
        assertThat(SweepStudy.parse("study.yaml", "settings: {anatomy: virtual/adult-male}\n" + cohort)
                        .factors())
                .hasSize(1);
    }
}
