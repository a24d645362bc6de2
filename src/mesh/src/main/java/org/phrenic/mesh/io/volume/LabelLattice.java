package org.phrenic.mesh.io.volume;

import java.util.List;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * The grid that holds several volumes whose voxels are on one lattice. Volumes of the same extent keep their grid; of
 * others, as masks that are cropped to their structures, it is the smallest box about all.
 */
final class LabelLattice {
    /** Greatest distance of the voxels of two volumes, in voxels. */
    private static final double TOLERANCE = 0.1;

    private final LabelRuns first;
    private final boolean cropped;
    private final int[] from = new int[3];
    private final int[] size = new int[3];

    /** @throws BadInputException if a volume has voxels elsewhere than the first one */
    LabelLattice(List<LabelRuns> volumes) {
        first = volumes.get(0);
        int[] end = first.size().clone();
        boolean same = true;
        for (LabelRuns volume : volumes) {
            int[] offset = offset(volume);
            for (int axis = 0; axis < 3; axis++) {
                same &= offset[axis] == 0 && volume.size()[axis] == first.size()[axis];
                from[axis] = Math.min(from[axis], offset[axis]);
                end[axis] = Math.max(end[axis], offset[axis] + volume.size()[axis]);
            }
        }
        cropped = !same;
        for (int axis = 0; axis < 3; axis++) {
            size[axis] = end[axis] - from[axis];
        }
    }

    /** Columns, rows and slices of a volume's first voxel from that of the first volume. */
    private int[] offset(LabelRuns volume) {
        double[] a = first.toMm();
        double[] b = volume.toMm();
        int[] offset = new int[3];
        double farthest = 0;
        for (int axis = 0; axis < 3; axis++) {
            double along = 0;
            double square = 0;
            double turn = 0;
            for (int row = 0; row < 3; row++) {
                double step = a[4 * row + axis];
                along += step * (b[4 * row + 3] - a[4 * row + 3]);
                square += step * step;
                turn = Math.max(turn, Math.abs(b[4 * row + axis] - step));
            }
            double voxels = along / square;
            offset[axis] = (int) Math.rint(voxels);
            farthest = Math.max(farthest, Math.abs(voxels - offset[axis]));
            farthest = Math.max(farthest, turn / Math.sqrt(square) * Math.max(volume.size()[axis], first.size()[axis]));
        }
        if (!(farthest <= TOLERANCE)) {
            throw new BadInputException(volume.file() + ": found other voxels than those of "
                    + first.file().getFileName() + ", expected masks of one scan on one grid");
        }
        return offset;
    }

    /** Whether volumes have different extents. */
    boolean isCropped() {
        return cropped;
    }

    /** A painter of this grid. */
    LabelPainter painter(String source) {
        return new LabelPainter(source, size[0], size[1], size[2]);
    }

    /** The voxels of a structure of a volume in this grid. */
    LabelPainter.Voxels voxels(LabelRuns volume, LabelRuns.Runs structure) {
        if (!cropped) {
            return structure;
        }
        int[] shift = offset(volume);
        for (int axis = 0; axis < 3; axis++) {
            shift[axis] -= from[axis];
        }
        int columns = volume.size()[0];
        int rows = volume.size()[1];
        return use -> structure.forEach(voxel -> {
            int column = voxel % columns + shift[0];
            int row = voxel / columns % rows + shift[1];
            int slice = voxel / columns / rows + shift[2];
            use.accept(column + size[0] * (row + size[1] * slice));
        });
    }

    /** The affine matrix of this grid, see {@link LabelGrid}. */
    double[] toMm() {
        return VoxelBox.beginningAt(first.toMm(), from[0], from[1], from[2]);
    }
}
