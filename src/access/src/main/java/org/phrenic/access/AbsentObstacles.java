package org.phrenic.access;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.phrenic.anatomy.OrganNames;

/**
 * Organs and vessels about the liver that people have and a body lacks, as a scan that does not label them. A path
 * through one of them is not noticed.
 */
public final class AbsentObstacles {
    private static final String RIGHT_LUNG = "right lung";
    private static final String LEFT_LUNG = "left lung";

    /** Names of structures by what they are, in lower case. */
    private static final Map<String, Predicate<String>> USUAL = new LinkedHashMap<>();

    static {
        usual(RIGHT_LUNG, "lungs?|lung_r(_.*)?");
        usual(LEFT_LUNG, "lungs?|lung_l(_.*)?");
        usual("heart", "heart.*");
        usual("aorta", "(vessel_)?aorta.*");
        usual("inferior vena cava", "(vessel_)?inferior_vena_cava.*");
        usual("portal vein", "(vessel_)?portal_.*|liver_vessels.*");
        usual("gall bladder", "gallbladder.*");
        USUAL.put("right kidney", name -> OrganNames.isKidney(name) && !name.endsWith("_l"));
        usual("stomach", "stomach.*");
        usual("duodenum", "duodenum.*|organ_bowel.*");
        usual("colon", "colon.*|organ_bowel.*");
    }

    private AbsentObstacles() {}

    private static void usual(String what, String names) {
        USUAL.put(what, Pattern.compile(names).asMatchPredicate());
    }

    /** What a body lacks; lungs if it lacks both. */
    public static List<String> of(Collection<String> structures) {
        List<String> names =
                structures.stream().map(name -> name.toLowerCase(Locale.ROOT)).toList();
        List<String> absent = USUAL.entrySet().stream()
                .filter(usual -> names.stream().noneMatch(usual.getValue()))
                .map(Map.Entry::getKey)
                .toList();
        boolean both = absent.contains(RIGHT_LUNG) && absent.contains(LEFT_LUNG);
        return absent.stream()
                .filter(what -> !(both && what.equals(LEFT_LUNG)))
                .map(what -> both && what.equals(RIGHT_LUNG) ? "lungs" : what)
                .toList();
    }

    /** One sentence without a full stop; empty if nothing is absent. */
    public static Optional<String> sentence(Collection<String> structures) {
        List<String> absent = of(structures);
        return absent.isEmpty()
                ? Optional.empty()
                : Optional.of("not in this body and so not avoided: " + String.join(", ", absent));
    }
}
