package org.phrenic.patient.label;

import java.util.Set;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Where the labels of a volume lie: number of voxels, centre and variances of each label, and of some their heights in
 * sectors about the middle of all labels. Lengths are in mm, in the coordinates of the file.
 */
final class LabelPositions {
    /** Number of sectors about the body's axis. */
    static final int SECTORS = 36;

    private final int[] counts = new int[LabelGrid.MAX_LABEL + 1];
    private final double[][] centres = new double[LabelGrid.MAX_LABEL + 1][];
    private final double[][][] sectors = new double[LabelGrid.MAX_LABEL + 1][][];
    private final double[][] variances = new double[LabelGrid.MAX_LABEL + 1][];
    private final boolean[] atEnd = new boolean[LabelGrid.MAX_LABEL + 1];

    private final double voxelVolume;

    /** @param inSectors labels whose heights are measured */
    LabelPositions(LabelGrid grid, Set<Integer> inSectors) {
        voxelVolume = grid.voxelVolume();
        findCentres(grid);
        boolean[] wanted = new boolean[LabelGrid.MAX_LABEL + 1];
        inSectors.forEach(label -> wanted[label] = counts[label] > 0);
        findHeights(grid, wanted);
    }

    private void findCentres(LabelGrid grid) {
        double[][] sums = new double[LabelGrid.MAX_LABEL + 1][];
        double[][] squares = new double[LabelGrid.MAX_LABEL + 1][];
        int[] last = {grid.columns() - 1, grid.rows() - 1, grid.slices() - 1};
        int voxel = 0;
        for (int k = 0; k <= last[2]; k++) {
            for (int j = 0; j <= last[1]; j++) {
                boolean endRow = k == 0 || k == last[2] || j == 0 || j == last[1];
                for (int i = 0; i <= last[0]; i++) {
                    int label = grid.label(voxel++);
                    if (label == 0) {
                        continue;
                    }
                    if (sums[label] == null) {
                        sums[label] = new double[3];
                        squares[label] = new double[6];
                    }
                    squares[label][0] += (double) i * i;
                    squares[label][1] += (double) j * j;
                    squares[label][2] += (double) k * k;
                    squares[label][3] += (double) i * j;
                    squares[label][4] += (double) j * k;
                    squares[label][5] += (double) k * i;
                    sums[label][0] += i;
                    sums[label][1] += j;
                    sums[label][2] += k;
                    counts[label]++;
                    atEnd[label] |= endRow || i == 0 || i == last[0];
                }
            }
        }
        for (int label = 1; label < sums.length; label++) {
            if (counts[label] > 0) {
                double[] sum = sums[label];
                int count = counts[label];
                centres[label] = new double[3];
                grid.voxelToMm(sum[0] / count, sum[1] / count, sum[2] / count, centres[label]);
                variances[label] = variances(grid.toMm(), sum, squares[label], count);
            }
        }
    }

    /**
     * Variances of the coordinates in mm.
     *
     * @param squares sums of i i, j j, k k, i j, j k and k i
     */
    private static double[] variances(double[] toMm, double[] sums, double[] squares, int count) {
        double[] variances = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            for (int a = 0; a < 3; a++) {
                int b = (a + 1) % 3;
                double own = squares[a] / count - sums[a] / count * (sums[a] / count);
                double mixed = squares[3 + a] / count - sums[a] / count * (sums[b] / count);
                double m = toMm[4 * axis + a];
                variances[axis] += m * m * own + 2 * m * toMm[4 * axis + b] * mixed;
            }
            variances[axis] = Math.max(0, variances[axis]);
        }
        return variances;
    }

    private void findHeights(LabelGrid grid, boolean[] wanted) {
        double[] middle = middle();
        double[] p = new double[3];
        int voxel = 0;
        for (int k = 0; k < grid.slices(); k++) {
            for (int j = 0; j < grid.rows(); j++) {
                for (int i = 0; i < grid.columns(); i++) {
                    int label = grid.label(voxel++);
                    if (!wanted[label]) {
                        continue;
                    }
                    if (sectors[label] == null) {
                        sectors[label] = new double[SECTORS][2];
                    }
                    grid.voxelToMm(i, j, k, p);
                    double turn = StrictMath.atan2(p[1] - middle[1], p[0] - middle[0]) / (2 * Math.PI) + 0.5;
                    double[] sector = sectors[label][Math.min(SECTORS - 1, (int) (SECTORS * turn))];
                    sector[0] += p[2];
                    sector[1]++;
                }
            }
        }
    }

    /** Mean of the centres of all labels. */
    private double[] middle() {
        double[] middle = new double[3];
        int labels = 0;
        for (double[] centre : centres) {
            if (centre != null) {
                labels++;
                for (int axis = 0; axis < 3; axis++) {
                    middle[axis] += (centre[axis] - middle[axis]) / labels;
                }
            }
        }
        return middle;
    }

    /** Number of voxels of a label. */
    int count(int label) {
        return label <= LabelGrid.MAX_LABEL ? counts[label] : 0;
    }

    /** Volume of a voxel, mm3. */
    double voxelVolume() {
        return voxelVolume;
    }

    /** Centre of a label of which there are voxels. */
    double[] centre(int label) {
        return centres[label];
    }

    /** Variances of the coordinates of a label of which there are voxels, mm2. */
    double[] variance(int label) {
        return variances[label];
    }

    /** Sum of heights and number of voxels of a label in each sector, of those whose heights are measured. */
    double[][] sectors(int label) {
        return sectors[label];
    }

    /** Whether a label has voxels at an end of the volume, where the scan may cut it off. */
    boolean isAtEnd(int label) {
        return atEnd[label];
    }
}
