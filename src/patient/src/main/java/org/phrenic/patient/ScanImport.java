package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.numbering.BoneNumbering;
import org.phrenic.patient.numbering.NumberingDoubts;
import org.phrenic.patient.segmentation.CartilageSplitter;
import org.phrenic.patient.segmentation.EnclosedStructures;
import org.phrenic.patient.segmentation.FilledOutline;
import org.phrenic.patient.segmentation.LungPieces;
import org.phrenic.patient.segmentation.LungSplitter;
import org.phrenic.patient.segmentation.PlanAids;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.SegmentationRepair;

/** Imports a label volume by meshing each of its structures. */
public final class ScanImport {
    /** Target edge lengths, mm. Soft organs have large smooth surfaces, bones are thin. */
    private static final double ORGAN_EDGE_MM = 4;

    private static final double BONE_EDGE_MM = 2.5;

    private static final Map<StructureKind, Double> EDGES_MM = new EnumMap<>(Map.of(
            StructureKind.LUNG, ORGAN_EDGE_MM,
            StructureKind.LIVER, ORGAN_EDGE_MM,
            StructureKind.DIAPHRAGM, ORGAN_EDGE_MM,
            StructureKind.ORGAN, ORGAN_EDGE_MM,
            StructureKind.VESSEL, ORGAN_EDGE_MM,
            StructureKind.MUSCLE, 2 * ORGAN_EDGE_MM,
            StructureKind.OTHER, ORGAN_EDGE_MM,
            StructureKind.SKIN, 2 * ORGAN_EDGE_MM));
    /** Segments of the body outline: background, and label 1. */
    private static final int[] SKIN = {0, 1};
    /** Voxel size of the body outline, relative to the edge length of its triangles. */
    private static final double VOXELS_PER_EDGE = 0.25;

    /** Minimum discarded fraction of a structure for which a note is added. */
    private static final double MIN_DISCARDED = 0.02;
    /** Maximum number of names in a note. */
    private static final int MAX_NAMED = 8;
    /** Structures with fewer voxels are skipped. */
    private static final int MIN_VOXELS = 30;

    private final LabelVolume volume;
    private final String file;
    private final MeshingSettings settings;
    private final Optional<Double> edgeMm;
    private final ImportProgress progress;
    private final List<String> notes;

    /**
     * @param file name of the volume, for messages
     * @param edgeMm edge length of the triangles, mm; 0 keeps the triangles of the decimation; empty uses 4 mm for soft
     *     structures, 2.5 mm for bones and 8 mm for skin, or the voxel size if it is larger
     */
    public ScanImport(
            LabelVolume volume,
            String file,
            MeshingSettings settings,
            Optional<Double> edgeMm,
            ImportProgress progress) {
        this.volume = volume;
        this.file = file;
        this.settings = settings;
        this.edgeMm = edgeMm;
        this.progress = progress;
        notes = new ArrayList<>(volume.notes());
    }

    /**
     * Imports the structures listed in a table.
     *
     * @param name name of the body
     * @throws BadInputException if the volume contains none of the structures
     */
    public PatientBody run(LabelTable table, String name) {
        Segmentation segmentation = new Segmentation(volume, table, file);
        if (!table.missing().isEmpty()) {
            notes.add("the volume has none of these structures of the table: " + String.join(", ", table.missing()));
        }
        noteLabels(table);
        PlanAids.giveToTheirSurroundings(segmentation);
        split(segmentation);
        List<String> built = meshable(segmentation);
        EnclosedStructures enclosed = EnclosedStructures.find(segmentation);
        enclosed.fillOrgans().ifPresent(notes::add);
        progress.stage("meshing " + built.size() + " structures (surface nets)");
        List<PatientStructure> structures = mesh(built, segmentation, enclosed);
        note(structures);
        return new PatientBody(name, structures, ExpectedStructures.missing(structures), notes);
    }

