package org.phrenic.mesh.io.raster;

import java.util.Arrays;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;

/**
 * Position of the voxels of a volume, mm.
 *
 * @param steps vectors between neighbouring voxels along columns, rows and slices
 * @param origin centre of the first voxel
 */
public record VolumeAxes(double[][] steps, double[] origin) {
    /** Tolerance of a right angle: half a degree, because files round directions to six digits or fewer. */
    private static final double RIGHT_ANGLE = 0.0087;

    private static final String[] DIRECTIONS = {"columns", "rows", "slices"};

    /** Axes parallel to x, y and z with these spacings. */
    static VolumeAxes axisAligned(double dx, double dy, double dz) {
        return new VolumeAxes(new double[][] {{dx, 0, 0}, {0, dy, 0}, {0, 0, dz}}, new double[3]);
    }

    /** The same position with x and y negated, which converts between RAS and LPS. */
    VolumeAxes rasToLps() {
        return scaled(-1, -1, 1);
    }

    /** Scales each coordinate by its own factor. */
    VolumeAxes scaled(double fx, double fy, double fz) {
        double[] f = {fx, fy, fz};
        double[][] s = new double[3][3];
        double[] o = new double[3];
        for (int row = 0; row < 3; row++) {
            o[row] = f[row] * origin[row];
            for (int direction = 0; direction < 3; direction++) {
                s[direction][row] = f[row] * steps[direction][row];
            }
        }
        return new VolumeAxes(s, o);
    }

    /** Distance of neighbouring voxels along the direction in which they are nearest. */
    double smallestSpacing() {
        return Arrays.stream(steps).mapToDouble(Vectors::length).min().orElseThrow();
    }

    /** Whether all steps are 0, as where a file states none. */
    boolean areZero() {
        return Arrays.stream(steps).allMatch(step -> Vectors.length(step) == 0);
    }

    /** Greatest distance of the corners of a volume of these sizes from where {@code other} has them. */
    double farthest(VolumeAxes other, int[] sizes) {
        double farthest = 0;
        for (int corner = 0; corner < 8; corner++) {
            double square = 0;
            for (int row = 0; row < 3; row++) {
                double apart = origin[row] - other.origin[row];
                for (int direction = 0; direction < 3; direction++) {
                    int voxel = (corner >> direction & 1) * (sizes[direction] - 1);
                    apart += voxel * (steps[direction][row] - other.steps[direction][row]);
                }
                square += apart * apart;
            }
            farthest = Math.max(farthest, Math.sqrt(square));
        }
        return farthest;
    }

    /**
     * The affine matrix as twelve numbers, in the layout of {@code LabelGrid}.
     *
     * @param file name for error messages
     * @throws BadInputException if a number is not finite, a spacing is 0 or the axes are not orthogonal
     */
    public double[] affine(String file) {
        double[] length = new double[3];
        double[] affine = new double[12];
        for (int direction = 0; direction < 3; direction++) {
            double[] s = steps[direction];
            length[direction] = Math.sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
            if (!Double.isFinite(length[direction]) || !Double.isFinite(origin[direction])) {
                throw new BadInputException(
                        file + ": found a place of the voxels that is not finite, expected numbers");
            }
            if (!(length[direction] > 0)) {
                throw new BadInputException(file + ": found a spacing of 0 mm along " + DIRECTIONS[direction]
                        + ", expected voxels with a size");
            }
            for (int row = 0; row < 3; row++) {
                affine[4 * row + direction] = s[row];
                affine[4 * row + 3] = origin[row];
            }
        }
        for (int one = 0; one < 3; one++) {
            int other = (one + 1) % 3;
            double cosine = 0;
            for (int row = 0; row < 3; row++) {
                cosine += steps[one][row] * steps[other][row] / (length[one] * length[other]);
            }
            if (Math.abs(cosine) > RIGHT_ANGLE) {
                double angle = Math.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))));
                String found = ": found " + DIRECTIONS[one] + " and " + DIRECTIONS[other];
                throw new BadInputException(file + found + Numbers.format(" at an angle of %.1f deg", angle)
                        + ", expected right angles (resample the sheared volume first)");
            }
        }
        return affine;
    }
}
