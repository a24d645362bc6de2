package org.phrenic.mesh.io.raster;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.raster.LayeredSegments.Segment;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Reader of NRRD and of 3D Slicer segmentations ({@code .seg.nrrd}), raw, gzip, bzip2 or text, with the header in the
 * file or in a separate file ({@code .nhdr}). It follows the format definition, teem.sourceforge.net/nrrd/format.html.
 * Label names come from {@code SegmentN_Name} and {@code SegmentN_LabelValue}, or from what MITK writes
 * ({@link MitkLabels}). Segmentations of Slicer up to 4.10 have no values, but a layer of 0 and 1 for each segment.
 */
final class NrrdReader {
    private static final String DATA_FILE = "data file";
    /** Fields of two words by their spelling as one word. */
    private static final Map<String, String> SPACED = Map.of(
            "datafile", DATA_FILE,
            "lineskip", NrrdEncoding.LINE_SKIP,
            "byteskip", NrrdEncoding.BYTE_SKIP,
            "spacedimension", NrrdPlace.DIMENSION,
            "spacedirections", NrrdPlace.DIRECTIONS,
            "spaceorigin", NrrdPlace.ORIGIN,
            "spaceunits", NrrdPlace.SPACE_UNITS);

    private static final String VALUE = "_labelvalue";
    private static final String LAYER = "_layer";
    /** How keys of segments begin. */
    private static final String OF_SEGMENT = "segment";

    private static final Pattern SEGMENT = Pattern.compile("(segment(\\d{1,5}))_(?:name|layer|id)");

    private final VolumeSource source;
    private final Path path;
    private final String file;
    private final VolumeHeader header;
    private final NrrdPlace place;
    private final List<String> notes = new ArrayList<>();
    /** The array axes that are spatial directions. */
    private int[] axes = {0, 1, 2};

    private VolumeFrames frames = VolumeFrames.ONE;

    private NrrdReader(VolumeSource source) {
        this.source = source;
        path = source.path();
        file = path.toString();
        header = new VolumeHeader(file);
        place = new NrrdPlace(header);
    }

    static <T> T read(VolumeSource source, InputStream in, StoredVolume.Use<T> use) throws IOException {
        return new NrrdReader(source).volume(in, use);
    }

    private <T> T volume(InputStream in, StoredVolume.Use<T> use) throws IOException {
        boolean attached = readHeader(in);
        int[] sizes = sizes();
        Optional<LayeredSegments> layers = layers();
        int frame = layers.isPresent() ? 0 : frames.choose(source);
        NrrdEncoding encoding = NrrdEncoding.of(header);
        VoxelDecoder voxels = encoding.decoder(sizes, type());
        double[] affine = place.axes(axes, notes).affine(file);
        Map<Integer, String> names = layers.map(LayeredSegments::names).orElseGet(this::names);
        if (attached) {
            InputStream all = encoding.voxels(path, in, voxels, frames.count(), true);
            InputStream chosen = layers.isPresent() ? all : frames.select(all, voxels, frame);
            return use.of(new StoredVolume(file, chosen, voxels, affine, names, notes, layers));
        }
        Path data = header.fileBeside(path, DATA_FILE);
        try (InputStream apart = new BufferedInputStream(Files.newInputStream(data), 1 << 16)) {
            InputStream all = encoding.voxels(data, apart, voxels, frames.count(), false);
            InputStream chosen = layers.isPresent() ? all : frames.select(all, voxels, frame);
            return use.of(new StoredVolume(data.toString(), chosen, voxels, affine, names, notes, layers));
        }
    }

    /** Reads the header; returns whether the voxels follow in the same file. */
    private boolean readHeader(InputStream in) throws IOException {
        String magic = header.line(in);
        if (magic == null || !magic.matches("NRRD000\\d\\s*")) {
            throw header.badInput("found no 'NRRD000', expected a NRRD file");
        }
        String text = header.line(in);
        // A LIST of data files follows its field without an empty line.
        while (text != null && !text.isBlank() && !header.isList(DATA_FILE)) {
            int pair = text.indexOf(":=");
            int colon = text.indexOf(':');
            if (!text.startsWith("#")) {
                if (colon < 1) {
                    throw header.badInput("found " + Numbers.quote(text) + ", expected a field or an empty line");
                }
                int at = pair > 0 ? pair : colon;
                String key = text.substring(0, at);
                String pairKey = key.strip().toLowerCase(Locale.ROOT);
                // A pair of another kind than a segment's is no field, though it may have the name of one.
                if (pair <= 0 || pairKey.startsWith(OF_SEGMENT) || pairKey.equals(MitkLabels.KEY)) {
                    header.put(pair > 0 ? key : spaced(key), text.substring(at + (pair > 0 ? 2 : 1)));
                }
            }
            text = header.line(in);
        }
        boolean attached = !header.has(DATA_FILE);
        if (attached && text == null) {
            throw header.badInput("found the end of the file, expected voxels after an empty line");
        }
        return attached;
    }

    /** A field as the format definition spells it; Teem reads some without the space in them as well. */
    private static String spaced(String field) {
        return SPACED.getOrDefault(field.strip().toLowerCase(Locale.ROOT), field);
    }

    private int[] sizes() {
        int[] all = header.integers("sizes");
        int dimensions = header.integers("dimension")[0];
        if (all.length != dimensions) {
            String expected = ", expected " + dimensions + " as in 'dimension'";
            throw header.badInput("sizes", "found " + all.length + " numbers" + expected);
        }
        if (dimensions == 4) {
            axes = spatialAxes(all);
        } else if (dimensions != 3) {
            throw header.badInput("dimension", "found " + dimensions + " dimensions, expected 3");
        }
        return new int[] {all[axes[0]], all[axes[1]], all[axes[2]]};
    }

