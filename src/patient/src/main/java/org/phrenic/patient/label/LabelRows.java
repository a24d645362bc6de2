package org.phrenic.patient.label;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureName;

/** Finds the labels that a row of a user's table names. */
final class LabelRows {
    /** A side before a name, as readers put it there where the file states it apart from the name. */
    private static final Pattern SIDED = Pattern.compile("(?i)(left|right) (.+)");

    private LabelRows() {}

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
