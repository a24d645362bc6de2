package org.phrenic.patient.segmentation;

import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/** Replaces the axes or spacing of a file by values given by the user. The centre of the volume keeps its position. */
public final class GeometryOverride {
    private static final String SIDES = "LRPASI";
    private static final double MAX_SPACING_MM = 50;

    private GeometryOverride() {}

    /**
     * Returns the volume with other axes.
     *
     * @param letters sides of the body toward which columns, rows and slices run, such as {@code LPS}: one letter each
     *     of L or R, P or A, S or I
     * @throws BadInputException if the letters are invalid
     */
    public static LabelVolume axes(LabelVolume volume, String letters) {
        String axes = letters.toUpperCase(Locale.ROOT);
        double[] toMm = new double[12];
        boolean[] taken = new boolean[3];
        for (int direction = 0; direction < 3; direction++) {
            int side = axes.length() == 3 ? SIDES.indexOf(axes.charAt(direction)) : -1;
            if (side < 0 || taken[side / 2]) {
                throw new BadInputException("--axes: found '" + letters
                        + "', expected three letters, one each of L or R, P or A, S or I, such as LPS or RAS");
            }
            taken[side / 2] = true;
            toMm[4 * (side / 2) + direction] =
                    (side % 2 == 0 ? 1 : -1) * volume.grid().spacing(direction);
        }
        return centred(volume, toMm);
    }

    /**
     * Returns the volume with another voxel size.
     *
     * @param text voxel size along columns, rows and slices, mm, such as {@code 1.75,1.75,1.25}
     * @throws BadInputException if the text is invalid
     */
    public static LabelVolume spacing(LabelVolume volume, String text) {
        LabelGrid grid = volume.grid();
        String[] parts = text.split(",", -1);
        double[] centre = place(grid, -1);
        double[] toMm = new double[12];
        for (int direction = 0; direction < 3; direction++) {
            double spacing = parts.length == 3 ? number(parts[direction]) : Double.NaN;
            if (!(spacing > 0 && spacing <= MAX_SPACING_MM)) {
                throw new BadInputException("--spacing: found '" + text
                        + "', expected the size of a voxel along columns, rows and slices in mm, above 0 to 50,"
                        + " such as 1.75,1.75,1.25");
            }
            double[] next = place(grid, direction);
            for (int row = 0; row < 3; row++) {
                toMm[4 * row + direction] = (next[row] - centre[row]) * spacing / grid.spacing(direction);
            }
        }
        return centred(volume, toMm);
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text.trim());
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    private static double[] half(LabelGrid grid) {
        return new double[] {(grid.columns() - 1) / 2.0, (grid.rows() - 1) / 2.0, (grid.slices() - 1) / 2.0};
    }

    /** Centre of the grid, or the position one voxel further along a direction, mm. */
    private static double[] place(LabelGrid grid, int direction) {
        double[] at = half(grid);
        if (direction >= 0) {
            at[direction] += 1;
        }
        double[] place = new double[3];
        grid.voxelToMm(at[0], at[1], at[2], place);
        return place;
    }

    private static LabelVolume centred(LabelVolume volume, double[] toMm) {
        double[] half = half(volume.grid());
        double[] centre = place(volume.grid(), -1);
        for (int row = 0; row < 3; row++) {
            toMm[4 * row + 3] = centre[row];
            for (int direction = 0; direction < 3; direction++) {
                toMm[4 * row + 3] -= toMm[4 * row + direction] * half[direction];
            }
        }
        return new LabelVolume(volume.grid().withAffine(toMm), volume.names(), volume.notes());
    }
}
