package org.phrenic.patient.label;

import java.text.Normalizer;
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

    /** The Latin part of a name that is in two scripts, with the sides of both; empty for other names. */
    static Optional<String> latin(String name) {
        if (!IDEOGRAPH.matcher(name).find() || !LATIN.matcher(name).find()) {
            return Optional.empty();
        }
        String text = Normalizer.normalize(name, Normalizer.Form.NFC);
        for (String word : UNSPACED) {
            String english = ENGLISH.get(word);
            text = text.replace(word, SIDES.contains(english) ? " " + english + " " : " ");
        }
        return Optional.of(IDEOGRAPH.matcher(text).replaceAll(" ").strip());
    }

    /** A name in lower case in which known words of other languages are English ones. */
    static String english(String name) {
        String text = Normalizer.normalize(name, Normalizer.Form.NFC).toLowerCase(Locale.ROOT);
        for (String word : UNSPACED) {
            text = text.replace(word, " " + ENGLISH.get(word) + " ");
        }
        Map<String, String> sides = new TreeMap<>();
        WORD.matcher(text)
                .results()
                .forEach(word ->
                        sides.putAll(ABBREVIATIONS.getOrDefault(LANGUAGES.getOrDefault(word.group(), ""), Map.of())));
        text = DORSAL.matcher(text).replaceAll(" t");
        text = SHORT.matcher(text).replaceAll(word -> sides.getOrDefault(word.group(), word.group()));
        text = WORD.matcher(text).replaceAll(word -> Matcher.quoteReplacement(english(word)));
        return LUMBAR.matcher(THORACIC.matcher(text).replaceAll("t")).replaceAll("l");
    }

    private static String english(MatchResult word) {
        String bare = LATIN.matcher(word.group()).find() ? bare(word.group()) : word.group();
        return ENGLISH.getOrDefault(word.group(), ENGLISH.getOrDefault(bare, bare));
    }
}
