package org.phrenic.patient.pipeline;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.label.LabelNames;
import org.phrenic.patient.label.LabelTable;

/**
 * A body to be completed, read from a folder of meshes.
 *
 * @param body the body; what the folder states not to be in the scan keeps that as its source
 * @param statements what else than structures the folder states not to be in the scan, in words
 */
record MeshFolder(PatientBody body, List<String> statements) {
    /**
     * Reads the meshes whose names are those that label tables know, but for the aids of a plan.
     *
     * @throws org.phrenic.file.BadInputException if the folder or a file in it cannot be used
     */
    static MeshFolder read(Path folder, String name) {
        Thorax thorax = ThoraxFolder.loadPart(folder, MeshFolder::structure);
        List<String> notes = new ArrayList<>(thorax.notes());
        List<PatientStructure> structures = parted(withoutAids(thorax, notes), notes).stream()
                .map(s -> new PatientStructure(s, source(thorax, s), Optional.empty(), Optional.empty()))
                .toList();
        List<String> statements = thorax.notInScan().stream()
                .filter(words -> StructureName.parse(words).isEmpty())
                .sorted()
                .toList();
        return new MeshFolder(
                new PatientBody(name, structures, ExpectedStructures.missing(structures), notes), statements);
    }

    /** The structure of a file's name, which is the name itself where that is one of the structure's. */
    private static Optional<String> structure(String name) {
        return LabelNames.structure(name)
                .map(known -> StructureName.parse(known).equals(StructureName.parse(name)) ? name : known);
    }

    private static List<Structure> withoutAids(Thorax thorax, List<String> notes) {
        Map<Boolean, List<Structure>> byAid =
                thorax.structures().stream().collect(Collectors.partitioningBy(s -> LabelTable.isOfPlan(s.name())));
        if (!byAid.get(true).isEmpty()) {
            notes.add(byAid.get(true).stream()
                    .map(Structure::name)
                    .collect(Collectors.joining(", ", LabelTable.AIDS_LEFT_OUT, "")));
        }
        return byAid.get(false);
    }

    private static PatientStructure.Source source(Thorax thorax, Structure s) {
        if (thorax.isInScan(s)) {
            return PatientStructure.Source.SCAN;
        }
        boolean isBuilt = s.kind() == StructureKind.DIAPHRAGM || s.kind() == StructureKind.SKIN;
        return isBuilt ? PatientStructure.Source.BUILT : PatientStructure.Source.VIRTUAL;
    }

    /**
     * Structures of which each has a name of its own. Several files may hold parts of one, such as lobes of a lung or
     * chambers of the heart. Parts of a kind whose structures may have parts, such as lobes, are named {@code lung_R},
     * {@code lung_R_2} and so on; those of another are one structure, as several labels of a volume are.
     */
    private static List<Structure> parted(List<Structure> structures, List<String> notes) {
        Set<String> names = structures.stream().map(MeshFolder::key).collect(Collectors.toCollection(HashSet::new));
        Map<String, List<Structure>> parts = new LinkedHashMap<>();
        structures.forEach(
                s -> parts.computeIfAbsent(key(s), name -> new ArrayList<>()).add(s));
        List<Structure> all = new ArrayList<>();
        for (List<Structure> same : parts.values()) {
            Structure first = same.get(0);
            if (same.size() == 1) {
                all.add(first);
            } else if (first.kind().isNamed()) {
                all.add(first.withMesh(PatientBody.merged(same.stream()).orElseThrow()));
                notes.add(first.name() + ": its " + same.size() + " files are taken together");
            } else {
                List<Structure> named = numbered(same, names);
                all.addAll(named);
                notes.add(first.name() + ": its " + same.size() + " files are kept as "
                        + named.stream().map(Structure::name).collect(Collectors.joining(", ")));
            }
        }
        return all;
    }

    /** What a name has in common with others that some systems take for the same file. */
    private static String key(Structure s) {
        return s.name().toLowerCase(Locale.ROOT);
    }

    private static List<Structure> numbered(List<Structure> parts, Set<String> names) {
        List<Structure> all = new ArrayList<>(parts.subList(0, 1));
        String stem = parts.get(0).name();
        int number = 2;
        for (Structure s : parts.subList(1, parts.size())) {
            while (!names.add((stem + "_" + number).toLowerCase(Locale.ROOT))) {
                number++;
            }
            all.add(new Structure(stem + "_" + number, s.kind(), s.level(), s.side(), s.mesh()));
        }
        return all;
    }
}
