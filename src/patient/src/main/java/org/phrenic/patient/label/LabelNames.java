package org.phrenic.patient.label;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.document.CsvTable;

/**
 * Structures by the names that files give to labels, such as "Right Lung", "rib 5 left", "T12" or "kidney_right". Case,
 * order of words and separators do not matter.
 */
public final class LabelNames {
    static final Pattern NUMBER = Pattern.compile("0*(\\d{1,2})(?:st|nd|rd|th)?");
    private static final List<String> ORDINALS = List.of(
            "first",
            "second",
            "third",
            "fourth",
            "fifth",
            "sixth",
            "seventh",
            "eighth",
            "ninth",
            "tenth",
            "eleventh",
            "twelfth");
    /** Words that capitals part, such as "SpinalCord". */
    private static final Pattern JOINED_WORDS = Pattern.compile("(?<=[a-z])(?=[A-Z])|(?<=\\d)(?=Left|Right)");
    /** A side written in one word with what it is of, such as "leftlung". */
    private static final Pattern JOINED_SIDE = Pattern.compile("\\b(left|right)(?=[a-z])");
    /** A side in one word with what it is of, such as "LLung". */
    private static final Pattern CAPITAL_SIDE = Pattern.compile("^([LR])(?=[A-Z][a-z]{2})");
    /** Words at an end of a name for what a file is, such as "liver_mask". */
    private static final Pattern MASK = ofFile("mask|seg|segmentation");
    /** Words for what a file is, or what has made it, beside the name of an organ: a "T1 volume" is no vertebra. */
    private static final Pattern MADE = ofFile("mask|seg|segmentation|roi|contour|volume|label|ai|dlc|auto");
    /** Lesions, and the target volumes of radiotherapy. */
    private static final Pattern LESION = Pattern.compile("tumou?r|lesion|metasta|(?<= )mets?\\b|nodule|cancer"
            + "|(carcin|sarc|aden|angi|lymph|hepat|hamart|blast|granul|melan|mesotheli|thym|fibr|neur)oma"
            + "|(?<!chole)cysts?(?![a-z])|(?<!fat |muscle |body |bone )\\bmass(es)?\\b"
            + "|\\bhcc\\b|\\b(i?[gcp]|i)tv|\\btarget volumes?\\b");
    /** Words for what lies in or beside an organ and is no part of it. */
    private static final Pattern BESIDE =
            Pattern.compile("effusion|fluid|(pneumo|hydro|ha?emo)thorax|empyema|arter(y|i)|\\bveins?\\b|\\bvenae?\\b"
                    + "|lymph|\\bnodes?\\b|nerve|ligament|intercostal|\\bprv|implant|catheter|\\bdrain|\\btube"
                    + "|fracture|pacemaker|\\bleads?\\b|marker|\\bclips?\\b|bolus"
                    + "|\\bplates?\\b|\\bscrews?\\b|fixation|osteosynthes"
                    + "|(?<= )((wire|coil|seed|device|stent|fiducial|needle|joint)s?|junction|costochondral)\\b"
                    + "|(?<= )(prosthes[ie]s|(b|bounding ?)box)\\b|^(non?|not|outside) (?!\\d)");

    /** Fluid below the diaphragm; free fluid alone may lie in the chest. */
    private static final Pattern ASCITES =
            Pattern.compile("(?!.*(pleura|thora|chest|pericard|drain|catheter|tube))(.*\\bascites\\b.*"
                    + "|(?=.*\\bfluid\\b).*\\b(abdom|(intra)?periton|pelvi).*)");

    private static final Pattern STERNUM = Pattern.compile("(?!.*malle)(.* )?(sternum|manubrium|xiphoid)( .*)?");
    private static final Pattern LUNG = Pattern.compile("(?!.*\\b(pleurae?|lungen\\w+)\\b)(.* )?lung.*");
    private static final Pattern LUNG_LOBE =
            Pattern.compile("(superior|upper|middle|inferior|lower) lobe|lingula|r[uml]l|l[ul]l");
    /** The parts of a segment's name, the numbers of Couinaud's segments among them. */
    private static final String LIVER_PART =
            "lobe|seg|segments?|\\d[ab]?|[iv]+[ab]?|whole|total|normal|healthy|uninvolved|future|remnant";