    /**
     * The three spatial axes of four. The other axis, first or last, is a list of volumes; those of a segmentation are
     * overlapping layers, of which one is read.
     */
    private int[] spatialAxes(int[] sizes) {
        String[] kinds = header.text("kinds", "").split("\\s+", -1);
        List<String> vectors = place.directions();
        int other = -1;
        for (int axis = 0; axis < 4; axis++) {
            boolean none = vectors.size() == 4
                    ? vectors.get(axis).equals("none")
                    : kinds.length == 4 && !kinds[axis].matches("domain|space");
            other = none ? axis : other;
        }
        int apart = other < 0 ? 3 : other;
        if (sizes[apart] > 1 && apart != 0 && apart != 3) {
            String list = "found a list of volumes as axis " + apart;
            throw header.badInput("dimension", list + ", expected it as the first axis or the last");
        }
        frames = new VolumeFrames(sizes[apart], apart == 0);
        return Arrays.stream(new int[] {0, 1, 2, 3}).filter(a -> a != apart).toArray();
    }

    private ScalarType type() {
        String type = header.text("type").toLowerCase(Locale.ROOT);
        return switch (type) {
            case "signed char", "int8", "int8_t" -> ScalarType.INT8;
            case "uchar", "unsigned char", "uint8", "uint8_t" -> ScalarType.UINT8;
            case "short", "short int", "signed short", "signed short int", "int16", "int16_t" -> ScalarType.INT16;
            case "ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t" -> ScalarType.UINT16;
            case "int", "signed int", "int32", "int32_t" -> ScalarType.INT32;
            case "uint", "unsigned int", "uint32", "uint32_t" -> ScalarType.UINT32;
            case "longlong",
                    "long long",
                    "long long int",
                    "signed long long",
                    "signed long long int",
                    "int64",
                    "int64_t" -> ScalarType.INT64;
            case "ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t" -> ScalarType.UINT64;
            case "float" -> ScalarType.FLOAT32;
            case "double" -> ScalarType.FLOAT64;
            default -> throw header.unexpected("type", type, "whole numbers or real ones");
        };
    }

    /** The segments of a segmentation with several layers, if no layer is named by its number. */
    private Optional<LayeredSegments> layers() {
        List<Segment> segments = segments();
        Optional<MitkLabels> mitk = mitk();
        boolean stated = mitk.isPresent()
                ? mitk.get().groups() == frames.count()
                : segments.stream().anyMatch(s -> header.has("segment" + (s.label() - 1) + LAYER));
        boolean isLayerEach = mitk.isEmpty()
                && segments.size() == frames.count()
                && segments.stream().noneMatch(s -> header.has("segment" + (s.label() - 1) + VALUE));
        if (frames.count() < 2 || segments.isEmpty() || source.phase().isPresent() || !(stated || isLayerEach)) {
            return Optional.empty();
        }
        for (Segment segment : segments) {
            if (segment.layer() < 0 || segment.layer() >= frames.count()) {
                throw header.badInput(
                        "dimension",
                        "found segment " + (segment.label() - 1) + " in layer " + segment.layer() + " of "
                                + frames.count() + ", expected one from 0");
            }
        }
        return Optional.of(new LayeredSegments(frames, segments));
    }

    /** What MITK lists: groups, which are layers, or are in each of several volumes over time. */
    private Optional<MitkLabels> mitk() {
        return header.has(MitkLabels.KEY) ? Optional.of(MitkLabels.of(header.text(MitkLabels.KEY))) : Optional.empty();
    }

    /** All segments that the header lists, by number. */
    private List<Segment> segments() {
        Optional<MitkLabels> mitk = mitk();
        if (mitk.isPresent()) {
            return mitk.get().segments().stream()
                    .filter(segment -> segment.layer() < frames.count() && segment.label() <= LabelGrid.MAX_LABEL)
                    .toList();
        }
        Map<Integer, String> keys = new TreeMap<>();
        for (String key : header.values().keySet()) {
            Matcher segment = SEGMENT.matcher(key);
            if (segment.matches()) {
                keys.put(Integer.parseInt(segment.group(2)), segment.group(1));
            }
        }
        List<Segment> segments = new ArrayList<>();
        keys.forEach((number, key) -> {
            boolean hasValue = header.has(key + VALUE) || frames.count() > 1 || keys.size() == 1;
            if (hasValue && number < LabelGrid.MAX_LABEL) {
                segments.add(segment(number, key));
            }
        });
        return segments;
    }

    /** A segment; without a value it is the 1 of a layer of its own. */
    private Segment segment(int number, String key) {
        int layer = frames.count() > 1 && !header.has(key + VALUE) ? number : 0;
        if (header.has(key + LAYER)) {
            layer = header.integers(key + LAYER)[0];
        }
        int stored = header.has(key + VALUE) ? header.integers(key + VALUE)[0] : 1;
        if (stored < 1 || stored > LabelGrid.MAX_LABEL) {
            throw header.unexpected(key + VALUE, header.text(key + VALUE), "a label from 1 to " + LabelGrid.MAX_LABEL);
        }
        return new Segment(number + 1, layer, stored, header.text(key + "_name", ""));
    }

    /** Names by stored value, of the layer that is read. */
    private Map<Integer, String> names() {
        Map<Integer, String> names = new TreeMap<>();
        boolean isOneGroup = mitk().stream().anyMatch(mitk -> mitk.groups() == 1);
        for (Segment segment : segments()) {
            boolean isRead = frames.count() == 1
                    || isOneGroup
                    || segment.layer() == source.phase().orElse(0);
            if (isRead && !segment.name().isEmpty()) {
                names.put(segment.value(), segment.name());
            }
        }
        return names;
    }
}
