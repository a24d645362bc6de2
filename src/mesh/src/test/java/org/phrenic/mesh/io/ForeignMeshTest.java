package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.mesh.TriangleMesh;

/** Meshes written by VTK, trimesh and meshio are read as these programs have them; numbers from PROVENANCE.md. */
class ForeignMeshTest {
    /** Text files hold six significant digits. */
    private static final double TEXT_MM = 1e-4;

    private static final double SPHERE_AREA_MM2 = 1134.473706868724;
    private static final double CONE_AREA_MM2 = 37.59475006384228;

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "sphere_ascii.stl",
                "sphere_binary.stl",
                "sphere_trimesh.stl",
                "sphere_meshio.stl",
                "sphere_trimesh.obj",
                "sphere_trimesh.ply",
                "sphere_meshio.ply",
                "sphere_vtk_ascii.ply",
                "sphere_vtk_binary_le.ply",
                "sphere_vtk_binary_be.ply",
                "sphere_v42_ascii.vtk",
                "sphere_v42_binary.vtk",
                "sphere_v51_ascii.vtk",
                "sphere_v51_binary.vtk",
                "strips_v42_ascii.vtk",
                "strips_v42_binary.vtk",
                "strips_v51_ascii.vtk",
                "strips_v51_binary.vtk",
                "sphere_ascii.vtp",
                "sphere_base64.vtp",
                "sphere_base64_be64.vtp",
                "sphere_base64_zlib.vtp",
                "sphere_appended_raw.vtp",
                "sphere_appended_raw_be64.vtp",
                "sphere_appended_raw_zlib.vtp",
                "sphere_appended_base64.vtp",
                "sphere_appended_base64_zlib.vtp",
                "strips_appended_raw.vtp",
                "metadata_v42_ascii.vtk",
                "metadata_v42_binary.vtk",
                "metadata_v51_ascii.vtk",
                "metadata_v51_binary.vtk",
                "metadata_ascii.vtp",
                "metadata_base64.vtp"
            })
    void theSphereHasThePointsTrianglesBoundsAndAreaItWasWrittenWith(String name) {
        TriangleMesh mesh = MeshSamples.read(folder, name);

        assertThat(mesh.vertexCount()).isEqualTo(34);
        assertThat(mesh.triangleCount()).isEqualTo(64);
        assertThat(mesh.bounds())
                .containsExactly(
                        new double[] {
                            -8.510564804077148, -7.510565280914307, -7, 10.510564804077148, 11.510564804077148, 13
                        },
                        within(TEXT_MM));
        assertThat(MeshSamples.area(mesh)).isCloseTo(SPHERE_AREA_MM2, within(0.02));
        assertThat(MeshSamples.volume(mesh)).as("outward winding").isPositive();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "cone_polygons.obj",
                "cone_polygons.ply",
                "cone_v42_ascii.vtk",
                "cone_v42_binary.vtk",
                "cone_v51_ascii.vtk",
                "cone_v51_binary.vtk",
                "cone_base64.vtp"
            })
    void thePolygonUnderTheConeIsCutIntoTriangles(String name) {
        TriangleMesh mesh = MeshSamples.read(folder, name);

        assertThat(mesh.vertexCount()).isEqualTo(8);
        assertThat(mesh.triangleCount()).isEqualTo(12);
        assertThat(MeshSamples.area(mesh)).isCloseTo(CONE_AREA_MM2, within(0.001));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "sphere_ascii.stl",
                "sphere_trimesh.obj",
                "sphere_vtk_ascii.ply",
                "strips_v51_ascii.vtk",
                "metadata_v42_ascii.vtk",
                "sphere_ascii.vtp"
            })
    void textFilesWithTheLineEndsOfWindowsAreReadAlike(String name) {
        assertIsReadAlike(name, "crlf_", text -> text.replace("\n", "\r\n"));
    }

    private void assertIsReadAlike(String name, String prefix, UnaryOperator<String> change) {
        TriangleMesh mesh = MeshSamples.read(folder, name);
        String text = new String(MeshSamples.bytes(name), StandardCharsets.ISO_8859_1);
        TriangleMesh changed = MeshFiles.read(MeshSamples.write(folder, prefix + name, change.apply(text)));

        assertThat(changed.positions()).containsExactly(mesh.positions());
        assertThat(changed.triangles()).containsExactly(mesh.triangles());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "sphere_ascii.stl",
                "sphere_trimesh.obj",
                "sphere_vtk_ascii.ply",
                "strips_v51_ascii.vtk",
                "cone_v51_binary.vtk",
                "sphere_ascii.vtp"
            })
    void filesThatBeginWithAByteOrderMarkAreReadAlike(String name) {
        assertIsReadAlike(name, "marked_", text -> "\u00ef\u00bb\u00bf" + text);
    }

    @Test
    void aVertexInTheFirstLineOfAMarkedFileIsRead() {
        String text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
        TriangleMesh mesh = MeshFiles.read(MeshSamples.write(folder, "m.obj", "\u00ef\u00bb\u00bf" + text));
        assertThat(mesh.vertexCount()).isEqualTo(4);
    }

    @Test
    void severalPiecesBecomeOneMesh() {
        TriangleMesh mesh = MeshSamples.read(folder, "sphere_pieces.vtp");

        assertThat(mesh.triangleCount()).isEqualTo(64);
        assertThat(mesh.vertexCount())
                .as("34 points, 10 of them on the seam in both pieces, as VTK reads it")
                .isEqualTo(44);
        assertThat(MeshSamples.area(mesh)).isCloseTo(SPHERE_AREA_MM2, within(0.001));
    }

    @Test
    void binaryVariantsGiveTheSameBits() {
        TriangleMesh first = MeshSamples.read(folder, "sphere_base64.vtp");
        for (String name : new String[] {
            "sphere_appended_raw_zlib.vtp",
            "sphere_appended_base64_zlib.vtp",
            "sphere_base64_be64.vtp",
            "sphere_v42_binary.vtk",
            "sphere_v51_binary.vtk",
            "sphere_vtk_binary_be.ply"
        }) {
            TriangleMesh other = MeshSamples.read(folder, name);
            assertThat(other.positions()).as(name).containsExactly(first.positions());
            assertThat(other.triangles()).as(name).containsExactly(first.triangles());
        }
    }
}
