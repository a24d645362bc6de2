package org.phrenic.patient.label;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.document.CsvTable;
import org.phrenic.document.ShippedFile;

/**
 * Anatomical words of other languages in the names of labels, put into English. The words are in
 * {@code data/labels/words.csv}; accents may be missing or written out (Rippe, côte or cote, Lungenflügel or
 * Lungenfluegel). Abbreviations of sides are taken where another word is of their language (Lunge li, polmone dx).
 */
final class LabelWords {
    private static final String FILE = "words.csv";
    private static final Pattern MARKS = Pattern.compile("\\p{M}+");
    private static final Pattern WORD = Pattern.compile("\\p{L}+");
    /** Thoracic and lumbar vertebrae as German and Latin name them: BWK 5, LWK 1, Th5. */
    private static final Pattern THORACIC = Pattern.compile("(?<![a-z])(?:bwk|th)[ _-]?(?=\\d)");

    private static final Pattern LUMBAR = Pattern.compile("(?<![a-z])lwk[ _-]?(?=\\d)");

    private static final Pattern LATIN = Pattern.compile("\\p{IsLatin}");
    private static final Pattern IDEOGRAPH = Pattern.compile("\\p{IsHan}");
    /** Text without spaces. */
    private static final Pattern UNSPACED_TEXT = Pattern.compile("[\\p{IsHan}\\p{IsHiragana}\\p{IsKatakana}\u30fc]+");
    /** A number that is none of a rib or a vertebra. */
    private static final Pattern CASE = Pattern.compile("\\d{3}");
    /** Letters with a number, as those of a case or a vertebra; that of a rib may have a side. */
    private static final Pattern LATIN_WORD = Pattern.compile("\\p{IsLatin}+\\d*|\\d{3,}");

    private static final Pattern SIDE = Pattern.compile("(?i)(left|right|lt|rt|[lr])\\d*");
    private static final Pattern BONE = Pattern.compile("(bones?|skeleton)( (left|right|[lr]|\\d+))*");
    /** Lungs and airways share words. */
    private static final String AIRWAY = "trachea";

    /** A word that may be an abbreviation; a letter beside a number is that of a vertebra. */
    private static final Pattern SHORT = Pattern.compile("(?<![\\p{L}\\d])\\p{L}{1,3}(?![\\p{L}\\d'\u2019])");
    /** The letter of a dorsal vertebra in a name that says that it is a vertebra. */
    private static final Pattern DORSAL = Pattern.compile("(?<=v[e\u00e9]rt[e\u00e8]b.{1,9}) d(?= ?\\d)");
    /** Letters that say more than a side. */
    static final Pattern WHOLE_WORD = Pattern.compile("\\p{IsLatin}{3}");

    private static final String ABBREVIATION = " abbreviation";

    private static final Map<String, String> ENGLISH = new TreeMap<>();
    /** The language of each word. */
    private static final Map<String, String> LANGUAGES = new TreeMap<>();
    /** English words of abbreviations, by language. */
    private static final Map<String, Map<String, String>> ABBREVIATIONS = new TreeMap<>();

    private static final Set<String> SIDES = Set.of("left", "right");
    private static final Set<String> PARTS = Set.of("upper", "middle", "lower");
    /** Words of scripts that write no spaces, the longest first. */
    private static final List<String> UNSPACED;

    static {
        CsvTable table = CsvTable.parse(FILE, ShippedFile.text("labels/" + FILE));
        List<String> words = table.texts("word");
        for (int row = 0; row < words.size(); row++) {
            String word = words.get(row);
            String english = table.texts("english").get(row);
            String language = table.texts("language").get(row);
            if (language.endsWith(ABBREVIATION)) {
                String of = language.replace(ABBREVIATION, "");
                ABBREVIATIONS.computeIfAbsent(of, l -> new TreeMap<>()).put(word, english);
                continue;
            }
            String written = bare(word.replace("ä", "ae").replace("ö", "oe").replace("ü", "ue"));
            for (String spelling : List.of(word, bare(word), written)) {
                ENGLISH.put(spelling, english);
                LANGUAGES.put(spelling, language);
            }
        }
        UNSPACED = ENGLISH.keySet().stream()
                .filter(word -> word.codePoints().anyMatch(Character::isIdeographic))
                .sorted(Comparator.comparingInt(String::length).reversed().thenComparing(Comparator.naturalOrder()))
                .toList();
    }

