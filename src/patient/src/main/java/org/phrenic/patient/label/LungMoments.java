package org.phrenic.patient.label;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.MeshVoxelizer;

/**
 * Shape of both lungs: their extents along the axes, and their central moments of third order. Lungs taper to the top,
 * are wide below and thick at the back, so that these tell which way up and round they are.
 *
 * <pre>
 * s_i = sqrt(E[x_i x_i]) (mm),   T_ijk = E[x_i x_j x_k] / (s_i s_j s_k)
 * </pre>
 */
public final class LungMoments {
    private static final double VOXEL_MM = 4;

    /** Standard deviation of each coordinate, mm. */
    private final double[] spread = new double[3];
    /** Third moments with indices in ascending order. */
    private final double[][][] third = new double[3][3][3];

    /** @param box of the voxels of lungs, as {@link LabelGrid#box} */
    private LungMoments(LabelGrid grid, int[] box, IntPredicate isLung) {
        double[] mean = new double[3];
        long[] count = new long[1];
        each(grid, box, isLung, p -> {
            count[0]++;
            for (int i = 0; i < 3; i++) {
                mean[i] += p[i];
            }
        });
        for (int i = 0; i < 3; i++) {
            mean[i] /= count[0];
        }
        each(grid, box, isLung, p -> {
            for (int i = 0; i < 3; i++) {
                p[i] -= mean[i];
            }
            for (int i = 0; i < 3; i++) {
                spread[i] += p[i] * p[i];
                for (int j = i; j < 3; j++) {
                    for (int k = j; k < 3; k++) {
                        third[i][j][k] += p[i] * p[j] * p[k];
                    }
                }
            }
        });
        for (int i = 0; i < 3; i++) {
            spread[i] = Math.sqrt(spread[i] / count[0]);
        }
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                for (int k = j; k < 3; k++) {
                    third[i][j][k] /= count[0] * spread[i] * spread[j] * spread[k];
                }
            }
        }
    }

    /** Receives the place of a voxel, mm; it may be changed. */
    private interface Visitor {
        void visit(double[] place);
    }

    private static void each(LabelGrid grid, int[] box, IntPredicate isLung, Visitor visitor) {
        double[] p = new double[3];
        for (int k = box[2]; k <= box[5]; k++) {
            for (int j = box[1]; j <= box[4]; j++) {
                for (int i = box[0]; i <= box[3]; i++) {
                    if (isLung.test(grid.label(i, j, k))) {
                        grid.voxelToMm(i, j, k, p);
                        visitor.visit(p);
                    }
                }
            }
        }
    }

    /**
     * Moments of the voxels with certain labels.
     *
     * @throws IllegalArgumentException if there are none
     */
    static LungMoments of(LabelGrid grid, IntPredicate isLung) {
        int[] box = grid.box(isLung);
        if (box[5] < 0) {
            throw new IllegalArgumentException("no voxel of a lung");
        }
        return new LungMoments(grid, box, isLung);
    }

    /** Moments of the lungs of a thorax in LPS, in voxels of 4 mm; of a thorax without closed lungs none are known. */
    public static Optional<LungMoments> of(Thorax thorax) {
        List<TriangleMesh> lungs = thorax.structures().stream()
                .filter(s -> s.kind() == StructureKind.LUNG && MeshMeasure.hasInside(s.mesh()))
                .map(s -> s.mesh())
                .toList();
        if (lungs.isEmpty()) {
            return Optional.empty();
        }
        double[] box = BoundingBoxes.of(lungs.stream());
        int[] size = new int[3];
        for (int axis = 0; axis < 3; axis++) {
            size[axis] = (int) Math.ceil((box[3 + axis] - box[axis]) / VOXEL_MM) + 1;
        }
        byte[] labels = new byte[size[0] * size[1] * size[2]];
        double f = 1 / VOXEL_MM;
        MeshVoxelizer voxels = new MeshVoxelizer(
                size[0],
                size[1],
                size[2],
                new double[] {f, 0, 0, -f * box[0], 0, f, 0, -f * box[1], 0, 0, f, -f * box[2]},
                labels);
        lungs.forEach(lung -> voxels.fill(lung, 1));
        LabelGrid grid = LabelGrid.of(size[0], size[1], size[2], labels, new double[] {
            VOXEL_MM, 0, 0, box[0], 0, VOXEL_MM, 0, box[1], 0, 0, VOXEL_MM, box[2]
        });
        return Optional.of(of(grid, label -> label == 1));
    }

    /**
     * Difference of other lungs, taken in these axes, from these: root of the sum of squared differences of the third
     * moments, and of the logarithms of the extents, each less their mean.
     */
    double distance(LungMoments other, BodyAxes axes) {
        double[] larger = new double[3];
        for (int i = 0; i < 3; i++) {
            larger[i] = StrictMath.log(other.spread[axes.from(i)] / spread[i]);
        }
        double mean = (larger[0] + larger[1] + larger[2]) / 3;
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += (larger[i] - mean) * (larger[i] - mean);
            for (int j = i; j < 3; j++) {
                for (int k = j; k < 3; k++) {
                    int[] from = {axes.from(i), axes.from(j), axes.from(k)};
                    Arrays.sort(from);
                    int sign = axes.sign(i) * axes.sign(j) * axes.sign(k);
                    double d = third[i][j][k] - sign * other.third[from[0]][from[1]][from[2]];
                    sum += d * d;
                }
            }
        }
        return Math.sqrt(sum);
    }
}
