package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * Lungs and ribs that a completed body has of its template although the scan shows their places: they lie within its
 * field of view, among bones that it labels. The person may lack them, as a lung that was removed or a twelfth rib, or
 * their labels are missing.
 */
public final class AbsentStructures {
    /** Ribs of a side from which on the scan labels the ribs of that side. */
    private static final int LEAST_RIBS = 6;
    /** Least share of the vertices of a structure within the field of view. */
    private static final double LEAST_WITHIN = 0.9;
    /** Edge of the voxels in which overlaps are measured, mm. */
    private static final double VOXEL_MM = 3;
    /** Least overlap with an organ that a note states, ml. */
    private static final double STATED_ML = 1;

    private final PatientBody body;
    private final VoxelBox view;
    private final double[] toVoxel;
    /** First and last slice with labels. */
    private final int[] slices;

    private AbsentStructures(PatientBody body, LabelGrid grid) {
        this.body = body;
        view = VoxelBox.of(grid);
        toVoxel = view.toVoxel();
        slices = labelled(grid);
    }

    /**
     * Returns one sentence for each lung, and one for all ribs.
     *
     * @param body the completed body at the breath level of its scan
     * @param grid voxels of the scan
     */
    public static List<String> notes(PatientBody body, LabelGrid grid) {
        AbsentStructures absent = new AbsentStructures(body, grid);
        List<String> notes = new ArrayList<>();
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            absent.lung(side).ifPresent(notes::add);
        }
        absent.ribs().ifPresent(notes::add);
        return notes;
    }

    private Optional<String> lung(Side side) {
        List<PatientStructure> own = of(StructureKind.LUNG, side);
        List<PatientStructure> other = of(StructureKind.LUNG, side == Side.RIGHT ? Side.LEFT : Side.RIGHT);
        boolean otherIsWhole = !other.isEmpty() && other.stream().allMatch(s -> isShown(s) && s.isComplete());
        if (own.isEmpty() || !otherIsWhole || !own.stream().allMatch(this::isExpected)) {
            return Optional.empty();
        }
        String word = side == Side.RIGHT ? "right" : "left";
        return Optional.of(Numbers.format(
                "the scan shows the %s side of the chest and no %s lung, as after its removal or without its label;"
                        + " a virtual one lies there%s",
                word, word, overlaps(own)));
    }

    private Optional<String> ribs() {
        List<String> names = body.structures().stream()
                .filter(s -> s.structure().kind() == StructureKind.RIB && isExpected(s))
                .filter(s -> of(StructureKind.VERTEBRA, Side.MIDLINE).stream()
                        .anyMatch(v -> v.structure().level() == s.structure().level() && isShown(v) && v.isComplete()))
                .map(s -> s.structure().name())
                .toList();
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "the scan shows the vertebrae of these ribs whole and not the ribs, as of a person without"
                                + " them or without their labels; virtual ones lie there: " + String.join(", ", names));
    }

    private List<PatientStructure> of(StructureKind kind, Side side) {
        return body.structures().stream()
                .filter(s -> s.structure().kind() == kind && s.structure().side() == side)
                .toList();
    }

    private static boolean isShown(PatientStructure s) {
        return s.source() == PatientStructure.Source.SCAN || s.source() == PatientStructure.Source.EXTENDED;
    }

    /** Whether a structure is the template's and the scan would show it. */
    private boolean isExpected(PatientStructure s) {
        long ribs = of(StructureKind.RIB, s.structure().side()).stream()
                .filter(AbsentStructures::isShown)
                .count();
        return s.source() == PatientStructure.Source.VIRTUAL
                && s.scan().isEmpty()
                && ribs >= LEAST_RIBS
                && shareInView(s.structure().mesh()) >= LEAST_WITHIN;
    }

    /** First and last slice with labels; a volume can be filled up with empty ones beyond the end of the scan. */
    private static int[] labelled(LabelGrid grid) {
        int area = grid.columns() * grid.rows();
        int first = 0;
        int last = grid.voxelCount() - 1;
        while (first < last && grid.label(first) == 0) {
            first++;
        }
        while (last > first && grid.label(last) == 0) {
            last--;
        }
        return new int[] {first / area, last / area};
    }

    private double shareInView(TriangleMesh mesh) {
        double[] voxel = new double[3];
        int inside = 0;
        for (int v = 0; v < mesh.vertexCount(); v++) {
            VoxelBox.apply(toVoxel, mesh.x(v), mesh.y(v), mesh.z(v), voxel);
            boolean within = true;
            for (int axis = 0; axis < 3; axis++) {
                within &= voxel[axis] > -0.5 && voxel[axis] < view.size()[axis] - 0.5;
            }
            within &= voxel[2] > slices[0] - 0.5 && voxel[2] < slices[1] + 0.5;
            inside += within ? 1 : 0;
        }
        return (double) inside / mesh.vertexCount();
    }

    /** Volumes that a lung shares with lungs and organs of the scan, in words; nothing if there are none. */
    private String overlaps(List<PatientStructure> lung) {
        TriangleMesh mesh = PatientBody.merged(lung.stream().map(PatientStructure::structure))
                .orElseThrow();
        double[] box = mesh.bounds();
        VoxelBox voxels = VoxelBox.covering(Arrays.copyOfRange(box, 0, 3), Arrays.copyOfRange(box, 3, 6), VOXEL_MM);
        byte[] labels = new byte[voxels.voxels()];
        MeshVoxelizer voxelizer =
                new MeshVoxelizer(voxels.columns(), voxels.rows(), voxels.slices(), voxels.toVoxel(), labels);
        voxelizer.fill(mesh, 1);
        List<String> found = new ArrayList<>();
        int left = count(labels);
        for (PatientStructure s : body.structures()) {
            if (isShown(s) && isOrgan(s.structure())) {
                voxelizer.fill(s.structure().mesh(), 0);
                int before = left;
                left = count(labels);
                double ml = (before - left) * VOXEL_MM * VOXEL_MM * VOXEL_MM / MeshMeasure.MM3_PER_ML;
                if (ml >= STATED_ML) {
                    found.add(Numbers.format("%s by %.0f ml", s.structure().name(), ml));
                }
            }
        }
        return found.isEmpty() ? "" : found.stream().collect(Collectors.joining(", ", " and overlaps ", ""));
    }

    private static boolean isOrgan(Structure s) {
        return s.kind() == StructureKind.LUNG || s.kind() == StructureKind.LIVER || s.kind() == StructureKind.ORGAN;
    }

    private static int count(byte[] labels) {
        int count = 0;
        for (byte label : labels) {
            count += label;
        }
        return count;
    }
}
