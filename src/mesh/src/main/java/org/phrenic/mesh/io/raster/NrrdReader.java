package org.phrenic.mesh.io.raster;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
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
import java.util.zip.GZIPInputStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.raster.LayeredSegments.Segment;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Reader of NRRD and of 3D Slicer segmentations ({@code .seg.nrrd}), raw or gzip, with the header in the file or in a
 * separate file ({@code .nhdr}). It follows the format definition, teem.sourceforge.net/nrrd/format.html. Label names
 * come from {@code SegmentN_Name} and {@code SegmentN_LabelValue}.
 */
final class NrrdReader {
    private static final String DATA_FILE = "data file";
    private static final Pattern SEGMENT = Pattern.compile("(segment(\\d{1,5}))_(?:name|layer|id)");
    private static final Pattern VECTOR = Pattern.compile("none|\\(([^)]*)\\)");

    private final VolumeSource source;
    private final Path path;
    private final String file;
    private final VolumeHeader header;
    private final List<String> notes = new ArrayList<>();
    /** The array axes that are spatial directions. */
    private int[] axes = {0, 1, 2};

    private VolumeFrames frames = VolumeFrames.ONE;

    private NrrdReader(VolumeSource source) {
        this.source = source;
        path = source.path();
        file = path.toString();
        header = new VolumeHeader(file);
    }

    static <T> T read(VolumeSource source, InputStream in, StoredVolume.Use<T> use) throws IOException {
        return new NrrdReader(source).volume(in, use);
    }