    private void split(Segmentation segmentation) {
        if (segmentation.find(LabelTable.LUNGS) > 0) {
            progress.stage("separating the lungs");
            LungSplitter.split(segmentation, notes).ifPresent(problem -> {
                throw new BadInputException(file + ": " + problem);
            });
        }
        try {
            notes.addAll(BoneNumbering.numberRibs(segmentation));
        } catch (BadInputException problem) {
            throw new BadInputException(file + ": " + problem.getMessage(), problem);
        }
        if (segmentation.find(LabelTable.COSTAL_CARTILAGES) > 0) {
            progress.stage("separating the cartilages");
            CartilageSplitter.split(segmentation).ifPresent(notes::add);
        }
        progress.stage("filling holes, joining pieces");
        notes.addAll(SegmentationRepair.mend(segmentation));
        notes.addAll(NumberingDoubts.find(segmentation));
        notes.addAll(LungPieces.name(segmentation));
        segmentation.findCuts();
    }

    /** Structures with enough voxels. The largest come first to balance the parallel meshing. */
    private List<String> meshable(Segmentation segmentation) {
        int[] counts = segmentation.counts();
        List<String> built = new ArrayList<>();
        for (int segment = 1; segment < counts.length; segment++) {
            String structure = segmentation.names().get(segment - 1);
            if (counts[segment] >= MIN_VOXELS) {
                built.add(structure);
            } else if (counts[segment] > 0) {
                notes.add(structure + ": left out, it has " + counts[segment] + " voxels");
            }
        }
        if (built.isEmpty()) {
            throw new BadInputException(
                    file + ": found no structure of " + MIN_VOXELS + " voxels or more, expected one");
        }
        built.sort(Comparator.comparingInt((String structure) -> -counts[segmentation.find(structure)]));
        return built;
    }

    private List<PatientStructure> mesh(List<String> built, Segmentation segmentation, EnclosedStructures enclosed) {
        double voxelMm3 = segmentation.grid().voxelVolume();
        int[] counts = segmentation.counts();
        int ofBody = IntStream.of(counts).skip(1).sum();
        int[] ownCounts = enclosed.ownVoxels().map(LabelGrid::counts).orElse(counts);
        int[] segments = new int[counts.length];
        int[] within = new int[counts.length];
        for (String structure : built) {
            int segment = segmentation.find(structure);
            if (enclosed.contains(structure) && enclosed.ownVoxels().isPresent()) {
                within[segment] = segment;
                counts[segment] = ownCounts[segment];
            } else if (!isSkin(structure)) {
                segments[segment] = segment;
            }
        }
        SegmentMesher mesher = new SegmentMesher(segmentation.grid(), segments, settings);
        Optional<SegmentMesher> inner = enclosed.ownVoxels().map(voxels -> new SegmentMesher(voxels, within, settings));
        // The skin encloses all other structures, so its outline is meshed separately.
        Optional<SegmentMesher> skin = built.stream()
                .filter(ScanImport::isSkin)
                .min(Comparator.comparingInt(segmentation::find))
                .map(structure -> new SegmentMesher(
                        FilledOutline.of(segmentation, coarsening(segmentation, edge(structure, voxelMm3))),
                        SKIN,
                        settings));
        segmentation.releaseVoxels();
        PatientStructure[] meshed = new PatientStructure[built.size()];
        AtomicInteger next = new AtomicInteger();
        AtomicInteger done = new AtomicInteger();
        IntStream.range(0, Math.min(built.size(), ForkJoinPool.getCommonPoolParallelism() + 1))
                .parallel()
                .forEach(worker -> {
                    for (int i = next.getAndIncrement(); i < meshed.length; i = next.getAndIncrement()) {
                        String structure = built.get(i);
                        int segment = segmentation.find(structure);
                        double edge = edge(structure, voxelMm3);
                        SegmentMesher own = within[segment] > 0 ? inner.orElseThrow() : mesher;
                        meshed[i] = isSkin(structure)
                                ? structure(
                                        structure,
                                        segmentation,
                                        ofBody,
                                        voxelMm3,
                                        skin.orElseThrow().mesh(1, edge))
                                : structure(
                                        structure,
                                        segmentation,
                                        counts[segment],
                                        voxelMm3,
                                        keepsPieces(structure) ? own.meshAll(segment, edge) : own.mesh(segment, edge));
                        synchronized (done) {
                            progress.meshed(done.incrementAndGet(), built.size(), structure);
                        }
                    }
                });
        return Stream.of(meshed)
                .sorted(Comparator.comparing(s -> s.structure().name()))
                .toList();
    }

