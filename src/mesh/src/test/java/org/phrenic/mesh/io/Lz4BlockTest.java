package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;

/** Blocks of LZ4 made by hand from its description, and VTP files packed with them. */
class Lz4BlockTest {
    @TempDir
    private Path folder;

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int n = 0; n < values.length; n++) {
            bytes[n] = (byte) values[n];
        }
        return bytes;
    }

    private static String unpacked(byte[] block, int length) {
        byte[] out = new byte[length + 2];
        return Lz4Block.unpack(block, out, 1, length)
                ? new String(out, 1, length, StandardCharsets.US_ASCII)
                : "damaged";
    }

    @Test
    void literalsAndCopiesThatOverlap() {
        assertThat(unpacked(bytes(0x30, 'a', 'b', 'c'), 3)).isEqualTo("abc");
        // Three literals, eleven bytes from three back, one literal.
        assertThat(unpacked(bytes(0x37, 'a', 'b', 'c', 3, 0, 0x10, 'x'), 15)).isEqualTo("abcabcabcabcabx");
        // One literal, 4 + 15 + 255 + 2 copies of it, none at the end.
        assertThat(unpacked(bytes(0x1F, 'z', 1, 0, 255, 2, 0), 277)).isEqualTo("z".repeat(277));
        // 15 + 3 literals.
        byte[] eighteen = new byte[20];
        Arrays.fill(eighteen, (byte) 'y');
        eighteen[0] = (byte) 0xF0;
        eighteen[1] = 3;
        assertThat(unpacked(eighteen, 18)).isEqualTo("y".repeat(18));
    }

    @Test
    void damagedBlocksAreKnown() {
        assertThat(unpacked(bytes(), 3)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x30, 'a', 'b'), 3)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x30, 'a', 'b', 'c'), 4)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x30, 'a', 'b', 'c'), 2)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x10, 'a', 2, 0, 0), 5)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x10, 'a', 0, 0, 0), 5)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x10, 'a', 1), 5)).isEqualTo("damaged");
        assertThat(unpacked(bytes(0x1F, 'a', 1, 0, 255, 255), 20)).isEqualTo("damaged");
    }

    /** An array in base64: one block of literals, its header apart from the data as VTK writes it. */
    private static String array(String name, String type, int components, ByteBuffer content) {
        byte[] literals = content.array();
        ByteBuffer block = ByteBuffer.allocate(literals.length + 2);
        block.put((byte) 0xF0).put((byte) (literals.length - 15)).put(literals);
        ByteBuffer header = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
        header.putInt(1).putInt(literals.length).putInt(0).putInt(block.capacity());
        Base64.Encoder base64 = Base64.getEncoder();
        return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + components
                + "\" format=\"binary\">" + base64.encodeToString(header.array())
                + base64.encodeToString(block.array()) + "</DataArray>\n";
    }

    private static String document(String compressor, String points, String polygons) {
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" compressor=\""
                + compressor + "\">\n<PolyData><Piece NumberOfPoints=\"4\" NumberOfPolys=\"4\"><Points>" + points
                + "</Points><Polys>" + polygons + "</Polys></Piece></PolyData></VTKFile>\n";
    }

    private static String packed(String compressor, TriangleMesh mesh) {
        ByteBuffer points = ByteBuffer.allocate(96).order(ByteOrder.LITTLE_ENDIAN);
        points.asDoubleBuffer().put(mesh.positions());
        ByteBuffer corners = ByteBuffer.allocate(48).order(ByteOrder.LITTLE_ENDIAN);
        corners.asIntBuffer().put(mesh.triangles());
        ByteBuffer offsets = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
        offsets.asIntBuffer().put(new int[] {3, 6, 9, 12});
        return document(
                compressor,
                array("Points", "Float64", 3, points),
                array("connectivity", "Int32", 1, corners) + array("offsets", "Int32", 1, offsets));
    }

    private TriangleMesh read(String content) {
        return MeshFiles.read(MeshSamples.write(folder, "packed.vtp", content));
    }

    @Test
    void aVtpFilePackedWithLz4HasTheBitsItWasWrittenWith() {
        TriangleMesh mesh = MeshSamples.tetrahedron();
        TriangleMesh read = read(packed("vtkLZ4DataCompressor", mesh));
        assertThat(read.positions()).containsExactly(mesh.positions());
        assertThat(read.triangles()).containsExactly(mesh.triangles());
    }

    @Test
    void dataOfAnotherCompressorIsRefusedByName() {
        assertThatThrownBy(() -> read(packed("vtkLZMADataCompressor", MeshSamples.tetrahedron())))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found data packed by 'vtkLZMADataCompressor'")
                .hasMessageContaining("expected vtkZLibDataCompressor, vtkLZ4DataCompressor or none");
    }

    /** VTK states a compressor in text files too, which it does not use there. */
    @Test
    void aTextFileThatNamesACompressorIsRead() {
        String text = document(
                "vtkLZMADataCompressor",
                "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
                        + "0 0 0 1 0 0 0 1 0 0 0 1</DataArray>",
                "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 2 1 0 1 3 1 2 3 0 3 2</DataArray>"
                        + "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray>");
        assertThat(MeshSamples.volume(read(text))).isCloseTo(1.0 / 6, within(1e-15));
    }
}
