package org.phrenic.mesh.io.volume;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.JavaMemory;
import org.phrenic.mesh.io.dicom.DicomDataSet;
import org.phrenic.mesh.io.dicom.DicomFile;
import org.phrenic.mesh.io.dicom.DicomPixels;
import org.phrenic.mesh.io.dicom.DicomTag;
import org.phrenic.mesh.io.dicom.FramePlane;
import org.phrenic.mesh.io.dicom.FunctionalGroups;
import org.phrenic.mesh.voxel.ImageGrid;

/** Reader of images of DICOM: a folder with the slices of one series, or one file with all frames. */
final class DicomSeries {
    private static final int MAX_FILES = 20_000;
    private static final double MAX_MEMORY = 0.5;

    private record Slice(Path path, String series, int columns, int rows, FramePlane plane) {}

    private DicomSeries() {}

    /**
     * Reads a series of slices, one a file, in the order of their positions along their normal.
     *
     * @throws BadInputException if the folder holds no or several series, or if slices are missing, unevenly apart, at
     *     the same place or of several sizes
     */
    static ImageVolume readFolder(Path folder) {
        List<Slice> slices = slices(folder, Set.of());
        if (slices.isEmpty()) {
            throw new BadInputException(folder + ": found no slices of DICOM images, expected one series");
        }
        SliceGrid grid = grid(folder.toString(), slices);
        PlaneStack stack = stack(folder.toString(), slices);
        float[] values = values(folder.toString(), grid);
        int[] pixels = new int[grid.columns() * grid.rows()];
        for (int s = 0; s < slices.size(); s++) {
            DicomFile file = DicomFile.read(slices.get(s).path());
            DicomDataSet image = file.dataSet();
            DicomPixels stored = new DicomPixels(file);
            if (stored.columns() != grid.columns() || stored.rows() != grid.rows()) {
                throw new BadInputException(slices.get(s).path() + ": found a slice that changed, expected the same");
            }
            stored.read(0, pixels);
            rescale(image, pixels, values, stack.slice(s));
        }
        return image(folder.toString(), grid, values, stack);
    }

    /** Reads an image of several frames in one file. */
    static ImageVolume readFile(DicomFile file) {
        DicomDataSet image = file.dataSet();
        DicomPixels stored = new DicomPixels(file);
        FunctionalGroups groups = new FunctionalGroups(image);
        if (!groups.arePresent()) {
            throw new BadInputException(image.file() + ": found one slice, expected the folder of its series");
        }
        PlaneStack stack = new PlaneStack(image.file(), FramePlane.all(image, groups, stored.frames()), false);
        checkPlanes(image.file(), stack, stored.frames());
        SliceGrid grid = new SliceGrid(stored.columns(), stored.rows(), stack.slices(), stack.axes());
        float[] values = values(image.file(), grid);
        int[] pixels = new int[grid.columns() * grid.rows()];
        for (int frame = 0; frame < stored.frames(); frame++) {
            stored.read(frame, pixels);
            DicomDataSet scale = groups.find(frame, DicomTag.PIXEL_VALUE_TRANSFORMATION_SEQUENCE)
                    .orElse(image);
            rescale(scale, pixels, values, stack.slice(frame));
        }
        return image(image.file(), grid, values, stack);
    }

    /**
     * A series that was looked for.
     *
     * @param damaged why a file beside its slices, which may be one of them, cannot be read
     */
    record Candidate(SliceGrid grid, Optional<String> damaged) {}

    /**
     * The series with these identifiers in a folder, or in those in it.
     *
     * @param problems why other slices of such series, or those in the folder, are of no use
     */
    record Found(List<Candidate> series, List<String> problems) {
        private Found() {
            this(new ArrayList<>(), new ArrayList<>());
        }

        /** The number of series of several slices. */
        private long count() {
            return series.stream()
                    .filter(candidate -> candidate.grid().slices() > 1)
                    .count();
        }

        /** Returns why the first of the files that cannot be read cannot. */
        private Optional<String> add(Path folder, Set<String> wanted) {
            Map<String, List<Slice>> bySeries = new TreeMap<>();
            List<String> messages = new ArrayList<>();
            for (Path path : list(folder)) {
                try {
                    slice(path, wanted)
                            .ifPresent(slice -> bySeries.computeIfAbsent(slice.series(), none -> new ArrayList<>())
                                    .add(slice));
                } catch (BadInputException unreadable) {
                    messages.add(unreadable.getMessage());
                }
            }
            Optional<String> damaged = messages.stream().findFirst();
            for (List<Slice> slices : bySeries.values()) {
                try {
                    SliceGrid grid = grid(folder.toString(), slices);
                    grid.axes().affine(folder.toString());
                    series.add(new Candidate(grid, damaged));
                } catch (BadInputException noGrid) {
                    problems.add(damaged.orElse(noGrid.getMessage()));
                }
            }
            return damaged;
        }
    }

