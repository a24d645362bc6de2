package org.phrenic.anatomy;

import java.util.List;
import java.util.Optional;

/**
 * A thorax at end-expiration: its named surfaces, in LPS and mm.
 *
 * @param name display name for reports
 * @param structures all surfaces, with unique names
 * @param notes repairs and omissions by the loader, one sentence each
 */
public record Thorax(String name, List<Structure> structures, List<String> notes) {

    public Thorax {
        structures = List.copyOf(structures);
        notes = List.copyOf(notes);
    }

    /** All structures of a kind, in their original order. */
    public List<Structure> structuresOf(StructureKind kind) {
        return structures.stream().filter(s -> s.kind() == kind).toList();
    }

    /** Finds the structure of a kind, level and side. */
    public Optional<Structure> find(StructureKind kind, int level, Side side) {
        return structures.stream()
                .filter(s -> s.kind() == kind && s.level() == level && s.side() == side)
                .findFirst();
    }

    /** Finds a structure by name. */
    public Optional<Structure> find(String name) {
        return structures.stream().filter(s -> s.name().equals(name)).findFirst();
    }
}
