package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;

/**
 * The body of a patient. Each structure records its source.
 *
 * @param structures structures in the order used by a thorax
 * @param missing names of structures of a complete thorax that the body lacks
 * @param notes decisions and omissions, one sentence each
 */
public record PatientBody(String name, List<PatientStructure> structures, List<String> missing, List<String> notes) {
    public PatientBody {
        structures = List.copyOf(structures);
        missing = List.copyOf(missing);
        notes = List.copyOf(notes);
    }

    /** The structure with this name, or empty. */
    public Optional<PatientStructure> structure(String structure) {
        return structures.stream()
                .filter(s -> s.structure().name().equals(structure))
                .findFirst();
    }

    /** The first part of a structure that the scan truncates; with one part truncated the whole structure is. */
    public Optional<PatientStructure> firstCut(Structure structure) {
        return structures.stream()
                .filter(s -> !s.isComplete() && s.structure().isSameAs(structure))
                .findFirst();
    }

    /** Whether the body can be simulated, which requires a diaphragm and ribs. */
    public boolean canBreathe() {
        return has(StructureKind.DIAPHRAGM) && has(StructureKind.RIB);
    }

    private boolean has(StructureKind kind) {
        return structures.stream().anyMatch(s -> s.structure().kind() == kind);
    }

    /** Returns a copy in which each structure is changed alike, as by a motion. */
    public PatientBody withEach(UnaryOperator<Structure> change) {
        return new PatientBody(
                name,
                structures.stream()
                        .map(s -> s.withStructure(change.apply(s.structure())))
                        .toList(),
                missing,
                notes);
    }

    /** Returns a copy with additional notes. */
    public PatientBody withNotes(List<String> further) {
        return new PatientBody(
                name,
                structures,
                missing,
                Stream.concat(notes.stream(), further.stream()).toList());
    }

    /** Converts the body to a thorax, which contains the surfaces only. */
    public Thorax thorax() {
        return new Thorax(
                name, structures.stream().map(PatientStructure::structure).toList(), notes, Set.copyOf(notInScan()));
    }

    /**
     * What the scan does not show: the names of structures of a template and of those built from others, and words for
     * the organs that a template continues beyond the end of the scan, such as "part of the lungs".
     */
    public List<String> notInScan() {
        Stream<String> absent = structures.stream()
                .filter(s ->
                        s.source() == PatientStructure.Source.VIRTUAL || s.source() == PatientStructure.Source.BUILT)
                .map(s -> s.structure().name());
        Stream<String> continued = structures.stream()
                .filter(s -> s.source() == PatientStructure.Source.EXTENDED && !s.isComplete())
                .map(s -> Thorax.partOf(s.structure().kind(), s.structure().name()))
                .distinct();
        return Stream.concat(absent, continued).toList();
    }

    /** Merges the surfaces of structures into one mesh; empty if there are none. */
    public static Optional<TriangleMesh> merged(Stream<Structure> structures) {
        List<TriangleMesh> meshes = structures.map(Structure::mesh).toList();
        return meshes.isEmpty() ? Optional.empty() : Optional.of(MeshMerge.merge(meshes));
    }

    /** Merges the parts of one structure; those of a lung by their outline. Empty if there are none. */
    public static Optional<TriangleMesh> merged(List<Structure> of, Structure like) {
        Stream<Structure> same = of.stream().filter(s -> s.isSameAs(like));
        return like.kind() == StructureKind.LUNG ? LungOutline.of(same) : merged(same);
    }

    /** Bounding box of structures: least x, y, z, then greatest x, y, z, mm; empty without structures. */
    static Optional<double[]> bounds(Stream<Structure> structures) {
        return merged(structures).map(TriangleMesh::bounds);
    }
}
