package org.phrenic.mesh.io.raster;

import java.io.BufferedInputStream;
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
import java.util.zip.GZIPInputStream;
import java.util.zip.InflaterInputStream;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;

/**
 * Reader of MetaImage, with voxels in the file ({@code .mha}) or in a separate file ({@code .mhd}), uncompressed or
 * zlib or gzip, in either byte order, or as text. It follows MetaIO as used by ITK: axes are LPS, and each three
 * consecutive numbers of {@code TransformMatrix} are the direction of one grid axis.
 */
final class MetaImageReader {
    private final VolumeSource source;
    private final Path path;
    private final String file;
    private final VolumeHeader header;
    private final List<String> notes = new ArrayList<>();

    private MetaImageReader(VolumeSource source) {
        this.source = source;
        path = source.path();
        file = path.toString();
        header = new VolumeHeader(file);
    }

    static <T> T read(VolumeSource source, InputStream in, StoredVolume.Use<T> use) throws IOException {
        return new MetaImageReader(source).volume(in, use);
    }

    private <T> T volume(InputStream in, StoredVolume.Use<T> use) throws IOException {
        readHeader(in);
        int dimensions = header.integers("ndims")[0];
        int[] sizes = header.integers("dimsize");
        if (dimensions != 3 && dimensions != 4) {
            throw header.badInput("ndims", "found " + dimensions + " dimensions, expected 3, or 4 with time");
        }
        if (sizes.length != dimensions) {
            throw header.badInput("dimsize", "found " + sizes.length + " numbers, expected " + dimensions);
        }
        String channels = "elementnumberofchannels";
        if (header.has(channels) && header.integers(channels)[0] != 1) {
            throw new SeveralValuesException(
                    header.badInput(channels, "found " + header.text(channels) + " values a voxel, expected 1"));
        }
        VolumeFrames frames = dimensions == 4 ? new VolumeFrames(sizes[3], false) : VolumeFrames.ONE;
        frames.choose(source);
        int[] volume = Arrays.copyOf(sizes, 3);
        VoxelDecoder voxels = isText() ? TextVoxels.decoder(volume) : new VoxelDecoder(volume, type(), order());
        double[] affine = axes(dimensions).affine(file);
        if (header.text("elementdatafile").equalsIgnoreCase("LOCAL")) {
            return use.of(stored(path, in, voxels, affine, frames));
        }
        Path data = header.fileBeside(path, "elementdatafile");
        try (InputStream apart = new BufferedInputStream(Files.newInputStream(data), 1 << 16)) {
            apart.skipNBytes(bytesToSkip(data, voxels.bytes() * frames.count()));
            return use.of(stored(data, apart, voxels, affine, frames));
        }
    }

    private StoredVolume stored(Path data, InputStream in, VoxelDecoder voxels, double[] affine, VolumeFrames frames)
            throws IOException {
        String name = data.toString();
        boolean packed = isPacked();
        if (isText()) {
            TextVoxels.validate(name, voxels, InputBytes.size(data), frames.count());
        } else {
            voxels.validate(name, InputBytes.size(data), packed, frames.count());
        }
        InputStream unpacked = packed ? unpacked(in) : in;
        InputStream values = isText() ? new TextVoxels(name, unpacked) : unpacked;
        InputStream chosen = frames.select(values, voxels, frames.choose(source));
        return new StoredVolume(name, chosen, voxels, affine, Map.of(), notes);
    }

    /** MetaIO takes gzip as well as zlib. */
    private static InputStream unpacked(InputStream in) throws IOException {
        return VolumeFormats.isGzip(in)
                ? new GZIPInputStream(in, 1 << 16)
                : new InflaterInputStream(in, new java.util.zip.Inflater(), 1 << 16);
    }

    private void readHeader(InputStream in) throws IOException {
        while (!header.has("elementdatafile")) {
            String text = header.line(in);
            if (text == null) {
                throw header.badInput("found the end of the header, expected 'ElementDataFile'");
            }
            int equals = text.indexOf('=');
            if (equals < 1 && !text.isBlank()) {
                throw header.badInput(
                        "found " + Numbers.quote(text) + ", expected a line 'key = value' of a MetaImage");
            }
            if (equals > 0) {
                header.put(text.substring(0, equals), text.substring(equals + 1));
            }
        }
    }

    /**
     * Number of bytes before the voxels in a separate data file. A header size of -1 means that the voxels end the
     * file.
     */
    private long bytesToSkip(Path data, long voxelBytes) {
        int stated = header.has("headersize") ? header.integers("headersize")[0] : 0;
        long bytes = stated < 0 && !isPacked() && !isText() ? InputBytes.size(data) - voxelBytes : stated;
        return Math.max(0, bytes);
    }

    private boolean isText() {
        return !flag("binarydata", true);
    }

    private boolean isPacked() {
        return flag("compresseddata", false);
    }

    private boolean flag(String key, boolean absent) {
        String word = header.text(key, Boolean.toString(absent)).toLowerCase(Locale.ROOT);
        return switch (word) {
            case "true", "1" -> true;
            case "false", "0" -> false;
            default -> throw header.unexpected(key, word, "True or False");
        };
    }

    private ScalarType type() {
        String type = header.text("elementtype").toUpperCase(Locale.ROOT);
        return switch (type) {
            case "MET_CHAR" -> ScalarType.INT8;
            case "MET_UCHAR" -> ScalarType.UINT8;
            case "MET_SHORT" -> ScalarType.INT16;
            case "MET_USHORT" -> ScalarType.UINT16;
            case "MET_INT", "MET_LONG" -> ScalarType.INT32;
            case "MET_UINT", "MET_ULONG" -> ScalarType.UINT32;
            case "MET_LONG_LONG" -> ScalarType.INT64;
            case "MET_ULONG_LONG" -> ScalarType.UINT64;
            case "MET_FLOAT" -> ScalarType.FLOAT32;
            case "MET_DOUBLE" -> ScalarType.FLOAT64;
            default -> throw header.unexpected("elementtype", type, "MET_UCHAR, MET_SHORT or alike");
        };
    }

    private ByteOrder order() {
        boolean big = flag("binarydatabyteordermsb", flag("elementbyteordermsb", false));
        return big ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    }

    private VolumeAxes axes(int dimensions) {
        String spacingKey = header.has("elementspacing") ? "elementspacing" : "elementsize";
        double[] spacing = {1, 1, 1};
        if (header.has(spacingKey)) {
            spacing = header.numbers(spacingKey, dimensions);
        } else {
            notes.add("no ElementSpacing: voxels were taken to be 1 mm wide");
        }
        double[] origin = numbers(dimensions, "offset", "position", "origin");
        double[] matrix = numbers(dimensions * dimensions, "transformmatrix", "rotation", "orientation");
        double[][] steps = new double[3][3];
        for (int axis = 0; axis < 3; axis++) {
            for (int row = 0; row < 3; row++) {
                double direction = matrix.length == 0 ? (axis == row ? 1 : 0) : matrix[dimensions * axis + row];
                steps[axis][row] = spacing[axis] * direction;
            }
        }
        return new VolumeAxes(steps, Arrays.copyOf(origin, 3));
    }

    /** The numbers of the first of these keys that is present; empty if none is. */
    private double[] numbers(int count, String... keys) {
        for (String key : keys) {
            if (header.has(key)) {
                return header.numbers(key, count);
            }
        }
        return new double[0];
    }
}
