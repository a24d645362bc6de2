package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;

/** Ribs, their cartilages and vertebrae by the names that files give to labels, as {@link LabelNames}. */
final class BoneNames {
    private static final Pattern CARTILAGE =
            Pattern.compile("(?=.*cartilage)(.*\\b(costal|ribs?\\d*\\b).*|cartilages?[ \\d]*)");
    private static final Pattern RIB = Pattern.compile("(.* )?rib(s|cage)?\\d*( .*)?");
    /** Ribs that some people have beyond the usual ones. */
    private static final Pattern EXTRA_RIB =
            Pattern.compile("(?=.*\\bribs?\\b)(?!.*\\bvertebra)(.* )?(cervical|lumbar)( .*)?");

    private static final Pattern SEVERAL = Pattern.compile("ribs|ribcage|cartilages");
    /**
     * Numbers from one to another, such as 1-12 or 1 to 12, or one and another. A number without a dash or word before
     * it is a copy's.
     */
    private static final Pattern RANGE = Pattern.compile("(?<![a-z\\d])[lr]?0*(\\d{1,2})(?:st|nd|rd|th)?"
            + "(?: ?[-\u2013&+,] ?|[ _](?:to|bis|through|thru|and|und)[ _])"
            + "[lr]?0*(\\d{1,2})(?:st|nd|rd|th)?[lr]?(?![a-z\\d])");
    /** A rib, its number and its side in one word, or two of them, such as rib5l, l5 and 5l. */
    private static final Pattern JOINED = Pattern.compile("\\b(rib\\d{1,2}[lr]|[lr]\\d{1,2}|\\d{1,2}[lr])\\b");

    /** Words of several ribs, and a rib of a lumbar vertebra: letters beside numbers are no sides in their names. */
    private static final Pattern NO_SIDES = Pattern.compile("\\b(ribs\\d*|ribcage\\d*|cage|l0?[1-5] rib)\\b");
    /** A German abbreviation of a side beside a number or at the end. */
    private static final Pattern GERMAN_SIDE = Pattern.compile("\\b(?:(?<=\\d )(li|re)|(li|re)(?= \\d|$))\\b");

    /** An ordinal in Romance languages, as in "5a costa"; "rib 5a" is a part of one. */
    private static final Pattern ORDINAL = Pattern.compile("(?<=^\\d{1,2})(a|o|er?|re|eme|ere)$");

    private static final Pattern GERMANIC = Pattern.compile("(?i)ri(b|pp)");
    private static final Pattern ROMAN =
            Pattern.compile("(?<![\\p{L}\\d])(I{1,3}|IV|VI{0,3}|IX|XI{0,2})(?![\\p{L}\\d])");
    private static final List<String> ROMANS =
            List.of("I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X", "XI", "XII");

    private static final Pattern VERTEBRA = Pattern.compile("(th|[ctls])0*(\\d{1,2})");
    /** The region and the number of a vertebra, written apart. */
    private static final Pattern APART = Pattern.compile("\\b(th|[ct]) (?=0*\\d{1,2}\\b)");

    /** A thoracic vertebra as Romance languages name it, where a name says that it is a vertebra. */
    private static final Pattern DORSAL = Pattern.compile("\\bd(?: (?=0*\\d{1,2}\\b)|(?=\\d))");

    private static final Map<String, String> REGIONS =
            Map.of("cervical", "c", "thoracic", "t", "dorsal", "t", "lumbar", "l");
    /** Words that add nothing to the name of a structure. */
    static final List<String> FILLERS = List.of(("vertebra vertebrae vertebral vb body corpus thoracic dorsal lumbar "
                    + "cervical upper middle lower superior inferior of the")
            .split(" ", -1));

    /** Vertebrae that some people have beyond the usual number. */
    private static final Set<String> EXTRA_VERTEBRAE = Set.of("T13", "L6");

    private static final Set<String> SOFT_TISSUES = Set.of(LabelTable.SKIN, "muscle_skeletal");

    private BoneNames() {}

    /** Whether a name is of ribs or cartilages, whose numbers and sides may be unknown. */
    static boolean isRib(String name) {
        return CARTILAGE.matcher(name).matches()
                || EXTRA_RIB.matcher(name).matches()
                || RIB.matcher(name).matches();
    }

