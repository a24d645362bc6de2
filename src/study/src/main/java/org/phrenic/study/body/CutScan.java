package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.MeshVoxelizer;

/** The label volume that a scan of a body would give, with label numbers as {@link BodyCut#numbers}. */
final class CutScan {
    private static final int MARGIN = 3;
    /** Most voxels along an axis: their product is within the length of an array. */
    private static final int MAX_VOXELS = 1200;

    private static final long SEED = 5;
    private static final double ABOVE_LIVER_MM = 25;
    private static final double BEYOND_MIDLINE_MM = 10;
    /** Level of the vertebra at which {@link BodyCut#CUT_ENDS} ends above. */
    private static final int UPPER_END = 3;

    private static final int LIVER = 5;
    private static final int LEFT_LUNG = 10;
    private static final int RIGHT_LUNG = 12;
    private static final int BEFORE_T1 = 44;
    private static final int BEFORE_LEFT_RIB_1 = 91;
    private static final int BEFORE_RIGHT_RIB_1 = 103;
    private static final int STERNUM = 116;
    private static final int CARTILAGES = 117;
    private static final Map<String, Integer> NAMED = Map.of(
            "spleen", 1, "kidney_R", 2, "kidney_L", 3, "gallbladder", 4, "stomach", 6, "trachea", 16, "heart", 51);

    private final BodyCut cut;
    private final Thorax body;
    private final double voxelMm;
    /** Rows are the unit vectors of columns, rows and slices. */
    private final double[][] axes;

    private CutScan(Thorax body, BodyCut cut, double voxelMm) {
        this.cut = cut;
        this.voxelMm = voxelMm;
        this.body = inScan(body, cut);
        double[][] straight = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        axes = cut == BodyCut.OBLIQUE ? rotation(new double[] {1, 1, 1}) : straight;
    }

    /** A body in the position in which a scan shows it. */
    static Thorax inScan(Thorax body, BodyCut cut) {
        return cut == BodyCut.TURNED ? turned(body) : body;
    }

    /** @param body at the inspiration of the cut */
    static LabelGrid of(Thorax body, BodyCut cut) {
        return of(body, cut, BodyCut.VOXEL_MM);
    }

    /** As {@link #of(Thorax, BodyCut)}, with voxels of another edge length in a slice, mm. */
    static LabelGrid of(Thorax body, BodyCut cut, double voxelMm) {
        return new CutScan(body, cut, voxelMm).volume();
    }

    private LabelGrid volume() {
        List<Structure> shown = new ArrayList<>(
                body.structuresAndOrgans().stream().filter(s -> label(s) > 0).toList());
        // Bones are written last: they keep their thickness where surfaces overlap.
        shown.sort(Comparator.comparing(s -> BodyCut.isBone(s.kind())));
        double[] box = box(shown);
        double[] step = {voxelMm, voxelMm, Math.max(voxelMm, cut.sliceMm())};
        int[] size = new int[3];
        double[] toMm = new double[12];
        double[] toVoxel = new double[12];
        for (int axis = 0; axis < 3; axis++) {
            size[axis] = voxels(axis, box, step[axis]);
            for (int row = 0; row < 3; row++) {
                toMm[4 * row + axis] = axes[axis][row] * step[axis];
                toMm[4 * row + 3] += axes[axis][row] * (box[axis] + step[axis] / 2);
                toVoxel[4 * axis + row] = axes[axis][row] / step[axis];
            }
            toVoxel[4 * axis + 3] = -box[axis] / step[axis] - 0.5;
        }
        byte[] labels = new byte[size[0] * size[1] * size[2]];
        MeshVoxelizer voxels = new MeshVoxelizer(size[0], size[1], size[2], toVoxel, labels);
        shown.forEach(s -> voxels.fill(s.mesh(), label(s)));
        LabelGrid grid = LabelGrid.of(size[0], size[1], size[2], labels, toMm);
        damage(grid, labels);
        return grid;
    }

