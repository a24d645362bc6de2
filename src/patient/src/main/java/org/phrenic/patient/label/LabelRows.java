package org.phrenic.patient.label;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureName;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;

/** Finds the labels that the rows of a user's table name. */
final class LabelRows {
    /** A side before a name, as readers put it there where the file states it apart from the name. */
    private static final Pattern SIDED = Pattern.compile("(?i)(left|right) (.+)");

    private LabelRows() {}

    /** The table of names and structures without the numbers of labels that {@code --labels} asks for, if it does. */
    static Optional<CsvTable> ofNamesAlone(String asked) {
        Path file = Path.of(asked);
        if (!Files.isRegularFile(file) || !NumberTable.named(asked).isEmpty() || NameFile.isJson(file)) {
            return Optional.empty();
        }
        try {
            return Optional.of(CsvTable.read(file))
                    .filter(table -> table.has("name") && table.has("structure") && !table.has("label"));
        } catch (BadInputException noTable) {
            return Optional.empty();
        }
    }

    /** Whether a row of a table of names has one of these. */
    static boolean anyNames(CsvTable table, Map<Integer, String> given) {
        List<String> rows = table.texts("name");
        List<String> structures = table.texts("structure");
        return IntStream.range(0, rows.size())
                .anyMatch(row -> !labels(given, rows, row, structures.get(row)).isEmpty());
    }

    /**
     * The labels of a row's name. A name that the volume does not have is that of the labels with a side before it that
     * no row names, unless the structure is of the other side: {@code Kidney} for {@code kidney_L} is {@code Left
     * Kidney}.
     *
     * @param given names by label in the volume
     * @param rows names in the table
     */
    static List<Integer> labels(Map<Integer, String> given, List<String> rows, int row, String structure) {
        String name = rows.get(row);
        List<Integer> exact = labels(given, name::equals);
        return exact.isEmpty()
                ? labels(given, own -> !Set.copyOf(rows).contains(own) && isWithSide(own, name, structure))
                : exact;
    }

    private static List<Integer> labels(Map<Integer, String> given, Predicate<String> isAsked) {
        return given.entrySet().stream()
                .filter(entry -> isAsked.test(entry.getValue()))
                .map(Map.Entry::getKey)
                .toList();
    }

    private static boolean isWithSide(String own, String name, String structure) {
        Matcher sided = SIDED.matcher(own);
        if (!sided.matches() || !sided.group(2).equals(name)) {
            return false;
        }
        Side other = sided.group(1).equalsIgnoreCase("left") ? Side.RIGHT : Side.LEFT;
        return StructureName.parse(structure)
                .filter(known -> known.side() == other)
                .isEmpty();
    }
}
