package org.phrenic.mesh.io.raster;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.zip.ZipException;
import org.phrenic.file.BadInputException;
import org.phrenic.file.JavaMemory;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Decodes the stored voxels of a volume to labels, with one byte per label until a label exceeds 255.
 *
 * @param sizes number of voxels along columns, rows and slices
 * @param type type of a stored value
 * @param order byte order of stored values
 * @param slope label = slope * stored value + intercept
 * @param intercept see {@code slope}
 */
public record VoxelDecoder(int[] sizes, ScalarType type, ByteOrder order, double slope, double intercept) {
    private static final int CHUNK = 1 << 15;
    /** Greatest distance of a value from the label that it is, as after a rounded slope or a resampling. */
    private static final double ROUNDING = 0.01;
    /** Absolute value below which a number is shown, and taken for a background, as a whole one. */
    private static final double MAX_WHOLE = 1e15;

    /** Greatest compression ratio of deflate. */
    private static final long MAX_RATIO = 1032;

    public static final long MAX_VOXELS = Integer.MAX_VALUE - 8;
    /**
     * Initial capacity in labels. It grows with the data read, so that a damaged header cannot allocate too much
     * memory.
     */
    private static final int INITIAL_CAPACITY = 1 << 22;
    /** Greatest fraction of the Java heap for one label volume; growing an array needs both copies for a short time. */
    private static final double MAX_MEMORY = 0.5;

    /** A decoder for stored values that are labels. */
    public VoxelDecoder(int[] sizes, ScalarType type, ByteOrder order) {
        this(sizes, type, order, 1, 0);
    }

    /** Uncompressed size of all voxels, bytes. */
    long bytes() {
        return voxels() * type.size();
    }

    /** Number of voxels of a volume. */
    long voxels() {
        return (long) sizes[0] * sizes[1] * sizes[2];
    }

    /**
     * Rejects invalid sizes, and sizes that the file cannot contain, before memory is allocated.
     *
     * @param available number of bytes left in the file
     * @param volumes number of volumes of this size in the file
     */
    public void validate(String file, long available, boolean packed, int volumes) {
        for (int size : sizes) {
            if (size < 1) {
                throw new BadInputException(
                        file + ": found a size of " + shown(sizes) + " voxels, expected at least 1 each way");
            }
        }
        // This first comparison is needed because the product of three sizes below 2^31 can overflow a long.
        if ((long) sizes[0] * sizes[1] > MAX_VOXELS || voxels() > MAX_VOXELS) {
            throw new BadInputException(
                    file + ": found a size of " + shown(sizes) + " voxels, expected less than 2^31 in all");
        }
        long needed = bytes() * volumes;
        if (needed > available * (packed ? MAX_RATIO : 1)) {
            throw new BadInputException(file + ": found " + available + " bytes of voxels, expected "
                    + (packed ? "enough for " : "") + needed + " for " + (volumes == 1 ? "" : volumes + " x ")
                    + shown(sizes) + " of " + type.size()
                    + (type.size() == 1 ? " byte" : " bytes"));
        }
        checkMemory(file, 1);
    }

    /** Rejects more voxels than fit into memory with this number of bytes each. */
    public void checkMemory(String file, int bytesEach) {
        long memory = Runtime.getRuntime().maxMemory();
        if (voxels() * bytesEach > MAX_MEMORY * memory) {
            throw new BadInputException(file + ": found a size of " + shown(sizes) + " voxels, expected no more than"
                    + " fit into half of Java's memory, which is " + JavaMemory.inWords(memory));
        }
    }

    private static String shown(int[] sizes) {
        return sizes[0] + " x " + sizes[1] + " x " + sizes[2];
    }

    /**
     * Reads all voxels. A negative value of the first voxel is background if that is all corners and, with the zeros
     * beside it, the most frequent label.
     *
     * @param in uncompressed data, positioned at the first voxel
     * @param affine voxel positions, see {@link LabelGrid}
     * @param notes gets a note about a negative background
     */
    public LabelGrid decode(String file, InputStream in, double[] affine, List<String> notes) {
        int count = (int) voxels();
        byte[] small = new byte[Math.min(count, INITIAL_CAPACITY)];
        short[] large = new short[0];
        byte[] chunk = new byte[CHUNK * type.size()];
        ByteBuffer buffer = ByteBuffer.wrap(chunk).order(order);
        boolean plain = type == ScalarType.UINT8 && slope == 1 && intercept == 0;
        int done = 0;
        double background = Double.NaN;
        int negatives = 0;
        try {
            while (done < count) {
                int now = Math.min(CHUNK, count - done);
                if (large.length > 0) {
                    large = done + now > large.length ? Arrays.copyOf(large, room(large.length, count)) : large;
                } else if (done + now > small.length) {
                    small = Arrays.copyOf(small, room(small.length, count));
                }
                if (plain) {
                    now = in.readNBytes(small, done, now);
                } else {
                    now = in.readNBytes(chunk, 0, now * type.size()) / type.size();
                    background = done == 0 ? negative(value(buffer, 0)) : background;
                    Chunk values = new Chunk(file, buffer, now, done, background);
                    negatives += negatives(values);
                    if (large.length == 0 && !takeBytes(values, small)) {
                        large = widened(small, done);
                    }
                    if (large.length > 0) {
                        takeShorts(values, large);
                    }
                }
                done += now;
                if (now < Math.min(CHUNK, count - done + now)) {
                    throw new EOFException();
                }
            }
            // Reading to the end of a compressed file verifies its checksum.
            in.transferTo(OutputStream.nullOutputStream());
        } catch (EOFException ended) {
            throw new BadInputException(
                    file + ": found the end after " + done + " voxels, expected " + count + " (" + shown(sizes) + ")"
                            + (done == count ? " and the checksum of the packed data" : ""),
                    ended);
        } catch (ZipException damaged) {
            throw new BadInputException(
                    file + ": found damaged packed data after " + done + " of " + count + " voxels ("
                            + damaged.getMessage() + "), expected what was packed",
                    damaged);
        } catch (IOException failure) {
            throw new BadInputException(file + ": reading failed: " + failure.getMessage(), failure);
        }
        LabelGrid grid = large.length > 0
                ? LabelGrid.of(sizes[0], sizes[1], sizes[2], large, affine)
                : LabelGrid.of(sizes[0], sizes[1], sizes[2], small, affine);
        if (background < 0) {
            notes.add(backgroundNote(file, grid, background, negatives));
        }
        return grid;
    }

