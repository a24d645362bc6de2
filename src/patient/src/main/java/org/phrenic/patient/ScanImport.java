package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.patient.segmentation.CartilageSplitter;
import org.phrenic.patient.segmentation.LabelTable;
import org.phrenic.patient.segmentation.LungSplitter;
import org.phrenic.patient.segmentation.Segmentation;

/** Meshes every structure that a volume of labels holds. */
public final class ScanImport {
    /** Edge of the triangles of soft organs: their surfaces are large and smooth. */
    private static final double ORGAN_EDGE_MM = 4;
    /** Edge of those of bones, which are thin. */
    private static final double BONE_EDGE_MM = 2.5;

    private static final Map<StructureKind, Double> EDGES_MM = new EnumMap<>(Map.of(
            StructureKind.LUNG, ORGAN_EDGE_MM,
            StructureKind.LIVER, ORGAN_EDGE_MM,
            StructureKind.DIAPHRAGM, ORGAN_EDGE_MM,
            StructureKind.SKIN, 2 * ORGAN_EDGE_MM));
    private static final double MM3_PER_ML = 1000;
    /** The outline of the body alone: background, and label 1. */
    private static final int[] SKIN = {0, 1};
    /** Size of the voxels of the outline, in edges of its triangles. */
    private static final double VOXELS_AN_EDGE = 0.25;

    /** Pieces of less than this share of a structure are not worth a sentence. */
    private static final double LITTLE = 0.02;
    /** Names in a sentence. */
    private static final int MOST_NAMED = 8;
    /** A structure of fewer voxels has no shape. */
    private static final int LEAST_VOXELS = 30;

    private final LabelVolume volume;
    private final String file;
    private final MeshingSettings steps;
    private final Optional<Double> edgeMm;
    private final ImportProgress progress;
    private final List<String> notes;

    /**
     * @param file to name in sentences
     * @param edgeMm edge of the triangles, mm, 0 for those of the decimation; empty for 4 mm on soft organs, 2.5 mm on
     *     bones and 8 mm on skin, or the voxel's size if that is larger
     */
    public ScanImport(
            LabelVolume volume, String file, MeshingSettings steps, Optional<Double> edgeMm, ImportProgress progress) {
        this.volume = volume;
        this.file = file;
        this.steps = steps;
        this.edgeMm = edgeMm;
        this.progress = progress;
        notes = new ArrayList<>(volume.notes());
    }

    /**
     * The structures of the map that the volume has.
     *
     * @param name what to call the body
     * @throws BadInputException if it has none
     */
    public PatientBody run(LabelTable map, String name) {
        Segmentation parts = Segmentation.of(volume, map, file);
        if (!map.missing().isEmpty()) {
            notes.add("the volume lacks what the table names: " + String.join(", ", map.missing()));
        }
        noteUnused(map);
        if (parts.find(LabelTable.LUNGS) > 0) {
            progress.stage("telling the lungs apart");
            LungSplitter.split(parts).ifPresent(problem -> {
                throw new BadInputException(file + ": " + problem);
            });
        }
        if (parts.find(LabelTable.COSTAL_CARTILAGES) > 0) {
            progress.stage("telling the cartilages apart");
            CartilageSplitter.split(parts).ifPresent(notes::add);
        }
        double voxelMm3 = parts.grid().voxelVolume();
        int[] counts = parts.counts();
        List<String> built = new ArrayList<>();
        int[] partNumbers = new int[counts.length];
        for (int part = 1; part < counts.length; part++) {
            String structure = parts.names().get(part - 1);
            if (counts[part] >= LEAST_VOXELS) {
                partNumbers[part] = isSkin(structure) ? 0 : part;
                built.add(structure);
            } else if (counts[part] > 0) {
                notes.add(structure + ": left out, it has " + counts[part] + " voxels");
            }
        }
        if (built.isEmpty()) {
            throw new BadInputException(
                    file + ": found no structure of " + LEAST_VOXELS + " voxels or more, expected one");
        }
        progress.stage("laying a net between " + built.size() + " structures");
        SegmentMesher mesher = new SegmentMesher(parts.grid(), partNumbers, steps);
        // The skin has all else within it: its inner side is of no interest, and its outline is meshed by itself.
        Optional<SegmentMesher> skin = built.stream()
                .filter(ScanImport::isSkin)
                .findFirst()
                .map(structure ->
                        new SegmentMesher(parts.bodyOutline(coarser(parts, edge(structure, voxelMm3))), SKIN, steps));
        parts.releaseVoxels();
        // The largest first, so that no thread is left with one of them in the end.
        built.sort(Comparator.comparingInt((String structure) -> -counts[parts.find(structure)]));
        PatientStructure[] meshed = new PatientStructure[built.size()];
        AtomicInteger next = new AtomicInteger();
        AtomicInteger done = new AtomicInteger();
        IntStream.range(0, Math.min(built.size(), ForkJoinPool.getCommonPoolParallelism() + 1))
                .parallel()
                .forEach(worker -> {
                    for (int i = next.getAndIncrement(); i < meshed.length; i = next.getAndIncrement()) {
                        meshed[i] = organ(built.get(i), parts, counts, voxelMm3, mesher, skin);
                        synchronized (done) {
                            progress.meshed(done.incrementAndGet(), built.size(), built.get(i));
                        }
                    }
                });
        List<PatientStructure> organs = Stream.of(meshed)
                .sorted(Comparator.comparing(organ -> organ.structure().name()))
                .toList();
        note(organs);
        return new PatientBody(name, organs, ExpectedStructures.missing(organs), notes);
    }

