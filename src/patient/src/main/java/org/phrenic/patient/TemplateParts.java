package org.phrenic.patient;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;

/**
 * What of a template completes a body. A template may be another patient, whose lesions and unknown structures are no
 * one else's, and whose lungs may be lobes.
 */
public final class TemplateParts {
    private TemplateParts() {}

    /**
     * The structures of a template that a body may have as well. The lobes of a lung that the scan cuts off are one
     * structure, for their outline continues what the scan shows.
     */
    public static List<Structure> of(List<Structure> template, PatientBody body) {
        List<Structure> all = new ArrayList<>();
        for (Structure s : template) {
            boolean cutLung = s.kind() == StructureKind.LUNG && body.firstCut(s).isPresent();
            boolean known = cutLung && all.stream().anyMatch(s::isSameAs);
            if (!isOfOnePerson(s) && !known) {
                all.add(cutLung ? whole(template, s) : s);
            }
        }
        return all;
    }

    /**
     * Whether a structure is a lesion or unknown, which other bodies do not have, and which may lie outside its own.
     */
    static boolean isOfOnePerson(Structure s) {
        return s.kind() == StructureKind.LESION || s.name().startsWith(OrganNames.OTHER_PREFIX);
    }

    /** A lung of one part as it is, one of lobes as their outline. */
    private static Structure whole(List<Structure> template, Structure lung) {
        boolean lobes = template.stream().filter(lung::isSameAs).count() > 1;
        return lobes
                ? new Structure(
                        lung.side() == Side.RIGHT ? "lung_R" : "lung_L",
                        lung.kind(),
                        lung.level(),
                        lung.side(),
                        PatientBody.merged(template, lung).orElseThrow())
                : lung;
    }
}