    /** Number of voxels along an axis of the field of view. */
    private int voxels(int axis, double[] box, double step) {
        double count = Math.ceil((box[axis + 3] - box[axis]) / step);
        if (!(count >= 1 && count <= MAX_VOXELS)) {
            throw new IllegalArgumentException(body.name() + ": found a field of view of " + count
                    + " voxels along an axis of the cut " + cut.label() + ", expected 1 to " + MAX_VOXELS);
        }
        return (int) count;
    }

    /** Label of a structure; 0 if the scan does not show it. */
    private int label(Structure s) {
        if (!cut.shows(s.kind())) {
            return 0;
        }
        return cut.hasCommonLabels() ? commonLabel(s) : ownLabel(s);
    }

    private static int commonLabel(Structure s) {
        return switch (s.kind()) {
            case LIVER -> 1;
            case LUNG -> 3;
            case ORGAN -> s.name().startsWith("kidney") ? 4 : 0;
            default -> 5;
        };
    }

    private static int ownLabel(Structure s) {
        return switch (s.kind()) {
            case RIB -> s.level() + (s.side() == Side.LEFT ? BEFORE_LEFT_RIB_1 : BEFORE_RIGHT_RIB_1);
            case COSTAL_CARTILAGE -> CARTILAGES;
            case STERNUM -> STERNUM;
            case VERTEBRA -> BEFORE_T1 - s.level();
            case LUNG -> s.side() == Side.LEFT ? LEFT_LUNG : RIGHT_LUNG;
            case LIVER -> LIVER;
            default -> NAMED.getOrDefault(s.name(), 0);
        };
    }