    /** A name in plain words, in which those of a rib are written apart and abbreviated German sides written out. */
    static String apart(String plain) {
        String words =
                JOINED.matcher(plain).replaceAll(m -> m.group().replaceAll("(?<=[a-z])(?=\\d)|(?<=\\d)(?=[a-z])", " "));
        boolean isRib =
                RIB.matcher(words).matches() && !EXTRA_RIB.matcher(words).matches();
        boolean told = isRib && !NO_SIDES.matcher(plain).find();
        if (!told || LabelNames.side(new ArrayList<>(List.of(plain.split(" ", -1)))) != Side.MIDLINE) {
            return plain;
        }
        return GERMAN_SIDE.matcher(words).replaceAll(m -> m.group().equals("li") ? "left" : "right");
    }

    /** The structure of a name and its words without the side; empty if it is of no rib or of an unknown one. */
    static Optional<String> structure(String name, List<String> words, Side side, String suffix) {
        String rest = String.join(" ", words);
        if (CARTILAGE.matcher(rest).matches()) {
            return levelled(name, words, side, "costal_cartilage", LabelTable.COSTAL_CARTILAGES);
        }
        Matcher extra = EXTRA_RIB.matcher(rest);
        if (extra.matches()) {
            return LabelNames.known("bone_" + extra.group(2) + "_rib" + suffix);
        }
        return RIB.matcher(rest).matches()
                ? levelled(name, words, side, "rib", side == Side.MIDLINE ? LabelTable.RIBS : LabelTable.ribsOf(side))
                : Optional.empty();
    }

    /** The side of a name such as "Right rib", which may be one rib or all of the side; empty for other names. */
    static Optional<Side> sideOfRib(String name) {
        List<String> words = new ArrayList<>(List.of(LabelNames.plain(name).split(" ", -1)));
        Side side = LabelNames.side(words);
        return side != Side.MIDLINE && words.equals(List.of("rib")) ? Optional.of(side) : Optional.empty();
    }

    private static Optional<String> levelled(String name, List<String> words, Side side, String stem, String common) {
        boolean several = words.stream().anyMatch(word -> SEVERAL.matcher(word).matches());
        boolean germanic = GERMANIC.matcher(name).find();
        List<String> numbers = words.stream()
                .map(word -> germanic ? word : ORDINAL.matcher(word).replaceFirst(""))
                .map(word -> LabelNames.NUMBER.matcher(LabelNames.ordinal(word).replaceAll("^(ribs?|cartilages?)", "")))
                .filter(Matcher::matches)
                .map(m -> m.group(1))
                .toList();
        numbers = numbers.isEmpty() && !several ? roman(name) : numbers;
        if (side == Side.MIDLINE || numbers.isEmpty() || (several && numbers.size() > 1) || isRange(name)) {
            return side == Side.MIDLINE || several || !numbers.isEmpty() ? Optional.of(common) : Optional.empty();
        }
        return LabelNames.known(stem + "_" + numbers.get(0) + (side == Side.RIGHT ? "_R" : "_L"));
    }

    /** The one Roman number of a name; empty where it has several. */
    private static List<String> roman(String name) {
        List<String> all = ROMAN.matcher(name).results().map(MatchResult::group).toList();
        return all.size() == 1 ? List.of(String.valueOf(1 + ROMANS.indexOf(all.get(0)))) : List.of();
    }

    private static boolean isRange(String name) {
        Matcher range = RANGE.matcher(LabelWords.english(name));
        return range.find() && Integer.parseInt(range.group(1)) < Integer.parseInt(range.group(2));
    }

    /** Whether structures are ribs and cartilages, which a name says by the latter. */
    static boolean haveCartilage(List<String> structures) {
        return structures.stream().anyMatch(BoneNames::isCartilage)
                && structures.stream().allMatch(known -> isRibs(known) || isCartilage(known));
    }

    private static boolean isRibs(String structure) {
        return Set.of(LabelTable.RIBS, LabelTable.RIGHT_RIBS, LabelTable.LEFT_RIBS)
                        .contains(structure)
                || LabelNames.isOfKind(structure, StructureKind.RIB);
    }

    private static boolean isCartilage(String structure) {
        return structure.equals(LabelTable.COSTAL_CARTILAGES)
                || LabelNames.isOfKind(structure, StructureKind.COSTAL_CARTILAGE);
    }

