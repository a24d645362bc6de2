package org.phrenic.mesh.io.raster;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.io.VtpWriter;

/**
 * Reader of NIfTI-1 and NIfTI-2 in one file, uncompressed or gzip with either extension, in either byte order (Cox et
 * al. 2004, A (sort of) new image data format standard: NIfTI-1). Voxel positions are given by the sform if it is set,
 * else by the qform; both have RAS axes. Label names come from a label table in an extension, as written by the tools
 * of the Human Connectome Project and TotalSegmentator.
 */
final class NiftiReader {
    /** Greatest number of extension bytes that are searched for names. */
    private static final int MAX_EXTENSION = 1 << 24;
    /** Codes of datatypes of several values: complex numbers and colours. */
    private static final Set<Integer> SEVERAL_VALUES = Set.of(32, 128, 1792, 2048, 2304);

    private static final Pattern LABEL =
            Pattern.compile("<Label\\s+Key=\"(\\d{1,5})\"[^>]*>\\s*(?:<!\\[CDATA\\[(.*?)]]>|([^<]*))\\s*</Label>");

    private final String file;
    private final NiftiFields header;
    private final List<String> notes = new ArrayList<>();

    private NiftiReader(String file, NiftiFields header) {
        this.file = file;
        this.header = header;
    }

    static <T> T read(VolumeSource source, BufferedInputStream raw, StoredVolume.Use<T> use) throws IOException {
        Path path = source.path();
        boolean packed = VolumeFormats.isGzip(raw);
        try (InputStream in = packed ? new GZIPInputStream(raw, 1 << 16) : raw) {
            return use.of(opened(source, in, InputBytes.size(path), packed));
        }
    }

    private static StoredVolume opened(VolumeSource source, InputStream in, long size, boolean packed)
            throws IOException {
        String file = source.path().toString();
        NiftiFields header = NiftiFields.read(file, in);
        return new NiftiReader(file, header).volume(source, in, size, packed);
    }

    private StoredVolume volume(VolumeSource source, InputStream in, long size, boolean packed) throws IOException {
        double slope = header.slope();
        boolean scaled = slope != 0 && Double.isFinite(slope);
        VoxelDecoder voxels =
                new VoxelDecoder(sizes(), type(), header.order(), scaled ? slope : 1, scaled ? header.intercept() : 0);
        VolumeFrames frames = frames();
        int frame = frames.choose(source);
        double[] affine = axes().rasToLps().affine(file);
        long offset = header.voxels();
        if (offset < header.size() || offset > Integer.MAX_VALUE) {
            throw header.badVoxels("found voxels at byte " + offset + ", expected " + header.size() + " or more");
        }
        voxels.validate(file, packed ? size : size - offset, packed, frames.count());
        Map<Integer, String> names = names(in, (int) offset - header.size());
        return new StoredVolume(file, frames.select(in, voxels, frame), voxels, affine, names, notes);
    }

    /** The fourth dimension is time, in which several volumes may follow one another. */
    private VolumeFrames frames() {
        int dimensions = header.dimension(0);
        int more = 1;
        for (int d = 5; d <= Math.min(7, dimensions); d++) {
            more = Math.max(more, header.dimension(d));
        }
        if (dimensions < 3 || dimensions > 7 || more > 1) {
            String values = more > 1 ? " with " + more + " values a voxel" : "";
            BadInputException refusal = header.badDimensions(
                    "found " + dimensions + " dimensions" + values + ", expected 3, or 4 of which one is time");
            throw more > 1 ? new SeveralValuesException(refusal) : refusal;
        }
        return dimensions == 3 ? VolumeFrames.ONE : new VolumeFrames(header.dimension(4), false);
    }

    private int[] sizes() {
        return new int[] {header.dimension(1), header.dimension(2), header.dimension(3)};
    }

    private ScalarType type() {
        int code = header.datatype();
        return switch (code) {
            case 2 -> ScalarType.UINT8;
            case 4 -> ScalarType.INT16;
            case 8 -> ScalarType.INT32;
            case 16 -> ScalarType.FLOAT32;
            case 64 -> ScalarType.FLOAT64;
            case 256 -> ScalarType.INT8;
            case 512 -> ScalarType.UINT16;
            case 768 -> ScalarType.UINT32;
            case 1024 -> ScalarType.INT64;
            case 1280 -> ScalarType.UINT64;
            default -> {
                BadInputException refusal =
                        header.badDatatype("found datatype " + code + ", expected whole numbers or real ones");
                throw SEVERAL_VALUES.contains(code) ? new SeveralValuesException(refusal) : refusal;
            }
        };
    }

