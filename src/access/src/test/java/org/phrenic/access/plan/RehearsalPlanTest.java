package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

/** The plan of an attempt by hand that is saved can be read and says what was. */
class RehearsalPlanTest {
    private static final TargetLesion TARGET = new TargetLesion(new double[] {-90, 0, 50}, 20);
    private static final double HOUR_S = 3600;

    @TempDir
    Path folder;

    private RehearsalPlan savedAndRead(RehearsalPlan plan) {
        YamlWriter.write(folder.resolve("scenario.yaml"), plan.scenario().toMap());
        YamlWriter.write(folder.resolve("plan.yaml"), plan.toMap("scenario.yaml"));
        return RehearsalPlan.read(folder.resolve("plan.yaml"));
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, HOUR_S, 3 * HOUR_S, 100 * HOUR_S})
    void thePlanOfAnAttemptOfAnyLengthCanBeReadAgain(double lastS) {
        RehearsalPlan practice = RehearsalPlan.practice(Scenario.defaults(), TARGET, Needle.standard(), 40);
        RehearsalPlan kept = practice.withSteps(TARGET, List.of(), lastS);
        RehearsalPlan read = savedAndRead(kept);
        assertThat(read.timeoutS()).isEqualTo(kept.timeoutS()).isGreaterThan(lastS);
        assertThat(read.moments()).as("moments of the breath that was recorded").isEqualTo(40);
    }

    @Test
    void aStepThatOnlyWithdrawsIsKeptAsOne() {
        PlanStep out = new PlanStep.Advance("withdraw", Optional.of(0.0), 50, true, true);
        PlanStep in = new PlanStep.Advance("advance", Optional.of(20.0), 50, true);
        RehearsalPlan practice = RehearsalPlan.practice(Scenario.defaults(), TARGET, Needle.standard(), 40);
        assertThat(savedAndRead(practice.withSteps(TARGET, List.of(in, out), 1)).steps())
                .extracting(step -> ((PlanStep.Advance) step).back())
                .containsExactly(false, true);
    }

    private RehearsalPlan ofScenario(String name) throws IOException {
        return RehearsalPlan.read(Files.writeString(
                folder.resolve("plan.yaml"),
                "target: {rest_mm: [-90, 0, 50], diameter_mm: 20}\nscenario: '" + name + "'\n"));
    }

    /** Windows reads a device by the first name, a file of another name by the second, and has not the others. */
    @ParameterizedTest
    @ValueSource(strings = {"con.yaml", "own.yaml.", "Pat. A./own.yaml", "scan 12:30.yaml"})
    void aScenarioHasAnyNameThatTheSystemHas(String name) throws IOException {
        boolean onWindows = File.separatorChar == '\\';
        if (onWindows) {
            assertThatThrownBy(() -> ofScenario(name))
                    .hasMessageContaining("line 2, key 'scenario': found '" + name + "', expected a name");
        } else {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            Files.writeString(file, "preset: deep\n");
            assertThat(ofScenario(name).scenario().preset()).isEqualTo("deep");
        }
    }

    @Test
    void aScenarioThatIsNoTextFileIsToldForWhatItIs() throws IOException {
        assertThatThrownBy(() -> ofScenario(folder.resolve("own.yaml").toString()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("line 2, key 'scenario': found no file '")
                .hasMessageEndingWith("', expected one");
        assertThatThrownBy(() -> ofScenario("own.yaml"))
                .hasMessageEndingWith("found no file 'own.yaml' in " + folder.toAbsolutePath() + ", expected one");
        Files.createDirectory(folder.resolve("sub"));
        assertThatThrownBy(() -> ofScenario("sub"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("folder")
                .hasMessageNotContaining("found no file");
    }

    private RehearsalPlan withStep(String step) throws IOException {
        return RehearsalPlan.read(Files.writeString(
                folder.resolve("plan.yaml"),
                "target: {rest_mm: [-90, 0, 50], diameter_mm: 20}\nsteps: [{" + step + "}]\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"place: {}", "place: {aim: target}", "place: {entry: best}"})
    void withoutAnEntryOrAnAimTheBestPathToTheTargetIsTaken(String step) throws IOException {
        assertThat(withStep(step).toMap("s.yaml").get("steps"))
                .isEqualTo(withStep("place: {entry: best, aim: target}")
                        .toMap("s.yaml")
                        .get("steps"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"entry: true", "entry: 5", "entry: worst"})
    void anEntryThatIsNoneNamesWhatWouldBeOne(String entry) {
        assertThatThrownBy(() -> withStep("place: {" + entry + "}"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("expected 'best', 'best-at-end-expiration' or three numbers in mm");
    }

    @Test
    void aTimeThatNeverComesIsRefused() throws IOException {
        Path file = Files.writeString(
                folder.resolve("plan.yaml"),
                "target: {rest_mm: [-90, 0, 50], diameter_mm: 20}\ngive_up_after_s: .inf\n");
        assertThatThrownBy(() -> RehearsalPlan.read(file)).hasMessageContaining("give_up_after_s");
    }

    @Test
    void theBodyAndTheRecordingOfAPlanAreTakenFromItsFolder() throws IOException {
        Path body = Files.createDirectory(folder.resolve("body"));
        Path breath = Files.writeString(
                folder.resolve("breath.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n8,0\n");
        Path file = Files.writeString(
                folder.resolve("plan.yaml"),
                "set: {anatomy: body, trace: breath.csv}\ntarget: {rest_mm: [-90, 0, 50], diameter_mm: 20}\n");
        Scenario scenario = RehearsalPlan.read(file).scenario();
        assertThat(scenario.anatomy()).isEqualTo(body.toString());
        assertThat(scenario.trace()).contains(breath);
    }
}