    private static boolean isOtherBone(String structure) {
        return Stream.of(StructureKind.STERNUM, StructureKind.BONE, StructureKind.VERTEBRA)
                .anyMatch(kind -> LabelNames.isOfKind(structure, kind));
    }

    /** Whether a structure is several, of which another is one. */
    static boolean holds(String several, String one) {
        return switch (several) {
            case LabelTable.ALL_BONES -> isRibs(one) || isCartilage(one) || isOtherBone(one);
            case LabelTable.SPINE -> LabelNames.isVertebra(one);
            case LabelTable.RIBS, LabelTable.RIGHT_RIBS, LabelTable.LEFT_RIBS -> isRibs(one);
            case LabelTable.COSTAL_CARTILAGES -> isCartilage(one);
            case LabelTable.LUNGS -> LabelNames.isOfKind(one, StructureKind.LUNG);
            case "organ_kidneys" -> Set.of("kidney_L", "kidney_R").contains(one);
            case "organ_bowel" -> Set.of("small_bowel", "colon", "duodenum").contains(one);
            default -> false;
        };
    }

    /** What several structures under one label are: a pair, soft tissues, or bones that are told apart by shape. */
    static Optional<String> united(List<String> several, String plain) {
        Set<String> all = Set.copyOf(several);
        if (all.stream().allMatch(BoneNames::isRibs)) {
            Side side = LabelNames.side(new ArrayList<>(Arrays.asList(plain.split(" ", -1))));
            return Optional.of(side == Side.MIDLINE ? LabelTable.RIBS : LabelTable.ribsOf(side));
        }
        if (all.equals(Set.of("lung_L", "lung_R"))) {
            return Optional.of(LabelTable.LUNGS);
        }
        if (all.equals(Set.of("kidney_L", "kidney_R"))) {
            return Optional.of("organ_kidneys");
        }
        if (all.equals(SOFT_TISSUES)) {
            return Optional.of(LabelTable.SKIN);
        }
        boolean ofCage =
                all.contains(LabelTable.RIBS) && all.stream().allMatch(known -> isRibs(known) || isOtherBone(known));
        boolean haveSpine = all.contains(LabelTable.SPINE) || all.stream().anyMatch(LabelNames::isVertebra);
        return Optional.of(haveSpine ? LabelTable.ALL_BONES : LabelTable.RIBS).filter(bones -> ofCage);
    }

    /** The vertebra that words name, of which all others add nothing to it. */
    static Optional<String> vertebra(List<String> words) {
        String text = APART.matcher(String.join(" ", words)).replaceAll("$1");
        boolean stated = words.contains("vertebra") || words.contains("vertebrae");
        List<String> joined = Arrays.asList((stated ? DORSAL.matcher(text).replaceAll("t") : text).split(" ", -1));
        for (String word : joined) {
            Matcher m = VERTEBRA.matcher(word);
            if (m.matches() && (joined.size() == 1 || FILLERS.containsAll(without(joined, word)))) {
                Optional<String> usual = vertebra(m.group(1), Integer.parseInt(m.group(2)));
                return usual.isPresent() ? usual : extraVertebra(word, joined.size() > 1);
            }
            Matcher number = LabelNames.NUMBER.matcher(LabelNames.ordinal(word));
            if (number.matches() && words.contains("vertebra") && FILLERS.containsAll(without(words, word))) {
                return words.stream()
                        .filter(REGIONS::containsKey)
                        .findFirst()
                        .flatMap(region -> vertebra(REGIONS.get(region), Integer.parseInt(number.group(1))));
            }
        }
        return Optional.empty();
    }

    /** @param region c, t or th, l or s */
    private static Optional<String> vertebra(String region, int number) {
        String letter = region.substring(0, 1).toUpperCase(Locale.ROOT);
        return LabelNames.known("vertebra_" + letter + number);
    }

    /** @param stated whether the name says that it is a vertebra: "T13" alone may be anything, as a slice or a time */
    private static Optional<String> extraVertebra(String word, boolean stated) {
        String name = word.toUpperCase(Locale.ROOT);
        return EXTRA_VERTEBRAE.contains(name) && (stated || name.startsWith("L"))
                ? LabelNames.known("bone_vertebra_" + name)
                : Optional.empty();
    }

    private static List<String> without(List<String> words, String word) {
        return words.stream().filter(other -> !other.equals(word)).toList();
    }
}
