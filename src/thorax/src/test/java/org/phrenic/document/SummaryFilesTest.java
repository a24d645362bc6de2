package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Hashes;
import org.phrenic.mesh.io.PvdSeries;

/** The small files beside the meshes: JSON, the index of a series, hashes. */
class SummaryFilesTest {
    @TempDir
    Path folder;

    @Test
    void jsonKeepsTheOrderAndEscapesText() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("steps", 8000);
        values.put("dt_s", 1e-3);
        values.put("name", "a \"b\" \\ \n\u0001 ü");
        values.put("ok", true);
        values.put("none", null);
        values.put("box_mm", new double[] {1, 2.5});
        values.put("inner", Map.of("k", List.of()));
        values.put("empty", Map.of());
        Path file = folder.resolve("summary.json");
        JsonWriter.write(file, values);

        assertThat(file)
                .usingCharset(StandardCharsets.UTF_8)
                .hasContent(
                        """
                        {
                          "steps": 8000,
                          "dt_s": 0.001,
                          "name": "a \\"b\\" \\\\ \\n\\u0001 ü",
                          "ok": true,
                          "none": null,
                          "box_mm": [1.0, 2.5],
                          "inner": {
                            "k": []
                          },
                          "empty": {}
                        }
                        """);
    }

    /** JSON may hold these characters as they are, YAML may not, and takes some for the end of a line. */
    @Test
    void jsonOfAnyTextCanBeReadAsYaml() {
        StringBuilder text = new StringBuilder("a");
        for (char c = 1; c < 0x100; c++) {
            text.append(c);
        }
        text.append("\u2028\u2029\uFEFF\uFFFE\uFFFF\uD83D\uDE00b");
        String json = JsonWriter.format(Map.of("name " + text, text.toString()));
        assertThat(json)
                .contains("\\u007F\\u0080", "\\u0096", "\\u009F", "\\u2028")
                .contains("\u00E4");
        assertThat(YamlDocument.parse("a.json", json).text("name " + text)).isEqualTo(text.toString());
    }

    /**
     * The file is replaced, not written over: a second name of the old file, as an open reader has, keeps its content.
     */
    @Test
    void jsonReplacesAFileAtOnce() throws IOException {
        Path file = Files.writeString(folder.resolve("summary.json"), "old");
        Path old = Files.createLink(folder.resolve("old.json"), file);
        JsonWriter.write(file, Map.of("steps", 1));
        assertThat(file).hasContent("{\n  \"steps\": 1\n}");
        assertThat(old).hasContent("old");
    }

    @Test
    void jsonRefusesWhatItCannotSay() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> JsonWriter.format(Map.of("a", List.of(1, Double.POSITIVE_INFINITY))))
                .withMessage("a[1]: found Infinity, expected a finite number");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> JsonWriter.format(Map.of("a", new Object[0])))
                .withMessageStartingWith("a: found a [Ljava.lang.Object;, expected a map");
    }

    @Test
    void theIndexNamesFilesRelativeToItself() {
        PvdSeries series = new PvdSeries(folder.resolve("out/scene.pvd"));
        series.add(0, folder.resolve("out/meshes/a&b_0.vtp"));
        series.add(0.5, 1, folder.resolve("out/liver.vtp"));
        series.write();

        assertThat(folder.resolve("out/scene.pvd"))
                .content()
                .contains("<DataSet timestep=\"0.0\" group=\"\" part=\"0\" file=\"meshes/a&amp;b_0.vtp\"/>")
                .contains("<DataSet timestep=\"0.5\" group=\"\" part=\"1\" file=\"liver.vtp\"/>")
                .endsWith("</Collection>\n</VTKFile>\n");
        assertThatIllegalArgumentException().isThrownBy(() -> series.add(Double.NaN, folder.resolve("x.vtp")));
    }

    @Test
    void theHashOfAFileIsThatOfTheStandard() throws IOException {
        // FIPS 180-4 example: SHA-256 of "abc".
        Path file = Files.writeString(folder.resolve("abc"), "abc");
        assertThat(Hashes.sha256(file)).isEqualTo("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> Hashes.sha256(folder.resolve("none")))
                .withMessageContaining("none");
    }

    @Test
    void theHashOfNumbersIsThatOfTheirBits() {
        // Python: hashlib.sha256(struct.pack('>3d', 1.0, -0.0, 3.141592653589793)).hexdigest()
        String expected = "009a830ca47a1a149dc15b90df5423eb39d4d4f0fe47ea013845e93fe7d7ed06";
        assertThat(Hashes.sha256(new double[] {1, -0.0, Math.PI})).isEqualTo(expected);
        assertThat(Hashes.sha256(new double[] {1}, new double[] {-0.0, Math.PI}))
                .isEqualTo(expected);
        assertThat(Hashes.sha256(new double[] {1, 0.0, Math.PI})).isNotEqualTo(expected);
        assertThat(Hashes.sha256(new double[20_000]))
                .as("more than one chunk")
                .isEqualTo("b9ce164d30e4101b009fe4be765a070593cfbdd48f897853de159a8c177fabe8");
    }
}
