package org.phrenic.mesh.io.dicom;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/** The stored pixels of an image of one sample a pixel, plain or in run lengths, of 1, 8 or 16 bits. */
public final class DicomPixels {
    private static final int MAX_FRAMES = 1_000_000;

    private final DicomDataSet image;
    private final DicomElement data;
    private final int columns;
    private final int rows;
    private final int frames;
    private final int bits;
    private final int stored;
    private final boolean isSigned;
    /** First and last byte of each packed frame; empty where pixels are plain. */
    private final List<int[]> packed = new ArrayList<>();

    /**
     * Checks that the file holds the pixels that it states.
     *
     * @throws BadInputException if it does not, or if pixels are of several samples or of other bits
     */
    public DicomPixels(DicomFile file) {
        image = file.dataSet();
        int samples = image.has(DicomTag.SAMPLES_PER_PIXEL) ? image.whole(DicomTag.SAMPLES_PER_PIXEL, 1, 1) : 1;
        rows = image.whole(DicomTag.ROWS, samples, 0xFFFF);
        columns = image.whole(DicomTag.COLUMNS, 1, 0xFFFF);
        boolean several = image.has(DicomTag.NUMBER_OF_FRAMES);
        frames = several ? image.whole(DicomTag.NUMBER_OF_FRAMES, 1, MAX_FRAMES) : 1;
        bits = image.whole(DicomTag.BITS_ALLOCATED, 1, Short.SIZE);
        if (bits != 1 && bits != Byte.SIZE && bits != Short.SIZE) {
            throw image.badInput(DicomTag.BITS_ALLOCATED, "found " + bits + ", expected 1, 8 or 16");
        }
        stored = image.has(DicomTag.BITS_STORED) ? image.whole(DicomTag.BITS_STORED, 1, bits) : bits;
        isSigned = image.has(DicomTag.PIXEL_REPRESENTATION) && image.whole(DicomTag.PIXEL_REPRESENTATION, 0, 1) == 1;
        data = image.element(DicomTag.PIXEL_DATA)
                .orElseThrow(() -> new BadInputException(image.file() + ": found no pixels, expected an image"));
        if (file.isRunLength()) {
            findPackedFrames();
        } else if (file.isPlain()) {
            checkPlain();
        } else {
            throw image.badInput(
                    DicomTag.PIXEL_DATA,
                    "found pixels packed by " + Numbers.quote(file.transferSyntax())
                            + ", expected plain ones or run lengths (gdcmconv --raw unpacks them)");
        }
    }

    private void checkPlain() {
        long whole = (framePixels() * frames * bits + Byte.SIZE - 1) / Byte.SIZE;
        long needed = isSwapped() ? whole + whole % 2 : whole;
        if (data.isUndefined() || needed > data.length()) {
            String found = data.isUndefined() ? "packed pixels" : data.length() + " bytes of pixels";
            throw image.badInput(
                    DicomTag.PIXEL_DATA,
                    "found " + found + ", expected " + needed + " bytes for " + columns + " x " + rows + " x " + frames
                            + " of " + bits + (bits == 1 ? " bit" : " bits"));
        }
    }

    private void findPackedFrames() {
        if (!data.isUndefined() || bits == 1) {
            throw image.badInput(DicomTag.PIXEL_DATA, "found plain pixels or single bits, expected run lengths");
        }
        image.bytes().items(data.offset(), data.end(), 0, (from, to, isOpen) -> packed.add(new int[] {from, to}));
        if (packed.size() != frames + 1) {
            throw image.badInput(
                    DicomTag.PIXEL_DATA,
                    "found " + packed.size() + " items, expected a table and " + frames
                            + (frames == 1 ? " frame" : " frames"));
        }
        packed.remove(0);
        for (int[] frame : packed) {
            if (framePixels() * bits / Byte.SIZE > RunLength.MAX_RATIO * (frame[1] - frame[0])) {
                throw image.badInput(
                        DicomTag.PIXEL_DATA,
                        "found a frame of " + (frame[1] - frame[0]) + " bytes, expected enough for " + columns + " x "
                                + rows + " pixels");
            }
        }
    }

    public int columns() {
        return columns;
    }

    public int rows() {
        return rows;
    }

    public int frames() {
        return frames;
    }

    /** Pixels of one frame. */
    public long framePixels() {
        return (long) rows * columns;
    }

    /**
     * The stored values of a frame, row by row.
     *
     * @param frame number from 0
     * @param pixels receives {@link #framePixels} values
     */
    public void read(int frame, int[] pixels) {
        if (!packed.isEmpty()) {
            int[] range = packed.get(frame);
            new RunLength(image.bytes(), range[0], range[1]).unpack(bits / Byte.SIZE, pixels);
        } else {
            readPlain(frame, pixels);
        }
        if (bits == 1) {
            return;
        }
        int shift = Integer.SIZE - stored;
        for (int n = 0; n < pixels.length; n++) {
            int high = pixels[n] << shift;
            pixels[n] = isSigned ? high >> shift : high >>> shift;
        }
    }

    /** Whether the first byte of a word of 16 bits holds the second half of its pixels (PS3.5, 8.1.1). */
    private boolean isSwapped() {
        return bits <= Byte.SIZE
                && image.bytes().bytes().order() == ByteOrder.BIG_ENDIAN
                && data.representation().equals("OW");
    }

    private void readPlain(int frame, int[] pixels) {
        long first = frame * framePixels();
        if (bits == 1) {
            readBits(first, pixels);
            return;
        }
        ByteBuffer bytes = image.bytes().bytes();
        int at = data.offset();
        int swap = isSwapped() ? 1 : 0;
        for (int n = 0; n < pixels.length; n++) {
            long pixel = first + n;
            pixels[n] = bits == Byte.SIZE
                    ? bytes.get(at + ((int) pixel ^ swap)) & 0xFF
                    : bytes.getShort(at + (int) (2 * pixel)) & 0xFFFF;
        }
    }

    /** Bytes without a pixel, which are most in segmentations, are passed over. */
    private void readBits(long first, int[] pixels) {
        ByteBuffer bytes = image.bytes().bytes();
        int at = data.offset();
        int swap = isSwapped() ? 1 : 0;
        long end = first + pixels.length;
        Arrays.fill(pixels, 0);
        for (long block = first >> 3; block <= (end - 1) >> 3; block++) {
            for (int left = bytes.get(at + ((int) block ^ swap)) & 0xFF; left != 0; left &= left - 1) {
                long pixel = 8 * block + Integer.numberOfTrailingZeros(left);
                if (pixel >= first && pixel < end) {
                    pixels[(int) (pixel - first)] = 1;
                }
            }
        }
    }
}
