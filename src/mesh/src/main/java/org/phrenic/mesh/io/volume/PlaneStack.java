package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.Vectors;
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

    /** Greatest share by which a spacing that is rounded to a digit or two differs from that of positions. */
    private static final double ROUNDED = 0.01;
    /** Planes whose distances say how far slices are apart, whatever is stated; fewer may be even by chance. */
    private static final int MIN_EVEN = 4;

    private static final double MAX_TURN = 1e-3;

    private final String file;
    private final FramePlane first;
    private final double[] offsets;
    private final double[] distinct;
    private final double step;
    private final int slices;
    private final double[][] positions;
    private final double[] lowest;
    private final double[] highest;
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
            offsets[f] = Vectors.dot(positions[f], normal);
        }
        distinct = distinct();
        step = step(mayHaveGaps);
        slices = (int) Math.round(range() / step) + 1;
        lowest = positions[indexOf(distinct[0])];
        highest = positions[indexOf(distinct[distinct.length - 1])];
        for (int f = 0; f < offsets.length; f++) {
            checkPlace(f);
        }
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
            return thickness();
        }
        if (!mayHaveGaps) {
            return range() / (distinct.length - 1);
        }
        double used = spacing();
        double steps = Math.rint(range() / used);
        if (steps > (double) MAX_GAP * distinct.length) {
            throw new BadInputException(file + ": found " + distinct.length + " planes over " + (long) steps
                    + " slices, expected no more than " + MAX_GAP + " slices a plane");
        }
        if (first.between() > 0 && Math.abs(used - first.between()) > ROUNDED * used) {
            notes.add(Numbers.format(
                    "slices are %.3f mm apart by their positions, and %.3f mm by what the file states: positions were"
                            + " taken",
                    used, first.between()));
        }
        return used;
    }

    /** The thickness of a single plane. */
    private double thickness() {
        if (first.between() > 0) {
            return first.between();
        }
        if (first.thickness() > 0) {
            return first.thickness();
        }
        notes.add("one slice without a stated thickness: it was taken to be 1 mm thick");
        return 1;
    }

    /**
     * The distance of slices, of which some may have no plane. It is the smallest gap between planes if there are
     * enough planes and all lie at multiples of it, for some programs state the gap between the faces of thick slices.
     * It is the stated distance where that is about the smallest gap, or a half of it, as in a segmentation of every
     * second slice, or where planes are few or lie otherwise.
     */
    private double spacing() {
        double[] gaps = gaps();
        Arrays.sort(gaps);
        double smallest = gaps[0];
        double byPlaces = refined(gaps, smallest);
        double stated = first.between();
        if (!(stated > SAME_PLANE && stated < (1 + OFF) * smallest)) {
            return byPlaces;
        }
        boolean isSame = stated > (1 - OFF) * smallest;
        boolean isHalf = Math.abs(2 * stated - smallest) <= OFF * smallest;
        if (!isSame && !isHalf && distinct.length >= MIN_EVEN && fits(byPlaces)) {
            return byPlaces;
        }
        double whole = range() / Math.rint(range() / stated);
        return fits(whole) ? whole : refined(gaps, stated);
    }

    private double[] gaps() {
        double[] gaps = new double[distinct.length - 1];
        Arrays.setAll(gaps, d -> distinct[d + 1] - distinct[d]);
        return gaps;
    }

    /**
     * The distance of slices from a rounded one, by numbers of slices in gaps from the smallest to the largest: each
     * makes it more exact for the next.
     */
    private double refined(double[] sortedGaps, double rounded) {
        double along = 0;
        double steps = 0;
        double refined = rounded;
        for (double gap : sortedGaps) {
            along += gap;
            steps += Math.max(1, Math.rint(gap / refined));
            refined = along / steps;
        }
        return range() / steps;
    }

    /** Whether all planes lie in slices of this distance. */
    private boolean fits(double spacing) {
        return Arrays.stream(distinct)
                .map(offset -> (offset - distinct[0]) / spacing)
                .allMatch(along -> Math.abs(along - Math.rint(along)) <= OFF);
    }

    private void checkPlace(int f) {
        double along = (offsets[f] - distinct[0]) / step;
        if (Math.abs(along - Math.rint(along)) > OFF) {
            throw uneven();
        }
        double share = distinct.length > 1 ? (offsets[f] - distinct[0]) / range() : 0;
        double tolerance = OFF * Math.min(step, Math.min(first.columnSpacing(), first.rowSpacing()));
        for (int row = 0; row < 3; row++) {
            double expected = lowest[row] + share * (highest[row] - lowest[row]);
            if (!(Math.abs(positions[f][row] - expected) <= tolerance)) {
                throw new BadInputException(file + ": found slices that are shifted sideways, expected one stack");
            }
        }
    }

    /** An exception that names the gap that differs most from most gaps. */
    private BadInputException uneven() {
        double[] gaps = gaps();
        double[] sorted = gaps.clone();
        Arrays.sort(sorted);
        double usual = sorted[sorted.length / 2];
        int odd = 0;
        for (int d = 1; d < gaps.length; d++) {
            odd = Math.abs(gaps[d] - usual) > Math.abs(gaps[odd] - usual) ? d : odd;
        }
        return new BadInputException(Numbers.format(
                "%s: found slices that are unevenly apart or missing (%.3f mm between those at %.2f and %.2f mm along"
                        + " their normal), expected one every %.3f mm",
                file, gaps[odd], distinct[odd], distinct[odd + 1], usual));
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
        double[][] steps = new double[3][3];
        for (int row = 0; row < 3; row++) {
            steps[0][row] = first.columnSpacing() * first.along()[row];
            steps[1][row] = first.rowSpacing() * first.down()[row];
            steps[2][row] = slices > 1 ? (highest[row] - lowest[row]) / (slices - 1) : step * normal[row];
        }
        return new VolumeAxes(steps, lowest.clone());
    }

    /** Assumptions about missing information, one sentence each. */
    List<String> notes() {
        return notes;
    }
}
