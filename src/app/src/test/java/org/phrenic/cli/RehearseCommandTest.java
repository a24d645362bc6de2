package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.plan.Goals;
import org.phrenic.access.plan.RehearsalPlan;

/**
 * A planned attempt from the command line: its report, the same every time, and what is said of a plan that cannot be.
 */
@Execution(ExecutionMode.CONCURRENT)
class RehearseCommandTest {
    /** Fast breaths of the coarse body without what an attempt does not need. */
    private static final String BODY =
            "set: {preset: rapid-shallow, rate_per_min: 70, resolution: low, mesh_vertices: 2000, lungs: embedded, sternum: kinematic}\n"
                    + "phases: 4\n";

    private static final String TARGET = "target: {rest_mm: [-90, 0, 50], diameter_mm: 30}\n";
    private static final String STEPS = "steps:\n"
            + "  - wait: end-expiration of breath 1\n"
            + "  - place: {entry: best-at-end-expiration, aim: target}\n"
            + "  - advance: {speed_mm_per_s: 300}\n"
            + "  - image: {skin: right-intercostal, tilt_deg: 5}\n"
            + "  - sample: now\n";

    private static final String IMAGE_STEP = "  - image: {skin: right-intercostal}\n";
    private static final String IMAGE = "steps:\n" + IMAGE_STEP;

    @TempDir
    Path folder;

    private CommandLineRun rehearse(String out, String plan) throws IOException {
        Path file = Files.writeString(folder.resolve("plan.yaml"), plan);
        return CommandLineRun.of(
                "rehearse",
                file.toString(),
                "--no-pictures",
                "--out",
                folder.resolve(out).toString());
    }

    @Test
    void theSamePlanGivesTheSameReportOnAnyNumberOfThreadsAndWhatIsNotReachedIsExitCodeThree() throws IOException {
        String reached = "done_when: {hit: true, lung_s_at_most: 0}\n";
        String unreached = "done_when: {hit: true, attempts_at_most: 0}\n";
        CommandLineRun one = rehearse("one", onThreads(1) + TARGET + reached + STEPS);
        CommandLineRun two = rehearse("two", onThreads(2) + TARGET + unreached + STEPS);
        assertThat(one.exitCode()).as(one.err()).isZero();
        assertThat(two.exitCode()).as(two.err()).isEqualTo(3);
        assertThat(one.out()).contains("hit", "Not for clinical use");
        assertThat(two.out()).contains("not done");
        String first = Files.readString(folder.resolve("one/report.json"));
        String second = Files.readString(folder.resolve("two/report.json"));
        assertThat(first).contains("\"ultrasound\": [", "\"needle_in_beam_mm\"");
        assertThat(Files.readAllBytes(folder.resolve("one/ultrasound_0001.png")))
                .isEqualTo(Files.readAllBytes(folder.resolve("two/ultrasound_0001.png")));
        assertThat(first).contains("\"done\": true", "capsule_puncture", "not validated", "Not for clinical use");
        assertThat(second).contains("\"done\": false");
        assertThat(attempt(first.replace("\"threads\": 1", "\"threads\": 2"))).isEqualTo(attempt(second));
        assertThat(Files.readString(folder.resolve("one/report.html")))
                .contains("Not for clinical use", "not validated", "The path over a breath")
                .containsPattern("Date: 20[0-9-]{8} [0-9:]{5}");
    }

    @Test
    void aGoalThatIsMissedSaysWhy() {
        List<Goals.GoalResult> missed = List.of(
                new Goals.GoalResult("no_go_s_at_most", 0, 0, true, false),
                new Goals.GoalResult("lateral_mm_at_most", 5, Double.POSITIVE_INFINITY, false, false));
        assertThat(RehearseCommand.text(missed)).contains("0, and touched by a core", "no sample");
    }

