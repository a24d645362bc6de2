package org.phrenic.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Numerics;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;

class SettingsTest {
    static Stream<Setting<?>> others() {
        return Settings.all().stream().filter(setting -> !(setting instanceof Parameter));
    }

    static Stream<NumberSetting> numbers() {
        return others().filter(NumberSetting.class::isInstance).map(NumberSetting.class::cast);
    }

    @ParameterizedTest
    @MethodSource("others")
    void aScenarioTakesEveryValueThatIsOffered(Setting<?> setting) {
        assertThat(setting.options())
                .allSatisfy(option ->
                        assertThat(with(setting, option).text(setting)).isEqualTo(option));
    }

    @ParameterizedTest
    @MethodSource("numbers")
    void aScenarioTakesTheEndsOfEveryNumber(NumberSetting setting) {
        for (double end : new double[] {setting.minimum(), setting.maximum()}) {
            Scenario scenario = setting == RunSettings.DURATION && end < Numerics.TIME_STEP.minimum() * 2
                    ? Scenario.defaults().with(Numerics.TIME_STEP, end)
                    : Scenario.defaults();
            Assignment assignment = Assignment.read("test", setting.key(), NumberSetting.number(end));
            assertThat(scenario.with(List.of(assignment)).get(setting)).isEqualTo(end);
        }
    }

    @Test
    void aLightnessThatWouldHaveNoEffectIsRefused() {
        assertThatThrownBy(() -> Scenario.defaults().with("tendon_lightness=0.5"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 0.5, expected at least 1, at most 100 times");
    }

    @Test
    void aTimeStepOfWhichABreathTakesMillionsIsRefused() {
        assertThatThrownBy(() -> Scenario.defaults().with("time_step_s=1e-9"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 1.0E-9, expected at least 1.0E-5, at most 0.1 s");
    }

    /** A refusal says that 0 is taken where it is, and only there. */
    @ParameterizedTest
    @MethodSource("numbers")
    void whatIsLessThanNothingIsRefusedWithTheLeastThatIsTaken(NumberSetting setting) {
        String message = assertThrows(BadInputException.class, () -> Assignment.read("test", setting.key(), "-1"))
                .getMessage();
        assertThat(message.contains("expected at least 0,")).as(message).isEqualTo(setting.minimum() == 0);
    }

    /** On a command line nobody has quoted it. */
    @Test
    void aValueThatIsNoNumberIsStatedAsItWasTyped() {
        for (String typed : List.of("1,5", "80 %", "it's")) {
            assertThatThrownBy(() -> Scenario.defaults().with("depth=" + typed))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining(": key 'depth': found '" + typed + "', expected a number");
        }
    }

    private static Scenario with(Setting<?> setting, String value) {
        return Scenario.defaults().with(List.of(Assignment.read("test", setting.key(), value)));
    }

    @ParameterizedTest
    @MethodSource("others")
    void everySettingStandsInTheTableOfTheDocumentation(Setting<?> setting) throws IOException {
        String row = Files.readString(Path.of("docs/usage/run.md"))
                .lines()
                .filter(line -> line.startsWith("| `" + setting.key() + "` |"))
                .findFirst()
                .orElseThrow();
        if (setting != Breathing.PRESET || !row.contains("breathing")) {
            assertThat(setting.options()).allMatch(row::contains);
        }
        assertThat(setting.description()).endsWith(".");
    }

    @Test
    void keysAreUniqueAndAParameterIsFoundByIts() {
        assertThat(Settings.all()).extracting(Setting::key).doesNotHaveDuplicates();
        assertThat(others()).allMatch(setting -> Settings.find(setting.key()) == setting);
    }
}
