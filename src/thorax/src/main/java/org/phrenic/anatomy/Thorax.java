package org.phrenic.anatomy;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.file.Hashes;

/**
 * A thorax at end-expiration: its named surfaces, in LPS and mm.
 *
 * @param name display name for reports
 * @param structures all surfaces, with unique names
 * @param notes repairs and omissions by the loader, one sentence each
 * @param notInScan names of the structures of a scanned body that its scan does not show, and words for what else it
 *     does not show, such as the breath level of the body
 * @param organs further organs and vessels, which no model of breathing needs, such as the kidneys of a virtual body;
 *     they are generated when they are first asked for
 */
public record Thorax(
        String name,
        List<Structure> structures,
        List<String> notes,
        Set<String> notInScan,
        Supplier<List<Structure>> organs) {

    public Thorax {
        structures = List.copyOf(structures);
        notes = List.copyOf(notes);
        notInScan = Set.copyOf(notInScan);
    }

    /** A body without further organs. */
    public Thorax(String name, List<Structure> structures, List<String> notes, Set<String> notInScan) {
        this(name, structures, notes, notInScan, List::of);
    }

    /** A body whose structures all have the same source. */
    public Thorax(String name, List<Structure> structures, List<String> notes) {
        this(name, structures, notes, Set.of());
    }

    /** This body with further organs. */
    public Thorax withOrgans(Supplier<List<Structure>> further) {
        return new Thorax(name, structures, notes, notInScan, further);
    }

    /** All structures, then the further organs. */
    public List<Structure> structuresAndOrgans() {
        return Stream.concat(structures.stream(), organs.get().stream()).toList();
    }

    /** What is not in the scan, structures by kind, such as "skin, 4 of 24 ribs"; empty if there is nothing. */
    public String notInScanSummary() {
        Set<String> names = structures.stream().map(Structure::name).collect(Collectors.toSet());
        Stream<String> ofKinds =
                Arrays.stream(StructureKind.values()).map(this::notInScanOfKind).filter(text -> !text.isEmpty());
        return Stream.concat(
                        ofKinds,
                        notInScan.stream().filter(name -> !names.contains(name)).sorted())
                .collect(Collectors.joining(", "));
    }

    private String notInScanOfKind(StructureKind kind) {
        List<Structure> all = structuresOf(kind);
        long count = all.stream().filter(s -> !isInScan(s)).count();
        String label = kind.name().toLowerCase(Locale.ROOT).replace('_', ' ');
        if (count == 0 || all.size() == 1) {
            return count == 0 ? "" : label;
        }
        String plural =
                switch (kind) {
                    case VERTEBRA -> "vertebrae";
                    case STERNUM, SKIN, OTHER -> label;
                    default -> label + "s";
                };
        return count == all.size() ? plural : count + " of " + all.size() + " " + plural;
    }

    /** A text that two bodies share only if a simulation finds no difference between their structures. */
    public String content() {
        StringBuilder text = new StringBuilder();
        for (Structure s : structures) {
            text.append(s.name()).append(' ').append(s.kind()).append(' ').append(s.level());
            text.append(' ')
                    .append(s.side())
                    .append(' ')
                    .append(Hashes.sha256(s.mesh().positions()));
            text.append(' ').append(Hashes.sha256(s.mesh().triangles())).append('\n');
        }
        return text.append(notInScan.stream().sorted().toList()).toString();
    }

    /** Whether a structure of a scanned body is in its scan; every structure of another body is. */
    public boolean isInScan(Structure structure) {
        return !notInScan.contains(structure.name());
    }

    /** Words for a part of a structure among what is not in the scan, such as "part of the lungs". */
    public static String partOf(StructureKind kind, String name) {
        return "part of the " + (kind == StructureKind.LUNG ? "lungs" : name.replace('_', ' '));
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
