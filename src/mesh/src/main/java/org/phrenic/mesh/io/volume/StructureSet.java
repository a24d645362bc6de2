package org.phrenic.mesh.io.volume;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.dicom.DicomDataSet;
import org.phrenic.mesh.io.dicom.DicomTag;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Reader of structure sets of radiotherapy (PS3.3, A.19 and C.8.8.5, C.8.8.6): closed planar contours, filled slice by
 * slice with the even-odd rule on the grid of the series that they were drawn on, else on one through their own planes.
 * Slices between contoured ones are interpolated ({@link ContouredRegion}). Labels are the numbers of regions of
 * interest, or free ones where these are no labels.
 */
final class StructureSet {
    /** Greatest distance of a contour's points from their slice, in slices. */
    private static final double OFF = 0.25;
    /** Least share of the contours in planes that slices of a series have to hold. */
    private static final double HELD = 0.9;
    /** Corners nearer to the centre of a voxel are on it, in voxels: files round to a hundredth of a millimetre. */
    private static final double ROUNDING = 0.02;

    private final DicomDataSet set;
    private final Map<Integer, String> names = new TreeMap<>();
    private final Map<Integer, List<double[]>> contours = new TreeMap<>();
    private final List<String> notes = new ArrayList<>();
    private final List<String> problems = new ArrayList<>();
    private boolean isOfMasks;

    private StructureSet(DicomDataSet set) {
        this.set = set;
    }

    static LabelVolume read(Path path, DicomDataSet set) {
        return new StructureSet(set).volume(path);
    }

    private LabelVolume volume(Path path) {
        readNames();
        readContours();
        if (contours.isEmpty()) {
            throw new BadInputException(set.file() + ": found no closed contours, expected some");
        }
        makeLabels();
        Optional<SliceGrid> series = series(path);
        SliceGrid grid = series.orElseGet(this::ownGrid);
        LabelPainter painter = new LabelPainter(set.file(), grid.columns(), grid.rows(), grid.slices());
        ContourFill fill = new ContourFill(grid.columns(), grid.rows());
        Set<Integer> filled = new HashSet<>();
        List<String> between = new ArrayList<>();
        List<String> masks = new ArrayList<>();
        List<String> small = new ArrayList<>();
        contours.forEach((number, closed) -> {
            boolean isMask = ContouredRegion.isMask(
                    closed.stream().filter(points -> isInSlice(grid, points)).map(points -> corners(grid, points)),
                    isOfMasks);
            // Of a mask, a point is a pixel; elsewhere, it would stand for the outline of its slice.
            List<double[]> filling = closed.stream()
                    .filter(points -> isMask || points.length >= ContourGrid.AREA)
                    .toList();
            Map<Integer, List<double[]>> bySlice = bySlice(grid, number, filling);
            if (filling.isEmpty()) {
                small.add(name(number));
            } else if (!bySlice.isEmpty()) {
                ContouredRegion region = ContouredRegion.of(grid, fill, bySlice, isMask);
                if (painter.add(number, region) == 0) {
                    small.add(name(number));
                } else {
                    filled.add(number);
                }
                if (region.slicesBetween() > 0) {
                    between.add(name(number));
                }
                if (isMask) {
                    masks.add(name(number));
                }
            }
        });
        requireFilled(filled, small);
        if (!between.isEmpty()) {
            notes.add("slices between contoured ones have the shape between their neighbours': "
                    + String.join(", ", between));
        }
        if (!masks.isEmpty()) {
            notes.add(
                    "contours through the centres of voxels were taken for outlines of masks, which hold these voxels: "
                            + String.join(", ", masks));
        }
        LabelGrid labels = painter.grid(grid.axes().affine(set.file()), notes);
        names.keySet().retainAll(filled);
        LabelVolume volume = new LabelVolume(labels, LabelPainter.named(names), notes);
        return series.isPresent() ? volume : volume.with(LabelVolume.Extent.LABELS);
    }

    /** Tells of regions too small for a voxel, whose contours hold the middle of none. */
    private void requireFilled(Set<Integer> filled, List<String> small) {
        String told = String.join(", ", small);
        if (filled.isEmpty() && small.isEmpty()) {
            throw new BadInputException(
                    set.file() + ": found contours in none of the slices, expected planar ones along the series");
        }
        if (filled.isEmpty()) {
            throw new BadInputException(set.file() + ": found contours that hold the middle of no voxel (" + told
                    + "), expected larger ones");
        }
        if (!small.isEmpty()) {
            notes.add("contours that hold the middle of no voxel were left out: " + told);
        }
    }

