package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * Words at the beginning or the end that all names of a volume share and that say which case or file it is, as in
 * {@code s0011_liver} or {@code liver_BDMAP_1}: numbers, words with numbers such as {@code s0011}, capitals beside
 * them, and words for files. Words of anatomy are none of these.
 */
final class SharedWords {
    private static final Pattern WORD = Pattern.compile("[^\\s_.-]+");
    private static final Pattern DIGITS = Pattern.compile("\\d+");
    /** Letters and a number as of a vertebra or a side, which are no number of a case. */
    private static final Pattern LEVEL = Pattern.compile("(?i)[a-z]{1,2}\\d{1,2}|\\d{1,2}[a-z]{1,2}");

    private static final Pattern CAPITALS = Pattern.compile("[A-Z]{2,}");
    /** Words for cases, scans and files. */
    private static final Set<String> OF_FILES = Set.of(
            "case",
            "patient",
            "pat",
            "pt",
            "p",
            "subject",
            "subj",
            "sub",
            "id",
            "study",
            "series",
            "scan",
            "ct",
            "cta",
            "mr",
            "mri",
            "image",
            "img",
            "vol",
            "volume",
            "seg",
            "segmentation",
            "mask",
            "label",
            "labels",
            "roi",
            "pred",
            "prediction",
            "gt",
            "auto",
            "manual",
            "final");

    private static final Set<String> OF_ANATOMY = ofAnatomy();

    private final List<String> names;
    private final List<List<MatchResult>> words;

    private SharedWords(List<String> names) {
        this.names = names;
        words = names.stream()
                .map(name -> WORD.matcher(name).results().toList())
                .toList();
    }

    private static Set<String> ofAnatomy() {
        Set<String> all = new HashSet<>();
        NumberTable.ALL.forEach(table -> table.names()
                .keySet()
                .forEach(
                        name -> all.addAll(List.of(name.toLowerCase(Locale.ROOT).split("_", -1)))));
        return all;
    }

    /** The names without the shared words by whose removal most names are known; as they are if none becomes known. */
    static List<String> removed(List<String> names) {
        SharedWords shared = new SharedWords(names);
        List<String> best = names;
        long bestScore = score(names);
        int first = shared.removable(true);
        int last = shared.removable(false);
        for (int n = 0; n <= first; n++) {
            for (int m = 0; m <= last; m++) {
                List<String> bare = shared.without(n, m);
                long score = score(bare);
                if (score > 0 && score >= bestScore) {
                    best = bare;
                    bestScore = score;
                }
            }
        }
        return best;
    }

    /** Number of names that are known, and of structures of these names, which counts less. */
    private static long score(List<String> names) {
        List<String> known = names.stream()
                .filter(name -> !LabelVolume.isNumber(name))
                .flatMap(name -> LabelNames.structure(name).stream())
                .toList();
        return known.size() * (names.size() + 1L) + known.stream().distinct().count();
    }

    /** Number of shared words that may be removed from the beginnings or the ends of the names. */
    private int removable(boolean fromBeginning) {
        List<String> shared = new ArrayList<>();
        int shortest = words.stream().mapToInt(List::size).min().orElse(0);
        for (int n = 0; n < shortest - 1; n++) {
            int place = n;
            List<String> all = words.stream()
                    .map(w ->
                            w.get(fromBeginning ? place : w.size() - 1 - place).group())
                    .distinct()
                    .toList();
            if (all.size() > 1) {
                break;
            }
            shared.add(all.get(0));
        }
        boolean numbered = shared.stream().anyMatch(word -> DIGITS.matcher(word).find());
        int count = 0;
        while (count < shared.size() && isOfCase(shared.get(count), numbered)) {
            count++;
        }
        return count;
    }

    /** @param numbered whether a number stands beside the word */
    private boolean isOfCase(String word, boolean numbered) {
        String letters = DIGITS.matcher(word).replaceAll("").toLowerCase(Locale.ROOT);
        if (letters.isEmpty()) {
            return true;
        }
        if (OF_FILES.contains(letters)) {
            return true;
        }
        boolean ofAnatomy = OF_ANATOMY.contains(letters)
                || LabelNames.isOfAnatomy(letters)
                || LabelNames.structure(word).isPresent();
        if (ofAnatomy || LEVEL.matcher(word).matches()) {
            return false;
        }
        boolean capitals = CAPITALS.matcher(word).matches()
                && names.stream().allMatch(name -> name.chars().anyMatch(Character::isLowerCase));
        return !letters.equals(word.toLowerCase(Locale.ROOT)) || (capitals && numbered);
    }

    /** The names without some words at their beginnings and ends; as they are where nothing would be left. */
    private List<String> without(int first, int last) {
        List<String> bare = new ArrayList<>();
        for (int n = 0; n < names.size(); n++) {
            List<MatchResult> all = words.get(n);
            if (first + last >= all.size()) {
                return names;
            }
            bare.add(names.get(n)
                    .substring(
                            all.get(first).start(),
                            all.get(all.size() - 1 - last).end()));
        }
        return bare;
    }
}
