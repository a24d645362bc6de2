package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.MeshSamples;

class YamlTest {
    private static final String SCENARIO =
            """
            preset: quiet   # the breathing
            time_step_s: 1e-3
            threads: 2
            record: true
            country: no
            fixed: [0, 1.5, -2]
            views:
              - anterior
              - left
            muscle:
              activation: 0.5
              'quoted': '5'
            meshes:
              - {file: liver.stl, side: right}
              - file: lung.stl
            nothing:
            """;

    @TempDir
    Path folder;

    private static YamlMap scenario() {
        return YamlDocument.parse("scenario.yaml", SCENARIO);
    }

    private static void refused(ThrowingCallable read, String sentence) {
        assertThatExceptionOfType(BadInputException.class).isThrownBy(read).withMessage(sentence);
    }

    private static void refusedText(String text, String... words) {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> YamlDocument.parse("s.yaml", text))
                .satisfies(e -> assertThat(e.getMessage())
                        .startsWith("s.yaml: ")
                        .contains(words)
                        .doesNotContain("\n"));
    }

    @Test
    void valuesAreReadAsTheirKind() {
        YamlMap yaml = scenario();
        assertThat(yaml.text("preset")).isEqualTo("quiet");
        assertThat(yaml.number("time_step_s")).isEqualTo(0.001);
        assertThat(yaml.integer("threads")).isEqualTo(2);
        assertThat(yaml.flag("record")).isTrue();
        assertThat(yaml.text("country")).isEqualTo("no");
        assertThat(yaml.numbers("fixed")).containsExactly(0, 1.5, -2);
        assertThat(yaml.texts("views")).containsExactly("anterior", "left");
        assertThat(yaml.map("muscle").number("activation")).isEqualTo(0.5);
        assertThat(yaml.maps("meshes")).extracting(m -> m.text("file")).containsExactly("liver.stl", "lung.stl");
        assertThat(yaml.number("absent", 7)).isEqualTo(7);
        assertThat(yaml.mapOrEmpty("absent").keys()).isEmpty();
    }

    @Test
    void aWrongValueIsToldWithFileLineAndKey() {
        YamlMap yaml = scenario();
        refused(() -> yaml.number("preset"), "scenario.yaml: line 1, key 'preset': found 'quiet', expected a number");
        refused(
                () -> yaml.integer("time_step_s"),
                "scenario.yaml: line 2, key 'time_step_s': found '1e-3', expected a whole number");
        refused(() -> yaml.flag("country"), "scenario.yaml: line 5, key 'country': found 'no', expected true or false");
        refused(
                () -> yaml.map("muscle").number("quoted"),
                "scenario.yaml: line 12, key 'muscle.quoted': found the quoted text '5', expected a number");
        refused(
                () -> yaml.number("muscle"),
                "scenario.yaml: line 10, key 'muscle': found a mapping, expected a number");
        refused(
                () -> yaml.numbers("views"),
                "scenario.yaml: line 8, key 'views[0]': found 'anterior', expected a number");
        refused(
                () -> yaml.number("nothing"),
                "scenario.yaml: line 16, key 'nothing': found nothing, expected a number");
        refused(
                () -> yaml.number("time_step"),
                "scenario.yaml: line 1, key 'time_step': found no such key (there is 'time_step_s'), expected a number");
        refused(
                () -> {
                    throw yaml.bad("threads", "found 2, expected 1");
                },
                "scenario.yaml: line 3, key 'threads': found 2, expected 1");
    }

    @ParameterizedTest
    @ValueSource(strings = {".nan", ".inf", "-.inf", "NaN", "Infinity", "1e999", "0x10", "1:30", "1_000", "5d", "''"})
    void whatIsNoPlainDecimalNumberIsRefused(String value) {
        YamlMap yaml = YamlDocument.parse("s.yaml", "a: " + value);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> yaml.number("a"))
                .withMessageContaining("expected a number");
    }

    @Test
    void anUnknownKeyIsRefusedWithTheNearestOne() {
        YamlMap yaml = YamlDocument.parse("s.yaml", "duration_s: 8\ntimestep_s: 1\n");
        refused(
                () -> yaml.requireOnly(List.of("duration_s", "time_step_s", "threads")),
                "s.yaml: line 2, key 'timestep_s': found an unknown key, did you mean 'time_step_s'?");
        refused(
                () -> yaml.requireOnly(List.of("duration_s", "preset")),
                "s.yaml: line 2, key 'timestep_s': found an unknown key, expected one of duration_s, preset");
    }

    @Test
    void whatIsNoMappingIsRefusedWithTheLine() {
        refusedText("a: 1\nb: 2\na: 3\n", "line 3", "key 'a'", "a second time");
        refusedText("a: [1, 2\nb: 3\n", "line 2");
        refusedText("a: \tx: y\n", "line 1");
        refusedText("- 1\n- 2\n", "found a list", "expected a mapping");
        refusedText("just words", "found 'just words'");
        refusedText("a: 1\n---\nb: 2\n", "line 2", "another document");
        refusedText("? [1, 2]\n: x\n", "as a key");
        refusedText("a: \u0007", "s.yaml");
        assertThat(YamlDocument.parse("s.yaml", "# only a comment\n").keys()).isEmpty();
    }

    @Test
    void aSmallFileCannotUnfoldIntoALargeOneNorMakeObjects() {
        StringBuilder laughs = new StringBuilder("a0: &a0 [x, x]\n");
        for (int i = 1; i < 30; i++) {
            laughs.append("a" + i + ": &a" + i + " [*a" + (i - 1) + ", *a" + (i - 1) + "]\n");
        }
        refusedText(laughs.toString(), "aliases");
        refusedText("a: &a [*a]\n", "nested within themselves");
        refusedText("a: " + "[".repeat(5000), "s.yaml");
        refusedText("a: !!javax.script.ScriptEngineManager [x]\n", "line 1", "tag is not allowed");
    }

    /** The map, the list and the values of the list are a million values, and one more. */
    @Test
    void moreThanAMillionValuesAreRefused() {
        refusedText("a: [0" + ",0".repeat(999_998) + "]\n", "expected at most 30 levels and 1000000 values");
    }

    /** A list of many points, as a study leaves one. */
    @Test
    void aFileOfManyMegabytesIsRead() {
        String person = "- " + "a person ".repeat(100) + "\n";
        YamlMap yaml = YamlDocument.parse("s.yaml", "persons:\n" + person.repeat(10_000));
        assertThat(yaml.texts("persons")).hasSize(10_000);
    }

    @Test
    void aFileIsReadWithOrWithoutAByteOrderMark() {
        byte[] bytes = ("\uFEFF" + SCENARIO).getBytes(StandardCharsets.UTF_8);
        YamlMap file = YamlDocument.read(MeshSamples.write(folder, "s.yaml", bytes));
        assertThat(file.toMap()).isEqualTo(scenario().toMap());
        Path broken = MeshSamples.write(folder, "x.yaml", new byte[] {'a', ':', (byte) 0xFF});
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> YamlDocument.read(broken))
                .withMessageContaining("UTF-8");
    }

    @Test
    void anAliasStandsForTheValueOfItsAnchor() {
        YamlMap yaml = YamlDocument.parse(
                "s.yaml", "a: &x {p: 1, q: [1, 2]}\nb: *x\n&k key: &v word\nc: {*k : *v}\nd: [*v, '5']\n");
        assertThat(yaml.map("b").toMap()).isEqualTo(yaml.map("a").toMap());
        assertThat(yaml.map("c").text("key")).isEqualTo("word");
        assertThat(yaml.texts("d")).containsExactly("word", "5");
        refused(() -> yaml.number("b"), "s.yaml: line 2, key 'b': found a mapping, expected a number");
        refusedText("a: *nope\n", "line 1", "key 'a'", "undefined alias 'nope'");
    }

    @Test
    void whatIsWrittenIsReadBack() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("time_step_s", 1e-4);
        values.put("threads", 2);
        values.put("name", "no");
        values.put("number_as_text", "12");
        values.put("text", "a: b # c, 'd' \"e\"\nnext line ü");
        values.put("flag", false);
        values.put("list", new double[] {0.1, 1e300, -0.0});
        values.put("again", List.of(1, "x", Map.of("k", List.of())));
        Path file = folder.resolve("resolved.yaml");
        YamlWriter.write(file, values);
        YamlMap back = YamlDocument.read(file);

        assertThat(back.keys()).containsExactlyElementsOf(values.keySet());
        assertThat(back.number("time_step_s")).isEqualTo(1e-4);
        assertThat(back.text("name")).isEqualTo("no");
        assertThat(back.isNumber("number_as_text")).isFalse();
        assertThat(back.text("text")).isEqualTo(values.get("text"));
        assertThat(back.numbers("list")).containsExactly(0.1, 1e300, -0.0);
        assertThat(YamlWriter.format(back.toMap())).isEqualTo(YamlWriter.format(values));
        assertThat(YamlWriter.format(values)).startsWith("time_step_s: 1.0E-4\nthreads: 2\n");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> YamlWriter.format(Map.of("a", Map.of("b", Double.NaN))))
                .withMessage("a.b: found NaN, expected a finite number");
    }
}
