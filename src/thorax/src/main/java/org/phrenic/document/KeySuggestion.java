package org.phrenic.document;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Suggests a known name for a mistyped one. */
public final class KeySuggestion {
    private KeySuggestion() {}

    /** Words of a key lie between these: muscle_stiffness_n_per_m. */
    private static final char BETWEEN_WORDS = '_';

    /** Letters from which on a name may be the beginning of a longer one. */
    private static final int BEGINNING = 4;

    /**
     * The first of {@code known} with the least edit distance to {@code name}, if the distance is small for its length.
     * Words that a key has beyond {@code name}, such as its unit, count as one edit.
     */
    public static Optional<String> nearest(String name, Collection<String> known) {
        int best = Math.max(2, name.length() / 3) + 1;
        String nearest = null;
        for (String candidate : known) {
            int distance = distance(name, candidate);
            if (distance < best) {
                best = distance;
                nearest = candidate;
            }
        }
        return Optional.ofNullable(nearest);
    }

    private static int distance(String name, String candidate) {
        String key = candidate.toLowerCase(Locale.ROOT);
        int[] edits = edits(name.toLowerCase(Locale.ROOT), key);
        int distance = edits[key.length()];
        if (name.length() >= BEGINNING) {
            if (candidate.startsWith(name)) {
                distance = Math.min(distance, 2);
            }
            for (int end = key.indexOf(BETWEEN_WORDS); end >= 0; end = key.indexOf(BETWEEN_WORDS, end + 1)) {
                distance = Math.min(distance, edits[end] + 1);
            }
        }
        return distance;
    }

    /** Levenshtein distances to each beginning of a text: insertions, deletions and replacements of one letter. */
    private static int[] edits(String from, String to) {
        int[] above = new int[to.length() + 1];
        for (int j = 0; j <= to.length(); j++) {
            above[j] = j;
        }
        for (int i = 1; i <= from.length(); i++) {
            int[] row = new int[to.length() + 1];
            row[0] = i;
            for (int j = 1; j <= to.length(); j++) {
                int replaced = above[j - 1] + (from.charAt(i - 1) == to.charAt(j - 1) ? 0 : 1);
                row[j] = Math.min(replaced, 1 + Math.min(above[j], row[j - 1]));
            }
            above = row;
        }
        return above;
    }
}