    /** Structures by expressions for their names without the side; the first that matches counts. */
    private static final Map<Pattern, String> BY_EXPRESSION = new LinkedHashMap<>();

    static {
        BY_EXPRESSION.put(Pattern.compile(".*(\\bairway|\\bbronch|\\btrachea).*"), "trachea");
        BY_EXPRESSION.put(Pattern.compile("((body|upper|lower) )*extremit(y|ies)"), LabelTable.IGNORE);
        BY_EXPRESSION.put(
                Pattern.compile("couch( ?(surface|interior|exterior|inner|outer|shell|top|rails?|support|\\d+))*"
                        + "|((treatment|ct) )?table( ?top)?"),
                LabelTable.IGNORE);
        BY_EXPRESSION.put(Pattern.compile("(.* )?(liver|hepatic) ?(vessel|vascul).*"), "liver_vessels");
        BY_EXPRESSION.put(
                Pattern.compile("((caudate|quadrate|of|the|" + LIVER_PART + ") )*liver( (parenchyma|s\\d[ab]?|"
                        + LIVER_PART + "))*"),
                "liver");
        BY_EXPRESSION.put(
                Pattern.compile("(?!.*\\b(fat|vessels?|lung|stomach)\\b)"
                        + "(.*\\b(heart|cardiac|\\w*cardium)\\b.*|atrium|ventricle)"),
                "heart");
        BY_EXPRESSION.put(
                Pattern.compile("(subcutaneous|torso|body|visceral|intermuscular) (fat|adipose.*)"), LabelTable.SKIN);
        BY_EXPRESSION.put(Pattern.compile("(skeletal )?muscles?"), "muscle_skeletal");
        BY_EXPRESSION.put(Pattern.compile("(all )?bones?|skeleton"), LabelTable.ALL_BONES);
        BY_EXPRESSION.put(
                Pattern.compile("spine|vertebrae|(spinal|vertebral) column|column vertebral"), LabelTable.SPINE);
        BY_EXPRESSION.put(Pattern.compile("sternal body|corpus sterni"), "sternum_body");
        // Only whole names: celiac trunk, pancreas body and external carotid artery are no skin.
        BY_EXPRESSION.put(
                Pattern.compile("((whole|entire|full|outer|human|patient) )*(body|torso|trunk|external)\\d?"
                        + "( (contour|outline|mask|surface|hull|trunk|trunc|torso|body|\\d{1,2}))*"),
                LabelTable.SKIN);
        BY_EXPRESSION.put(Pattern.compile("(outer|patient) (contour|outline|surface)"), LabelTable.SKIN);
        BY_EXPRESSION.put(Pattern.compile("(.* )?skin( .*)?"), LabelTable.SKIN);
    }

    /** Structures by names of labels of segmentation tools and public data sets, in lower case. */
    private static final Map<String, String> OF_TOOLS = ofTools();

    /** Structures by other words for them in lower case, with the side after it if the words have it. */
    private static final Map<String, String> SYNONYMS = synonyms();

    /** A vein or an artery that is named before its organ, as in TG-263. */
    private static final Pattern VESSEL_OF = Pattern.compile("(?:(v|vein|vena)|(a|artery))_(.+)");
    /** A vena cava in any order of words. */
    private static final Pattern CAVA =
            Pattern.compile("(?=.*cava)(?:(?:v|vein|vena|cava|inf|inferior|(?<superior>sup|superior))(?:_|$)){2,3}");

    /** Vessels of which a scan shows several; other plurals are pairs of organs, whose two sides one name would mix. */
    private static final Map<String, String> VESSELS = Map.of("veins", "vein", "arteries", "artery");

    private static final Pattern PLURAL_VESSELS = Pattern.compile("(?<![a-z])(veins|arteries)(?![a-z])");
    /** The "L" of an L spine is no side. */
    private static final Pattern LUMBAR_SPINE = Pattern.compile("(?i)l[ _-]?spine");

    private static final Pattern AND = Pattern.compile("(?i) ?[+&] ?|[ _]and[ _]");

    /** Beginnings of the names that an import writes. */
    private static final Pattern WRITTEN = Pattern.compile("(organ|vessel|muscle|bone|lesion|other)_.*");

    private LabelNames() {}

    private static Pattern ofFile(String words) {
        return Pattern.compile("(?i)^(" + words + ")[ _-]+|[ _-]+(" + words + ")$");
    }

