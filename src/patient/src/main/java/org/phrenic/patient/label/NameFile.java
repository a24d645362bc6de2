package org.phrenic.patient.label;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.phrenic.document.CsvTable;
import org.phrenic.document.TextFile;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Names of labels in a file of their own: {@code dataset.json} of nnU-Net or any JSON of names and numbers, the label
 * descriptions of ITK-SNAP, the colour tables of 3D Slicer.
 */
final class NameFile {
    private static final String LABELS = "labels";
    private static final String WHAT = "names of labels";
    /** Columns of labels and names; the second pair is that of 3D Slicer. */
    private static final Map<String, String> COLUMNS = Map.of("label", "name", "LabelValue", "Name");

    private static final Pattern NUMBER = Pattern.compile("\\d{1,5}");
    /** What JSON may hold and YAML does not. */
    private static final Pattern ESCAPED_SLASH = Pattern.compile("(?<!\\\\)((?:\\\\\\\\)*)\\\\/");
    /** Number, red, green, blue, opacity, whether it is seen and meshed, name. */
    private static final Pattern DESCRIPTION =
            Pattern.compile("\\s*(\\d{1,5})\\s+\\d+\\s+\\d+\\s+\\d+\\s+[\\d.]+\\s+\\d\\s+\\d\\s+\"(.*)\"\\s*");
    /** A row of a colour table: number, name in quotes or as far as its last word with a letter, numbers after it. */
    private static final Pattern COLOUR =
            Pattern.compile("\\s*(\\d{1,5})\\s+(\"[^\"]*\"|\\S.*\\p{L}\\S*|\\p{L}\\S*)((?:\\s+\\d{1,3}){3,})\\s*");
    /** Red, green, blue and mostly opacity end each row of a colour table. */
    private static final int MOST_CHANNELS = 4;

    private NameFile() {}

    /**
     * The names by label; empty if the file is none of these.
     *
     * @throws BadInputException if it cannot be read, or gives a label two names
     */
    static Optional<Map<Integer, String>> read(Path file) {
        Map<Integer, String> names;
        if (ends(file, ".csv")) {
            names = ofTable(file, CsvTable.read(file));
        } else {
            String text = TextFile.read(file, WHAT);
            names = isJson(file) ? ofJson(file, json(file, text)) : ofLines(file, rows(text));
        }
        return Optional.of(names).filter(found -> !found.isEmpty());
    }

    /**
     * The names of a file that lies beside a volume; empty if it is none of names. A data set has to have
     * {@code labels}, whose names may all be of several labels. A text that cannot be read, or that does not begin with
     * a name, is a note of somebody.
     *
     * @throws BadInputException if it cannot be read, or gives a label two names
     */
    static Optional<Map<Integer, String>> beside(Path file) {
        if (isJson(file)) {
            return Optional.of(json(file, TextFile.read(file, WHAT)))
                    .filter(all -> all.get(LABELS) instanceof Map<?, ?>)
                    .map(all -> ofJson(file, all));
        }
        String text;
        try {
            text = TextFile.read(file, WHAT);
        } catch (BadInputException unreadable) {
            if (ends(file, ".txt")) {
                return Optional.empty();
            }
            throw unreadable;
        }
        List<String> rows = rows(text);
        return rows.isEmpty() || !isOfName(rows.get(0))
                ? Optional.empty()
                : Optional.of(ofLines(file, rows)).filter(found -> !found.isEmpty());
    }

    static boolean isJson(Path file) {
        return ends(file, ".json");
    }

    private static boolean ends(Path file, String ending) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith(ending);
    }

    /** Names of a table of labels and names without their structures. */
    private static Map<Integer, String> ofTable(Path file, CsvTable table) {
        Map<Integer, String> names = new TreeMap<>();
        for (Map.Entry<String, String> columns : COLUMNS.entrySet()) {
            if (!table.has("structure") && table.has(columns.getKey()) && table.has(columns.getValue())) {
                List<String> labels = table.texts(columns.getKey());
                List<String> words = table.texts(columns.getValue());
                IntStream.range(0, labels.size()).forEach(row -> put(file, names, labels.get(row), words.get(row)));
            }
        }
        return names;
    }

    private static Map<String, Object> json(Path file, String text) {
        String yaml = ESCAPED_SLASH.matcher(text.replace('\t', ' ')).replaceAll("$1/");
        return YamlDocument.parse(file.toString(), yaml).toMap();
    }

    /** Names of {@code labels}, or of the whole file, as a number by name or a name by number. */
    private static Map<Integer, String> ofJson(Path file, Map<String, Object> all) {
        Map<Integer, String> names = new TreeMap<>();
        Map<?, ?> rows = all.get(LABELS) instanceof Map<?, ?> labels ? labels : all;
        rows.forEach((key, value) -> {
            String name = String.valueOf(key);
            if (value instanceof List<?> numbers && numbers.size() == 1) {
                put(file, names, String.valueOf(numbers.get(0)), name);
            } else if (value instanceof String words && NUMBER.matcher(name).matches()) {
                put(file, names, name, words);
            } else {
                put(file, names, String.valueOf(value), name);
            }
        });
        return names;
    }

    private static List<String> rows(String text) {
        return text.lines()
                .filter(line -> !line.isBlank() && !line.stripLeading().startsWith("#"))
                .toList();
    }

    private static boolean isOfName(String row) {
        return DESCRIPTION.matcher(row).matches() || COLOUR.matcher(row).matches();
    }

    /** Names of rows of either form; others are passed over. */
    private static Map<Integer, String> ofLines(Path file, List<String> rows) {
        Map<Integer, String> names = new TreeMap<>();
        int channels = channels(rows);
        for (String row : rows) {
            Matcher description = DESCRIPTION.matcher(row);
            Matcher colour = COLOUR.matcher(row);
            if (description.matches()) {
                put(file, names, description.group(1), description.group(2));
            } else if (colour.matches()) {
                List<String> name = new ArrayList<>(List.of(colour.group(2)));
                List<String> numbers = numbers(colour);
                name.addAll(numbers.subList(0, numbers.size() - channels));
                put(file, names, colour.group(1), String.join(" ", name));
            }
        }
        return names;
    }

    /** Numbers of a colour: those that all rows have after the name, for names may end with numbers of their own. */
    private static int channels(List<String> rows) {
        return rows.stream()
                .map(COLOUR::matcher)
                .filter(Matcher::matches)
                .mapToInt(row -> numbers(row).size())
                .reduce(MOST_CHANNELS, Math::min);
    }

    private static List<String> numbers(Matcher colour) {
        return List.of(colour.group(3).strip().split("\\s+", -1));
    }

    /** Adds a name, unless the number is none of a label, as that of the background. */
    private static void put(Path file, Map<Integer, String> names, String number, String name) {
        int label = NUMBER.matcher(number).matches() ? Integer.parseInt(number) : 0;
        if (label < 1 || label > LabelGrid.MAX_LABEL) {
            return;
        }
        String words = name.strip().replaceAll("^\"(.*)\"$", "$1").replaceFirst(":$", "");
        String before = names.put(label, words);
        if (before != null && !before.equals(words)) {
            throw new BadInputException(
                    file + ": found label " + label + " for '" + before + "' and '" + words + "', expected one name");
        }
    }
}