    /** The name of a region, or its number. */
    private String name(int number) {
        String name = names.getOrDefault(number, "");
        return name.isBlank() ? "region " + number : name;
    }

    private void readNames() {
        for (DicomDataSet region : set.items(DicomTag.STRUCTURE_SET_ROI_SEQUENCE)) {
            int number = region.whole(DicomTag.ROI_NUMBER, Integer.MIN_VALUE, Integer.MAX_VALUE);
            if (names.put(number, region.text(DicomTag.ROI_NAME, "")) != null) {
                throw region.badInput(DicomTag.ROI_NUMBER, "found " + number + " twice, expected it once");
            }
        }
    }

    private void readContours() {
        int other = 0;
        for (DicomDataSet region : set.items(DicomTag.ROI_CONTOUR_SEQUENCE)) {
            int number = region.whole(DicomTag.REFERENCED_ROI_NUMBER, Integer.MIN_VALUE, Integer.MAX_VALUE);
            for (DicomDataSet contour : region.items(DicomTag.CONTOUR_SEQUENCE)) {
                boolean isClosed =
                        contour.text(DicomTag.CONTOUR_GEOMETRIC_TYPE, "").startsWith("CLOSED");
                if (!isClosed || !contour.has(DicomTag.CONTOUR_DATA)) {
                    other++;
                    continue;
                }
                double[] points = contour.numbers(DicomTag.CONTOUR_DATA);
                if (points.length % 3 != 0) {
                    throw contour.badInput(
                            DicomTag.CONTOUR_DATA, "found " + points.length + " numbers, expected three a point");
                }
                contours.computeIfAbsent(number, none -> new ArrayList<>()).add(points);
            }
        }
        if (other > 0) {
            notes.add(other + " points, open and empty contours are no volumes and were left out");
        }
    }

    /** Gives regions whose number is no label the next one that no region has. */
    private void makeLabels() {
        List<String> changed = new ArrayList<>();
        int free = 1;
        for (int number : List.copyOf(contours.keySet())) {
            if (number >= 1 && number <= LabelGrid.MAX_LABEL) {
                continue;
            }
            while (contours.containsKey(free) || names.containsKey(free)) {
                free++;
            }
            if (free > LabelGrid.MAX_LABEL) {
                throw new BadInputException(set.file() + ": found more regions than there are labels, expected at most "
                        + LabelGrid.MAX_LABEL);
            }
            changed.add(name(number) + " from " + number + " to " + free);
            contours.put(free, contours.remove(number));
            names.put(free, names.getOrDefault(number, ""));
        }
        if (!changed.isEmpty()) {
            notes.add("region numbers that are no labels from 1 to " + LabelGrid.MAX_LABEL + " were changed: "
                    + String.join(", ", changed));
        }
    }

    /**
     * The grid of the series to which the contours refer, of several that of which slices hold most contours; empty if
     * none lies beside them that can be used and holds nearly all.
     */
    private Optional<SliceGrid> series(Path path) {
        Set<String> series = new HashSet<>();
        for (DicomDataSet frame : set.items(DicomTag.REFERENCED_FRAME_OF_REFERENCE_SEQUENCE)) {
            for (DicomDataSet study : frame.items(DicomTag.RT_REFERENCED_STUDY_SEQUENCE)) {
                for (DicomDataSet one : study.items(DicomTag.RT_REFERENCED_SERIES_SEQUENCE)) {
                    series.add(one.text(DicomTag.SERIES_INSTANCE_UID, ""));
                }
            }
        }
        series.remove("");
        if (series.isEmpty()) {
            return Optional.empty();
        }
        DicomSeries.Found found = DicomSeries.find(path.toAbsolutePath().getParent(), series);
        problems.addAll(found.problems());
        double planar = new ContourGrid(set.file(), contours.values()).contours();
        Optional<DicomSeries.Candidate> best = found.series().stream()
                .max(Comparator.comparingLong((DicomSeries.Candidate candidate) -> held(candidate.grid())));
        if (best.isEmpty()) {
            return Optional.empty();
        }
        Optional<String> damaged = best.get().damaged();
        long held = held(best.get().grid());
        if (held < (damaged.isPresent() ? planar : HELD * planar)) {
            problems.add(damaged.orElse(Numbers.format("its slices hold %d of %.0f contours", held, planar)));
            return Optional.empty();
        }
        damaged.ifPresent(why -> notes.add("a file beside the series of the contours was left out: " + why));
        return best.map(DicomSeries.Candidate::grid);
    }