    private double millimetres() {
        return switch (header.units() & 7) {
            case 1 -> 1000;
            case 3 -> 1e-3;
            default -> 1;
        };
    }

    private VolumeAxes axes() {
        double mm = millimetres();
        VolumeAxes axes;
        if (header.sformCode() > 0 && header.qformCode() > 0 && sform().smallestSpacing() == 0) {
            notes.add("the sform is zero: the qform was taken");
            axes = spacedQform();
        } else if (header.sformCode() > 0 && !sform().areZero()) {
            axes = sform();
            if (header.qformCode() > 0) {
                compareForms(axes, mm);
            }
        } else if (header.qformCode() > 0) {
            axes = spacedQform();
        } else {
            notes.add("neither sform nor qform is set: columns were taken to run to the right, rows to the front,"
                    + " slices up");
            noteSpacing();
            axes = VolumeAxes.axisAligned(spacing(1), spacing(2), spacing(3));
        }
        return axes.scaled(mm, mm, mm);
    }

    private VolumeAxes spacedQform() {
        noteSpacing();
        return qform();
    }

    private void noteSpacing() {
        MissingSpacing.note(notes, header.pixel(1) == 0, header.pixel(2) == 0, header.pixel(3) == 0);
    }

    /** The spacing along a dimension, 1 mm where none is stated. */
    private double spacing(int dimension) {
        double stated = header.pixel(dimension);
        return stated == 0 ? 1 / millimetres() : stated;
    }

    /** Says in a note how far the qform places voxels from where the sform does, if by half a voxel or more. */
    private void compareForms(VolumeAxes sform, double mm) {
        double apart = sform.farthest(qform(), sizes());
        if (apart > 0 && apart >= sform.smallestSpacing() / 2) {
            notes.add(Numbers.format(
                    "sform and qform place voxels up to %.1f mm apart: the sform was taken", mm * apart));
        }
    }

    private VolumeAxes sform() {
        double[][] steps = new double[3][3];
        double[] origin = new double[3];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                steps[column][row] = header.affine(row, column);
            }
            origin[row] = header.affine(row, 3);
        }
        return new VolumeAxes(steps, origin);
    }

    /** The rotation of the quaternion (a, b, c, d) with a = sqrt(1 - b^2 - c^2 - d^2), times the spacing. */
    private VolumeAxes qform() {
        double b = header.quaternion(0);
        double c = header.quaternion(1);
        double d = header.quaternion(2);
        double rest = 1 - b * b - c * c - d * d;
        // For half turns, rounding may make b^2 + c^2 + d^2 slightly larger than 1.
        double a = rest > 0 ? Math.sqrt(rest) : 0;
        double scale = rest > 0 ? 1 : 1 / Math.sqrt(b * b + c * c + d * d);
        b *= scale;
        c *= scale;
        d *= scale;
        double dz = header.pixel(0) < 0 ? -spacing(3) : spacing(3);
        double dx = spacing(1);
        double dy = spacing(2);
        double[][] steps = {
            {dx * (a * a + b * b - c * c - d * d), dx * 2 * (b * c + a * d), dx * 2 * (b * d - a * c)},
            {dy * 2 * (b * c - a * d), dy * (a * a + c * c - b * b - d * d), dy * 2 * (c * d + a * b)},
            {dz * 2 * (b * d + a * c), dz * 2 * (c * d - a * b), dz * (a * a + d * d - b * b - c * c)}
        };
        return new VolumeAxes(steps, new double[] {header.origin(0), header.origin(1), header.origin(2)});
    }

    private Map<Integer, String> names(InputStream in, int length) throws IOException {
        Map<Integer, String> names = new TreeMap<>();
        byte[] extension = in.readNBytes(Math.min(length, MAX_EXTENSION));
        in.skipNBytes(length - extension.length);
        Matcher label = LABEL.matcher(new String(extension, StandardCharsets.UTF_8));
        while (label.find()) {
            String name = label.group(2) == null ? VtpWriter.unescape(label.group(3)) : label.group(2);
            names.put(Integer.parseInt(label.group(1)), name.strip());
        }
        return names;
    }
}
