package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.Vectors;

/**
 * The voxels of a region that is drawn in some slices. Slices between these get the shape between their neighbours'
 * ({@link ShapeInterpolation}), where the gap is no wider than {@value #MAX_GAP_MM} mm nor than twice the usual one of
 * the region, and the neighbours overlap. Where contours step from centre to centre of voxels ({@link MaskOutline}),
 * they are outlines of a mask, as OpenCV finds them: they run through its outermost pixels, which are in the region.
 */
final class ContouredRegion implements LabelPainter.Voxels {
    /** Widest gap between drawn slices of one structure, mm. */
    private static final double MAX_GAP_MM = 15;

    private final SliceGrid grid;
    private final TreeMap<Integer, Supplier<IntList>> sections;
    private final double widest;
    private int slicesBetween;

    /**
     * @param sections pixels of the region, column + columns row, by slice
     * @param isMask whether they are all of a mask, whose gaps between slices that follow each other are its own
     */
    ContouredRegion(SliceGrid grid, Map<Integer, Supplier<IntList>> sections, boolean isMask) {
        this.grid = grid;
        this.sections = new TreeMap<>(sections);
        List<Integer> gaps = new ArrayList<>();
        for (int slice : this.sections.keySet()) {
            Integer next = this.sections.higherKey(slice);
            if (next != null) {
                gaps.add(next - slice);
            }
        }
        gaps.sort(null);
        double usual = gaps.isEmpty() ? 0 : gaps.get(gaps.size() / 2);
        widest = isMask && usual == 1
                ? 1
                : Math.min(2 * usual, MAX_GAP_MM / Vectors.length(grid.axes().steps()[2]));
    }

    /** @param bySlice corners of the contours in columns and rows, by slice */
    static ContouredRegion of(SliceGrid grid, ContourFill fill, Map<Integer, List<double[]>> bySlice, boolean isMask) {
        Map<Integer, Supplier<IntList>> sections = new TreeMap<>();
        bySlice.forEach((slice, contours) -> sections.put(slice, () -> filled(fill, contours, isMask)));
        return new ContouredRegion(grid, sections, isMask);
    }

    /**
     * Whether contours run through the outermost voxels of the region, from one to another of the eight about it.
     *
     * @param isOfMasks whether other contours do
     */
    static boolean isMask(Stream<double[]> contours, boolean isOfMasks) {
        Set<MaskOutline> kinds = contours.map(MaskOutline::of).collect(Collectors.toSet());
        return !kinds.contains(MaskOutline.DRAWN) && (isOfMasks || kinds.contains(MaskOutline.THROUGH_CENTRES));
    }

    private static IntList filled(ContourFill fill, List<double[]> contours, boolean isMask) {
        IntList pixels = new IntList();
        contours.forEach(isMask ? fill::addThroughPoints : fill::add);
        fill.flush(pixels::add);
        return pixels;
    }

    /** Number of slices between drawn ones that the last {@link #forEach} filled. */
    int slicesBetween() {
        return slicesBetween;
    }

    /** Number of slices from a drawn one to the next; 0 if that is too far away. */
    private int gapAbove(int slice) {
        Integer next = sections.higherKey(slice);
        return next == null || next - slice > widest ? 0 : next - slice;
    }

    @Override
    public void forEach(IntConsumer voxel) {
        IntList before = new IntList();
        slicesBetween = 0;
        for (int slice : sections.keySet()) {
            IntList pixels = sections.get(slice).get();
            Integer low = sections.lowerKey(slice);
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
