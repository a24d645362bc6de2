package org.phrenic.anatomy;

import java.util.List;
import java.util.Optional;

/**
 * A thorax at end-expiration: its named surfaces, in LPS and mm.
 *
 * @param name what to call it in reports
 * @param structures every surface, each name once
 * @param notes what a loader repaired or left out, one sentence each
 */
public record Thorax(String name, List<Structure> structures, List<String> notes) {

    public Thorax {
        structures = List.copyOf(structures);
        notes = List.copyOf(notes);
    }

    /** All structures of a kind, in the order they were given. */
    public List<Structure> structuresOf(StructureKind kind) {
        return structures.stream().filter(s -> s.kind() == kind).toList();
    }

    /** The structure of this kind, level and side, if the thorax has it. */
    public Optional<Structure> find(StructureKind kind, int level, Side side) {
        return structures.stream()
                .filter(s -> s.kind() == kind && s.level() == level && s.side() == side)
                .findFirst();
    }

    /** The structure of this name, if the thorax has it. */
    public Optional<Structure> find(String name) {
        return structures.stream().filter(s -> s.name().equals(name)).findFirst();
    }
}
