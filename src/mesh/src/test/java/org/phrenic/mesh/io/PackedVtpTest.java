package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Base64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;

/** VTP files packed with LZ4, and by compressors that are not read. */
class PackedVtpTest {
    @TempDir
    private Path folder;

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
    void damagedOrShorterBlocksAreRefused() {
        String whole = packed("vtkLZ4DataCompressor", MeshSamples.tetrahedron());
        // The first token promises 15 literals and more: 0xF0 becomes 0x50, five literals.
        byte[] token = {(byte) 0xF0, 81, 0};
        byte[] fewer = {(byte) 0x50, 81, 0};
        String damaged = whole.replace(
                Base64.getEncoder().encodeToString(token), Base64.getEncoder().encodeToString(fewer));
        assertThat(damaged).isNotEqualTo(whole);
        assertThatThrownBy(() -> read(damaged))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("compressed");
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