    /** The field of view along the grid's axes, mm: what is shown with a margin, or where the cut ends it. */
    private double[] box(List<Structure> shown) {
        double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE, -1e9, -1e9, -1e9};
        for (Structure s : shown) {
            double[] p = s.mesh().positions();
            for (int k = 0; k < p.length; k += 3) {
                for (int axis = 0; axis < 3; axis++) {
                    double at = axes[axis][0] * p[k] + axes[axis][1] * p[k + 1] + axes[axis][2] * p[k + 2];
                    box[axis] = Math.min(box[axis], at - MARGIN * voxelMm);
                    box[axis + 3] = Math.max(box[axis + 3], at + MARGIN * voxelMm);
                }
            }
        }
        switch (cut) {
            case ABDOMEN, INSPIRED_ABDOMEN, COMMON_ABDOMEN -> box[5] = liver()[5] + ABOVE_LIVER_MM;
            case RIGHT_SIDE -> box[3] = middle(UPPER_END)[0] + BEYOND_MIDLINE_MM;
            case CUT_ENDS -> {
                box[2] = 0.5 * (liver()[2] + liver()[5]);
                box[5] = middle(UPPER_END)[2];
            }
            default -> {
                // Everything that is shown lies in the field of view.
            }
        }
        return box;
    }

    private double[] liver() {
        return body.structuresOf(StructureKind.LIVER).stream()
                .findFirst()
                .map(s -> s.mesh().bounds())
                .orElseThrow(() -> new IllegalArgumentException(body.name() + ": found no liver, expected one"));
    }

    /** Middle of the box of a vertebra. */
    private double[] middle(int level) {
        double[] b = body.find(StructureKind.VERTEBRA, level, Side.MIDLINE)
                .map(s -> s.mesh().bounds())
                .orElseThrow(() -> new IllegalArgumentException(
                        body.name() + ": found no vertebra of level " + level + ", expected one"));
        return new double[] {0.5 * (b[0] + b[3]), 0.5 * (b[1] + b[4]), 0.5 * (b[2] + b[5])};
    }

    /** Takes voxels away: of bones near the heads of ribs or at random, of the right lung below a level. */
    private void damage(LabelGrid grid, byte[] labels) {
        if (cut == BodyCut.EFFUSION) {
            int[] box = grid.box(label -> label == RIGHT_LUNG);
            int surface = (int) (grid.columns() * grid.rows() * (box[2] + BodyCut.FLUID_SHARE * (box[5] - box[2])));
            for (int v = 0; v < surface; v++) {
                labels[v] = labels[v] == RIGHT_LUNG ? 0 : labels[v];
            }
        }
        if (cut == BodyCut.DROPPED) {
            Random random = new Random(SEED);
            for (int v = 0; v < labels.length; v++) {
                boolean bone = (labels[v] & 0xff) > BEFORE_LEFT_RIB_1
                        || ((labels[v] & 0xff) < BEFORE_T1 && (labels[v] & 0xff) >= BEFORE_T1 - 17);
                labels[v] = bone && random.nextDouble() < BodyCut.DROPPED_SHARE ? 0 : labels[v];
            }
        }
        if (cut.ribsShortMm() == 0) {
            return;
        }
        double[][] heads = new double[256][];
        body.structuresOf(StructureKind.RIB).forEach(rib -> heads[label(rib)] = head(rib));
        double[] at = new double[3];
        for (int v = 0; v < labels.length; v++) {
            double[] head = heads[labels[v] & 0xff];
            if (head != null) {
                int row = v / grid.columns() % grid.rows();
                int slice = v / (grid.columns() * grid.rows());
                grid.voxelToMm(v % grid.columns(), row, slice, at);
                labels[v] = squaredDistance(at, head, 0) < cut.ribsShortMm() * cut.ribsShortMm() ? 0 : labels[v];
            }
        }
    }

    /** The vertex of a rib nearest to the middle of the front of its vertebra. */
    private double[] head(Structure rib) {
        Optional<double[]> box = body.find(StructureKind.VERTEBRA, rib.level(), Side.MIDLINE)
                .map(s -> s.mesh().bounds());
        double[] b = box.orElseThrow(() ->
                new IllegalArgumentException(body.name() + ": found no vertebra of " + rib.name() + ", expected one"));
        double[] front = {0.5 * (b[0] + b[3]), b[1], 0.5 * (b[2] + b[5])};
        double[] p = rib.mesh().positions();
        int best = 0;
        for (int k = 0; k < p.length; k += 3) {
            best = squaredDistance(front, p, k) < squaredDistance(front, p, best) ? k : best;
        }
        return new double[] {p[best], p[best + 1], p[best + 2]};
    }

    private static double squaredDistance(double[] a, double[] p, int k) {
        double dx = a[0] - p[k];
        double dy = a[1] - p[k + 1];
        double dz = a[2] - p[k + 2];
        return dx * dx + dy * dy + dz * dz;
    }

    private static Thorax turned(Thorax body) {
        double[][] r = rotation(new double[] {0, 0, 1});
        List<Structure> structures = body.structuresAndOrgans().stream()
                .map(s -> s.withMesh(rotated(s.mesh(), r)))
                .toList();
        return new Thorax(body.name(), structures, body.notes());
    }

    private static TriangleMesh rotated(TriangleMesh mesh, double[][] r) {
        double[] p = mesh.positions();
        double[] q = new double[p.length];
        for (int k = 0; k < p.length; k += 3) {
            for (int row = 0; row < 3; row++) {
                q[k + row] = r[row][0] * p[k] + r[row][1] * p[k + 1] + r[row][2] * p[k + 2];
            }
        }
        return mesh.withPositions(q);
    }

    /** Rotation by {@link BodyCut#TURN_DEG} about an axis (Rodrigues). */
    private static double[][] rotation(double[] axis) {
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        double[] u = {axis[0] / length, axis[1] / length, axis[2] / length};
        double c = StrictMath.cos(Math.toRadians(BodyCut.TURN_DEG));
        double s = StrictMath.sin(Math.toRadians(BodyCut.TURN_DEG));
        double[][] r = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                r[i][j] = (1 - c) * u[i] * u[j] + (i == j ? c : 0);
            }
            r[i][(i + 1) % 3] -= s * u[(i + 2) % 3];
            r[i][(i + 2) % 3] += s * u[(i + 1) % 3];
        }
        return r;
    }
}
