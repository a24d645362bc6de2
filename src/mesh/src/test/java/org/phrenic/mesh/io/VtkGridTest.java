package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;

/** Surfaces as unstructured grids of legacy VTK files, as meshio and PyVista write them. */
class VtkGridTest {
    private static final String HEAD = "# vtk DataFile Version 4.2\nsurface\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    /** A unit cube: corner n at the bits of n. */
    private static final String CUBE = HEAD + "POINTS 8 double\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n";

    @TempDir
    private Path folder;

    private TriangleMesh read(String content) {
        return MeshFiles.read(MeshSamples.write(folder, "grid.vtk", content));
    }

    private static void assertIsCube(TriangleMesh mesh) {
        assertThat(mesh.vertexCount()).isEqualTo(8);
        assertThat(mesh.triangleCount()).isEqualTo(12);
        assertThat(MeshSamples.area(mesh)).isCloseTo(6, within(1e-12));
        assertThat(MeshSamples.volume(mesh)).isCloseTo(1, within(1e-12));
    }

    /** A polygon, a pixel, two quads, two triangles, a strip; a point and a line that are no surface. */
    @Test
    void everyKindOfSurfaceCellIsRead() {
        assertIsCube(read(CUBE
                + "CELLS 9 38\n4 0 2 3 1\n4 4 5 6 7\n4 0 1 5 4\n4 2 6 7 3\n3 0 4 6\n3 0 6 2\n4 1 3 5 7\n1 0\n2 0 1\n"
                + "CELL_TYPES 9\n7 8 9 9 5 5 6 1 3\nCELL_DATA 9\nSCALARS part int 1\n"));
    }

    @Test
    void binaryGridsOfBothLayoutsAreRead() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        text(out, "# vtk DataFile Version 5.1\nsurface\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n");
        ByteBuffer points = ByteBuffer.allocate(96);
        TriangleMesh mesh = MeshSamples.tetrahedron();
        points.asDoubleBuffer().put(mesh.positions());
        out.writeBytes(points.array());
        text(out, "\nCELLS 5 12\nOFFSETS vtktypeint64\n");
        ByteBuffer offsets = ByteBuffer.allocate(40);
        offsets.asLongBuffer().put(new long[] {0, 3, 6, 9, 12});
        out.writeBytes(offsets.array());
        text(out, "\nCONNECTIVITY vtktypeint32\n");
        ByteBuffer corners = ByteBuffer.allocate(48);
        corners.asIntBuffer().put(mesh.triangles());
        out.writeBytes(corners.array());
        text(out, "\nCELL_TYPES 4\n");
        ByteBuffer types = ByteBuffer.allocate(16);
        types.asIntBuffer().put(new int[] {5, 5, 5, 5});
        out.writeBytes(types.array());
        TriangleMesh read = MeshFiles.read(MeshSamples.write(folder, "binary.vtk", out.toByteArray()));
        assertThat(read.positions()).containsExactly(mesh.positions());
        assertThat(read.triangles()).containsExactly(mesh.triangles());
    }

    private static void text(ByteArrayOutputStream out, String text) {
        out.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
    }

    @Test
    void volumeCellsAndCellsWithoutTypesAreRefused() {
        String tetrahedron = CUBE + "CELLS 1 5\n4 0 1 2 4\n";
        assertRefused(tetrahedron + "CELL_TYPES 1\n10\n", "line 10: found a cell of type 10 with 4 points");
        assertRefused(tetrahedron, "found 1 cells without types, expected CELL_TYPES");
        assertRefused(tetrahedron + "POINT_DATA 8\n", "found 1 cells without types, expected CELL_TYPES");
        assertRefused(tetrahedron + "CELL_TYPES 2\n9 9\n", "found 2 types of cells, expected one for each of 1");
        assertRefused(CUBE + "CELLS 1 4\n3 0 1 8\nCELL_TYPES 1\n5\n", "vertex index 8");
        assertRefused(CUBE + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n", "found no triangles");
    }

    private void assertRefused(String content, String part) {
        assertThatThrownBy(() -> read(content))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(part)
                .hasMessageContaining("expected");
    }
}
