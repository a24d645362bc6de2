package org.phrenic.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.SheetSprings;

class ScenarioTest {
    @TempDir
    Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("mine.yaml"), text);
    }

    static Stream<Path> shipped() throws IOException {
        return Files.list(Path.of("data/scenarios")).sorted();
    }

    @ParameterizedTest
    @MethodSource("shipped")
    void everyShippedScenarioIsReadAndItsResolvedFormReadsBackEqual(Path shipped) {
        Scenario scenario = Scenario.read(shipped);
        Path resolved = folder.resolve("scenario.yaml");
        YamlWriter.write(resolved, scenario.toMap());
        assertThat(Scenario.read(resolved)).isEqualTo(scenario).hasSameHashCodeAs(scenario);
        assertThat(Scenario.read(resolved).toMap()).isEqualTo(scenario.toMap());
    }

    @Test
    void withoutAnyKeyItIsTwoQuietBreathsOfTheVirtualAdultMale() {
        Scenario scenario = Scenario.defaults();
        assertThat(scenario.name()).isEqualTo("quiet");
        assertThat(scenario.anatomy()).isEqualTo("virtual/adult-male");
        assertThat(scenario.resolution()).isEqualTo(Resolution.MEDIUM);
        assertThat(scenario.durationS()).isNaN();
        assertThat(scenario.durationS(Breathing.patternOf(scenario))).isEqualTo(8);
        assertThat(scenario.timeStepS()).isEqualTo(0.00125);
        assertThat(scenario.get(SheetSprings.MUSCLE_STIFFNESS)).isEqualTo(300);
        assertThat(scenario.states(Breathing.RATE)).isFalse();
        assertThat(scenario.get(Breathing.RATE)).isEqualTo(15);
        assertThat(scenario.toMap()).doesNotContainKey("rate_per_min");
        assertThat(scenario.breathing().parameters().ratePerMin()).isEqualTo(15);
        assertThat(scenario.states(Breathing.DEPTH)).isFalse();
    }

    @Test
    void aChangeToWhatThePresetGivesStatesNothing() {
        Scenario slow = Scenario.defaults().with("rate_per_min=9");
        Scenario back = slow.changed(List.of(Assignment.parse("rate_per_min=15")));
        assertThat(back.states(Breathing.RATE)).isFalse();
        assertThat(back.changed(List.of(Assignment.parse("preset=deep"))).get(Breathing.RATE))
                .isEqualTo(7.5);
    }

    @Test
    void aValueThatIsStatedEqualsTheSameByDefault() {
        Scenario stated = Scenario.defaults().with("rate_per_min=15");
        assertThat(stated.states(Breathing.RATE)).isTrue();
        assertThat(stated).isEqualTo(Scenario.defaults()).hasSameHashCodeAs(Scenario.defaults());
        assertThat(stated.with("preset=deep")).isNotEqualTo(Scenario.defaults().with("preset=deep"));
    }

    @Test
    void everyKeyCanBeGivenAndComesBack() throws IOException {
        Path body = Files.createDirectory(folder.resolve("body"));
        Files.writeString(folder.resolve("curve.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n");
        Scenario scenario = Scenario.read(
                file(
                        """
                name: "a: b"
                preset: deep
                trace: curve.csv
                material: paper
                anatomy: body
                resolution: low
                mesh_vertices: 9000
                duration_s: 3.5
                time_step_s: 2e-3
                integrator: rk4
                step_policy: refuse
                threads: 1
                record_every_s: 0.1
                meshes_every_s: 0.5
                muscle: false
                pressure: false
                ribs: false
                tensegrity: false
                contact: false
                sternum: kinematic
                lungs: embedded
                liver: false
                links_per_node: 3
                tendon: plane
                spring_stiffness_n_per_m: 20
                rate_per_min: 12
                """));
        assertThat(scenario.name()).isEqualTo("a: b");
        assertThat(scenario.anatomy()).isEqualTo(body.toAbsolutePath().toString());
        assertThat(scenario.trace()).contains(folder.resolve("curve.csv").toAbsolutePath());
        assertThat(scenario.integrator()).isEqualTo(IntegratorKind.RK4);
        assertThat(scenario.timeStepS()).isEqualTo(0.002);
        assertThat(scenario.durationS(Breathing.patternOf(scenario))).isEqualTo(3.5);
        assertThat(scenario.get(SheetSprings.SPRING_STIFFNESS)).isEqualTo(20);
        assertThat(scenario.get(Breathing.RATE)).isEqualTo(12);
        assertThat(scenario.toMap().keySet()).containsAll(Settings.keys().subList(0, 24));
        Path resolved = folder.resolve("resolved/scenario.yaml");
        YamlWriter.write(resolved, scenario.toMap());
        assertThat(Scenario.read(resolved)).isEqualTo(scenario);
    }

    @Test
    void assignmentsTakeTheKeysOfTheFileAndTheLaterOfTwoCounts() {
        Scenario scenario = Scenario.defaults().with("depth=1.2", "preset=deep", "depth=0.5", "name=a b #1: 'c'");
        assertThat(scenario.get(Breathing.DEPTH)).isEqualTo(0.5);
        assertThat(scenario.preset()).isEqualTo("deep");
        assertThat(scenario.name()).isEqualTo("a b #1: 'c'");
        for (String word : List.of("null", "Null", "NULL", "~", "-", "nullify", "true", "12")) {
            assertThat(Scenario.defaults().with("name=" + word).name()).isEqualTo(word);
        }
        assertThat(Scenario.defaults().with("material=paper").timeStepS()).isEqualTo(0.01);
        assertThat(scenario.states(Breathing.DEPTH)).isTrue();
        assertThat(scenario.states(Breathing.RATE)).isFalse();
    }

    @Test
    void aParameterOfTheOtherMaterialIsRefusedRatherThanIgnored() {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> Scenario.defaults().with("node_mass_kg=0.2"))
                .withMessageContaining("does not use it")
                .withMessageContaining("paper");
        Scenario paper = Scenario.defaults().with("material=paper", "node_mass_kg=0.2");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> paper.with("material=physical"))
                .withMessageContaining("node_mass_kg");
    }

    @Test
    void theSentenceOfABadValueNamesFileLineKeyAndWhatWasExpected() throws IOException {
        Path file = file("preset: quiet\ndepth: 9\n");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> Scenario.read(file))
                .withMessage(file + ": line 2, key 'depth': found 9, expected 0 to 2");
        Path misspelt = file("presset: quiet\n");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> Scenario.read(misspelt))
                .withMessage(file + ": line 1, key 'presset': found an unknown key, did you mean 'preset'?");
    }

    /** A unit that is left out is no reason to list all keys, nor is a word that is near none of them. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "muscle_stifness | did you mean 'muscle_stiffness_n_per_m'?",
                "muscle_stiffness | did you mean 'muscle_stiffness_n_per_m'?",
                "wanderlust_zone | expected a key such as name, preset, trace, material, anatomy (docs/parameters.md has all)"
            })
    void anUnknownKeyIsRefusedWithAFewKeys(String key, String expected) throws IOException {
        Path file = file(key + ": 1\n");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> Scenario.read(file))
                .withMessage(file + ": line 1, key '" + key + "': found an unknown key, " + expected);
    }
}
