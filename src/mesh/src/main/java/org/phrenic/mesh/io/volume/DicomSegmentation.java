package org.phrenic.mesh.io.volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.io.dicom.DicomDataSet;
import org.phrenic.mesh.io.dicom.DicomFile;
import org.phrenic.mesh.io.dicom.DicomPixels;
import org.phrenic.mesh.io.dicom.DicomTag;
import org.phrenic.mesh.io.dicom.FramePlane;
import org.phrenic.mesh.io.dicom.FunctionalGroups;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Reader of DICOM segmentations (PS3.3, A.51 and C.8.20): binary and fractional ones, whose segments may overlap, and
 * label maps. A voxel is in a segment if its fraction, a probability or an occupancy, is a half or more. Labels are
 * segment numbers, names are segment labels, with the side of the coded type where they state none, or the coded types
 * where labels are mere numbers.
 */
final class DicomSegmentation {
    /** A side in the label of a segment, in the languages of names of labels. */
    private static final Pattern SIDE =
            Pattern.compile("(?i)(?<![a-z])(l|r|lt|rt|l[ul]l|r[uml]l)(?![a-z])|left|right|link|recht|gauch|droit"
                    + "|izquierd|derech|sinist|destr|dext|esquerd|direit|左|右");

    /** Share of the gaps between slices of a segment that are of two where it is drawn in every second slice. */
    private static final double EVERY_SECOND = 0.8;
    /** Such gaps of a segment that is drawn in every second slice, at least. */
    private static final int MIN_SECONDS = 3;

    private final DicomDataSet image;
    private final DicomPixels pixels;
    private final FunctionalGroups groups;
    private final PlaneStack stack;
    private final int[] frame;
    private final int threshold;
    private int read = -1;
    /** Whether the file holds frames in which their segment has no pixel, so that it leaves out no slices. */
    private boolean hasEmptyFrames;
    /** Pixels of each frame that are in its segment, the first of them and the one after the last. */
    private final int[] counts;

    private final int[] firsts;
    private final int[] ends;

    private DicomSegmentation(DicomFile file) {
        image = file.dataSet();
        pixels = new DicomPixels(file);
        groups = new FunctionalGroups(image);
        groups.checkCount(pixels.frames());
        stack = new PlaneStack(image.file(), FramePlane.all(image, groups, pixels.frames()), true);
        threshold = threshold(image.text(DicomTag.SEGMENTATION_TYPE, "LABELMAP"));
        counts = new int[pixels.frames()];
        firsts = new int[pixels.frames()];
        ends = new int[pixels.frames()];
        frame = new int[(int) Math.min(Integer.MAX_VALUE - 8, pixels.framePixels())];
    }

    static LabelVolume read(DicomFile file) {
        return new DicomSegmentation(file).volume();
    }

    private LabelVolume volume() {
        String type = image.text(DicomTag.SEGMENTATION_TYPE, "LABELMAP");
        Map<Integer, String> names = new TreeMap<>();
        for (DicomDataSet segment : image.items(DicomTag.SEGMENT_SEQUENCE)) {
            int number = segment.whole(DicomTag.SEGMENT_NUMBER, 0, LabelGrid.MAX_LABEL);
            if (names.put(number, name(segment)) != null) {
                throw segment.badInput(DicomTag.SEGMENT_NUMBER, "found " + number + " twice, expected it once");
            }
        }
        names.remove(0);
        if (names.isEmpty()) {
            throw new BadInputException(image.file() + ": found no segments, expected some");
        }
        LabelPainter painter = new LabelPainter(image.file(), pixels.columns(), pixels.rows(), stack.slices());
        double[] affine = stack.axes().affine(image.file());
        List<String> notes = new ArrayList<>(stack.notes());
        if (type.equals("FRACTIONAL")) {
            notes.add("fractional segments: a voxel is in a segment whose fraction there is a half or more");
        }
        LabelGrid grid;
        if (threshold > 0) {
            List<String> between = new ArrayList<>();
            framesOfSegments(names)
                    .forEach((number, frames) -> add(painter, number, frames, names.get(number), between));
            if (!between.isEmpty()) {
                notes.add("slices between every second one, in which a segment is drawn, have the shape between their"
                        + " neighbours': " + String.join(", ", between));
            }
            grid = painter.grid(affine, notes);
        } else {
            paintMap(painter, names);
            grid = painter.grid(affine);
        }
        LabelVolume volume = new LabelVolume(grid, LabelPainter.named(names), notes);
        return hasEmptyFrames ? volume : volume.with(LabelVolume.Extent.LABELLED_SLICES);
    }

    /** The least value of a pixel in a segment; 0 where a pixel is the number of its segment. */
    private int threshold(String type) {
        return switch (type) {
            case "BINARY" -> 1;
            case "FRACTIONAL" -> (image.whole(DicomTag.MAXIMUM_FRACTIONAL_VALUE, 1, 0xFFFF) + 1) / 2;
            case "LABELMAP" -> 0;
            default ->
                throw image.badInput(
                        DicomTag.SEGMENTATION_TYPE,
                        "found " + Numbers.quote(type) + ", expected BINARY, FRACTIONAL or LABELMAP");
        };
    }

