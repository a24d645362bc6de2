package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Names that plans of radiotherapy give to organs, as {@code zLiver_opt} or {@code Lungs-GTV}, and to aids: margins
 * about organs, rings and shells, doses, what a plan is optimised by, and the rind of the chest wall.
 */
final class PlanNames {
    private static final String TARGET = "(i?[gcp]|i)tv\\w*";
    private static final Pattern TARGET_WORD = Pattern.compile("\\b" + TARGET);
    /** How far away or how large an aid is. */
    private static final String PLACE = "\\d\\w*|c?gy|[cm]m|inner|outer|near|far|high|mid|low";

    private static final String RINGS = "(rings?|shells?)\\d*";
    /** An organ less a target volume in the names of TG-263, as "Lungs-GTV", or less anything else. */
    private static final Pattern LESS = Pattern.compile("(?i)(.+?)( ?[-\u2013] ?\\(?(i?[gcp]|i)tv"
            + "|[ _](minus|without|excluding|less|w/o)[ _]|[ _]?(minus|no[nt]?|less)[ _]?(i?[gcp]|i)tv).*");

    private static final String SIDE = "([ _](l|r|left|right))?";
    private static final String CHEST = "(lungs?|heart)" + SIDE;
    private static final String ABDOMEN = "(liver|kidneys?|spleen|stomach)" + SIDE;
    /**
     * A lung less an organ, an organ of the abdomen less one of the chest, or a heart, a body or a chest wall less the
     * lungs. Others may be two organs under one label.
     */
    private static final Pattern LESS_ORGAN = Pattern.compile("(?i)(?!([a-z]{4}).*[-\u2013] ?\\1)(lungs?" + SIDE
            + " ?[-\u2013] ?(" + CHEST + "|" + ABDOMEN + ")|" + ABDOMEN + " ?[-\u2013] ?" + CHEST
            + "|(e|external|body|heart) ?[-\u2013] ?lungs|heart ?[-\u2013] ?lung|chest ?wall ?[-\u2013] ?lungs?)");
    /** A dash and anything but a target volume. */
    private static final String NO_TARGET = " ?[-\u2013] ?+(?!\\(?" + TARGET + ").*";

    private static final Pattern OF_ORGAN =
            Pattern.compile("(?i)(lungs?|heart|liver|kidneys?|spleen|stomach)" + NO_TARGET);
    private static final Pattern OF_BODY = Pattern.compile("(?i)(body|e|external)" + NO_TARGET);

    private static final Pattern DASH = Pattern.compile(" ?[-\u2013] ?");

    private static final Pattern AID = Pattern.compile(".*prv.*|(.* )?isodoses?\\d*( .*)?"
            + "|((z|ns) )?(" + TARGET + " ((\\d+|high|mid|low) )*)*" + RINGS + "( (" + PLACE + "|" + TARGET + "))*"
            + "|(z )?doses?\\d*( (" + PLACE + "|" + TARGET + "))*"
            + "|(\\d+ )+(percent |c?gy )?dose|(\\d+c?gy )+dose|z? ?(opt|aid|avoid|avoidance)\\d*( \\d+)*"
            + "|(chest|thorax|thoracic) ?wall( ?\\d.*)?|cw( ?\\d+ ?[cm]m|( minus)? lungs?)|(hot|cold) ?spots?\\d*");
    /** A ring with a name beside it. */
    private static final Pattern RING = Pattern.compile("((z|ns) )?(rings?|shells?)( (" + PLACE + "))* (?<after>.+)"
            + "|(z )?(?<before>.+?) " + RINGS + "( (" + PLACE + "))*");
    /** Airways have rings of their own. */
    private static final String AIRWAY = "trachea";
    /** Words by which an organ in a plan is one less a margin: before it, or after it. */
    private static final Pattern OPTIMISED =
            Pattern.compile("^z (opt\\d* )?|^opt\\d* |opt\\d*(?=( (left|right|[lr]))?$)");
    /** A word that is no abbreviation, as "N" for the optic nerve is. */
    private static final Pattern WHOLE_WORD = Pattern.compile("[a-z]{3}");

    private PlanNames() {}

    /** Whether plain words without a side are those of an aid. */
    static boolean isAid(String words) {
        return AID.matcher(words).matches() || isRing(words);
    }

    /** Whether words are those of a ring about a structure or a target volume. */
    static boolean isRing(String words) {
        Matcher ring = RING.matcher(words);
        if (!ring.matches()) {
            return false;
        }
        String about = ring.group("after") == null ? ring.group("before") : ring.group("after");
        return LabelNames.structure(about)
                .filter(known -> !known.equals(AIRWAY) && !known.equals(LabelTable.IGNORE))
                .filter(known -> !LabelNames.isLesion(known)
                        || TARGET_WORD.matcher(about).find())
                .isPresent();
    }

