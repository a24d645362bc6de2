package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * Words at the beginning or the end that all names of a volume share and that say which case or file it is, as in
 * {@code s0011_liver} or {@code liver_BDMAP_1}: numbers, words with numbers such as {@code s0011}, capitals beside
 * them, and words for files. Words of anatomy are none of these; what may be a level, such as {@code S1}, is one only
 * where names become known without it.
 */
final class SharedWords {
    private static final Pattern WORD = Pattern.compile("[^\\s_.-]+");
    private static final Pattern DIGITS = Pattern.compile("\\d+");
    /** Letters and a number as of a vertebra or a side, which may be a case as well. */
    private static final Pattern LEVEL = Pattern.compile("(?i)[a-z]{1,2}\\d{1,2}|\\d{1,2}[a-z]{1,2}");

    /** Beginning of the structure of a lesion, which has its name after it. */
    private static final String LESION = "lesion_";

    private static final Pattern ABBREVIATION = Pattern.compile("[A-Z]{2,3}");
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
    /** What a name is that says least: several structures, or none. */
    private static final Set<String> COMMON = Set.of(
            LabelTable.IGNORE,
            LabelTable.RIBS,
            LabelTable.RIGHT_RIBS,
            LabelTable.LEFT_RIBS,
            LabelTable.COSTAL_CARTILAGES,
            LabelTable.ALL_BONES,
            LabelTable.SPINE,
            LabelTable.LUNGS);

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
                boolean better = score > bestScore && shared.mayBeBetter(bare, n, m);
                if (better || (score > 0 && score == bestScore && shared.mayBeAsGood(bare, n, m))) {
                    best = bare;
                    bestScore = score;
                }
            }
        }
        return PlanNames.withoutBody(best);
    }

    /**
     * Whether names of which more are known may be meant. Where a word that may be a level is removed, known names have
     * to keep their structures and one that is more than common has to become known.
     */
    private boolean mayBeBetter(List<String> bare, int first, int last) {
        List<String> removed =
                Stream.concat(ends(first, true), ends(last, false)).toList();
        if (removed.stream().noneMatch(SharedWords::isLevel)) {
            return true;
        }
        // Of T5-T8 the second is no case.
        boolean isSpan =
                bare.stream().distinct().count() == 1 && removed.stream().anyMatch(SharedWords::isVertebra);
        boolean foundOne = false;
        for (int n = 0; n < names.size(); n++) {
            String before = LabelNames.structure(names.get(n)).orElse("");
            String after = LabelNames.structure(bare.get(n)).orElse("");
            boolean keepsKind = (before.startsWith(LESION) && after.startsWith(LESION))
                    || (LabelTable.isOfPlan(before) && LabelTable.isOfPlan(after));
            if (!before.isEmpty() && !before.equals(after) && !keepsKind) {
                return false;
            }
            boolean isOne = !COMMON.contains(after) && !(isSpan && LabelNames.isVertebra(after));
            foundOne |= before.isEmpty() && !after.isEmpty() && isOne;
        }
        return foundOne;
    }

    /**
     * Whether names of which as many are known may be meant. A mere number is that of a structure and not of a case
     * where a name is common only without it, as that of a rib is that of all ribs.
     */
    private boolean mayBeAsGood(List<String> bare, int first, int last) {
        boolean isLevel = Stream.concat(ends(first, true), ends(last, false)).anyMatch(SharedWords::isLevel);
        if (isLevel || !keepsAids(bare)) {
            return false;
        }
        boolean saysCase = Stream.of(
                        ends(first, true).toList(), ends(last, false).toList())
                .allMatch(end -> end.isEmpty()
                        || !end.stream().allMatch(word -> DIGITS.matcher(word).matches()));
        return saysCase
                || IntStream.range(0, names.size()).allMatch(n -> {
                    Optional<String> after = LabelNames.structure(bare.get(n));
                    return after.filter(COMMON::contains).isEmpty() || after.equals(LabelNames.structure(names.get(n)));
                });
    }

    /** Whether no aid of a plan becomes a part of a body, as a ring about a target would become the target. */
    private boolean keepsAids(List<String> bare) {
        return IntStream.range(0, names.size()).filter(n -> isAid(names.get(n))).allMatch(n -> isAid(bare.get(n)));
    }

    private static boolean isAid(String name) {
        return LabelNames.structure(name).filter(LabelTable::isOfPlan).isPresent();
    }

    /** The first or the last words that all names share. */
    private Stream<String> ends(int count, boolean fromBeginning) {
        List<MatchResult> all = words.get(0);
        return (fromBeginning ? all.subList(0, count) : all.subList(all.size() - count, all.size()))
                .stream().map(MatchResult::group);
    }

    private static boolean isLevel(String word) {
        return LEVEL.matcher(word).matches() && !OF_FILES.contains(letters(word));
    }

    private static boolean isVertebra(String word) {
        return LabelNames.structure(word).filter(LabelNames::isVertebra).isPresent();
    }

    private static String letters(String word) {
        return DIGITS.matcher(word).replaceAll("").toLowerCase(Locale.ROOT);
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
        // Of all names none is that of an organ less another.
        boolean beforeDash = fromBeginning && PlanNames.areOfOthers(names);
        int count = 0;
        while (count < shared.size()
                && ((count == 0 && beforeDash)
                        || isOfCase(shared.get(count), numbered)
                        || isAbbreviation(shared, count, fromBeginning))) {
            count++;
        }
        return count;
    }

    /** Whether a word is one in capitals before the number of a case, which may be short for a vein or an artery. */
    private static boolean isAbbreviation(List<String> shared, int place, boolean fromBeginning) {
        String word = shared.get(place);
        return fromBeginning
                && ABBREVIATION.matcher(word).matches()
                && !OF_ANATOMY.contains(letters(word))
                && !LabelNames.isOfAnatomy(letters(word))
                && place + 1 < shared.size()
                && DIGITS.matcher(shared.get(place + 1)).matches();
    }

    /** @param numbered whether a number stands beside the word */
    private boolean isOfCase(String word, boolean numbered) {
        String letters = letters(word);
        if (letters.isEmpty() || OF_FILES.contains(letters) || isLevel(word)) {
            return true;
        }
        boolean ofAnatomy = OF_ANATOMY.contains(letters)
                || LabelNames.isOfAnatomy(letters)
                || LabelNames.structure(word)
                        .filter(known -> !LabelTable.isOfPlan(known) && !known.equals(LabelTable.IGNORE))
                        .isPresent();
        if (ofAnatomy) {
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
