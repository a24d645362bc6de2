package org.phrenic.patient.diaphragm;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;

/** The organs above and below the diaphragm that touch it. */
final class ContactingOrgans {
    private static final Set<String> ABOVE = Set.of("heart");
    private static final Set<String> BELOW = Set.of("spleen", "stomach");

    /** Word in the names of labels of fluid below the diaphragm. */
    private static final String ASCITES = "ascites";

    private ContactingOrgans() {}

    /** Lungs and heart, as far as the body has them. */
    static List<Structure> thoracic(Thorax body) {
        return Stream.concat(body.structuresOf(StructureKind.LUNG).stream(), heart(body).stream())
                .toList();
    }

    /** The heart, if the body has it. The lungs are not in the list. */
    static List<Structure> heart(Thorax body) {
        return body.structures().stream()
                .filter(s -> ABOVE.contains(lower(s)) && s.mesh().triangleCount() > 0)
                .toList();
    }

    /** Liver, spleen, stomach and kidneys, as far as the body has them. */
    static List<Structure> abdominal(Thorax body) {
        return body.structures().stream()
                .filter(s -> isBelow(s) && s.mesh().triangleCount() > 0)
                .toList();
    }

    /** Bowel and ascites, as far as the body has them: they may lie between the diaphragm and the organs below. */
    static List<Structure> between(Thorax body) {
        return body.structures().stream()
                .filter(s -> (OrganNames.BOWEL.contains(lower(s)) || lower(s).contains(ASCITES))
                        && s.mesh().triangleCount() > 0)
                .toList();
    }

    private static boolean isBelow(Structure s) {
        String name = lower(s);
        return s.kind() == StructureKind.LIVER || BELOW.contains(name) || OrganNames.isKidney(name);
    }

    private static String lower(Structure s) {
        return s.name().toLowerCase(java.util.Locale.ROOT);
    }
}