    private static Map<String, String> ofTools() {
        Map<String, String> all = new TreeMap<>();
        NumberTable.ALL.forEach(table ->
                table.names().forEach((name, structure) -> all.putIfAbsent(name.toLowerCase(Locale.ROOT), structure)));
        return all;
    }

    private static Map<String, String> synonyms() {
        CsvTable table = NumberTable.shipped("synonyms.csv");
        List<String> names = table.texts("name");
        Map<String, String> all = new TreeMap<>();
        for (int row = 0; row < names.size(); row++) {
            all.put(names.get(row), table.texts("structure").get(row));
        }
        return all;
    }

    /** The structure that a label's name stands for; empty if the name is unknown. */
    public static Optional<String> structure(String name) {
        return ofName(name)
                .or(() -> ofOther(name, MASK.matcher(name).replaceAll("")))
                .or(() -> Optional.of(MADE.matcher(name).replaceAll(""))
                        .filter(rest ->
                                LabelWords.WHOLE_WORD.matcher(plain(rest)).find())
                        .flatMap(rest -> ofOther(name, rest)))
                .or(() -> ofOther(name, CAPITAL_SIDE.matcher(name).replaceAll("$1 ")));
    }

    private static Optional<String> ofOther(String name, String other) {
        return other.equals(name) || other.isBlank() ? Optional.empty() : ofName(other);
    }

    private static Optional<String> ofName(String name) {
        if (LabelWords.isInTwoScripts(name)) {
            return LabelWords.ofTwoScripts(name);
        }
        return LabelWords.isPartlyKnown(name) ? Optional.empty() : ofWhole(name);
    }

    /** The structure of a name in English words; letters of scripts without such words are passed over. */
    static Optional<String> ofWhole(String name) {
        String plain = plain(JOINED_WORDS.matcher(name).replaceAll(" "));
        String ofTool = OF_TOOLS.get(plain.replace(' ', '_'));
        if (ofTool != null) {
            return Optional.of(ofTool);
        }
        boolean isWritten = WRITTEN.matcher(name).matches()
                && isNamed(name)
                && StructureName.usual(name).equals(name);
        if (LabelTable.isOfPlan(name)) {
            return Optional.of(LabelTable.usual(name));
        }
        Optional<String> organ = PlanNames.organ(name, plain).filter(known -> !(isWritten && name.startsWith(known)));
        if (organ.isPresent() || isWritten) {
            return organ.or(() -> Optional.of(name));
        }
        List<String> several = several(name);
        if (!several.isEmpty()) {
            return BoneNames.united(several, plain);
        }
        List<String> words = new ArrayList<>(Arrays.asList(
                BoneNames.apart(JOINED_SIDE.matcher(plain).replaceAll("$1 ")).split(" ", -1)));
        Side side = side(words);
        String suffix = side == Side.RIGHT ? "_R" : side == Side.LEFT ? "_L" : "";
        String rest = String.join(" ", words);
        boolean lesion = LESION.matcher(rest).find();
        boolean beside = BESIDE.matcher(rest).find();
        boolean aid = PlanNames.isAid(rest);
        if (LabelTable.isStructure(name) && (isNamed(name) || !(lesion || beside || aid))) {
            return Optional.of(LabelTable.usual(name));
        }
        if (aid) {
            return Optional.of(LabelTable.OF_PLAN + String.join("_", words) + suffix);
        }
        if (lesion) {
            return Optional.of("lesion_" + String.join("_", words) + suffix);
        }
        if (ASCITES.matcher(rest).matches()) {
            return Optional.of(OrganNames.OTHER_PREFIX + "ascites" + suffix);
        }
        return beside ? organ(words, suffix).filter(LabelNames::isNamed) : ofWords(name, words, side, suffix);
    }

    /** The structures of a name such as "Ribs+Sternum"; empty where it is of one, or of one that is unknown. */
    private static List<String> several(String name) {
        String[] parts = AND.split(name, -1);
        List<String> all = Arrays.stream(parts)
                .flatMap(part -> parts.length == 1 ? Stream.empty() : structure(part).stream())
                .distinct()
                .toList();
        boolean ofBody = all.stream()
                .noneMatch(known -> isLesion(known) || LabelTable.isOfPlan(known) || known.equals(LabelTable.IGNORE));
        return all.size() > 1 && all.size() == parts.length && ofBody && !BoneNames.haveCartilage(all)
                ? all
                : List.of();
    }

