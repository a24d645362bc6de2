package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;

/**
 * The body of a patient; each structure has its source.
 *
 * @param structures in the order in which a thorax lists them
 * @param missing names of structures of a whole thorax that the body lacks
 * @param notes on decisions and omissions, one sentence each
 */
public record PatientBody(String name, List<PatientStructure> structures, List<String> missing, List<String> notes) {
    public PatientBody {
        structures = List.copyOf(structures);
        missing = List.copyOf(missing);
        notes = List.copyOf(notes);
    }

    /** The structure of a name; empty if there is none. */
    public Optional<PatientStructure> structure(String structure) {
        return structures.stream()
                .filter(s -> s.structure().name().equals(structure))
                .findFirst();
    }

    /** Whether it can be simulated: it has a diaphragm and ribs. */
    public boolean canBreathe() {
        return has(StructureKind.DIAPHRAGM) && has(StructureKind.RIB);
    }

    private boolean has(StructureKind kind) {
        return structures.stream().anyMatch(s -> s.structure().kind() == kind);
    }

    /** The body with further notes. */
    public PatientBody withNotes(List<String> further) {
        return new PatientBody(
                name,
                structures,
                missing,
                Stream.concat(notes.stream(), further.stream()).toList());
    }

    /** Its surfaces alone. */
    public Thorax thorax() {
        return new Thorax(
                name, structures.stream().map(PatientStructure::structure).toList(), notes);
    }

    /** The surfaces of structures as one mesh; empty if there are none. */
    public static Optional<TriangleMesh> merged(Stream<Structure> structures) {
        List<TriangleMesh> meshes = structures.map(Structure::mesh).toList();
        return meshes.isEmpty() ? Optional.empty() : Optional.of(MeshMerge.merge(meshes));
    }
}
