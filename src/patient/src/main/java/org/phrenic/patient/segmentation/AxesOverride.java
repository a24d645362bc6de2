package org.phrenic.patient.segmentation;

import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Axes that a user states because the file's own are wrong or missing: the sides of the body to which columns, rows and
 * slices run.
 */
public final class AxesOverride {
    private static final String SIDES = "LRPASI";

    private AxesOverride() {}

    /**
     * The same volume about the same middle, along other axes.
     *
     * @param letters three, one each of L or R, P or A, S or I, such as {@code LPS}
     * @throws BadInputException if they are none
     */
    public static LabelVolume apply(LabelVolume volume, String letters) {
        String axes = letters.toUpperCase(Locale.ROOT);
        LabelGrid grid = volume.grid();
        double[] toMm = new double[12];
        boolean[] taken = new boolean[3];
        for (int direction = 0; direction < 3; direction++) {
            int side = axes.length() == 3 ? SIDES.indexOf(axes.charAt(direction)) : -1;
            if (side < 0 || taken[side / 2]) {
                throw new BadInputException("--axes: found '" + letters
                        + "', expected three letters, one each of L or R, P or A, S or I, such as LPS or RAS");
            }
            taken[side / 2] = true;
            toMm[4 * (side / 2) + direction] = (side % 2 == 0 ? 1 : -1) * grid.spacing(direction);
        }
        double[] half = {(grid.columns() - 1) / 2.0, (grid.rows() - 1) / 2.0, (grid.slices() - 1) / 2.0};
        double[] middle = new double[3];
        grid.voxelToMm(half[0], half[1], half[2], middle);
        for (int row = 0; row < 3; row++) {
            toMm[4 * row + 3] = middle[row];
            for (int direction = 0; direction < 3; direction++) {
                toMm[4 * row + 3] -= toMm[4 * row + direction] * half[direction];
            }
        }
        return new LabelVolume(grid.withAffine(toMm), volume.names(), volume.notes());
    }
}
