package org.phrenic.patient.segmentation;

import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/** Size of the voxels that a user states because the file's own is wrong. */
public final class SpacingOverride {
    private static final double LARGEST_MM = 50;

    private SpacingOverride() {}

    /**
     * The same volume about the same middle with voxels of another size.
     *
     * @param text three sizes along columns, rows and slices in mm, such as {@code 1.75,1.75,1.25}
     * @throws BadInputException if they are none
     */
    public static LabelVolume apply(LabelVolume volume, String text) {
        String[] parts = text.split(",", -1);
        double[] spacing = new double[3];
        for (int direction = 0; direction < 3; direction++) {
            try {
                spacing[direction] = parts.length == 3 ? Double.parseDouble(parts[direction].trim()) : Double.NaN;
            } catch (NumberFormatException e) {
                spacing[direction] = Double.NaN;
            }
            if (!(spacing[direction] > 0 && spacing[direction] <= LARGEST_MM)) {
                throw new BadInputException(
                        "--spacing: found '" + text
                                + "', expected the size of a voxel along columns, rows and slices in mm, above 0 to 50, such as 1.75,1.75,1.25");
            }
        }
        LabelGrid grid = volume.grid();
        double[] half = {(grid.columns() - 1) / 2.0, (grid.rows() - 1) / 2.0, (grid.slices() - 1) / 2.0};
        double[] middle = new double[3];
        double[] next = new double[3];
        grid.voxelToMm(half[0], half[1], half[2], middle);
        double[] toMm = new double[12];
        for (int direction = 0; direction < 3; direction++) {
            grid.voxelToMm(
                    half[0] + (direction == 0 ? 1 : 0),
                    half[1] + (direction == 1 ? 1 : 0),
                    half[2] + (direction == 2 ? 1 : 0),
                    next);
            for (int row = 0; row < 3; row++) {
                toMm[4 * row + direction] = (next[row] - middle[row]) * spacing[direction] / grid.spacing(direction);
            }
        }
        for (int row = 0; row < 3; row++) {
            toMm[4 * row + 3] = middle[row];
            for (int direction = 0; direction < 3; direction++) {
                toMm[4 * row + 3] -= toMm[4 * row + direction] * half[direction];
            }
        }
        return new LabelVolume(grid.withAffine(toMm), volume.names(), volume.notes());
    }
}