    /**
     * The label of a segment, with the side of its type if it states none; the meaning of its type, with its side,
     * where the label is no more than a number.
     */
    private static String name(DicomDataSet segment) {
        String label = segment.text(DicomTag.SEGMENT_LABEL, "");
        if (!LabelVolume.isNumber(label)) {
            return SIDE.matcher(label).find() ? label : side(segment) + label;
        }
        String meaning = segment.items(DicomTag.SEGMENTED_PROPERTY_TYPE_CODE_SEQUENCE).stream()
                .flatMap(type -> Stream.concat(
                        type.items(DicomTag.SEGMENTED_PROPERTY_TYPE_MODIFIER_CODE_SEQUENCE).stream(), Stream.of(type)))
                .map(code -> code.text(DicomTag.CODE_MEANING, ""))
                .collect(Collectors.joining(" "))
                .strip();
        return meaning.isEmpty() ? label : meaning;
    }

    /** The side of a segment by the modifiers of its type, with a space after it; empty for none or both. */
    private static String side(DicomDataSet segment) {
        List<String> sides = segment.items(DicomTag.SEGMENTED_PROPERTY_TYPE_CODE_SEQUENCE).stream()
                .flatMap(type -> type.items(DicomTag.SEGMENTED_PROPERTY_TYPE_MODIFIER_CODE_SEQUENCE).stream())
                .map(code -> code.text(DicomTag.CODE_MEANING, "").strip())
                .filter(meaning -> meaning.equalsIgnoreCase("left") || meaning.equalsIgnoreCase("right"))
                .toList();
        return sides.size() == 1 ? sides.get(0) + " " : "";
    }

    /** Each pixel of a label map is the number of its segment. */
    private void paintMap(LabelPainter painter, Map<Integer, String> names) {
        painter.allocate(names.keySet().stream().mapToInt(n -> n).max().orElse(0));
        for (int f = 0; f < pixels.frames(); f++) {
            pixels.read(f, frame);
            int first = stack.slice(f) * frame.length;
            for (int n = 0; n < frame.length; n++) {
                if (frame[n] != 0 && !names.containsKey(frame[n])) {
                    throw new BadInputException(
                            image.file() + ": found a pixel of segment " + frame[n] + ", expected one of the segments");
                }
                painter.set(first + n, frame[n]);
            }
        }
    }

    /** The frames of each segment. */
    private Map<Integer, List<Integer>> framesOfSegments(Map<Integer, String> names) {
        Map<Integer, List<Integer>> frames = new TreeMap<>();
        names.keySet().forEach(number -> frames.put(number, new ArrayList<>()));
        for (int f = 0; f < pixels.frames(); f++) {
            DicomDataSet identification = groups.item(f, DicomTag.SEGMENT_IDENTIFICATION_SEQUENCE);
            int number = identification.whole(DicomTag.REFERENCED_SEGMENT_NUMBER, 1, LabelGrid.MAX_LABEL);
            if (!frames.containsKey(number)) {
                throw identification.badInput(
                        DicomTag.REFERENCED_SEGMENT_NUMBER, "found " + number + ", expected one of the segments");
            }
            frames.get(number).add(f);
        }
        return frames;
    }

    /** Adds a segment; names it to {@code between} where slices between those that it is drawn in are filled. */
    private void add(LabelPainter painter, int number, List<Integer> frames, String name, List<String> between) {
        Map<Integer, List<Integer>> bySlice = new TreeMap<>();
        long count = 0;
        for (int f : frames) {
            measure(f);
            count += counts[f];
            hasEmptyFrames |= counts[f] == 0;
            if (counts[f] > 0) {
                bySlice.computeIfAbsent(stack.slice(f), none -> new ArrayList<>())
                        .add(f);
            }
        }
        if (!isEverySecond(bySlice.keySet())) {
            painter.add(
                    number,
                    use -> bySlice.forEach(
                            (slice, here) -> here.forEach(f -> forEach(f, n -> use.accept(slice * frame.length + n)))),
                    count);
            return;
        }
        Map<Integer, Supplier<IntList>> sections = new TreeMap<>();
        bySlice.forEach((slice, here) -> sections.put(slice, () -> {
            IntList inside = new IntList();
            here.forEach(f -> forEach(f, inside::add));
            return inside;
        }));
        SliceGrid grid = new SliceGrid(pixels.columns(), pixels.rows(), stack.slices(), stack.axes());
        ContouredRegion region = new ContouredRegion(grid, sections, true);
        painter.add(number, region);
        if (region.slicesBetween() > 0) {
            between.add(name.isBlank() ? "segment " + number : name);
        }
    }

    private static boolean isEverySecond(Set<Integer> slices) {
        int seconds = 0;
        int before = Integer.MIN_VALUE / 2;
        for (int slice : slices) {
            seconds += slice - before == 2 ? 1 : 0;
            before = slice;
        }
        return seconds >= MIN_SECONDS && seconds >= EVERY_SECOND * (slices.size() - 1);
    }

    private void read(int f) {
        if (read != f) {
            pixels.read(f, frame);
            read = f;
        }
    }

    /** Counts the pixels of a frame that are in its segment. */
    private void measure(int f) {
        read(f);
        for (int n = 0; n < frame.length; n++) {
            if (frame[n] >= threshold) {
                firsts[f] = counts[f] == 0 ? n : firsts[f];
                ends[f] = n + 1;
                counts[f]++;
            }
        }
    }

    /** The pixels of a measured frame that are in its segment. */
    private void forEach(int f, IntConsumer use) {
        read(f);
        for (int n = firsts[f]; n < ends[f]; n++) {
            if (frame[n] >= threshold) {
                use.accept(n);
            }
        }
    }
}