    /**
     * What is said of a negative background.
     *
     * @param negatives number of voxels that have it
     * @throws NoLabelException if a value that was read as label 0 is no background
     * @throws BadInputException if 0 is a label as likely, as where labels are counted from 0 and -1 means none
     */
    private String backgroundNote(String file, LabelGrid grid, double background, int negatives) {
        if (!isBackground(grid)) {
            throw noLabel(file, 0, background);
        }
        int zeros = grid.counts()[0] - negatives;
        if (background == -1 && zeros > 0 && zeros <= negatives) {
            throw new BadInputException(file + ": found " + negatives + " voxels of -1 and " + zeros
                    + " of 0, expected one of them as background: add 1 to all labels if 0 is a structure");
        }
        return zeros > 0
                ? "the values " + (long) background
                        + " and 0 are background, as the most frequent ones and those of the corners"
                : "the value " + (long) background + " is background, as the most frequent one and that of the corners";
    }

    /** A whole negative number; NaN for all else. */
    private static double negative(double value) {
        return value < 0 && isWhole(value) ? value : Double.NaN;
    }

    private static boolean isWhole(double value) {
        return value == Math.rint(value) && Math.abs(value) < MAX_WHOLE;
    }

    /** Whether label 0 is that of the corners and the most frequent one. */
    private static boolean isBackground(LabelGrid grid) {
        int[] counts = grid.counts();
        int last = grid.voxelCount() - 1;
        int column = grid.columns() - 1;
        int slice = grid.columns() * (grid.rows() - 1);
        return Arrays.stream(counts).max().orElse(0) == counts[0]
                && IntStream.of(0, column, slice, slice + column)
                        .allMatch(v -> grid.label(v) == 0 && grid.label(last - v) == 0);
    }

    private static int room(int before, int count) {
        return (int) Math.min(count, 2L * before);
    }

    /**
     * Stored values that were read at once.
     *
     * @param first index of the voxel of the first value
     * @param background value that is label 0, NaN for none
     */
    private record Chunk(String file, ByteBuffer from, int count, int first, double background) {}

    /** Decodes to bytes; returns false as soon as a label does not fit into a byte. */
    private boolean takeBytes(Chunk values, byte[] to) {
        for (int n = 0; n < values.count(); n++) {
            int label = label(values, n);
            if (label > LabelGrid.MAX_BYTE_LABEL) {
                return false;
            }
            to[values.first() + n] = (byte) label;
        }
        return true;
    }

    private void takeShorts(Chunk values, short[] to) {
        for (int n = 0; n < values.count(); n++) {
            to[values.first() + n] = (short) label(values, n);
        }
    }

    /** Number of values that are the negative background. */
    private int negatives(Chunk values) {
        return values.background() < 0
                ? (int) IntStream.range(0, values.count())
                        .filter(n -> value(values.from(), n) == values.background())
                        .count()
                : 0;
    }

    private int label(Chunk values, int n) {
        double value = value(values.from(), n);
        if (value == values.background()) {
            return 0;
        }
        int label = (int) value;
        if (label != value || label < 0 || label > LabelGrid.MAX_LABEL) {
            throw noLabel(values.file(), values.first() + n, value);
        }
        return label;
    }

    /** A value, which is whole if it is nearly so. */
    private double value(ByteBuffer from, int n) {
        double value = type.isInteger()
                ? slope * type.readLong(from, n * type.size()) + intercept
                : slope * type.readDouble(from, n * type.size()) + intercept;
        double whole = Math.rint(value);
        return Math.abs(value - whole) < ROUNDING ? whole : value;
    }

    private NoLabelException noLabel(String file, int voxel, double value) {
        String found = isWhole(value) ? Long.toString((long) value) : Double.toString(value);
        return new NoLabelException(file + ": " + place(voxel) + ": found " + found
                + ", expected a label, a whole number from 0 to " + LabelGrid.MAX_LABEL
                + "; images have to be segmented first");
    }

    /** A voxel in a message, by its index. */
    String place(int voxel) {
        int row = voxel / sizes[0];
        return "voxel (" + voxel % sizes[0] + ", " + row % sizes[1] + ", " + row / sizes[1] + ")";
    }

    private static short[] widened(byte[] labels, int count) {
        short[] wide = new short[labels.length];
        for (int i = 0; i < count; i++) {
            wide[i] = (short) (labels[i] & LabelGrid.MAX_BYTE_LABEL);
        }
        return wide;
    }
}
