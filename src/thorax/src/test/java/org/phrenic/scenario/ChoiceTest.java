package org.phrenic.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.parameter.Parameter;

class ChoiceTest {
    @ParameterizedTest
    @EnumSource(Choice.class)
    void aScenarioTakesEveryValueThatIsOffered(Choice choice) {
        assertThat(choice.options()).allSatisfy(option -> assertThat(choice.valueIn(with(choice, option)))
                .isEqualTo(option));
        if (choice.isNumber()) {
            for (double end : new double[] {choice.minimum(), choice.maximum()}) {
                assertThat(Double.parseDouble(choice.valueIn(with(choice, Parameter.format(end)))))
                        .isEqualTo(end);
            }
        }
    }

    private static Scenario with(Choice choice, String value) {
        return Scenario.defaults().with(List.of(new Assignment("test", choice.key(), value)));
    }

    @ParameterizedTest
    @EnumSource(Choice.class)
    void everyChoiceStandsInTheTableOfTheDocumentation(Choice choice) throws IOException {
        String row = Files.readString(Path.of("docs/usage.md"))
                .lines()
                .filter(line -> line.startsWith("| `" + choice.key() + "` |"))
                .findFirst()
                .orElseThrow();
        assertThat(choice.options()).allMatch(row::contains);
        assertThat(choice.description()).endsWith(".");
    }

    @Test
    void aChoiceIsNoParameterAndEachIsAKeyOfAScenario() {
        assertThat(Choice.values())
                .extracting(Choice::key)
                .doesNotHaveDuplicates()
                .doesNotContainAnyElementsOf(Parameter.keys())
                .allMatch(Scenario.keys()::contains);
    }
}
