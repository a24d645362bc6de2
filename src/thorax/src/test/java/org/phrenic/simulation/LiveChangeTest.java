package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Muscle;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.scenario.Settings;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.SceneObserver;

/**
 * Settings changed while the simulation runs. The sheet alone is stepped where that shows what is asked, for it is
 * quick.
 */
@Execution(ExecutionMode.CONCURRENT)
class LiveChangeTest {
    /** A held time is a difference of two. */
    private static final double ROUNDING = 1e-12;

    /**
     * A mesh for what any sheet does, and for equal bits: four blocks of nodes on the sheet, which two threads share.
     */
    private static final String SMALL = "mesh_vertices=3000";

    /** Steps between two changes: a ramp takes thirteen times as long, so that several are always on their way. */
    private static final int BETWEEN = 15;
    /**
     * A scene held at rest creeps by 0.2 mm rms in 2 s as contacts settle, by more where tissue is softer or the
     * pressure higher; tension lost would be many millimetres.
     */
    private static final double STILL_MM = 1.2;

    @TempDir
    Path folder;

    /** For every live key two values, the second set while the first is still ramping in. */
    private Map<String, List<String>> values() throws IOException {
        Path curve = Files.writeString(
                folder.resolve("a curve.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n");
        Map<String, List<String>> values = new TreeMap<>(Map.of(
                "preset", List.of("deep", "hold-inspiration"),
                "trace", List.of(curve.toString(), "none"),
                "hold", List.of("true", "false"),
                "muscle", List.of("false", "true"),
                "pressure", List.of("false", "true"),
                "ribs", List.of("false", "true"),
                "tensegrity", List.of("false", "true"),
                "contact", List.of("false", "true"),
                "integrator", List.of("rk4", "symplectic-euler"),
                "time_step_s", List.of("0.0005", "0.0013")));
        values.put("repeat_breath", List.of("true", "false"));
        for (Parameter p : Materials.parameters()) {
            double low = p.minimum() + 0.1 * (p.maximum() - p.minimum());
            double high = p.minimum() + 0.2 * (p.maximum() - p.minimum());
            values.put(p.key(), List.of(Double.toString(low), Double.toString(high)));
        }
        return values;
    }

    /** Keys that the material has a use for. */
    private static List<String> liveKeys(TissueMaterial material) {
        return Settings.all().stream()
                .filter(Setting::isLive)
                .filter(setting -> !(setting instanceof Parameter p) || material.uses(p))
                .map(Setting::key)
                .toList();
    }

    @ParameterizedTest
    @CsvSource({"physical, 1", "paper, 2"})
    void theSameChangesAtTheSameStepsGiveTheSameBitsFromAScenarioAndLiveOnAnyThreads(String name, int threads)
            throws IOException {
        TissueMaterial material = Materials.MATERIAL.named(name);
        String[] set = {"material=" + material.label(), "duration_s=9", SMALL, "threads=2"};
        Scenario start = Runs.scenario(Runs.sheetAlone(set));
        List<ScheduledChange> changes = new ArrayList<>();
        for (String key : liveKeys(material)) {
            for (String value : values().get(key)) {
                changes.add(ScheduledChange.parse(BETWEEN * (changes.size() + 1) + ":" + key + "=" + value));
            }
        }
        Path file = folder.resolve(material + ".yaml");
        YamlWriter.write(file, start.withChanges(changes).toMap());
        assertThat(Scenario.read(file)).isEqualTo(start.withChanges(changes));
        try (Simulation scheduled = Runs.simulation(Scenario.read(file));
                Simulation live = Runs.simulation(start.with("threads=" + threads))) {
            for (ScheduledChange change : changes) {
                steps(scheduled, BETWEEN);
                steps(live, BETWEEN);
                assertThat(live.stateHash()).as("before %s", change.text()).isEqualTo(scheduled.stateHash());
                // What is changed and changed again before a step was never there.
                live.change(Assignment.read("a slider", change.assignment().key(), firstOf(change)));
                live.change(change.assignment());
            }
            steps(scheduled, BETWEEN);
            steps(live, BETWEEN);
            assertThat(live.stateHash()).isEqualTo(scheduled.stateHash());
            assertThat(live.changes()).extracting(ScheduledChange::text).isEqualTo(texts(changes));
            assertThat(scheduled.changes()).extracting(ScheduledChange::text).isEqualTo(texts(changes));
        }
    }

    /**
     * Settings that are set back before the next step, as by a slider or by undo, have not changed. With steps of 2 ms
     * most sums of a start and a number of steps have other bits than the number of all steps times the time step.
     */
    @Test
    void whatIsSetBackBeforeTheNextStepWasNeverThere() {
        Scenario start = Runs.scenario(Runs.sheetAlone("preset=deep", "time_step_s=0.002", SMALL));
        int before = 101;
        List<ScheduledChange> changes = new ArrayList<>();
        for (String kept : List.of("time_step_s=0.002", "integrator=verlet", "muscle_stiffness_n_per_m=300")) {
            changes.add(ScheduledChange.parse(before * (changes.size() + 1) + ":" + kept));
        }
        List<String> others = List.of("time_step_s=0.001", "integrator=rk4", "muscle_stiffness_n_per_m=900");
        try (Simulation scheduled = Runs.simulation(start.withChanges(changes));
                Simulation live = Runs.simulation(start)) {
            for (int i = 0; i < changes.size(); i++) {
                steps(live, before);
                live.change(Assignment.parse(others.get(i)));
                live.change(changes.get(i).assignment());
            }
            steps(live, before);
            steps(scheduled, (int) live.steps());
            assertThat(live.stateHash()).isEqualTo(scheduled.stateHash());
            assertThat(live.time()).isEqualTo(scheduled.time());
            assertThat(live.stepper().substeps()).isEqualTo(scheduled.stepper().substeps());
            assertThat(live.stepper().limit()).isEqualTo(scheduled.stepper().limit());
            assertThat(live.changes()).extracting(ScheduledChange::text).isEqualTo(texts(changes));
        }
    }

    /** Ramps take 0.2 s, 160 steps: at the divergence they are over, at the restored state they begin. */
    @ParameterizedTest
    @ValueSource(strings = {"springs", "embedded"})
    void afterADivergenceARunGoesOnFromTheChangeBitForBitAsBefore(String lungs) {
        int before = 100;
        int after = 200;
        Scenario start = Runs.scenario("preset=deep", "lungs=" + lungs, SMALL, "threads=2");
        try (Simulation simulation = Runs.simulation(start)) {
            steps(simulation, before);
            simulation.change(List.of(
                    Assignment.parse("muscle_stiffness_n_per_m=900"),
                    Assignment.parse("greatest_pressure_kpa=3"),
                    Assignment.parse("sternum_coupling=2")));
            steps(simulation, after);
            String hash = simulation.stateHash();
            for (int failures = 0; failures < 2; failures++) {
                simulation.system().velocities()[0] = Double.NaN;
                assertThatExceptionOfType(DivergenceException.class).isThrownBy(simulation::step);
                assertThat(simulation.steps()).isEqualTo(before);
                steps(simulation, after);
                assertThat(simulation.stateHash()).isEqualTo(hash);
            }
        }
    }

    /** The state that comes back is one that no change has saved. */
    @Test
    void soItDoesWithoutAChangeWhichItsChangesThenTell() {
        Scenario start = Runs.scenario("preset=deep", "lungs=springs", SMALL, "threads=2");
        try (Simulation simulation = Runs.simulation(start)) {
            steps(simulation, 300);
            simulation.system().velocities()[0] = Double.NaN;
            assertThatExceptionOfType(DivergenceException.class).isThrownBy(simulation::step);
            assertThat(simulation.steps()).isEqualTo(256);
            simulation.goOn();
            steps(simulation, 100);
            try (Simulation again = Runs.simulation(start.withChanges(simulation.changes()))) {
                steps(again, 356);
                assertThat(again.stateHash()).isEqualTo(simulation.stateHash());
            }
            assertThat(simulation.undoLastChange()).as("anything to undo").isFalse();
        }
    }

    @Test
    void soDoTheKeysOfSternumAndLungsInTheWholeScene() {
        Scenario start = Runs.scenario(SMALL, "threads=2");
        List<ScheduledChange> changes = List.of(
                ScheduledChange.parse("5:lung_stiffness_n_per_m=12"),
                ScheduledChange.parse("20:sternum_coupling=2"),
                ScheduledChange.parse("35:muscle_stiffness_n_per_m=500"));
        try (Simulation scheduled = Runs.simulation(start.withChanges(changes));
                Simulation live = Runs.simulation(start.with("threads=1"))) {
            for (ScheduledChange change : changes) {
                steps(live, (int) (change.step() - live.steps()));
                live.change(change.assignment());
            }
            steps(live, 20);
            steps(scheduled, (int) live.steps());
            assertThat(live.stateHash()).isEqualTo(scheduled.stateHash());
        }
    }

    /**
     * The second change finds the ramp of the first on its way, at a step whose time has other bits than the end of the
     * step before. Who looks at that step, as a row of observables or a picture does, computes the ribs for its time.
     */
    @ParameterizedTest
    @CsvSource({"rib_rotation, 1.5, 0.7", "upper_rib_rotation, 1.5, 0.7", "ribs, false, true"})
    void lookingAtARunBeforeAChangeChangesNoBits(String key, String firstValue, String secondValue) {
        int first = 520;
        int second = 544;
        Scenario start = Runs.scenario("preset=deep", "lungs=embedded", SMALL, "threads=2");
        assertThat((second - 1) * start.timeStepS() + start.timeStepS()).isNotEqualTo(second * start.timeStepS());
        try (Simulation unseen = Runs.simulation(start);
                Simulation seen = Runs.simulation(start)) {
            for (Simulation simulation : List.of(unseen, seen)) {
                steps(simulation, first);
                simulation.change(Assignment.parse(key + "=" + firstValue));
                steps(simulation, second - first);
            }
            new SceneObserver(seen.scene()).observe(seen.time());
            for (Simulation simulation : List.of(unseen, seen)) {
                simulation.change(Assignment.parse(key + "=" + secondValue));
                steps(simulation, BETWEEN);
            }
            assertThat(seen.stateHash()).isEqualTo(unseen.stateHash());
        }
    }

    private String firstOf(ScheduledChange change) throws IOException {
        return values().get(change.assignment().key()).get(0);
    }

    private static List<String> texts(List<ScheduledChange> changes) {
        return changes.stream().map(ScheduledChange::text).toList();
    }

    private static void steps(Simulation simulation, int count) {
        for (int i = 0; i < count; i++) {
            simulation.step();
        }
    }

    private static double fromRest(Simulation simulation) {
        return new SceneObserver(simulation.scene()).observe(simulation.time()).get("from_rest_rms_mm");
    }

    @Test
    void tissueMadeStifferSofterHeavierOrUnderAnotherPressureStaysWhereItIsAtRest() {
        // Everything but the breath: whole scene, held at end-expiration.
        try (Simulation simulation = Runs.simulation(Runs.scenario("hold=true", SMALL, "threads=2"))) {
            for (String change : List.of(
                    "muscle_stiffness_n_per_m=1200",
                    "muscle_stiffness_n_per_m=150",
                    "muscle_stiffness_n_per_m=300",
                    "rest_pressure_kpa=0.5",
                    "pressure=false",
                    "lung_stiffness_n_per_m=20")) {
                simulation.change(Assignment.parse(change));
                steps(simulation, 250);
                assertThat(fromRest(simulation)).as(change).isLessThan(STILL_MM);
            }
        }
    }

    @Test
    void aChangeNeverJerksAndNeverStepsBeyondTheLimit() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone(SMALL)))) {
            SceneObserver observer = new SceneObserver(simulation.scene());
            steps(simulation, 300);
            for (String change : List.of(
                    "depth=2",
                    "rate_per_min=25",
                    "hold=true",
                    "hold=false",
                    "preset=deep",
                    "ribs=false",
                    "muscle=false",
                    "muscle_stiffness_n_per_m=3000")) {
                Observation before = observer.observe(simulation.time());
                simulation.change(Assignment.parse(change));
                Observation after = observer.observe(simulation.time());
                for (String column : Observation.COLUMNS) {
                    // Only the place in the breath may be another at once.
                    if (!column.equals("breath") && !column.equals("phase")) {
                        assertThat(after.get(column))
                                .as("%s: %s", change, column)
                                .isEqualTo(before.get(column));
                    }
                }
                for (int i = 0; i < 170; i++) {
                    simulation.step();
                    Observation now = observer.observe(simulation.time());
                    for (String driven : List.of("activation", "rib_turn", "pressure_kpa")) {
                        // All the way in 0.2 s at the ramp's steepest (15/8) is 0.0094 of it a millisecond.
                        assertThat(Math.abs(now.get(driven) - before.get(driven)))
                                .as(change + ": " + driven)
                                .isLessThan(0.02);
                    }
                    before = now;
                }
                double stable = StabilityLimit.of(simulation.system())
                        .largestStep(simulation.stepper().integrator().kind());
                assertThat(simulation.stepper().dt() / simulation.stepper().substeps())
                        .as(change)
                        .isLessThan(stable);
            }
            assertThat(simulation.stepper().substeps()).isGreaterThan(1);
            assertThat(simulation.stabilityMessage())
                    .contains("beyond the stability limit")
                    .contains("substeps");
        }
    }

    @Test
    void aBreathThatIsHeldStandsStillWhereItIsAndGoesOnFromThere() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone("preset=deep", SMALL)))) {
            steps(simulation, 1500);
            simulation.change(Assignment.parse("hold=true"));
            steps(simulation, 600);
            double held = new SceneObserver(simulation.scene())
                    .observe(simulation.time())
                    .get("activation");
            steps(simulation, 500);
            Observation later = new SceneObserver(simulation.scene()).observe(simulation.time());
            assertThat(held).isGreaterThan(0.1);
            assertThat(later.get("activation")).isCloseTo(held, within(ROUNDING));
            assertThat(simulation.breathLabel().name()).isEqualTo("HOLD");
            simulation.change(Assignment.parse("hold=false"));
            steps(simulation, 100);
            double onward = new SceneObserver(simulation.scene())
                    .observe(simulation.time())
                    .get("phase");
            assertThat(onward).isGreaterThan(later.get("phase")).isCloseTo(later.get("phase"), within(0.05));
        }
    }

    @Test
    void whatDidNotHelpIsFollowedByTakingBackTheChangesBefore() {
        Scenario start = Runs.scenario(Runs.sheetAlone(SMALL));
        try (Simulation simulation = Runs.simulation(start)) {
            assertThat(simulation.undoLastChange()).isFalse();
            simulation.change(List.of(Assignment.parse("depth=2"), Assignment.parse("muscle=false")));
            steps(simulation, 3);
            simulation.change(Assignment.parse("depth=0.5"));
            steps(simulation, 3);
            assertThat(simulation.undoLastChange()).isTrue();
            assertThat(simulation.settings().get(Breathing.DEPTH)).isEqualTo(2);
            assertThat(simulation.settings().get(Muscle.MUSCLE)).isFalse();
            steps(simulation, 3);
            assertThat(simulation.undoLastChange()).isTrue();
            assertThat(simulation.settings()).isEqualTo(start.with("depth=1"));
            assertThat(simulation.undoLastChange()).isFalse();
            // What somebody does after that is again the first to be taken back.
            steps(simulation, 3);
            simulation.change(Assignment.parse("muscle=false"));
            assertThat(simulation.undoLastChange()).isTrue();
            assertThat(simulation.settings().get(Muscle.MUSCLE)).isTrue();
        }
    }

    /** A slider sends many values while it is dragged; none of those on its way is a setting to go back to. */
    @Test
    void theDragOfASliderIsTakenBackAsOne() {
        Scenario start = Runs.scenario(Runs.sheetAlone(SMALL));
        try (Simulation simulation = Runs.simulation(start)) {
            simulation.change(Assignment.parse("depth=2"));
            steps(simulation, 3);
            for (String stiffness : List.of("290", "250", "200")) {
                simulation.change(Assignment.parse("muscle_stiffness_n_per_m=" + stiffness));
                steps(simulation, 3);
                // As after a divergence, where the next value comes at the same step.
                simulation.goOn();
            }
            steps(simulation, 3);
            assertThat(simulation.undoLastChange()).isTrue();
            assertThat(simulation.settings()).isEqualTo(start.with("depth=2"));
            assertThat(simulation.changes())
                    .filteredOn(c -> c.step() == simulation.steps())
                    .extracting(c -> c.assignment().key())
                    .containsExactly("muscle_stiffness_n_per_m");
            // Long after a change another of the same setting is one of its own.
            simulation.change(Assignment.parse("depth=1.5"));
            steps(simulation, (int) Math.ceil(1 / simulation.stepper().dt()));
            simulation.change(Assignment.parse("depth=1"));
            assertThat(simulation.undoLastChange()).isTrue();
            assertThat(simulation.settings()).isEqualTo(start.with("depth=1.5"));
        }
    }

    @Test
    void timeIsTheSumOfStepCountsTimesTheirSteps() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone(SMALL)))) {
            steps(simulation, 100);
            simulation.change(Assignment.parse("time_step_s=0.0003"));
            steps(simulation, 100);
            simulation.change(Assignment.parse("time_step_s=0.0007"));
            steps(simulation, 100);
            assertThat(simulation.time()).isEqualTo(100 * 0.00125 + 100 * 0.0003 + 100 * 0.0007);
        }
    }

    @Test
    void anUnknownAStructuralAndAnImpossibleChangeAreOneSentenceAndChangeNothing() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone(SMALL)))) {
            for (String bad : List.of("depht=1", "resolution=high", "depth=9", "integrator=rk2")) {
                Scenario before = simulation.settings();
                boolean refused = false;
                try {
                    simulation.change(
                            bad.startsWith("integrator")
                                    ? List.of(Assignment.parse(bad), Assignment.parse("damping_rate_per_s=0"))
                                    : List.of(Assignment.parse(bad)));
                } catch (IllegalArgumentException | BadInputException e) {
                    refused = true;
                    assertThat(e.getMessage())
                            .doesNotContain("\n")
                            .containsAnyOf("depht", "resolution", "depth", "rk2");
                }
                assertThat(refused).as(bad).isTrue();
                assertThat(simulation.settings()).isEqualTo(before);
                assertThat(simulation.changes()).isEmpty();
            }
        }
    }

    @Test
    void changesOfAScenarioAreCheckedBeforeItRuns() {
        Scenario scenario = Scenario.defaults();
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> ScheduledChange.parse("-3:depth=1"))
                .withMessageContaining("step of 0 or more");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> scenario.withChanges(
                        List.of(ScheduledChange.parse("9:depth=1"), ScheduledChange.parse("3:depth=1"))))
                .withMessageContaining("found step 3 after step 9");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> scenario.withChanges(List.of(ScheduledChange.parse("9:resolution=low"))))
                .withMessageContaining("cannot be changed while");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> scenario.withChanges(List.of(ScheduledChange.parse("9:depht=1"))))
                .withMessageContaining("did you mean 'depth'?");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> scenario.withChanges(List.of(ScheduledChange.parse("9:depth=7"))))
                .withMessageContaining("found 7, expected 0 to 2");
    }

    @Test
    void aRestartGivesTheBitsOfASceneThatWasPutTogetherWithWhatIsSet() {
        try (Simulation simulation = Runs.simulation(Runs.scenario(Runs.sheetAlone(SMALL)));
                Simulation fresh = Runs.simulation(Runs.scenario(Runs.sheetAlone(SMALL, "depth=1.5", "preset=deep")))) {
            steps(simulation, 77);
            simulation.change(Assignment.parse("preset=deep"));
            simulation.change(Assignment.parse("depth=1.5"));
            steps(simulation, 77);
            assertThat(simulation.restart()).isTrue();
            assertThat(simulation.time()).isZero();
            steps(simulation, 120);
            steps(fresh, 120);
            assertThat(simulation.stateHash()).isEqualTo(fresh.stateHash());
            simulation.change(Assignment.parse("muscle_stiffness_n_per_m=500"));
            assertThat(simulation.restart()).as("another assembly").isFalse();
        }
    }
}