    private LabelWords() {}

    private static String bare(String word) {
        return MARKS.matcher(Normalizer.normalize(word, Normalizer.Form.NFD)).replaceAll("");
    }

    /**
     * Whether a name in a script without spaces has words that are not in the list, which may say that it is no organ
     * but, for one, its lymph nodes.
     */
    static boolean isPartlyKnown(String name) {
        return IDEOGRAPH.matcher(english(name)).find();
    }

    /** Whether a name has letters and ideographs. */
    static boolean isInTwoScripts(String name) {
        return IDEOGRAPH.matcher(name).find() && LATIN.matcher(name).find();
    }

    /**
     * The structure of a name that has letters and ideographs. Mostly both name the same. Else that counts which says
     * more: "Femur" beside the ideograph for bone, those for a lung beside "opt" or "Body". If both are of one thing
     * each, the structure is unknown.
     */
    static Optional<String> ofTwoScripts(String name) {
        Optional<String> whole = LabelNames.ofWhole(name);
        if (whole.filter(name::equals).isPresent()) {
            return whole;
        }
        String known = withoutUnknown(name);
        String letters = letters(known);
        Optional<String> ofLetters = LabelNames.structure(letters);
        boolean isForeign = WORD.matcher(letters.toLowerCase(Locale.ROOT))
                .results()
                .anyMatch(word -> LANGUAGES.containsKey(word.group()));
        if (!IDEOGRAPH.matcher(known).find()) {
            return whole.filter(structure -> !(isForeign && isPartlyKnown(name)));
        }
        Optional<String> ofKind = ofLetters.filter(one -> isOfKind(known, one));
        if (isPartlyKnown(known)) {
            boolean isBone = plainIdeographs(known).equals("bone");
            return ofKind.or(() -> ofLetters.flatMap(one -> whole).filter(one -> !isBone || LabelNames.isLesion(one)));
        }
        Optional<String> ofIdeographs = LabelNames.ofWhole(ideographs(known));
        if (ofLetters.equals(ofIdeographs)) {
            return ofLetters.or(() -> whole);
        }
        boolean isOfOther = LabelNames.isOfOther(LabelNames.plain(name));
        if (isOfOther || whole.filter(LabelTable::isOfPlan).isPresent()) {
            return whole;
        }
        if (ofLetters.isEmpty() || ofIdeographs.isEmpty()) {
            return whole.or(() -> ofKind);
        }
        boolean saysLess = isForeign
                || CASE.matcher(letters).find()
                || saysLess(ofLetters.get())
                || BONE.matcher(LabelNames.plain(letters)).matches();
        return narrower(ofLetters.get(), ofIdeographs.get())
                .or(() -> saysLess
                        ? ofIdeographs
                        : whole.filter(one -> LabelNames.isVertebra(ofLetters.get())
                                || one.equals(AIRWAY)
                                || BoneNames.haveCartilage(List.of(ofLetters.get(), ofIdeographs.get()))));
    }

    /** Of the structures of letters and of ideographs the one that is a part of the other, or one of several. */
    private static Optional<String> narrower(String letters, String ideographs) {
        // Ideographs have no plural.
        boolean isPlural = letters.equals("organ_" + ideographs + "s");
        if (isPlural || letters.startsWith(ideographs + "_") || BoneNames.holds(ideographs, letters)) {
            return Optional.of(letters);
        }
        return BoneNames.holds(letters, ideographs) ? Optional.of(ideographs) : Optional.empty();
    }

