package org.phrenic.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.MeshSamples;

@Isolated("changes the default locale")
class CsvTest {
    @TempDir
    Path folder;

    private static void refused(String text, String column, String sentence) {
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> CsvTable.parse("t.csv", text).numbers(column))
                .withMessage("t.csv: " + sentence);
    }

    @Test
    void commasPointsQuotesSpacesAndEmptyLinesAreUnderstood() {
        CsvTable table =
                CsvTable.parse("t.csv", "time_s, \"flow, l/s\" ,who\r\n0,1.5,\"a \"\"b\"\"\"\r\n\r\n1e-1 , -2,c");
        assertThat(table.columnNames()).containsExactly("time_s", "flow, l/s", "who");
        assertThat(table.rowCount()).isEqualTo(2);
        assertThat(table.numbers("time_s")).containsExactly(0, 0.1);
        assertThat(table.numbers("flow, l/s")).containsExactly(1.5, -2);
        assertThat(table.texts("who")).containsExactly("a \"b\"", "c");
    }

    @Test
    void aSpreadsheetWithSemicolonsDecimalCommasAndAByteOrderMarkIsUnderstood() {
        // A line with nothing before the header.
        byte[] bytes = "\uFEFF\r\ntime_s;volume_ml\r\n0,5;500\r\n1.5;-0,25\r\n".getBytes(StandardCharsets.UTF_8);
        CsvTable table = CsvTable.read(MeshSamples.write(folder, "t.csv", bytes));
        assertThat(table.numbers("time_s")).containsExactly(0.5, 1.5);
        assertThat(table.numbers("volume_ml")).containsExactly(500, -0.25);
    }

    @Test
    void aTableInAnotherEncodingIsRefusedAndNotReadWithoutItsLetters() {
        byte[] bytes = "label,structure\n1,other_l\u00e4sion\n".getBytes(StandardCharsets.ISO_8859_1);
        Path file = MeshSamples.write(folder, "latin.csv", bytes);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> CsvTable.read(file))
                .withMessage(file + ": found bytes that are not UTF-8, expected a table in UTF-8");
    }

    @Test
    void problemsAreToldWithFileLineAndColumn() {
        refused("a,b\n1,2\n3,x\n", "b", "line 3, column 'b': found 'x', expected a number");
        refused("a,b\n\n\n1,2\n3,x", "b", "line 5, column 'b': found 'x', expected a number");
        refused("a,b\n\"1\n\",2\n3,x\n", "b", "line 4, column 'b': found 'x', expected a number");
        refused("a,b\n1,NaN\n", "b", "line 2, column 'b': found 'NaN', expected a number");
        refused("a,b\n1,\n", "b", "line 2, column 'b': found '', expected a number");
        refused("a;b\n1;1.000,5\n", "b", "line 2, column 'b': found '1.000,5', expected a number");
        refused("a,b\n1,\"2,5\"\n", "b", "line 2, column 'b': found '2,5', expected a number");
        refused("a,b\n1,2\n", "c", "line 1: found columns a, b, expected a column 'c'");
        refused("a,b\n1,2,3\n", "a", "line 2: found 3 cells, expected 2 as in the header");
        refused("a,b\n1\n", "a", "line 2: found 1 cells, expected 2 as in the header");
        refused("a,a\n1,2\n", "a", "line 1: found column 'a' a second time, expected different names");
        refused("a,\n1,2\n", "a", "line 1: found column 2 without a name, expected one");
        refused("\n\n", "a", "line 1: found nothing, expected a line of column names");
        refused(
                "a,b\n1,\"2\n",
                "a",
                "after line 1: found a quoted cell that is broken, expected a closing quote before the delimiter");
    }

    @Test
    void aNumberThatIsNotThereIsAnEmptyCellInATableOfAnyCells() {
        String text = CsvWriter.format(
                List.of("name", "from_mm", "to_mm"),
                List.of(List.of("liver", Double.NaN, 1.5), List.of("spleen", -2.0, 7)));
        assertThat(text).isEqualTo("name,from_mm,to_mm\nliver,,1.5\nspleen,-2.0,7\n");
    }

    @Test
    void numbersAreWrittenAlikeWhateverTheLocale() {
        Map<String, double[]> columns = new LinkedHashMap<>();
        columns.put("time_s", new double[] {0, 0.001, 1.0 / 3});
        columns.put("dome_right_mm", new double[] {-1e-9, Double.NaN, 12345.678});
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            assertThat(CsvWriter.format(columns, CsvWriter.ALL_DIGITS))
                    .isEqualTo("time_s,dome_right_mm\n0.0,-1.0E-9\n0.001,\n0.3333333333333333,12345.678\n");
            assertThat(CsvWriter.format(columns, 4))
                    .isEqualTo("time_s,dome_right_mm\n0.0,-1.0E-9\n0.001,\n0.3333,12350.0\n");
        } finally {
            Locale.setDefault(before);
        }
    }

    /** For a long table to need no more memory than a row. */
    @Test
    void theFirstRowsAreWrittenBeforeTheLastIsAskedFor() throws IOException {
        Path file = folder.resolve("long.csv");
        int last = 20_000;
        List<Long> written = new ArrayList<>();
        IntFunction<List<?>> row = i -> {
            if (i == last) {
                written.add(folder.resolve(".long.csv.part0").toFile().length());
            }
            return List.of(i / 7.0, Double.NaN);
        };
        List<String> header = List.of("a", "b");
        CsvWriter.write(file, header, () -> IntStream.rangeClosed(0, last)
                .<List<?>>mapToObj(row)
                .iterator());
        assertThat(Files.readString(file))
                .isEqualTo(CsvWriter.format(
                        header,
                        IntStream.rangeClosed(0, last).<List<?>>mapToObj(row).toList()));
        assertThat(written.get(0)).isGreaterThan(100_000);
    }

    @Test
    void whatIsWrittenIsReadBackBitForBit() {
        double[] values = {Math.PI, -1e-300, 1e300, 0.1 + 0.2, -0.0};
        Path file = folder.resolve("o/curves.csv");
        CsvWriter.write(file, Map.of("x", values), CsvWriter.ALL_DIGITS);
        assertThat(CsvTable.read(file).numbers("x")).containsExactly(values);
        CsvWriter.write(file, List.of("a", "b"), List.of(List.of("x, \"y\"", 1), List.of("", 2.5)));
        assertThat(CsvTable.read(file).texts("a")).containsExactly("x, \"y\"", "");
        Map<String, double[]> uneven = new LinkedHashMap<>();
        uneven.put("a", new double[1]);
        uneven.put("b", new double[2]);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> CsvWriter.format(uneven, 3))
                .withMessage("column 'b': 2 values, expected 1");
    }
}
