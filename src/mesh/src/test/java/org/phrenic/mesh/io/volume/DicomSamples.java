package org.phrenic.mesh.io.volume;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** Files of DICOM made element by element, in explicit little endian. */
final class DicomSamples {
    /** Columns of the only row of a frame of {@link #segmentation}. */
    static final int COLUMNS = 4;

    private DicomSamples() {}

    static byte[] element(int tag, String representation, byte[] value) {
        byte[] even = value.length % 2 == 0 ? value : VolumeSamples.join(value, new byte[1]);
        boolean isLong = List.of("SQ", "OB", "OW").contains(representation);
        ByteBuffer bytes = ByteBuffer.allocate((isLong ? 12 : 8) + even.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putShort((short) (tag >>> 16)).putShort((short) tag);
        bytes.put(representation.getBytes(StandardCharsets.US_ASCII));
        if (isLong) {
            bytes.putShort((short) 0).putInt(even.length);
        } else {
            bytes.putShort((short) even.length);
        }
        return bytes.put(even).array();
    }

    static byte[] text(int tag, String representation, String value) {
        return element(tag, representation, value.getBytes(StandardCharsets.US_ASCII));
    }

    static byte[] number(int tag, int value) {
        return element(tag, "US", new byte[] {(byte) value, (byte) (value >> 8)});
    }

    static byte[] joined(byte[]... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            all.writeBytes(part);
        }
        return all.toByteArray();
    }

    /** A sequence with one item for each argument. */
    static byte[] sequence(int tag, byte[]... items) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] item : items) {
            ByteBuffer head = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN);
            all.writeBytes(head.putShort((short) 0xFFFE)
                    .putShort((short) 0xE000)
                    .putInt(item.length)
                    .array());
            all.writeBytes(item);
        }
        return element(tag, "SQ", all.toByteArray());
    }

    /** A file of a class of objects, with these elements in the order of their tags. */
    static byte[] file(String sopClass, byte[]... elements) {
        return joined(
                new byte[128],
                "DICM".getBytes(StandardCharsets.US_ASCII),
                text(0x00020010, "UI", "1.2.840.10008.1.2.1"),
                text(0x00080016, "UI", sopClass),
                joined(elements));
    }

    /** The functional groups of a frame of a segment, whose plane lies at this height, mm. */
    static byte[] frame(int segment, double height) {
        return joined(
                sequence(0x00209113, text(0x00200032, "DS", "10\\20\\" + height)),
                sequence(0x0062000A, number(0x0062000B, segment)));
    }

    private static byte[] segment(int number, String label) {
        return joined(number(0x00620004, number), text(0x00620005, "LO", label));
    }

    /**
     * A segmentation of a liver and a cyst, segments 1 and 2, in frames of one row of pixels of 2 x 2 mm.
     *
     * @param measures other elements of the measures of pixels, such as the spacing of slices
     * @param frames functional groups of each frame
     * @param fractions pixels, frame after frame
     */
    static byte[] segmentation(String type, int maximum, byte[] measures, byte[][] frames, int... fractions) {
        byte[] segments = sequence(0x00620002, segment(1, "liver"), segment(2, "cyst"));
        return segmentation(segments, type, maximum, measures, frames, fractions);
    }

    /** A segment whose coded type has these modifiers. */
    static byte[] segment(int number, String label, String... modifiers) {
        byte[][] codes = Arrays.stream(modifiers)
                .map(meaning -> text(0x00080104, "LO", meaning))
                .toArray(byte[][]::new);
        byte[] type = joined(text(0x00080104, "LO", "Kidney"), sequence(0x00620011, codes));
        return joined(segment(number, label), sequence(0x0062000F, type));
    }

    /** A segmentation as above with other segments. */
    static byte[] segmentation(
            byte[] segments, String type, int maximum, byte[] measures, byte[][] frames, int... fractions) {
        byte[] pixels = new byte[fractions.length];
        IntStream.range(0, pixels.length).forEach(n -> pixels[n] = (byte) fractions[n]);
        return segmentation(segments, type, maximum, measures, frames, Byte.SIZE, pixels);
    }

    /** A segmentation of a liver and a cyst as above, with a bit for each pixel. */
    static byte[] bits(byte[][] frames, int... pixels) {
        byte[] segments = sequence(0x00620002, segment(1, "liver"), segment(2, "cyst"));
        byte[] packed = new byte[(pixels.length + 7) / 8];
        IntStream.range(0, pixels.length).forEach(n -> packed[n / 8] |= (byte) (pixels[n] << n % 8));
        return segmentation(segments, "BINARY", 1, new byte[0], frames, 1, packed);
    }

    private static byte[] segmentation(
            byte[] segments, String type, int maximum, byte[] measures, byte[][] frames, int bits, byte[] pixels) {
        return file(
                "1.2.840.10008.5.1.4.1.1.66.4",
                text(0x00280008, "IS", String.format(Locale.ROOT, "%d", frames.length)),
                number(0x00280010, 1),
                number(0x00280011, COLUMNS),
                number(0x00280100, bits),
                text(0x00620001, "CS", type),
                segments,
                number(0x0062000E, maximum),
                sequence(
                        0x52009229,
                        joined(
                                sequence(0x00209116, text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")),
                                sequence(0x00289110, joined(measures, text(0x00280030, "DS", "2\\2"))))),
                sequence(0x52009230, frames),
                element(0x7FE00010, "OB", pixels));
    }

    /**
     * An image of CT in one file: frames of 2 rows and 3 columns of 1.5 x 2 mm, signed pixels of 12 bits.
     *
     * @param frames functional groups of each frame, see {@link #frame(double, int, int)}
     * @param pixels frame after frame
     */
    static byte[] image(byte[][] frames, int... pixels) {
        ByteBuffer words = ByteBuffer.allocate(2 * pixels.length).order(ByteOrder.LITTLE_ENDIAN);
        IntStream.of(pixels).forEach(pixel -> words.putShort((short) (pixel & 0xFFF)));
        return file(
                "1.2.840.10008.5.1.4.1.1.2.1",
                text(0x00280008, "IS", String.format(Locale.ROOT, "%d", frames.length)),
                number(0x00280010, 2),
                number(0x00280011, 3),
                number(0x00280100, Short.SIZE),
                number(0x00280101, 12),
                number(0x00280103, 1),
                sequence(
                        0x52009229,
                        joined(
                                sequence(0x00209116, text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")),
                                sequence(0x00289110, text(0x00280030, "DS", "1.5\\2")))),
                sequence(0x52009230, frames),
                element(0x7FE00010, "OW", words.array()));
    }

    /** The functional groups of a frame of an image. */
    static byte[] frame(double height, int slope, int intercept) {
        return joined(
                sequence(0x00209113, text(0x00200032, "DS", "10\\20\\" + height)),
                sequence(
                        0x00289145,
                        joined(
                                text(0x00281052, "DS", String.format(Locale.ROOT, "%d", intercept)),
                                text(0x00281053, "DS", String.format(Locale.ROOT, "%d", slope)))));
    }
}
