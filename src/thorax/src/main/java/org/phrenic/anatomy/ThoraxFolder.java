package org.phrenic.anatomy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.InputBytes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;

/**
 * Reads a thorax from a folder of meshes. An optional {@code thorax.yaml} states {@code name}, {@code axes},
 * {@code units} (mm, cm, m) and, under {@code structures}, the structure of each file. Without it, structures follow
 * from the file names ({@link StructureName}), and axes and unit are detected ({@link AnatomicalFrame}). Duplicate
 * vertices are welded and degenerate triangles dropped; the notes of the thorax report this.
 */
public final class ThoraxFolder {
    /** Length of a structure that no person has, mm. */
    private static final double LARGEST_MM = 3000;

    /** Name of the file that states name, axes and units of a folder. */
    public static final String INDEX_FILE = "thorax.yaml";
    /** Key of the index of a folder whose meshes are being written. */
    public static final String UNFINISHED_KEY = "unfinished";
    /** Welding distance, mm: coordinates in files are rounded to about a thousandth. */
    public static final double WELD_MM = 1e-3;
    /**
     * Welding distance between patches of one surface, mm. Their coordinates are rounded independently: on the seams of
     * five scanned lobes all of 2,200 vertices had a partner within 0.009 mm, on those of a liver within 0.02 mm.
     */
    public static final double SEAM_MM = 0.05;

    private record Found(String name, StructureName known, Path file) {}

