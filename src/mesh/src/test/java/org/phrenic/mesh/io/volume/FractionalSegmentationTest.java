package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/** Fractional segmentations of DICOM (PS3.3, C.8.20.2), made here element by element in explicit little endian. */
class FractionalSegmentationTest {
    private static final int COLUMNS = 4;

    @TempDir
    private Path folder;

    private static byte[] element(int tag, String representation, byte[] value) {
        byte[] even = value.length % 2 == 0 ? value : VolumeSamples.join(value, new byte[1]);
        boolean isLong = representation.equals("SQ") || representation.equals("OB");
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

    private static byte[] text(int tag, String representation, String value) {
        return element(tag, representation, value.getBytes(StandardCharsets.US_ASCII));
    }

    private static byte[] number(int tag, int value) {
        return element(tag, "US", new byte[] {(byte) value, (byte) (value >> 8)});
    }

    private static byte[] joined(byte[]... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            all.writeBytes(part);
        }
        return all.toByteArray();
    }

    /** A sequence with one item for each argument. */
    private static byte[] sequence(int tag, byte[]... items) {
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

    private static byte[] frame(int segment, int slice) {
        return joined(
                sequence(0x00209113, text(0x00200032, "DS", "10\\20\\" + 3 * slice)),
                sequence(0x0062000A, number(0x0062000B, segment)));
    }

    private static byte[] segment(int number, String label) {
        return joined(number(0x00620004, number), text(0x00620005, "LO", label));
    }

    /** Four columns, one row, two slices 3 mm apart; a liver in both, a cyst in the upper one. */
    private Path file(String type, int maximum, int... fractions) {
        byte[] pixels = new byte[fractions.length];
        IntStream.range(0, pixels.length).forEach(n -> pixels[n] = (byte) fractions[n]);
        byte[] content = joined(
                new byte[128],
                "DICM".getBytes(StandardCharsets.US_ASCII),
                text(0x00020010, "UI", "1.2.840.10008.1.2.1"),
                text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.4"),
                text(0x00280008, "IS", "3"),
                number(0x00280010, 1),
                number(0x00280011, COLUMNS),
                number(0x00280100, Byte.SIZE),
                text(0x00620001, "CS", type),
                sequence(0x00620002, segment(1, "liver"), segment(2, "cyst")),
                number(0x0062000E, maximum),
                sequence(
                        0x52009229,
                        joined(
                                sequence(0x00209116, text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")),
                                sequence(0x00289110, text(0x00280030, "DS", "2\\2")))),
                sequence(0x52009230, frame(1, 0), frame(1, 1), frame(2, 1)),
                element(0x7FE00010, "OB", pixels));
        return VolumeSamples.write(folder, "fractions.dcm", content);
    }

    @Test
    void aVoxelIsInASegmentFromAHalfOn() {
        int[] fractions = {0, 127, 128, 255, 255, 255, 255, 0, 0, 255, 100, 0};
        LabelVolume volume = LabelVolumeFiles.read(file("FRACTIONAL", 255, fractions));
        LabelGrid grid = volume.grid();
        assertThat(IntStream.range(0, grid.voxelCount()).map(grid::label)).containsExactly(0, 0, 1, 1, 1, 2, 1, 0);
        assertThat(volume.names()).isEqualTo(Map.of(1, "liver", 2, "cyst"));
        assertThat(volume.notes()).anyMatch(note -> note.contains("a half or more"));
        double[] place = new double[3];
        grid.voxelToMm(3, 0, 1, place);
        assertThat(place).containsExactly(new double[] {16, 20, 3}, within(1e-12));
    }

    @Test
    void anEvenMaximumHasItsHalfInTheSegment() {
        LabelGrid grid = LabelVolumeFiles.read(file("FRACTIONAL", 100, 49, 50, 51, 100, 0, 0, 0, 0, 0, 0, 0, 0))
                .grid();
        assertThat(IntStream.range(0, COLUMNS).map(grid::label)).containsExactly(0, 1, 1, 1);
    }

    @Test
    void anotherTypeIsRefused() {
        assertThatThrownBy(() -> LabelVolumeFiles.read(file("VECTOR", 255, new int[12])))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 'VECTOR', expected BINARY, FRACTIONAL or LABELMAP");
    }
}