    /** The number of contours of an area that lie in slices of a grid. */
    private long held(SliceGrid grid) {
        return contours.values().stream()
                .flatMap(List::stream)
                .filter(points -> points.length >= ContourGrid.AREA && isHeld(grid, points))
                .count();
    }

    private static boolean isHeld(SliceGrid grid, double[] points) {
        double slice = slice(grid, points);
        return slice >= 0 && slice < grid.slices() && isInSlice(grid, points);
    }

    private SliceGrid ownGrid() {
        ContourGrid own = new ContourGrid(set.file(), contours.values());
        SliceGrid grid = own.grid();
        isOfMasks = own.isThroughCentres();
        notes.add(own.note(problems.stream().findFirst()));
        return grid;
    }

    /**
     * Corners in columns and rows, by slice; contours beyond the grid or across its slices are left out with a note,
     * and so are those of further planes of one slice.
     */
    private Map<Integer, List<double[]>> bySlice(SliceGrid grid, int number, List<double[]> closed) {
        Map<Integer, SlicePlane> bySlice = new TreeMap<>();
        int beyond = 0;
        int across = 0;
        for (double[] points : closed) {
            if (!isInSlice(grid, points)) {
                across++;
                continue;
            }
            double slice = slice(grid, points);
            double[] corners = corners(grid, points);
            boolean within = slice >= 0 && slice < grid.slices();
            boolean whole = within;
            for (int c = 0; c < corners.length; c += 2) {
                whole &= isOn(corners[c], grid.columns()) && isOn(corners[c + 1], grid.rows());
            }
            if (within) {
                bySlice.computeIfAbsent((int) slice, none -> new SlicePlane())
                        .add(meanHeight(grid, points) - slice, corners);
            }
            beyond += whole ? 0 : 1;
        }
        if (across > 0) {
            notes.add("of " + name(number) + ", contours that lie in none of the slices were left out, " + across
                    + " in number");
        }
        if (beyond > 0) {
            notes.add(beyond + " contours of " + name(number)
                    + " reach beyond the voxels of their series or lie beyond them, where they were left out");
        }
        Map<Integer, List<double[]>> corners = new TreeMap<>();
        int further = 0;
        for (Map.Entry<Integer, SlicePlane> slice : bySlice.entrySet()) {
            List<double[]> filled = slice.getValue().contours();
            corners.put(slice.getKey(), filled);
            further += slice.getValue().size() - filled.size();
        }
        if (further > 0) {
            notes.add("of " + name(number) + ", " + further
                    + " contours were left out that lie nearer together than the slices or come twice");
        }
        return corners;
    }

    /** Mean height of the corners of a contour, slices. */
    private static double meanHeight(SliceGrid grid, double[] points) {
        double sum = 0;
        for (int p = 0; p < points.length; p += 3) {
            sum += grid.index(2, points[p], points[p + 1], points[p + 2]);
        }
        return 3 * sum / points.length;
    }

    /** The slice of the first point of a contour. */
    private static double slice(SliceGrid grid, double[] points) {
        return Math.rint(grid.index(2, points[0], points[1], points[2]));
    }

    /** The corners of a contour in columns and rows. */
    private static double[] corners(SliceGrid grid, double[] points) {
        double[] corners = new double[points.length / 3 * 2];
        for (int c = 0; c < corners.length; c++) {
            int p = c / 2 * 3;
            corners[c] = snapped(grid.index(c % 2, points[p], points[p + 1], points[p + 2]));
        }
        return corners;
    }

    private static boolean isInSlice(SliceGrid grid, double[] points) {
        double slice = slice(grid, points);
        for (int p = 0; p < points.length; p += 3) {
            if (!(Math.abs(grid.index(2, points[p], points[p + 1], points[p + 2]) - slice) <= OFF)) {
                return false;
            }
        }
        return true;
    }

    /** A coordinate, which is whole where it is one but for rounding. */
    private static double snapped(double index) {
        double whole = Math.rint(index);
        return Math.abs(index - whole) <= ROUNDING ? whole : index;
    }

    /** Whether a coordinate lies among voxels, or within one of them. */
    private static boolean isOn(double index, int count) {
        return index >= -1 && index <= count;
    }
}