    /** Its page shows the pictures by their names alone, whosever they are. */
    @Test
    void aReportThatFailsOnTheWayLeavesNoPageOfAnEarlierAttempt() throws IOException {
        Files.createDirectories(folder.resolve("again/report.html/in the way"));
        Path values = Files.writeString(folder.resolve("again/report.json"), "{}");
        CommandLineRun run = rehearse("again", BODY.replace("phases: 4", "phases: 2") + TARGET + IMAGE);
        assertThat(run.exitCode()).isNotZero();
        assertThat(run.err()).contains("report.html");
        assertThat(values).doesNotExist();
        Files.delete(folder.resolve("again/report.html/in the way"));
        Files.delete(folder.resolve("again/report.html"));
        Files.createDirectories(folder.resolve("again/report.json/in the way"));
        Path page = Files.writeString(folder.resolve("again/report.html"), "Hit");
        run = rehearse("again", BODY.replace("phases: 4", "phases: 2") + TARGET + IMAGE);
        assertThat(run.exitCode()).isNotZero();
        assertThat(run.err()).contains("report.json");
        assertThat(page).content().isNotEqualTo("Hit");
    }

    @Test
    void aReportIsKeptWithoutAPictureThatCannotBeWrittenAndSaysSo() throws IOException {
        Files.createDirectories(folder.resolve("less/ultrasound_0001.png/in the way"));
        CommandLineRun run = rehearse("less", BODY.replace("phases: 4", "phases: 2") + TARGET + IMAGE + IMAGE_STEP);
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(run.err().lines().filter(line -> line.startsWith("The report lacks pictures: ")))
                .singleElement()
                .asString()
                .contains("ultrasound_0001.png");
        for (String file : List.of("report.html", "report.json")) {
            assertThat(folder.resolve("less").resolve(file))
                    .content()
                    .contains("ultrasound_0002.png")
                    .doesNotContain("ultrasound_0001.png");
        }
    }

    @Test
    void anEntryOnTheCutEndOfTheBodyIsRefusedWithOneSentence() throws IOException {
        String steps = STEPS.replace("entry: best-at-end-expiration", "entry: [-60, 0, -135]");
        CommandLineRun run = rehearse("cut", BODY + TARGET + steps);
        assertThat(run.exitCode()).as(run.err()).isEqualTo(2);
        assertThat(run.err()).contains("found (-60.0, 0.0, -135.0), the cut end of the body, expected skin");
        assertThat(folder.resolve("cut")).doesNotExist();
    }

    @Test
    void changesOfTheScenarioAreRefusedBeforeAnythingIsPlayed() throws IOException {
        Files.writeString(folder.resolve("own.yaml"), "changes: ['5:depth=1.2']\n");
        for (String scenario : new String[] {"set: {changes: ['5:depth=1']}\n", "scenario: own.yaml\n"}) {
            CommandLineRun run = rehearse("changes", TARGET + scenario);
            assertThat(run.exitCode()).isEqualTo(2);
            assertThat(run.err()).hasLineCount(1).contains("line 2", "a plan holds the breath by its steps");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"a\\0b.yaml", ""})
    void aScenarioWhoseNameTheSystemDoesNotHaveIsToldWithItsLine(String name) throws IOException {
        CommandLineRun run = rehearse("bad", TARGET + "scenario: \"" + name + "\"\n");
        told(run, "plan.yaml: line 2, key 'scenario': found '");
        assertThat(run.err()).contains("expected a name that a file can have on this system");
    }

    @Test
    void aScenarioThatIsNotThereIsToldWithItsLine() throws IOException {
        for (String name : List.of("missing.yaml", "l" + "o".repeat(5000) + "ng.yaml")) {
            CommandLineRun run = rehearse("bad", TARGET + "scenario: " + name + "\n");
            told(run, "plan.yaml: line 2, key 'scenario': found no file '" + name.substring(0, 5));
            assertThat(run.err()).hasSizeLessThan(500);
        }
    }

    private static String onThreads(int count) {
        return BODY.replace("resolution: low", "resolution: low, threads: " + count);
    }

