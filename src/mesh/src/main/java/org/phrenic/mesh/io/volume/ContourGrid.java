package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.dicom.FramePlane;
import org.phrenic.mesh.io.raster.EvenLines;

/**
 * A grid through the planes of contours, for contours whose series is not at hand: the pixels of the masks of which
 * nearly all contours are outlines, along edges of pixels or through their centres, else voxels of 1 mm.
 */
final class ContourGrid {
    /** Widest box of contours, mm. */
    private static final double MAX_EXTENT = 5000;

    /** Greatest distance of a contour's points from its plane, mm. */
    private static final double OFF_PLANE = 0.1;
    /** Contours whose normals are held against all contours. */
    private static final int CANDIDATES = 8;

    /** Least distance of slices that contours unevenly apart have in common, mm. */
    private static final double MIN_STEP = 0.5;
    /** Greatest distance of a plane from its slice, in steps. */
    private static final double OFF_STEP = 0.1;

    /** Numbers of the points of a contour that has an area, at least. */
    static final int AREA = 9;

    private static final double VOXEL = 1;
    private static final int MAX_VOXELS = 500;

    private final String file;
    private final List<double[]> contours;
    private final double[] normal;
    private final double[] along;
    private final double[] down;
    private final double[] spacing = {VOXEL, VOXEL};
    private boolean isThroughCentres;