    /** Whether every piece of a structure is kept: an obstacle is one wherever it lies, and each of several bones. */
    private static boolean keepsPieces(String structure) {
        StructureKind kind = StructureName.parse(structure).orElseThrow().kind();
        return (kind.isNamed() && kind != StructureKind.BONE) || LabelTable.isSeveralBones(structure);
    }

    private static boolean isSkin(String structure) {
        return StructureName.parse(structure).orElseThrow().kind() == StructureKind.SKIN;
    }

    private double edge(String structure, double voxelMm3) {
        StructureKind kind = StructureName.parse(structure).orElseThrow().kind();
        return edgeMm.orElse(Math.max(StrictMath.cbrt(voxelMm3), EDGES_MM.getOrDefault(kind, BONE_EDGE_MM)));
    }

    /** Coarsening factor of the voxels along each grid axis for a target edge length. */
    private static int[] coarsening(Segmentation segmentation, double edge) {
        return IntStream.range(0, 3)
                .map(direction -> Math.max(
                        1, (int) (VOXELS_PER_EDGE * edge / segmentation.grid().spacing(direction))))
                .toArray();
    }

    private static PatientStructure structure(
            String name, Segmentation segmentation, int voxels, double voxelMm3, MeshedSegment meshed) {
        StructureName known = StructureName.parse(name).orElseThrow();
        return PatientStructure.ofScan(
                new Structure(name, known.kind(), known.level(), known.side(), meshed.mesh()),
                new PatientStructure.Scan(
                        segmentation.labels(name),
                        voxels,
                        voxels * voxelMm3 / MeshMeasure.MM3_PER_ML,
                        segmentation.cuts(name),
                        meshed));
    }

    /** Adds notes about truncated structures, structures in several pieces, and implausible ribs and lungs. */
    private void note(List<PatientStructure> structures) {
        List<String> cut = new ArrayList<>();
        for (PatientStructure structure : structures) {
            PatientStructure.Scan scan = structure.scan().orElseThrow();
            String name = structure.structure().name();
            if (!scan.isComplete()) {
                cut.add(name + " (" + scan.cutAt() + ")");
            }
            if (scan.meshed().discardedMm3() > MIN_DISCARDED * MeshMeasure.MM3_PER_ML * scan.volumeMl()) {
                notes.add(Numbers.format(
                        "%s: of %d pieces the largest was taken, %.1f ml left out",
                        name, scan.meshed().components(), scan.meshed().discardedMm3() / MeshMeasure.MM3_PER_ML));
            }
        }
        if (!cut.isEmpty()) {
            notes.add("cut off by the end of the scan, at the side in brackets, and closed flat there: "
                    + String.join(", ", cut));
        }
        RibPlausibility.check(structures).ifPresent(notes::add);
        notes.addAll(LungPlausibility.check(structures));
    }

    /** Adds notes about labels that are left out, and labels whose structure is unknown. */
    private void noteLabels(LabelTable table) {
        int[] counts = volume.grid().counts();
        List<String> unused = new ArrayList<>();
        List<String> unknown = new ArrayList<>();
        List<String> ofPlan = new ArrayList<>();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0) {
                String structure = table.structures().getOrDefault(label, LabelTable.IGNORE);
                String name = volume.names().get(label);
                if (structure.equals(LabelTable.IGNORE)) {
                    unused.add(name == null ? String.valueOf(label) : label + " (" + name + ")");
                } else if (LabelTable.isOfPlan(structure)) {
                    ofPlan.add(name == null ? structure : name);
                } else if (structure.startsWith(OrganNames.OTHER_PREFIX)) {
                    unknown.add(structure);
                }
            }
        }
        note("labels that the table maps to no structure: ", unused);
        note(LabelTable.AIDS_LEFT_OUT, ofPlan);
        note("labels of unknown structures, kept as obstacles: ", unknown);
    }

    private void note(String what, List<String> labels) {
        if (!labels.isEmpty()) {
            int shown = Math.min(MAX_NAMED, labels.size());
            notes.add(what
                    + String.join(", ", labels.subList(0, shown))
                    + (labels.size() > shown ? " and " + (labels.size() - shown) + " more" : ""));
        }
    }
}