    /** Looks for series, whatever else lies beside them: it may be damaged or not readable. */
    static Found find(Path folder, Set<String> series) {
        Found found = new Found();
        Optional<String> damaged = Optional.empty();
        try {
            damaged = found.add(folder, series);
            if (found.count() > 0) {
                return found;
            }
            for (Path inner : list(folder)) {
                if (found.count() < series.size() && Files.isDirectory(inner)) {
                    Optional<String> within = addInner(found, inner, series);
                    damaged = damaged.or(() -> within);
                }
            }
        } catch (BadInputException unreadable) {
            found.problems().add(unreadable.getMessage());
        }
        damaged.ifPresent(found.problems()::add);
        return found;
    }

    private static Optional<String> addInner(Found found, Path inner, Set<String> series) {
        try {
            return found.add(inner, series);
        } catch (BadInputException unreadable) {
            // A folder that is not the series'.
            return Optional.empty();
        }
    }

    private static List<Path> list(Path folder) {
        List<Path> paths = InputBytes.list(folder);
        if (paths.size() > MAX_FILES) {
            throw new BadInputException(
                    folder + ": found more than " + MAX_FILES + " files, expected a folder with one series");
        }
        return paths;
    }

    /** The slices in a folder, of the named series or, without names, of any. */
    private static List<Slice> slices(Path folder, Set<String> wanted) {
        List<Slice> slices = new ArrayList<>();
        list(folder).forEach(path -> slice(path, wanted).ifPresent(slices::add));
        return slices;
    }

    private static Optional<Slice> slice(Path path, Set<String> wanted) {
        if (!DicomFile.isDicom(path)) {
            return Optional.empty();
        }
        DicomDataSet image = DicomFile.read(path).dataSet();
        boolean isSlice = image.has(DicomTag.PIXEL_DATA)
                && image.has(DicomTag.IMAGE_POSITION)
                && image.has(DicomTag.SERIES_INSTANCE_UID);
        String series = image.text(DicomTag.SERIES_INSTANCE_UID, "");
        if (!isSlice || !(wanted.isEmpty() || wanted.contains(series))) {
            return Optional.empty();
        }
        int columns = image.whole(DicomTag.COLUMNS, 1, 0xFFFF);
        int rows = image.whole(DicomTag.ROWS, 1, 0xFFFF);
        return Optional.of(new Slice(path, series, columns, rows, FramePlane.of(image)));
    }

    private static PlaneStack stack(String folder, List<Slice> slices) {
        return new PlaneStack(folder, slices.stream().map(Slice::plane).toList(), false);
    }

    private static SliceGrid grid(String folder, List<Slice> slices) {
        Set<String> series = new TreeSet<>(slices.stream().map(Slice::series).toList());
        if (series.size() > 1) {
            throw new BadInputException(
                    folder + ": found slices of " + series.size() + " series, expected a folder for each");
        }
        Slice first = slices.get(0);
        if (slices.stream().anyMatch(slice -> slice.columns() != first.columns() || slice.rows() != first.rows())) {
            throw new BadInputException(folder + ": found slices of several sizes, expected those of one series");
        }
        PlaneStack stack = stack(folder, slices);
        checkPlanes(folder, stack, slices.size());
        return new SliceGrid(first.columns(), first.rows(), stack.slices(), stack.axes());
    }

    private static void checkPlanes(String file, PlaneStack stack, int frames) {
        if (stack.planes() != frames) {
            throw new BadInputException(file + ": found " + frames + " slices at " + stack.planes()
                    + " places, expected one at each, as of one phase");
        }
    }

    private static float[] values(String file, SliceGrid grid) {
        long voxels = (long) grid.columns() * grid.rows() * grid.slices();
        long memory = Runtime.getRuntime().maxMemory();
        if (voxels >= Integer.MAX_VALUE - 8 || voxels * Float.BYTES > MAX_MEMORY * memory) {
            throw new BadInputException(file + ": found " + voxels + " voxels, expected no more than fit into half of"
                    + " Java's memory, which is " + JavaMemory.inWords(memory));
        }
        return new float[(int) voxels];
    }

    private static void rescale(DicomDataSet scale, int[] pixels, float[] values, int slice) {
        double slope = scale.number(DicomTag.RESCALE_SLOPE, 1);
        double intercept = scale.number(DicomTag.RESCALE_INTERCEPT, 0);
        int first = slice * pixels.length;
        for (int n = 0; n < pixels.length; n++) {
            values[first + n] = (float) (slope * pixels[n] + intercept);
        }
        if (!Double.isFinite((float) (Math.abs(slope) * 0xFFFF + Math.abs(intercept)))) {
            throw scale.badInput(DicomTag.RESCALE_SLOPE, "found " + slope + ", expected finite values");
        }
    }

    private static ImageVolume image(String file, SliceGrid grid, float[] values, PlaneStack stack) {
        double[] affine = stack.axes().affine(file);
        return new ImageVolume(
                new ImageGrid(grid.columns(), grid.rows(), grid.slices(), values, affine), stack.notes());
    }
}
