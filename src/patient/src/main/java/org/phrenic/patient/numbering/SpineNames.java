package org.phrenic.patient.numbering;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Names of vertebrae and of the discs between them, by their place from the top: each vertebra, then its disc. */
final class SpineNames {
    static final String SACRAL = "vertebra_S1";

    private static final int CERVICAL = 7;
    private static final List<String> VERTEBRAE = IntStream.range(0, 24)
            .mapToObj(i -> String.format(
                    Locale.ROOT,
                    i < 7 ? "vertebra_C%d" : i < 19 ? "vertebra_T%02d" : "vertebra_L%02d",
                    i < 7 ? i + 1 : i < 19 ? i - 6 : i - 18))
            .toList();
    private static final List<String> NAMES = IntStream.range(0, VERTEBRAE.size())
            .boxed()
            .flatMap(i -> Stream.of(
                    VERTEBRAE.get(i),
                    "disc_" + shortName(VERTEBRAE.get(i)) + "_"
                            + shortName(i + 1 < VERTEBRAE.size() ? VERTEBRAE.get(i + 1) : SACRAL)))
            .toList();

    private SpineNames() {}

    /** The name of a vertebra in that of a disc, such as T9. */
    private static String shortName(String vertebra) {
        return vertebra.substring(vertebra.indexOf('_') + 1).replaceFirst("(?<=[TL])0", "");
    }

    /** Place of a cervical, thoracic or lumbar vertebra or of the disc below it; negative for all else. */
    static int place(String name) {
        return NAMES.indexOf(name);
    }

    /** Place of a vertebra by its level, 1 for the first thoracic one. */
    static int place(int level) {
        return 2 * (level + CERVICAL - 1);
    }

    static String at(int place) {
        return NAMES.get(place);
    }

    /** Whether this is a cervical vertebra or the disc below one. */
    static boolean isOfNeck(String name) {
        return place(name) >= 0 && place(name) < place(1);
    }

    /**
     * The name of the vertebra or disc so many below, or above if negative; beyond the last lumbar vertebra the first
     * sacral one. The last disc keeps its name, as does all else.
     */
    static String below(String name, int down) {
        int place = place(name);
        if (place < 0) {
            return name;
        }
        int to = Math.max(0, place + 2 * down);
        return to < NAMES.size() ? NAMES.get(to) : place % 2 == 0 ? SACRAL : name;
    }
}
