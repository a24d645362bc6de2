package org.phrenic.patient.label;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.document.CsvTable;
import org.phrenic.document.ShippedFile;

/**
 * Label numbers of a segmentation tool or a public data set. {@code data/labels/numbers.csv} lists the tables and their
 * sources.
 *
 * @param name what {@code --labels} calls it; versions of a tool share a name
 * @param title name of the tool or data set
 * @param structures structure by label
 * @param below label of the lower lobe of a lung by that of the upper one
 * @param names structure by the name of its label
 */
record NumberTable(
        String name,
        String title,
        Map<Integer, String> structures,
        Map<Integer, Integer> below,
        Map<String, String> names) {
    /** The shipped tables that a volume is held against. */
    static final List<NumberTable> ALL = all("yes");
    /** Tables that have to be asked for, because other orders of organs fit them as well. */
    private static final List<NumberTable> ASKED_FOR = all("no");

    /** @param guessed yes or no */
    private static List<NumberTable> all(String guessed) {
        CsvTable index = shipped("numbers.csv");
        return IntStream.range(0, index.texts("file").size())
                .filter(row -> index.texts("guessed").get(row).equals(guessed))
                .mapToObj(row -> read(
                        index.texts("name").get(row),
                        index.texts("title").get(row),
                        index.texts("file").get(row)))
                .toList();
    }

    private static NumberTable read(String name, String title, String file) {
        CsvTable table = shipped(file);
        double[] labels = table.numbers("label");
        List<String> structures = table.texts("structure");
        Map<Integer, String> byLabel = new TreeMap<>();
        Map<String, String> byName = new TreeMap<>();
        Map<Integer, Integer> below = new TreeMap<>();
        int[] upper = new int[2];
        for (int row = 0; row < labels.length; row++) {
            String words = table.texts("name").get(row);
            byLabel.put((int) labels[row], structures.get(row));
            byName.put(words, structures.get(row));
            if (words.contains("lung") && words.contains("upper_lobe")) {
                upper[side(words)] = (int) labels[row];
            } else if (words.contains("lung") && words.contains("lower_lobe")) {
                below.put(upper[side(words)], (int) labels[row]);
            }
        }
        return new NumberTable(name, title, byLabel, below, byName);
    }

    private static int side(String words) {
        return words.contains("left") ? 0 : 1;
    }

    static CsvTable shipped(String file) {
        return CsvTable.parse(file, ShippedFile.text("labels/" + file));
    }

    private static Stream<NumberTable> every() {
        return Stream.concat(ALL.stream(), ASKED_FOR.stream());
    }

    /** The tables of a name in upper or lower case. */
    static List<NumberTable> named(String name) {
        return every().filter(table -> table.name().equalsIgnoreCase(name)).toList();
    }

    /** Names of tables in order of preference. */
    static List<String> distinctNames() {
        return every().map(NumberTable::name).distinct().toList();
    }
}