    static boolean isLesion(String structure) {
        return isOfKind(structure, StructureKind.LESION);
    }

    static boolean isVertebra(String structure) {
        return isOfKind(structure, StructureKind.VERTEBRA) || structure.startsWith("vertebra_");
    }

    static boolean isOfKind(String structure, StructureKind kind) {
        return StructureName.parse(structure)
                .filter(name -> name.kind() == kind)
                .isPresent();
    }

    private static boolean isNamed(String structure) {
        return StructureName.parse(structure)
                .map(StructureName::kind)
                .filter(StructureKind::isNamed)
                .isPresent();
    }

    private static Optional<String> ofWords(String name, List<String> words, Side side, String suffix) {
        String rest = String.join(" ", words);
        Optional<String> rib = BoneNames.structure(name, words, side, suffix);
        if (rib.isPresent() || BoneNames.isRib(rest)) {
            return rib;
        }
        Matcher sternum = STERNUM.matcher(rest);
        if (sternum.matches()) {
            return Optional.of(sternum.group(2).equals("sternum") ? "sternum" : "sternum_" + sternum.group(2));
        }
        for (Map.Entry<Pattern, String> known : BY_EXPRESSION.entrySet()) {
            if (known.getKey().matcher(rest).matches()) {
                return Optional.of(known.getValue())
                        .filter(of -> !LUMBAR_SPINE.matcher(name).matches());
            }
        }
        if (LUNG.matcher(rest).matches()) {
            return Optional.of(side == Side.MIDLINE ? LabelTable.LUNGS : "lung" + suffix);
        }
        if (side != Side.MIDLINE && LUNG_LOBE.matcher(rest).matches()) {
            return Optional.of("lung" + suffix);
        }
        return BoneNames.vertebra(words).or(() -> organ(words, suffix));
    }

    /** Whether words say what lies in or beside a structure. */
    static boolean isOfOther(String words) {
        return LESION.matcher(words).find()
                || BESIDE.matcher(words).find()
                || ASCITES.matcher(words).matches();
    }

    /** Whether a word says what lies in or beside a structure, or which part of it. */
    static boolean isOfAnatomy(String word) {
        return isOfOther(word) || BoneNames.FILLERS.contains(word);
    }

    /** English words of a name in lower case, with a space between them. */
    static String plain(String name) {
        return LabelWords.english(name).replaceAll("[^a-z0-9]+", " ").strip();
    }

    static Side side(List<String> words) {
        boolean right = words.removeAll(List.of("right", "r", "rt"));
        boolean left = words.removeAll(List.of("left", "l", "lt"));
        right |= !Collections.disjoint(words, List.of("rul", "rml", "rll"));
        left |= !Collections.disjoint(words, List.of("lul", "lll"));
        return right == left ? Side.MIDLINE : right ? Side.RIGHT : Side.LEFT;
    }

    /** The number of an ordinal such as "fifth"; any other word as it is. */
    static String ordinal(String word) {
        int ordinal = 1 + ORDINALS.indexOf(word);
        return ordinal > 0 ? String.valueOf(ordinal) : word;
    }

    private static Optional<String> organ(List<String> words, String suffix) {
        String stem = PLURAL_VESSELS.matcher(String.join("_", words)).replaceAll(m -> VESSELS.get(m.group()));
        Matcher cava = CAVA.matcher(stem);
        if (cava.matches()) {
            return known((cava.group("superior") == null ? "inferior" : "superior") + "_vena_cava" + suffix);
        }
        Matcher vessel = VESSEL_OF.matcher(stem);
        String turned = vessel.matches() ? vessel.group(3) + (vessel.group(1) == null ? "_artery" : "_vein") : stem;
        return ofStem(stem, suffix).or(() -> ofStem(turned, suffix));
    }

    private static Optional<String> ofStem(String stem, String suffix) {
        String usual = SYNONYMS.getOrDefault(stem, stem);
        // Both kidneys of a side are one.
        return known((usual.equals("organ_kidneys") && !suffix.isEmpty() ? "kidney" : usual) + suffix);
    }

    static Optional<String> known(String structure) {
        return StructureName.parse(structure).map(name -> StructureName.usual(structure));
    }
}
