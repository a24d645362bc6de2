package org.phrenic.document;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Suggests a known name for a mistyped one. */
public final class KeySuggestion {
    private KeySuggestion() {}

    /**
     * The first of {@code known} with the least edit distance to {@code name}, if the distance is small for its length.
     */
    public static Optional<String> nearest(String name, Collection<String> known) {
        int best = Math.max(2, name.length() / 3) + 1;
        String nearest = null;
        for (String candidate : known) {
            int edits = edits(name.toLowerCase(Locale.ROOT), candidate.toLowerCase(Locale.ROOT));
            boolean continues = name.length() >= 4 && candidate.startsWith(name);
            int distance = continues ? Math.min(edits, 2) : edits;
            if (distance < best) {
                best = distance;
                nearest = candidate;
            }
        }
        return Optional.ofNullable(nearest);
    }

    /** Levenshtein distance: insertions, deletions and replacements of one letter. */
    private static int edits(String from, String to) {
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
        return above[to.length()];
    }
}
