package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;

/** Points of 3D Slicer's markups are a table in LPS, wherever a table of points is read. */
class MarkupPointsTest {
    private static final String POINTS =
            """
            {"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/markups-schema-v1.0.3.json#",
             "markups": [{"type": "Fiducial", "coordinateSystem": "RAS", "coordinateUnits": "mm",
              "controlPoints": [
               {"id": "1", "label": "F-1, dome", "position": [-12.5, 30, 440.25], "positionStatus": "defined"},
               {"id": "2", "label": "F-2", "position": [0, 0, 0], "positionStatus": "undefined"},
               {"id": "3", "label": "F-3", "orientation": [-1, 0, 0, 0, -1, 0, 0, 0, 1], "position": [1, 2, 3]}],
              "display": {"visibility": false, "color": [0.4, 1, 1]}}]}
            """;

    @TempDir
    private Path folder;

    private CsvTable read(byte[] content) throws IOException {
        return CsvTable.read(Files.write(folder.resolve("points.mrk.json"), content));
    }

    private CsvTable read(String text) throws IOException {
        return read(text.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void definedPointsComeInLps() throws IOException {
        CsvTable table = read(POINTS);
        assertThat(table.texts("name")).containsExactly("F-1, dome", "F-3");
        assertThat(table.numbers("x_mm")).containsExactly(12.5, -1);
        assertThat(table.numbers("y_mm")).containsExactly(-30, -2);
        assertThat(table.numbers("z_mm")).containsExactly(440.25, 3);
        CsvTable lps = read(POINTS.replace("\"RAS\"", "\"LPS\""));
        assertThat(lps.numbers("x_mm")).containsExactly(-12.5, 1);
    }

    /** Version 1.0.4 writes a unit as its symbol, the system of symbols and its meaning. */
    @Test
    void aUnitMayBeAListOfWords() throws IOException {
        String listed = POINTS.replace("\"mm\"", "[\"mm\", \"UCUM\", \"millimeter\"]");
        assertThat(read(listed).numbers("x_mm")).containsExactly(12.5, -1);
        assertThatThrownBy(() -> read(listed.replace("\"mm\"", "\"cm\"")))
                .hasMessageContaining("line 2: found the unit 'cm', expected mm");
        assertThatThrownBy(() -> read(listed.replace("\"mm\", ", "")))
                .hasMessageContaining("found the unit 'UCUM', expected mm");
        assertThatThrownBy(() -> read(POINTS.replace("\"mm\"", "[]"))).hasMessageContaining("expected a unit");
    }

    @Test
    void otherDocumentsAreRefusedWithTheirLine() {
        assertThatThrownBy(() -> read("x,y,z\n1,2,3\n"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("line 1: found no JSON");
        assertThatThrownBy(() -> read("{\"points\": []}")).hasMessageContaining("no 'markups'");
        assertThatThrownBy(() -> read(POINTS.replace("[1, 2, 3]", "[1, 2]")))
                .hasMessageContaining("line 6: found no number in a position");
        assertThatThrownBy(() -> read(POINTS.replace("RAS", "IJK"))).hasMessageContaining("expected LPS or RAS");
        assertThatThrownBy(() -> read(POINTS.replace("\"mm\"", "\"cm\""))).hasMessageContaining("expected mm");
    }

    @Test
    void damagedFilesAreReadOrRefusedInOneSentence() throws IOException {
        Random random = new Random(5);
        byte[] whole = POINTS.getBytes(StandardCharsets.UTF_8);
        for (int n = 0; n < 500; n++) {
            byte[] damaged = whole.clone();
            damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            damaged[random.nextInt(damaged.length)] =
                    "{}[],:\"0-9".getBytes(StandardCharsets.US_ASCII)[random.nextInt(10)];
            try {
                assertThat(read(damaged).rowCount()).isLessThan(4);
            } catch (BadInputException refused) {
                assertThat(refused.getMessage()).contains("points.mrk.json").doesNotContain("\n");
            }
        }
    }
}