    private record Repaired(TriangleMesh mesh, Optional<String> note) {}
    /** Kinds with at most one structure per level and side; sternum, lungs and skin may have several parts. */
    private static final Set<StructureKind> UNIQUE_KINDS = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.VERTEBRA,
            StructureKind.DISC,
            StructureKind.DIAPHRAGM,
            StructureKind.LIVER);

    /** How much of a thorax a folder has to hold; any is a whole one with a diaphragm, else a part. */
    private enum Extent {
        WHOLE,
        PART,
        ANY
    }

    private ThoraxFolder() {}

    /** @throws BadInputException if the folder or a file in it cannot be read or has invalid content */
    public static Thorax load(Path folder) {
        return load(folder, Extent.WHOLE, Optional::of);
    }

    /**
     * Reads a thorax as {@link #load(Path)}, or one without a diaphragm as {@link #loadPart}.
     *
     * @throws BadInputException as either
     */
    public static Thorax loadWholeOrPart(Path folder) {
        return load(folder, Extent.ANY, Optional::of);
    }

    /**
     * Reads a part of a thorax, to be completed: it needs no diaphragm. Where too few structures tell the axes, they
     * are LPS or RAS, whichever the sides in the names agree with.
     *
     * @param naming the name of the structure that a name of a file stands for
     * @throws BadInputException as {@link #load(Path)}, or if no file is a structure's
     */
    public static Thorax loadPart(Path folder, Function<String, Optional<String>> naming) {
        return load(folder, Extent.PART, naming);
    }

    private static Thorax load(Path folder, Extent extent, Function<String, Optional<String>> naming) {
        LabelVolumeFiles.refuse(folder, "a folder of meshes");
        if (!Files.isDirectory(folder)) {
            throw InputBytes.missing(folder, folder, folder + ": no such folder, expected a folder of meshes");
        }
        Path index = folder.resolve(INDEX_FILE);
        YamlMap yaml = Files.exists(index) ? YamlDocument.read(index) : YamlDocument.parse(INDEX_FILE, "{}");
        if (yaml.has(UNFINISHED_KEY)) {
            throw new BadInputException(
                    folder + ": found the files of an import that did not end, expected a whole body;"
                            + " the scan has to be imported again");
        }
        yaml.requireOnly(List.of("name", "axes", "units", "structures", "not_in_scan"));
        List<String> notes = new ArrayList<>();
        List<Found> found = found(folder, yaml, naming, notes);
        boolean hasDiaphragm = found.stream().anyMatch(f -> f.known().kind() == StructureKind.DIAPHRAGM);
        boolean whole = extent == Extent.WHOLE || (extent == Extent.ANY && hasDiaphragm);
        if (whole) {
            requireDifferentNames(folder, found);
        }
        List<Structure> raw = read(found);
        if (raw.isEmpty()) {
            throw new BadInputException(
                    folder + ": no mesh has the name of a structure, expected one such as rib_05_R.stl;"
                            + " the labels of a scan are imported first (File > Import scan, or phrenic import)");
        }
        if (whole && !hasDiaphragm) {
            throw new BadInputException(folder + ": no diaphragm among " + raw.size()
                    + " structures, expected a file diaphragm.ply (or .stl, .obj, .vtk, .vtp)");
        }
        AnatomicalFrame frame = frame(folder, yaml, raw, whole);
        if (yaml.has("axes")) {
            frame.axesMismatch(raw).ifPresent(notes::add);
        }
        List<Repaired> repaired = raw.stream()
                .map(s -> repairedSurface(folder, s.name(), frame.toLps(s.mesh())))
                .toList();
        List<Structure> structures = new ArrayList<>();
        for (int i = 0; i < raw.size(); i++) {
            structures.add(raw.get(i).withMesh(repaired.get(i).mesh()));
            repaired.get(i).note().ifPresent(notes::add);
        }
        structures.stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .forEach(s -> noteExtraShells(s.mesh(), notes));
        notes.add(0, "axes " + frame.axes() + ", " + frame.millimetresPerUnit() + " mm a unit");
        return new Thorax(
                yaml.text("name", FileNames.ofBody(folder)),
                structures,
                notes,
                yaml.has("not_in_scan")
                        ? yaml.texts("not_in_scan").stream()
                                .map(StructureName::usual)
                                .collect(Collectors.toSet())
                        : Set.of());
    }

    /** The files whose names are those of structures; adds a note on each other one. */
    private static List<Found> found(
            Path folder, YamlMap yaml, Function<String, Optional<String>> naming, List<String> notes) {
        Map<String, Path> files = yaml.has("structures") ? filesFromIndex(folder, yaml) : filesByName(folder);
        List<Found> found = new ArrayList<>();
        // Lists as keys, not records: the first hash of a record makes the JVM generate some forty classes.
        Map<List<Object>, Path> seen = new HashMap<>();
        for (var entry : files.entrySet()) {
            String structure = naming.apply(entry.getKey()).orElse("");
            Optional<StructureName> known = StructureName.parse(structure);
            if (known.isEmpty()) {
                if (yaml.has("structures")
                        && StructureName.parse(entry.getKey()).isEmpty()) {
                    throw yaml.map("structures")
                            .bad(entry.getKey(), "is no structure's name, expected one such as rib_05_R or diaphragm");
                }
                notes.add(entry.getValue().getFileName() + ": left out, its name is no structure's");
                continue;
            }
            StructureName name = known.get();
            List<Object> place = List.of(name.kind(), name.level(), name.side());
            Path twin = UNIQUE_KINDS.contains(name.kind()) ? seen.putIfAbsent(place, entry.getValue()) : null;
            if (twin != null) {
                throw duplicateStructure(folder, twin, entry.getValue());
            }
            found.add(new Found(StructureName.usual(structure), name, entry.getValue()));
        }
        return found;
    }

    /** Refuses two files whose names are two spellings of one. */
    private static void requireDifferentNames(Path folder, List<Found> found) {
        Map<String, Path> seen = new HashMap<>();
        for (Found f : found) {
            Path twin = seen.putIfAbsent(f.name(), f.file());
            if (twin != null) {
                throw duplicateStructure(folder, twin, f.file());
            }
        }
    }

    /**
     * Reads the files sequentially. In parallel, threads contend on profile counters of code that is not yet compiled.
     */
    private static List<Structure> read(List<Found> found) {
        return found.stream().map(ThoraxFolder::read).toList();
    }

    private static Structure read(Found f) {
        StructureName name = f.known();
        return new Structure(f.name(), name.kind(), name.level(), name.side(), MeshFiles.read(f.file()));
    }

    private static AnatomicalFrame frame(Path folder, YamlMap yaml, List<Structure> raw, boolean whole) {
        try {
            if (!whole) {
                String axes = yaml.has("axes") ? yaml.text("axes") : AnatomicalFrame.axesOfPart(raw);
                return new AnatomicalFrame(
                        axes, yaml.has("units") ? unit(yaml) : AnatomicalFrame.unitOfPart(axes, raw));
            }
            if (!yaml.has("units")) {
                return yaml.has("axes")
                        ? AnatomicalFrame.ofStatedAxes(yaml.text("axes"), raw)
                        : AnatomicalFrame.detect(raw);
            }
            double unit = unit(yaml);
            return new AnatomicalFrame(
                    yaml.has("axes")
                            ? yaml.text("axes")
                            : AnatomicalFrame.detect(raw).axes(),
                    unit);
        } catch (IllegalArgumentException e) {
            throw new BadInputException(folder + ": " + e.getMessage(), e);
        }
    }

    private static double unit(YamlMap yaml) {
        return switch (yaml.text("units")) {
            case "mm" -> 1;
            case "cm" -> 10;
            case "m" -> 1000;
            default -> throw yaml.bad("units", "found '" + yaml.text("units") + "', expected mm, cm or m");
        };
    }

    private static Repaired repairedSurface(Path folder, String name, TriangleMesh mesh) {
        requireSize(folder + ", " + name, mesh, "; the units of " + INDEX_FILE + " may be wrong");
        MeshRepair.Result result = MeshRepair.repair(mesh, WELD_MM, SEAM_MM);
        if (result.mesh().triangleCount() == 0) {
            throw new BadInputException(
                    name + ": found no triangle with an area, expected a surface of " + mesh.triangleCount());
        }
        boolean changed = result.mesh().triangleCount() != mesh.triangleCount()
                || result.mesh().vertexCount() != mesh.vertexCount()
                || result.report().trianglesFlipped() > 0;
        return new Repaired(result.mesh(), changed ? Optional.of(name + ": " + result.report()) : Optional.empty());
    }

    /**
     * Adds a note on shells of the diaphragm that are left out, such as loose crura: only the largest closed one is
     * simulated.
     */
    private static void noteExtraShells(TriangleMesh diaphragm, List<String> notes) {
        List<TriangleMesh> shells = ConnectedComponents.of(diaphragm);
        if (shells.size() > 1) {
            String sizes =
                    shells.stream().map(m -> String.valueOf(m.vertexCount())).collect(Collectors.joining(", "));
            notes.add("diaphragm: found " + shells.size() + " shells of " + sizes
                    + " vertices; the largest closed one breathes, the others are left out");
        }
    }

    private static BadInputException duplicateStructure(Path folder, Path one, Path other) {
        return new BadInputException(folder + ": found " + one.getFileName() + " and " + other.getFileName()
                + ", expected one file a structure");
    }

    private static Map<String, Path> filesFromIndex(Path folder, YamlMap yaml) {
        Map<String, Path> files = new TreeMap<>();
        YamlMap structures = yaml.map("structures");
        for (String name : structures.keys()) {
            Path file = folder.resolve(structures.text(name));
            if (!Files.isRegularFile(file)) {
                String sentence = structures
                        .bad(name, "found no file " + file + ", expected a mesh")
                        .getMessage();
                throw InputBytes.missing(file, folder, sentence);
            }
            files.put(name, file);
        }
        return files;
    }

    /**
     * Refuses a mesh with triangles farther apart than those of any structure of a person. Call it before a repair,
     * which drops a triangle with one coordinate far away as one without area.
     *
     * @param source names the mesh in the message
     * @param hint what may be wrong, after the sentence; empty for none
     * @throws BadInputException if the triangles extend over more than 3 m along an axis
     */
    public static void requireSize(String source, TriangleMesh mesh, String hint) {
        double[] p = mesh.positions();
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int v : mesh.triangles()) {
                low = Math.min(low, p[3 * v + axis]);
                high = Math.max(high, p[3 * v + axis]);
            }
            if (high - low > LARGEST_MM) {
                String pattern = "%s: found a structure of %.4g mm, expected at most %.0f mm%s";
                throw new BadInputException(String.format(Locale.ROOT, pattern, source, high - low, LARGEST_MM, hint));
            }
        }
    }

    private static boolean isPart(Path file) {
        return MeshFiles.isMesh(file) && !FileNames.isHidden(file);
    }

    /** Whether a folder has the index of a body or a mesh that would be part of one. */
    public static boolean isBody(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return Files.exists(folder.resolve(INDEX_FILE)) || files.anyMatch(ThoraxFolder::isPart);
        } catch (IOException | UncheckedIOException unlisted) {
            return Files.exists(folder.resolve(INDEX_FILE));
        }
    }

    /** Whether a folder has the index of a body or the mesh of a diaphragm: what is to be imported has neither. */
    public static boolean isWhole(Path folder) {
        try (Stream<Path> files = Files.list(folder)) {
            return Files.exists(folder.resolve(INDEX_FILE))
                    || files.filter(ThoraxFolder::isPart)
                            .map(file -> StructureName.parse(FileNames.withoutExtension(file)))
                            .anyMatch(name -> name.filter(n -> n.kind() == StructureKind.DIAPHRAGM)
                                    .isPresent());
        } catch (IOException | UncheckedIOException e) {
            throw new BadInputException(folder + ": cannot be listed: " + e.getMessage(), e);
        }
    }

    private static Map<String, Path> filesByName(Path folder) {
        Map<String, Path> files = new TreeMap<>();
        for (Path file : InputBytes.list(folder)) {
            String name = FileNames.withoutExtension(file);
            Path twin = isPart(file) ? files.putIfAbsent(name, file) : null;
            if (twin != null) {
                throw duplicateStructure(folder, twin, file);
            }
        }
        return files;
    }
}