    private static boolean isSkin(String structure) {
        return StructureName.parse(structure).orElseThrow().kind() == StructureKind.SKIN;
    }

    private double edge(String structure, double voxelMm3) {
        StructureKind kind = StructureName.parse(structure).orElseThrow().kind();
        return edgeMm.orElse(Math.max(Math.cbrt(voxelMm3), EDGES_MM.getOrDefault(kind, BONE_EDGE_MM)));
    }

    /** By how much larger voxels still show what triangles of an edge do. */
    private static int[] coarser(Segmentation parts, double edge) {
        return IntStream.range(0, 3)
                .map(direction ->
                        Math.max(1, (int) (VOXELS_AN_EDGE * edge / parts.grid().spacing(direction))))
                .toArray();
    }

    private PatientStructure organ(
            String structure,
            Segmentation parts,
            int[] counts,
            double voxelMm3,
            SegmentMesher mesher,
            Optional<SegmentMesher> skin) {
        StructureName known = StructureName.parse(structure).orElseThrow();
        int part = parts.find(structure);
        double edge = edge(structure, voxelMm3);
        boolean outline = isSkin(structure);
        MeshedSegment meshed = outline ? skin.orElseThrow().mesh(1, edge) : mesher.mesh(part, edge);
        int count = outline ? IntStream.of(counts).skip(1).sum() : counts[part];
        return PatientStructure.ofScan(
                new Structure(structure, known.kind(), known.level(), known.side(), meshed.mesh()),
                new PatientStructure.Scan(
                        parts.labels(structure), count, count * voxelMm3 / MM3_PER_ML, parts.cutAt(structure), meshed));
    }

    /** One sentence each about what the scan cuts off, what came in pieces and what looks turned. */
    private void note(List<PatientStructure> organs) {
        List<String> cut = new ArrayList<>();
        for (PatientStructure organ : organs) {
            PatientStructure.Scan scan = organ.scan().orElseThrow();
            String name = organ.structure().name();
            if (!scan.isComplete()) {
                cut.add(name + " (" + scan.cutAt() + ")");
            }
            if (scan.meshed().discardedMm3() > LITTLE * MM3_PER_ML * scan.volumeMl()) {
                notes.add(String.format(
                        Locale.ROOT,
                        "%s: of %d pieces the largest was taken, %.1f ml left out",
                        name,
                        scan.meshed().components(),
                        scan.meshed().discardedMm3() / MM3_PER_ML));
            }
        }
        if (!cut.isEmpty()) {
            notes.add("cut off by the end of the scan, at the side in brackets, and closed flat there: "
                    + String.join(", ", cut));
        }
        notes.addAll(LungPlausibility.check(organs));
    }

    /** The labels that the volume has beside those of structures. */
    private void noteUnused(LabelTable map) {
        int[] counts = volume.grid().counts();
        List<String> unused = new ArrayList<>();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0 && !map.structures().containsKey(label)) {
                String name = volume.names().get(label);
                unused.add(name == null ? String.valueOf(label) : label + " (" + name + ")");
            }
        }
        if (!unused.isEmpty()) {
            int shown = Math.min(MOST_NAMED, unused.size());
            notes.add("labels of the volume that are none of the structures asked for: "
                    + String.join(", ", unused.subList(0, shown))
                    + (unused.size() > shown ? " and " + (unused.size() - shown) + " more" : ""));
        }
    }
}
