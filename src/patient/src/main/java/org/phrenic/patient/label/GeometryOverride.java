package org.phrenic.patient.label;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Axes or spacing that take the place of those that a file states. The centre of the volume keeps its position.
 *
 * @param axes sides of the body toward which columns, rows and slices run, such as {@code LPS}; empty for the file's
 * @param spacing voxel size along columns, rows and slices, mm, such as {@code 1.75,1.75,1.25}; empty for the file's
 */
public record GeometryOverride(Optional<String> axes, Optional<String> spacing) {
    /** What the file states. */
    public static final GeometryOverride NONE = new GeometryOverride(Optional.empty(), Optional.empty());

    private static final double MIN_SPACING_MM = 0.1;
    private static final double MAX_SPACING_MM = 50;
    private static final Pattern AXES = Pattern.compile("(?i)(?=.*[LR])(?=.*[PA])(?=.*[SI])[LRPASI]{3}");

    /**
     * Returns the volume with these axes and this spacing.
     *
     * @throws BadInputException if a value is invalid, or the voxels are of no size that scans of people have
     */
    public LabelVolume apply(LabelVolume volume, String file) {
        LabelVolume turned = axes.map(letters -> axes(volume, letters)).orElse(volume);
        LabelVolume sized = spacing.map(text -> spacing(turned, text)).orElse(turned);
        LabelGrid grid = sized.grid();
        for (int direction = 0; direction < 3; direction++) {
            if (grid.spacing(direction) < MIN_SPACING_MM || grid.spacing(direction) > MAX_SPACING_MM) {
                throw new BadInputException(Numbers.format(
                        "%s: found voxels of %.3g x %.3g x %.3g mm, expected %.1f to %.0f mm; see --spacing",
                        file, grid.spacing(0), grid.spacing(1), grid.spacing(2), MIN_SPACING_MM, MAX_SPACING_MM));
            }
        }
        return sized;
    }

    /**
     * Returns the volume with other axes. Directions oblique to the axes of the body stay so.
     *
     * @param letters sides of the body toward which columns, rows and slices run, such as {@code LPS}: one letter each
     *     of L or R, P or A, S or I
     * @throws BadInputException if the letters are invalid
     */
    public static LabelVolume axes(LabelVolume volume, String letters) {
        BodyAxes turned = BodyAxes.of(volume.grid(), letters.strip().toUpperCase(Locale.ROOT))
                .orElseThrow(() -> badAxes(letters));
        double[] stated = volume.grid().toMm();
        double[] toMm = new double[12];
        for (int row = 0; row < 3; row++) {
            for (int direction = 0; direction < 3; direction++) {
                toMm[4 * row + direction] = turned.sign(row) * stated[4 * turned.from(row) + direction];
            }
        }
        return centred(volume, toMm);
    }

    /**
     * Requires a text that states axes.
     *
     * @throws BadInputException with one sentence, if it does not
     */
    public static void requireAxes(String letters) {
        if (!areAxes(letters)) {
            throw badAxes(letters);
        }
    }

    private static BadInputException badAxes(String letters) {
        return new BadInputException("--axes: found '" + letters
                + "', expected three letters, one each of L or R, P or A, S or I, such as LPS or RAS");
    }

    /** Whether a text states axes: one letter each of L or R, P or A, S or I, in any order and case. */
    public static boolean areAxes(String letters) {
        return AXES.matcher(letters.strip()).matches();
    }

    /** Whether a text states the size of a voxel along columns, rows and slices, mm. */
    public static boolean isSpacing(String text) {
        String[] parts = text.split(",", -1);
        return parts.length == 3 && Arrays.stream(parts).allMatch(part -> isSpacing(number(part)));
    }

    private static boolean isSpacing(double mm) {
        return mm >= MIN_SPACING_MM && mm <= MAX_SPACING_MM;
    }

    /**
     * Returns the volume with another voxel size.
     *
     * @param text voxel size along columns, rows and slices, mm, such as {@code 1.75,1.75,1.25}
     * @throws BadInputException if the text is invalid
     */
    public static LabelVolume spacing(LabelVolume volume, String text) {
        if (!isSpacing(text)) {
            throw new BadInputException("--spacing: found '" + text
                    + "', expected the size of a voxel along columns, rows and slices in mm, 0.1 to 50,"
                    + " such as 1.75,1.75,1.25");
        }
        LabelGrid grid = volume.grid();
        String[] parts = text.split(",", -1);
        double[] centre = place(grid, -1);
        double[] toMm = new double[12];
        for (int direction = 0; direction < 3; direction++) {
            double spacing = number(parts[direction]);
            double[] next = place(grid, direction);
            for (int row = 0; row < 3; row++) {
                toMm[4 * row + direction] = (next[row] - centre[row]) * spacing / grid.spacing(direction);
            }
        }
        return centred(volume, toMm);
    }

    private static double number(String text) {
        return Numbers.parse(text.strip()).orElse(Double.NaN);
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
        return volume.withGrid(volume.grid().withAffine(toMm));
    }
}
