package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.dicom.FramePlane;
import org.phrenic.mesh.io.raster.VolumeAxes;

/** Parallel planes of frames as the slices of one grid, in the order of their positions along the normal. */
final class PlaneStack {
    /** Planes nearer than this are one, mm; files round positions to a thousandth or finer. */
    private static final double SAME_PLANE = 0.005;
    /** Greatest distance of a plane from its slice, in steps; of a corner from its place, in the smallest spacing. */
    private static final double OFF = 0.1;
    /** Slices of the grid for each plane there is, where slices may be left out. */
    private static final int MAX_GAP = 64;

    private static final double MAX_TURN = 1e-3;

    private final String file;
    private final FramePlane first;
    private final double[] offsets;
    private final double[] distinct;
    private final double step;
    private final int slices;
    private final double[][] positions;
    private final List<String> notes = new ArrayList<>();

    /**
     * @param mayHaveGaps whether slices may be without a plane, as in segmentations that leave out empty ones
     * @throws BadInputException if planes are not parallel, of other spacing, unevenly apart or shifted sideways
     */
    PlaneStack(String file, List<FramePlane> planes, boolean mayHaveGaps) {
        this.file = file;
        first = planes.get(0);
        positions = planes.stream().map(FramePlane::position).toArray(double[][]::new);
        offsets = new double[planes.size()];
        double[] normal = first.normal();
        for (int f = 0; f < offsets.length; f++) {
            checkParallel(planes.get(f));
            offsets[f] = dot(positions[f], normal);
        }
        distinct = distinct();
        step = step(mayHaveGaps);
        slices = (int) Math.round(range() / step) + 1;
        for (int f = 0; f < offsets.length; f++) {
            checkPlace(f);
        }
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private void checkParallel(FramePlane plane) {
        double turn = 0;
        for (int row = 0; row < 3; row++) {
            turn = Math.max(turn, Math.abs(plane.along()[row] - first.along()[row]));
            turn = Math.max(turn, Math.abs(plane.down()[row] - first.down()[row]));
        }
        boolean same = Math.abs(plane.columnSpacing() - first.columnSpacing()) < MAX_TURN * first.columnSpacing()
                && Math.abs(plane.rowSpacing() - first.rowSpacing()) < MAX_TURN * first.rowSpacing();
        if (turn > MAX_TURN || !same) {
            throw new BadInputException(file + ": found slices of several orientations or pixel spacings, expected"
                    + " those of one series");
        }
    }

    private double[] distinct() {
        double[] sorted = offsets.clone();
        Arrays.sort(sorted);
        int count = 0;
        for (double offset : sorted) {
            if (count == 0 || offset - sorted[count - 1] > SAME_PLANE) {
                sorted[count++] = offset;
            }
        }
        return Arrays.copyOf(sorted, count);
    }

    private double range() {
        return distinct[distinct.length - 1] - distinct[0];
    }

    private double step(boolean mayHaveGaps) {
        if (distinct.length == 1) {
            if (first.between() > 0) {
                return first.between();
            }
            notes.add("one slice without a stated thickness: it was taken to be 1 mm thick");
            return 1;
        }
        if (!mayHaveGaps) {
            return range() / (distinct.length - 1);
        }
        double smallest = Double.MAX_VALUE;
        for (int d = 1; d < distinct.length; d++) {
            smallest = Math.min(smallest, distinct[d] - distinct[d - 1]);
        }
        double stated = first.between();
        double nearly = stated > 0 && stated < (1 + OFF) * smallest && stated > SAME_PLANE ? stated : smallest;
        double steps = Math.rint(range() / nearly);
        if (steps > (double) MAX_GAP * distinct.length) {
            throw new BadInputException(file + ": found " + distinct.length + " planes over " + (long) steps
                    + " slices, expected no more than " + MAX_GAP + " slices a plane");
        }
        return range() / steps;
    }

    private void checkPlace(int f) {
        int last = indexOf(distinct[distinct.length - 1]);
        int lowest = indexOf(distinct[0]);
        double along = (offsets[f] - distinct[0]) / step;
        if (Math.abs(along - Math.rint(along)) > OFF) {
            throw uneven();
        }
        double share = distinct.length > 1 ? (offsets[f] - distinct[0]) / range() : 0;
        double tolerance = OFF * Math.min(step, Math.min(first.columnSpacing(), first.rowSpacing()));
        for (int row = 0; row < 3; row++) {
            double expected = positions[lowest][row] + share * (positions[last][row] - positions[lowest][row]);
            if (!(Math.abs(positions[f][row] - expected) <= tolerance)) {
                throw new BadInputException(file + ": found slices that are shifted sideways, expected one stack");
            }
        }
    }

    /** An exception that names the gap that differs most from most gaps. */
    private BadInputException uneven() {
        double[] gaps = new double[distinct.length - 1];
        Arrays.setAll(gaps, d -> distinct[d + 1] - distinct[d]);
        double[] sorted = gaps.clone();
        Arrays.sort(sorted);
        double usual = sorted[sorted.length / 2];
        int odd = 0;
        for (int d = 1; d < gaps.length; d++) {
            odd = Math.abs(gaps[d] - usual) > Math.abs(gaps[odd] - usual) ? d : odd;
        }
        return new BadInputException(String.format(
                Locale.ROOT,
                "%s: found slices that are unevenly apart or missing (%.3f mm between those at %.2f and %.2f mm along"
                        + " their normal), expected one every %.3f mm",
                file,
                gaps[odd],
                distinct[odd],
                distinct[odd + 1],
                usual));
    }

    private int indexOf(double offset) {
        int f = 0;
        while (Math.abs(offsets[f] - offset) > SAME_PLANE) {
            f++;
        }
        return f;
    }

    /** Number of slices of the grid. */
    int slices() {
        return slices;
    }

    /** Number of planes at different places. */
    int planes() {
        return distinct.length;
    }

    /** The slice of a frame. */
    int slice(int frame) {
        return (int) Math.rint((offsets[frame] - distinct[0]) / step);
    }

    /** Columns along rows of the frames, rows down their columns, slices along their normal. */
    VolumeAxes axes() {
        double[] normal = first.normal();
        double[] origin = positions[indexOf(distinct[0])];
        double[] end = positions[indexOf(distinct[distinct.length - 1])];
        double[][] steps = new double[3][3];
        for (int row = 0; row < 3; row++) {
            steps[0][row] = first.columnSpacing() * first.along()[row];
            steps[1][row] = first.rowSpacing() * first.down()[row];
            steps[2][row] = slices > 1 ? (end[row] - origin[row]) / (slices - 1) : step * normal[row];
        }
        return new VolumeAxes(steps, origin.clone());
    }

    /** Assumptions about missing information, one sentence each. */
    List<String> notes() {
        return notes;
    }
}