    ContourGrid(String file, Collection<List<double[]>> contours) {
        this.file = file;
        List<double[]> all = contours.stream().flatMap(List::stream).toList();
        normal = commonNormal(
                all.stream().filter(points -> points.length >= AREA).toList());
        this.contours = all.stream().filter(points -> isPlanar(points, normal)).toList();
        // Columns run as nearly to the left of the patient as the plane allows, or to the back where that is no way.
        double[] wanted = Math.abs(normal[0]) < 0.9 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
        double part = dot(wanted, normal, 0);
        along = unit(
                new double[] {wanted[0] - part * normal[0], wanted[1] - part * normal[1], wanted[2] - part * normal[2]
                });
        down = cross(normal, along);
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** Scalar product of a direction and the point at {@code at}. */
    private static double dot(double[] direction, double[] points, int at) {
        return direction[0] * points[at] + direction[1] * points[at + 1] + direction[2] * points[at + 2];
    }

    private static double[] unit(double[] v) {
        double length = Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    /** The normal of most contours, as far as a sample of them tells. */
    private static double[] commonNormal(List<double[]> all) {
        double[] best = {Double.NaN, Double.NaN, Double.NaN};
        long most = 0;
        int step = Math.max(1, all.size() / CANDIDATES);
        for (int c = 0; c < all.size() && most <= all.size() / 2; c += step) {
            double[] candidate = normal(all.get(c));
            long planar =
                    all.stream().filter(points -> isPlanar(points, candidate)).count();
            if (planar > most) {
                most = planar;
                best = candidate;
            }
        }
        return best;
    }

    /** Whether the points of a contour lie in a plane of this normal. */
    private static boolean isPlanar(double[] points, double[] normal) {
        double height = dot(normal, points, 0);
        for (int at = 3; at < points.length; at += 3) {
            if (!(Math.abs(dot(normal, points, at) - height) <= OFF_PLANE)) {
                return false;
            }
        }
        return true;
    }

    /** The normal by Newell's sums, upwards or to the back or to the left; NaN of a contour without area. */
    private static double[] normal(double[] p) {
        double[] sum = new double[3];
        for (int a = 0; a < p.length; a += 3) {
            int b = (a + 3) % p.length;
            for (int row = 0; row < 3; row++) {
                int u = (row + 1) % 3;
                int v = (row + 2) % 3;
                sum[row] += (p[a + u] - p[b + u]) * (p[a + v] + p[b + v]);
            }
        }
        double[] n = unit(sum);
        int largest = Math.abs(n[2]) > 0.5 ? 2 : Math.abs(n[1]) > 0.5 ? 1 : 0;
        double sign = n[largest] < 0 ? -1 : 1;
        return new double[] {sign * n[0], sign * n[1], sign * n[2]};
    }

    /** The number of contours of an area that lie in planes of one normal. */
    long contours() {
        return contours.stream().filter(points -> points.length >= AREA).count();
    }

    SliceGrid grid() {
        if (contours.isEmpty()) {
            throw new BadInputException(file + ": found contours without area, expected closed planar ones");
        }
        double[] u = range(along);
        double[] v = range(down);
        Optional<EvenLines> columns = lines(along);
        Optional<EvenLines> rows = lines(down);
        Optional<Boolean> throughCentres = columns.flatMap(x -> rows.flatMap(y -> throughCentres(x, y)));
        if (throughCentres.isPresent()) {
            spacing[0] = columns.get().distance();
            spacing[1] = rows.get().distance();
        } else {
            Arrays.fill(spacing, Math.max(VOXEL, Math.max(u[1] - u[0], v[1] - v[0]) / MAX_VOXELS));
        }
        isThroughCentres = throughCentres.orElse(false);
        // Contours along edges of pixels, or at whole millimetres, run between the centres of voxels.
        double before = isThroughCentres ? 1 : 0.5;
        double left = first(u[0], 0, throughCentres.flatMap(any -> columns)) - before * spacing[0];
        double top = first(v[0], 1, throughCentres.flatMap(any -> rows)) - before * spacing[1];
        double between = commonStep();
        List<FramePlane> planes = new ArrayList<>();
        for (double[] points : contours) {
            double height = dot(normal, points, 0);
            double[] corner = new double[3];
            for (int row = 0; row < 3; row++) {
                corner[row] = left * along[row] + top * down[row] + height * normal[row];
            }
            planes.add(new FramePlane(corner, along, down, spacing[0], spacing[1], between, Double.NaN));
        }
        PlaneStack stack = new PlaneStack(file, planes, true);
        int width = (int) Math.ceil((u[1] - left) / spacing[0]) + 2;
        int height = (int) Math.ceil((v[1] - top) / spacing[1]) + 2;
        return new SliceGrid(width, height, stack.slices(), stack.axes());
    }

    /** The last line that is not above the least coordinate, or the whole number of voxels below it. */
    private double first(double least, int direction, Optional<EvenLines> lines) {
        double from = lines.map(EvenLines::low).orElse(0.0);
        double voxels = (least - from) / spacing[direction];
        return from + spacing[direction] * Math.floor(voxels + EvenLines.ROUNDING);
    }

    /** The even lines on which the corners of nearly all contours lie. */
    private Optional<EvenLines> lines(double[] direction) {
        return EvenLines.ofMost(contours.stream()
                .map(points -> IntStream.range(0, points.length / 3)
                        .mapToDouble(p -> dot(direction, points, 3 * p))
                        .sorted()
                        .toArray())
                .toList());
    }

    /**
     * Whether contours run through the centres of pixels rather than along their edges; empty if more than a few are no
     * outlines of masks, as what is drawn by hand.
     */
    private Optional<Boolean> throughCentres(EvenLines columns, EvenLines rows) {
        Map<MaskOutline, Long> kinds = contours.stream()
                .map(points -> IntStream.range(0, points.length / 3 * 2)
                        .mapToDouble(i -> i % 2 == 0
                                ? columns.index(dot(along, points, i / 2 * 3))
                                : rows.index(dot(down, points, i / 2 * 3)))
                        .toArray())
                .collect(Collectors.groupingBy(MaskOutline::of, Collectors.counting()));
        double few = EvenLines.MAX_DRAWN * contours.size();
        return kinds.getOrDefault(MaskOutline.DRAWN, 0L) > few
                ? Optional.empty()
                : Optional.of(kinds.getOrDefault(MaskOutline.THROUGH_CENTRES, 0L) > few);
    }

    /**
     * The distance of slices of which all gaps between planes are multiples, where these are no multiples of the
     * smallest one, as with contours 3 mm apart in a target and 5 mm elsewhere; NaN where they are, or if there is
     * none.
     */
    private double commonStep() {
        double[] heights = contours.stream()
                .mapToDouble(points -> dot(normal, points, 0))
                .sorted()
                .toArray();
        double[] gaps = IntStream.range(1, heights.length)
                .mapToDouble(i -> heights[i] - heights[i - 1])
                .filter(gap -> gap > OFF_PLANE)
                .toArray();
        double smallest = Arrays.stream(gaps).min().orElse(0);
        for (int parts = 1; smallest / parts >= MIN_STEP; parts++) {
            double step = smallest / parts;
            if (Arrays.stream(gaps).allMatch(gap -> Math.abs(gap / step - Math.rint(gap / step)) <= OFF_STEP)) {
                return parts == 1 ? Double.NaN : step;
            }
        }
        return Double.NaN;
    }

    /** Whether the grid is that of masks, of which contours run through the centres of pixels. */
    boolean isThroughCentres() {
        return isThroughCentres;
    }

    private double[] range(double[] direction) {
        double[] range = {Double.MAX_VALUE, -Double.MAX_VALUE};
        for (double[] points : contours) {
            for (int at = 0; at < points.length; at += 3) {
                double along = dot(direction, points, at);
                range[0] = Math.min(range[0], along);
                range[1] = Math.max(range[1], along);
            }
        }
        if (!(range[1] - range[0] < MAX_EXTENT) || Math.abs(range[0]) > 1e6) {
            throw new BadInputException(
                    file + ": found contours over more than " + MAX_EXTENT + " mm, expected those of a person");
        }
        return range;
    }

    /**
     * What was assumed, one sentence.
     *
     * @param problem why slices beside the contours are of no use
     */
    String note(Optional<String> problem) {
        return "the series of the contours "
                + (problem.isEmpty() ? "is not in their folder or one in it" : "is of no use")
                + Numbers.format(": they were filled in voxels of %.2g mm in their own planes", spacing[0])
                + problem.map(why -> " (" + why + ")").orElse("");
    }
}