    /** Whether a structure is none, or what another one may be beside its name, as the body in which it lies. */
    private static boolean saysLess(String structure) {
        return LabelTable.isOfPlan(structure)
                || Set.of(LabelTable.IGNORE, LabelTable.SKIN, LabelTable.ALL_BONES)
                        .contains(structure);
    }

    /** Whether a structure is of the kind that a name states by ideographs, beside others that are unknown. */
    private static boolean isOfKind(String name, String structure) {
        String words = plainIdeographs(name);
        boolean isSpine = structure.equals(LabelTable.SPINE) || LabelNames.isVertebra(structure);
        return (isSpine && words.contains("vertebra"))
                || LabelNames.structure(words)
                        .filter(several -> BoneNames.holds(several, structure))
                        .isPresent();
    }

    /** English words of the ideographs of a name without the sides and parts. */
    private static String plainIdeographs(String name) {
        List<String> words =
                new ArrayList<>(List.of(LabelNames.plain(ideographs(name)).split(" ", -1)));
        LabelNames.side(words);
        words.removeAll(PARTS);
        return String.join(" ", words);
    }

    /** A name without the groups of ideographs in which no word but a side is known, as that of a person. */
    private static String withoutUnknown(String name) {
        return UNSPACED_TEXT
                .matcher(Normalizer.normalize(name, Normalizer.Form.NFC))
                .replaceAll(text -> {
                    List<String> words = new ArrayList<>(
                            List.of(LabelNames.plain(text.group()).split(" ", -1)));
                    List<String> sides = words.stream().filter(SIDES::contains).toList();
                    boolean isKnown = words.size() > sides.size() && !words.contains("");
                    return isKnown ? text.group() : " " + String.join(" ", sides) + " ";
                });
    }

    /** A name in two scripts without its ideographs but for the sides. */
    private static String letters(String name) {
        String text = name;
        for (String word : UNSPACED) {
            String english = ENGLISH.get(word);
            text = text.replace(word, SIDES.contains(english) ? " " + english + " " : " ");
        }
        return IDEOGRAPH
                .matcher(text)
                .replaceAll(" ")
                .replaceAll("[ _]* [ _]*", " ")
                .strip();
    }

    /** A name in two scripts without its letters but for the sides. */
    private static String ideographs(String name) {
        return LATIN_WORD
                .matcher(name)
                .replaceAll(word -> isSide(word.group()) ? word.group() : " ")
                .strip();
    }

    private static boolean isSide(String word) {
        return SIDE.matcher(word).matches() || SIDES.contains(LabelNames.plain(word));
    }

    /** A name in lower case in which known words of other languages are English ones. */
    static String english(String name) {
        String text = Normalizer.normalize(name, Normalizer.Form.NFC).toLowerCase(Locale.ROOT);
        for (String word : UNSPACED) {
            text = text.replace(word, " " + ENGLISH.get(word) + " ");
        }
        Map<String, String> sides = sides(text);
        text = DORSAL.matcher(text).replaceAll(" t");
        text = SHORT.matcher(text).replaceAll(word -> sides.getOrDefault(word.group(), word.group()));
        text = WORD.matcher(text).replaceAll(word -> Matcher.quoteReplacement(english(word)));
        return LUMBAR.matcher(THORACIC.matcher(text).replaceAll("t")).replaceAll("l");
    }

    /** The sides of abbreviations in a text of their language, in which no side is written out. */
    private static Map<String, String> sides(String text) {
        Map<String, String> sides = new TreeMap<>();
        List<MatchResult> words = WORD.matcher(text).results().toList();
        if (words.stream().noneMatch(word -> SIDES.contains(english(word)))) {
            words.forEach(word ->
                    sides.putAll(ABBREVIATIONS.getOrDefault(LANGUAGES.getOrDefault(word.group(), ""), Map.of())));
        }
        return sides;
    }

    private static String english(MatchResult word) {
        String bare = LATIN.matcher(word.group()).find() ? bare(word.group()) : word.group();
        return ENGLISH.getOrDefault(word.group(), ENGLISH.getOrDefault(bare, bare));
    }
}