    /** The organ of a name such as "Liver-CTV" or, of plain words, "z liver opt"; empty for other names. */
    static Optional<String> organ(String name, String plain) {
        return withoutTarget(name).or(() -> optimised(plain));
    }

    /**
     * Whether names, of which each may be that of an organ less another, are of other organs. After "Heart", "T1" may
     * be an image and "Body" a part; where most names but lesions are of other organs, they are a vertebra and the
     * skin.
     */
    static boolean areOfOthers(List<String> names) {
        if (names.size() < 2
                || !names.stream().allMatch(name -> OF_ORGAN.matcher(name).matches())) {
            return false;
        }
        List<String> rests =
                SharedWords.removed(names.stream().map(PlanNames::behindDash).toList());
        if (rests.stream().flatMap(rest -> LabelNames.structure(rest).stream()).anyMatch(LabelTable::isOfPlan)) {
            return false;
        }
        Optional<String> organ = LabelNames.structure(DASH.split(names.get(0), 2)[0]);
        long others = rests.stream()
                .filter(rest -> isOrgan(rest) && !LabelNames.structure(rest).equals(organ))
                .count();
        long lesions = rests.stream()
                .filter(rest ->
                        LabelNames.structure(rest).filter(LabelNames::isLesion).isPresent())
                .count();
        return 2 * others > names.size() - lesions
                || (others > 0 && rests.stream().allMatch(PlanNames::isInWords));
    }

    /** Names without a body before a dash where it stands before several organs, which are not named otherwise. */
    static List<String> withoutBody(List<String> names) {
        Map<Boolean, List<String>> all = names.stream()
                .collect(Collectors.partitioningBy(name -> OF_BODY.matcher(name).matches()));
        List<Optional<String>> organs = all.get(true).stream()
                .map(PlanNames::behindDash)
                .filter(PlanNames::isOrgan)
                .map(LabelNames::structure)
                .toList();
        boolean areSeveral =
                all.get(true).size() > 1 && (organs.size() > 1 || all.get(false).isEmpty());
        if (!areSeveral || all.get(false).stream().map(LabelNames::structure).anyMatch(organs::contains)) {
            return names;
        }
        return names.stream()
                .map(name -> OF_BODY.matcher(name).matches() && isOfBody(behindDash(name)) ? behindDash(name) : name)
                .toList();
    }

    private static String behindDash(String name) {
        return DASH.split(name, 2)[1];
    }

    /** The structure of a name, if that is neither a lesion nor an aid. */
    private static Optional<String> ofBody(String name) {
        return LabelNames.structure(name).filter(known -> !LabelNames.isLesion(known) && !LabelTable.isOfPlan(known));
    }

    /** Whether a name is known and is neither a lesion nor an aid. */
    private static boolean isOfBody(String name) {
        return ofBody(name).isPresent();
    }

    /** Whether a name says more than a side and a number, and is none for a whole body or for none. */
    private static boolean isInWords(String name) {
        List<String> words = new ArrayList<>(List.of(LabelNames.plain(name).split(" ", -1)));
        LabelNames.side(words);
        return words.stream().anyMatch(word -> WHOLE_WORD.matcher(word).find())
                && LabelNames.structure(name)
                        .filter(Set.of(LabelTable.SKIN, LabelTable.IGNORE)::contains)
                        .isEmpty();
    }

    private static boolean isOrgan(String name) {
        return isInWords(name)
                && isOfBody(name)
                && !LabelNames.structure(name).equals(Optional.of(LabelTable.ALL_BONES));
    }

    private static boolean isLessOrgan(String name) {
        return LESS_ORGAN.matcher(name).matches();
    }

    /** "E" is External in the names of TG-263. */
    private static Optional<String> withoutTarget(String name) {
        Matcher less = LESS.matcher(name);
        if (!isLessOrgan(name) && !less.matches()) {
            return Optional.empty();
        }
        String organ = isLessOrgan(name) ? DASH.split(name, 2)[0] : less.group(1);
        return LabelNames.structure(organ.equalsIgnoreCase("e") ? "external" : organ)
                .filter(known -> !LabelNames.isLesion(known) && !known.equals(LabelTable.IGNORE));
    }

    /** Targets and aids keep their whole names. */
    private static Optional<String> optimised(String plain) {
        String bare = OPTIMISED.matcher(plain).replaceAll("").strip();
        return bare.equals(plain) || !WHOLE_WORD.matcher(bare).find() ? Optional.empty() : ofBody(bare);
    }
}