    private static String attempt(String report) {
        return report.substring(report.indexOf("\"attempt\""));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "speed: 3 | unknown key",
                "steps: [{jump: 1}] | unknown key",
                "steps: [{wait: end-of-the-world}] | expected seconds or one of",
                "steps: [{wait: -1}] | expected 0 or more",
                "steps: [{place: {entry: worst}}] | expected 'best'",
                "steps: [{place: {entry: [1, 2]}}] | expected three",
                "steps: [{advance: {speed_mm_per_s: 0}}] | more than 0",
                "steps: [{sample: later}] | expected 'now'",
                "steps: [{sample: now, wait: 1}] | found 2 keys",
                "needle: {gauge: 3} | expected 14 to 22 G",
                "needle: {length_mm: 3} | expected 20",
                "avoid: [air] | expected lung",
                "phases: 1 | expected 2",
                "done_when: {glory: 1} | unknown key",
                "done_when: {lung_s_at_most: -1} | found -1, expected 0 or more",
                "set: {preset: none} | key 'preset': found 'none'",
            })
    void aBadPlanIsToldInOneSentenceAndNothingIsWritten(String line, String expected) throws IOException {
        told(rehearse("bad", TARGET + line + "\n"), expected);
    }

    @Test
    void aPlanWithoutATargetOrWithTwoIsTold() throws IOException {
        told(rehearse("bad", "title: none\n"), "target");
        told(rehearse("bad", "target: {diameter_mm: 10}\n"), "found none of rest_mm, seed and lesion");
        told(rehearse("bad", "target: {rest_mm: [0, 0, 0], seed: 1}\n"), "found 2 of rest_mm, seed and lesion");
    }

    @Test
    void aTargetOutsideTheLiverAndAnEntryInsideTheBodyAreTold() throws IOException {
        told(rehearse("bad", BODY + TARGET.replace("-90, 0, 50", "90, 0, 50") + STEPS), "outside of the liver");
        String entry = STEPS.replace("best-at-end-expiration", "[-100, 0, 50]");
        told(rehearse("bad", BODY + TARGET + entry), "inside the body");
    }

    @Test
    void aNeedleThatIsTooShortAndABreathThatNeverComesAreTold() throws IOException {
        told(rehearse("bad", BODY + TARGET + "needle: {length_mm: 20}\n" + STEPS), "too short");
        String waits = "give_up_after_s: 1\nsteps: [{wait: end-inspiration of breath 90}]\n";
        told(rehearse("bad", BODY + TARGET + waits), "there was no end-inspiration of breath 90");
    }

    @Test
    void aBodyWhoseLiverOrLungsStandStillIsTold() throws IOException {
        told(
                rehearse("bad", BODY.replace("resolution: low", "resolution: low, liver: false") + TARGET + STEPS),
                "liver: false, or too far below the diaphragm), expected one that moves with the breath (liver: true,"
                        + " in the window Tune breathing > Forces > Liver");
        told(
                rehearse("bad", BODY.replace("lungs: embedded", "lungs: off") + TARGET + STEPS),
                "lungs: off), expected some that move with the breath (lungs: embedded, in the"
                        + " window Tune breathing > Forces > Lungs");
    }

    @Test
    void aFolderThatCannotBeWrittenIsToldBeforeAnythingIsSimulated() throws IOException {
        Path file = Files.writeString(folder.resolve("taken"), "a file");
        CommandLineRun run = rehearse("taken/below", BODY + TARGET + STEPS);
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.err().lines().filter(l -> l.startsWith("phrenic: ")))
                .singleElement()
                .asString()
                .contains("taken");
        assertThat(file).hasContent("a file");
    }

    private void told(CommandLineRun run, String expected) {
        assertThat(run.exitCode()).as(run.err()).isEqualTo(2);
        assertThat(run.err().lines().filter(l -> l.startsWith("phrenic: ")))
                .singleElement()
                .asString()
                .contains(expected);
        assertThat(run.out()).isEmpty();
        assertThat(folder.resolve("bad")).doesNotExist();
    }

    @Test
    void theShippedExercisesCanBeReadAndAskForSomething() {
        List<RehearsalPlan> exercises = RehearsalPlan.exercises();
        assertThat(exercises).hasSizeGreaterThanOrEqualTo(8);
        assertThat(exercises.stream().map(plan -> plan.scenario().anatomy()).distinct())
                .as("bodies")
                .hasSize(3);
        assertThat(exercises).allSatisfy(plan -> {
            assertThat(plan.goals().hit()).isTrue();
            assertThat(plan.steps()).isNotEmpty();
            assertThat(plan.description()).isNotEmpty();
            assertThat(plan.difficulty()).isNotEmpty();
        });
    }

    @Test
    void thePlanForABodyOfOnesOwnNamesTheFolderThatIsMissing() {
        CommandLineRun run = CommandLineRun.of(
                "rehearse",
                "data/exercises/own-body.yaml",
                "--out",
                folder.resolve("bad").toString());
        told(run, "my-body");
    }
}