    private <T> T volume(InputStream in, StoredVolume.Use<T> use) throws IOException {
        boolean attached = readHeader(in);
        int[] sizes = sizes();
        Optional<LayeredSegments> layers = layers();
        int frame = layers.isPresent() ? 0 : frames.choose(source);
        ScalarType type = type();
        VoxelDecoder voxels = new VoxelDecoder(sizes, type, order(type));
        double[] affine = volumeAxes().affine(file);
        Map<Integer, String> names = layers.map(LayeredSegments::names).orElseGet(this::names);
        boolean packed = isPacked();
        if (attached) {
            voxels.validate(file, InputBytes.size(path), packed, frames.count());
            InputStream all = data(in, packed);
            InputStream chosen = layers.isPresent() ? all : frames.select(all, voxels, frame);
            return use.of(new StoredVolume(file, chosen, voxels, affine, names, notes, layers));
        }
        Path data = header.fileBeside(path, DATA_FILE);
        voxels.validate(data.toString(), InputBytes.size(data), packed, frames.count());
        try (InputStream apart = new BufferedInputStream(Files.newInputStream(data), 1 << 16)) {
            InputStream all = data(apart, packed);
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
        while (text != null && !text.isBlank() && !header.text(DATA_FILE, "").startsWith("LIST")) {
            int pair = text.indexOf(":=");
            int colon = text.indexOf(':');
            if (!text.startsWith("#")) {
                if (colon < 1) {
                    throw header.badInput("found " + Numbers.quote(text) + ", expected a field or an empty line");
                }
                int at = pair > 0 ? pair : colon;
                String key = text.substring(0, at);
                header.put(key.equals("datafile") ? DATA_FILE : key, text.substring(at + (pair > 0 ? 2 : 1)));
            }
            text = header.line(in);
        }
        boolean attached = !header.has(DATA_FILE);
        if (attached && text == null) {
            throw header.badInput("found the end of the file, expected voxels after an empty line");
        }
        return attached;
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
        List<String> vectors = header.has("space directions") ? vectors("space directions") : List.of();
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

    private ByteOrder order(ScalarType type) {
        String endian = header.text("endian", "").toLowerCase(Locale.ROOT);
        if (type.size() > 1 && !endian.equals("little") && !endian.equals("big")) {
            throw new BadInputException(file + ": found endian " + Numbers.quote(endian) + ", expected little or big");
        }
        return endian.equals("big") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    }

    private VolumeAxes volumeAxes() {
        String space = header.text("space", "").toLowerCase(Locale.ROOT);
        if (header.has("space directions")) {
            List<String> vectors = vectors("space directions");
            double[][] steps = new double[3][];
            for (int i = 0; i < 3; i++) {
                String vector = axes[i] < vectors.size() ? vectors.get(axes[i]) : "none";
                if (vector.equals("none")) {
                    throw header.badInput("space directions", "found none for axis " + axes[i] + ", expected a vector");
                }
                steps[i] = vector("space directions", vector);
            }
            double[] origin = new double[3];
            if (header.has("space origin")) {
                origin = vector("space origin", vectors("space origin").get(0));
            }
            return toLps(new VolumeAxes(steps, origin), space);
        }
        notes.add("no space directions: columns were taken to run to the left, rows to the back, slices up");
        if (!header.has("spacings")) {
            throw new BadInputException(
                    file + ": found neither 'space directions' nor 'spacings', expected the size of a voxel");
        }
        double[] spacings = new double[3];
        String[] words = header.text("spacings").split("\\s+", -1);
        for (int i = 0; i < 3; i++) {
            String word = axes[i] < words.length ? words[axes[i]] : "";
            spacings[i] = header.number("spacings", word);
        }
        return VolumeAxes.axisAligned(spacings[0], spacings[1], spacings[2]);
    }

    private VolumeAxes toLps(VolumeAxes given, String space) {
        return switch (space) {
            case "left-posterior-superior", "lps" -> given;
            case "right-anterior-superior", "ras" -> given.rasToLps();
            case "left-anterior-superior", "las" -> given.scaled(1, -1, 1);
            case "" -> {
                notes.add("no space: axes were taken to be LPS");
                yield given;
            }
            default ->
                throw header.unexpected(
                        "space", space, "left-posterior-superior, right-anterior-superior or left-anterior-superior");
        };
    }

    private List<String> vectors(String key) {
        List<String> vectors = new ArrayList<>();
        Matcher vector = VECTOR.matcher(header.text(key));
        while (vector.find()) {
            vectors.add(vector.group(1) == null ? "none" : vector.group(1));
        }
        if (vectors.isEmpty()) {
            throw header.unexpected(key, header.text(key), "vectors such as (1,0,0)");
        }
        return vectors;
    }

    private double[] vector(String key, String text) {
        String[] parts = text.split(",", -1);
        if (parts.length != 3) {
            throw header.badInput(key, "found a vector of " + parts.length + " numbers, expected 3");
        }
        double[] vector = new double[3];
        Arrays.setAll(vector, i -> header.number(key, parts[i].strip()));
        return vector;
    }

    private boolean isPacked() {
        String encoding = header.text("encoding").toLowerCase(Locale.ROOT);
        return switch (encoding) {
            case "raw" -> false;
            case "gzip", "gz" -> true;
            default -> throw header.unexpected("encoding", encoding, "raw or gzip");
        };
    }

    private InputStream data(InputStream in, boolean packed) throws IOException {
        for (int n = header.has("line skip") ? header.integers("line skip")[0] : 0; n > 0; n--) {
            if (header.line(in) == null) {
                throw new EOFException();
            }
        }
        int skip = header.has("byte skip") ? header.integers("byte skip")[0] : 0;
        if (skip < 0) {
            throw header.badInput("byte skip", "found " + skip + ", expected 0 or more");
        }
        InputStream unpacked = packed ? new GZIPInputStream(in, 1 << 16) : in;
        unpacked.skipNBytes(skip);
        return unpacked;
    }

    /** The segments of a segmentation with several layers, if no layer is named by its number. */
    private Optional<LayeredSegments> layers() {
        List<Segment> segments = segments();
        boolean layered = segments.stream().anyMatch(s -> header.has("segment" + (s.label() - 1) + "_layer"));
        if (frames.count() < 2 || source.phase().isPresent() || !layered) {
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

    /** All segments that the header lists, by number. */
    private List<Segment> segments() {
        Map<Integer, String> keys = new TreeMap<>();
        for (String key : header.values().keySet()) {
            Matcher segment = SEGMENT.matcher(key);
            if (segment.matches()) {
                keys.put(Integer.parseInt(segment.group(2)), segment.group(1));
            }
        }
        List<Segment> segments = new ArrayList<>();
        keys.forEach((number, key) -> {
            String value = key + "_labelvalue";
            int layer = header.has(key + "_layer") ? header.integers(key + "_layer")[0] : 0;
            if (header.has(value) && number < LabelGrid.MAX_LABEL) {
                int stored = header.integers(value)[0];
                if (stored < 1 || stored > LabelGrid.MAX_LABEL) {
                    throw header.unexpected(value, header.text(value), "a label from 1 to " + LabelGrid.MAX_LABEL);
                }
                segments.add(new Segment(number + 1, layer, stored, header.text(key + "_name", "")));
            }
        });
        return segments;
    }

    /** Names by stored value, of the layer that is read. */
    private Map<Integer, String> names() {
        Map<Integer, String> names = new TreeMap<>();
        for (Segment segment : segments()) {
            boolean isRead =
                    frames.count() == 1 || segment.layer() == source.phase().orElse(0);
            if (isRead && !segment.name().isEmpty()) {
                names.put(segment.value(), segment.name());
            }
        }
        return names;
    }
}
