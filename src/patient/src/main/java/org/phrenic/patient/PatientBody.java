package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;

/**
 * A patient's body: each organ says where it came from.
 *
 * @param name what to call it
 * @param structures in the order in which a thorax lists them
 * @param missing structures that neither the scan nor anything else gave
 * @param notes what had to be decided or left out on the way, one sentence each
 */
public record PatientBody(String name, List<PatientStructure> structures, List<String> missing, List<String> notes) {
    public PatientBody {
        structures = List.copyOf(structures);
        missing = List.copyOf(missing);
        notes = List.copyOf(notes);
    }

    public Optional<PatientStructure> structure(String structure) {
        return structures.stream()
                .filter(o -> o.structure().name().equals(structure))
                .findFirst();
    }

    /** Whether a simulation can be made of it: it has a diaphragm, and ribs for it to hang from. */
    public boolean canBreathe() {
        return has(StructureKind.DIAPHRAGM) && has(StructureKind.RIB);
    }

    private boolean has(StructureKind kind) {
        return structures.stream().anyMatch(o -> o.structure().kind() == kind);
    }

    /** Its surfaces alone. */
    public Thorax thorax() {
        return new Thorax(
                name, structures.stream().map(PatientStructure::structure).toList(), notes);
    }
}
