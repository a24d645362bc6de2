package org.phrenic.anatomy;

import java.text.Normalizer;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.phrenic.file.FileNames;

/**
 * Names of organs, vessels, muscles, bones and lesions outside the mechanical model. A name is one of the known ones,
 * such as {@code kidney_R} or {@code inferior_vena_cava}, or free text after the prefix of its kind: {@code organ_},
 * {@code vessel_}, {@code muscle_}, {@code bone_}, {@code lesion_} or {@code other_}. The suffixes {@code _R} and
 * {@code _L} state the side.
 */
public final class OrganNames {
    /** Begins the names that {@link #other} makes. */
    public static final String OTHER_PREFIX = "other_";
    /** The part of a stomach in the chest, as with a hiatal hernia. */
    public static final String STOMACH_IN_CHEST = "organ_stomach_above_diaphragm";
    /** Names of the bowel that fills the abdomen. */
    public static final Set<String> BOWEL = Set.of("colon", "small_bowel", "organ_bowel");

    /** Parts of the bowel that lie behind the rest of it or below. */
    private static final Set<String> OTHER_BOWEL = Set.of("duodenum", "rectum");

    private static final Pattern KIDNEYS = Pattern.compile("(organ_)?kidneys?(_[rl])?");

    private static final Map<String, StructureKind> KNOWN = known();

    private static final Pattern VESSELS_IN_LIVER =
            Pattern.compile("(vessel_)?hepatic_vein.*|portal_vein_[rl]|liver_vessels");

    private OrganNames() {}

    private static Map<String, StructureKind> known() {
        Map<StructureKind, String> names = Map.of(
                StructureKind.ORGAN,
                """
                heart atrial_appendage spleen stomach kidney gallbladder pancreas colon small_bowel duodenum esophagus
                oesophagus adrenal_gland urinary_bladder prostate uterus rectum thyroid_gland kidney_cyst spinal_cord
                brain""",
                StructureKind.VESSEL,
                """
                aorta inferior_vena_cava superior_vena_cava portal_and_splenic_vein portal_vein splenic_vein
                hepatic_vein pulmonary_vein pulmonary_artery brachiocephalic_trunk brachiocephalic_vein
                subclavian_artery common_carotid_artery iliac_artery iliac_vein liver_vessels
                internal_mammary_vessels superior_epigastric_vessels""",
                StructureKind.MUSCLE,
                """
                autochthon iliopsoas gluteus_maximus gluteus_medius gluteus_minimus intercostal_muscles
                abdominal_wall""",
                StructureKind.BONE,
                """
                scapula clavicle humerus femur hip sacrum skull vertebra_s1 vertebra_c1 vertebra_c2 vertebra_c3
                vertebra_c4 vertebra_c5 vertebra_c6 vertebra_c7""",
                StructureKind.LESION,
                "liver_tumor liver_tumour liver_lesion tumor tumour lesion",
                StructureKind.OTHER,
                "trachea");
        Map<String, StructureKind> all = new HashMap<>();
        names.forEach((kind, list) -> {
            for (String name : list.split("\\s+", -1)) {
                all.put(name, kind);
            }
        });
        return Map.copyOf(all);
    }

    /** Kind and side of a named structure; empty if the name is unknown. Case is ignored. */
    static Optional<StructureName> parse(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        Side side = side(lower);
        String stem = stem(lower, side);
        StructureKind kind = KNOWN.get(stem);
        for (StructureKind named : StructureKind.values()) {
            if (named.isNamed() && stem.length() > prefix(named).length() && stem.startsWith(prefix(named))) {
                kind = named;
            }
        }
        return Optional.ofNullable(kind).map(k -> new StructureName(k, 0, side));
    }

    /**
     * Known names, without the side, of what lies neither in the liver nor, as its portal vein, at it, and is no bone.
     */
    static List<String> outsideLiver() {
        return KNOWN.entrySet().stream()
                .filter(known -> known.getValue() != StructureKind.LESION && known.getValue() != StructureKind.BONE)
                .map(Map.Entry::getKey)
                .filter(name -> !isVesselInLiver(name) && !name.equals("portal_vein"))
                .sorted()
                .toList();
    }

    /** Whether a vessel, by its name in lower case, is one of those that branch in the liver. */
    public static boolean isVesselInLiver(String lower) {
        return VESSELS_IN_LIVER.matcher(lower).matches();
    }

    /** Whether a name in lower case is that of a kidney, of either side or without it, or of both kidneys. */
    public static boolean isKidney(String lower) {
        return KIDNEYS.matcher(lower).matches();
    }

    /** Whether a name in lower case is that of the bowel or a part of it, duodenum and rectum among them. */
    public static boolean isBowel(String lower) {
        return BOWEL.contains(lower) || OTHER_BOWEL.contains(lower);
    }

    private static Side side(String lower) {
        return lower.endsWith("_r") ? Side.RIGHT : lower.endsWith("_l") ? Side.LEFT : Side.MIDLINE;
    }

    private static String stem(String lower, Side side) {
        return side == Side.MIDLINE ? lower : lower.substring(0, lower.length() - 2);
    }

    /** Words for a name without its side and without the prefix of its kind: {@code kidney_R} is "kidney". */
    public static String words(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        String stem = stem(lower, side(lower));
        for (StructureKind named : StructureKind.values()) {
            String prefix = prefix(named);
            if (named.isNamed() && stem.length() > prefix.length() && stem.startsWith(prefix)) {
                stem = stem.substring(prefix.length());
            }
        }
        return stem.replace('_', ' ');
    }

    private static String prefix(StructureKind kind) {
        return kind.name().toLowerCase(Locale.ROOT) + "_";
    }

    /**
     * A name for a structure that has none here: the prefix {@code other_} and the letters and digits of the text, of
     * any script, or the number of the label where the text has none that this system has in names of files.
     *
     * @param text name in a file; blank for none
     */
    public static String other(String text, int label) {
        String word = Normalizer.normalize(text.toLowerCase(Locale.ROOT), Normalizer.Form.NFC)
                .replaceAll("[^\\p{L}\\p{M}\\p{Nd}]+", "_")
                .replaceAll("^_+|_+$", "");
        return OTHER_PREFIX + (word.isEmpty() || !FileNames.isOfSystem(word) ? String.valueOf(label) : word);
    }
}
