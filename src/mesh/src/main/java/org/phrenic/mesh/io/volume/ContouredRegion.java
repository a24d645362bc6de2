package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntConsumer;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.Vectors;

/**
 * The voxels of a region that is drawn by closed contours in slices. Slices between contoured ones get the shape
 * between their neighbours' ({@link ShapeInterpolation}), where the gap is no wider than {@value #MAX_GAP_MM} mm nor
 * than twice the usual one of the region, and the neighbours overlap. Where all corners are centres of voxels, contours
 * are outlines of a mask, as OpenCV finds them: they run through its outermost pixels, which are in the region.
 */
final class ContouredRegion implements LabelPainter.Voxels {
    /** Widest gap between contours of one structure, mm. */
    private static final double MAX_GAP_MM = 15;
    /** Numbers of the corners of a contour that has an area, at least. */
    private static final int AREA = 6;

    private final SliceGrid grid;
    private final ContourFill fill;
    private final TreeMap<Integer, List<double[]>> bySlice;
    private final boolean isMask;
    private final double widest;
    private int slicesBetween;

    /** @param bySlice corners of the contours in columns and rows, by slice */
    ContouredRegion(SliceGrid grid, ContourFill fill, Map<Integer, List<double[]>> bySlice) {
        this.grid = grid;
        this.fill = fill;
        this.bySlice = new TreeMap<>(bySlice);
        isMask = bySlice.values().stream()
                .flatMap(List::stream)
                .flatMapToDouble(Arrays::stream)
                .allMatch(corner -> corner == Math.rint(corner));
        if (!isMask) {
            this.bySlice.replaceAll((slice, contours) ->
                    contours.stream().filter(corners -> corners.length >= AREA).toList());
            this.bySlice.values().removeIf(List::isEmpty);
        }
        List<Integer> gaps = new ArrayList<>();
        for (int slice : this.bySlice.keySet()) {
            Integer next = this.bySlice.higherKey(slice);
            if (next != null) {
                gaps.add(next - slice);
            }
        }
        gaps.sort(null);
        double usual = gaps.isEmpty() ? 0 : gaps.get(gaps.size() / 2);
        widest = Math.min(2 * usual, MAX_GAP_MM / Vectors.length(grid.axes().steps()[2]));
    }

    /** Whether contours run through the outermost voxels of the region. */
    boolean isMask() {
        return isMask;
    }

    /** Number of slices between contoured ones that the last {@link #forEach} filled. */
    int slicesBetween() {
        return slicesBetween;
    }

    /** Number of slices from a contoured one to the next; 0 if that is too far away. */
    private int gapAbove(int slice) {
        Integer next = bySlice.higherKey(slice);
        return next == null || next - slice > widest ? 0 : next - slice;
    }

    @Override
    public void forEach(IntConsumer voxel) {
        IntList before = new IntList();
        slicesBetween = 0;
        for (int slice : bySlice.keySet()) {
            IntList pixels = filled(slice);
            Integer low = bySlice.lowerKey(slice);
            if (low != null && gapAbove(low) > 1) {
                interpolate(low, before, slice, pixels, voxel);
            }
            int first = slice * grid.columns() * grid.rows();
            for (int i = 0; i < pixels.size(); i++) {
                voxel.accept(first + pixels.get(i));
            }
            before = pixels;
        }
    }

    private IntList filled(int slice) {
        IntList pixels = new IntList();
        bySlice.get(slice).forEach(isMask ? fill::addThroughPoints : fill::add);
        fill.flush(pixels::add);
        return pixels;
    }

    private void interpolate(int low, IntList before, int high, IntList after, IntConsumer voxel) {
        if (before.size() == 0 || after.size() == 0) {
            return;
        }
        ShapeInterpolation shape = new ShapeInterpolation(before, after, grid.columns());
        if (!shape.overlap()) {
            return;
        }
        slicesBetween += high - low - 1;
        for (int slice = low + 1; slice < high; slice++) {
            int first = slice * grid.columns() * grid.rows();
            shape.between((double) (slice - low) / (high - low), pixel -> voxel.accept(first + pixel));
        }
    }
}
