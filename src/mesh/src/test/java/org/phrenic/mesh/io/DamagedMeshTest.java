package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;

/** A damaged file is refused in one sentence: no other exception, no silently smaller mesh. */
class DamagedMeshTest {
    private static final long SEED = 20261121;
    private static final int DAMAGED_COPIES = 80;

    /** Cut at every byte here, further on at every thirteenth: a stride that meets every byte of a number. */
    private static final int HEADER_BYTES = 150;

    private static final int STRIDE_BYTES = 13;

    @TempDir
    Path folder;

    static Stream<String> samples() {
        return Stream.of(
                "sphere_ascii.stl",
                "sphere_binary.stl",
                "sphere_trimesh.obj",
                "sphere_trimesh.ply",
                "sphere_meshio.ply",
                "sphere_vtk_ascii.ply",
                "sphere_vtk_binary_be.ply",
                "cone_polygons.ply",
                "sphere_v42_ascii.vtk",
                "sphere_v42_binary.vtk",
                "sphere_v51_binary.vtk",
                "strips_v51_binary.vtk",
                "metadata_v42_binary.vtk",
                "metadata_v51_ascii.vtk",
                "sphere_ascii.vtp",
                "sphere_base64.vtp",
                "sphere_base64_zlib.vtp",
                "sphere_appended_raw.vtp",
                "sphere_appended_raw_zlib.vtp",
                "sphere_appended_base64_zlib.vtp",
                "sphere_pieces.vtp");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "sphere_binary.stl",
                "sphere_ascii.stl",
                "sphere_trimesh.ply",
                "sphere_vtk_binary_be.ply",
                "sphere_meshio.ply",
                "sphere_v42_binary.vtk",
                "sphere_v51_binary.vtk",
                "strips_v42_binary.vtk",
                "metadata_v42_binary.vtk",
                "metadata_v51_binary.vtk",
                "sphere_base64.vtp",
                "sphere_ascii.vtp",
                "sphere_base64_zlib.vtp",
                "sphere_appended_raw.vtp",
                "sphere_appended_raw_zlib.vtp",
                "sphere_appended_base64.vtp",
                "sphere_appended_base64_zlib.vtp",
                "sphere_pieces.vtp"
            })
    void aFileCutShortIsRefusedUnlessTheSurfaceIsComplete(String name) {
        byte[] whole = MeshSamples.bytes(name);
        TriangleMesh mesh = MeshSamples.read(folder, name);
        int refused = 0;
        for (int length = 0; length < whole.length; length += length < HEADER_BYTES ? 1 : STRIDE_BYTES) {
            TriangleMesh cut = readOrNull(name, Arrays.copyOf(whole, length));
            if (cut == null) {
                refused++;
            } else {
                // Only what follows the surface (closing tags, data on points) may be missing.
                assertThat(cut.triangles())
                        .as("%s cut to %d bytes", name, length)
                        .containsExactly(mesh.triangles());
                assertThat(cut.positions())
                        .as("%s cut to %d bytes", name, length)
                        .containsExactly(mesh.positions());
            }
        }
        assertThat(refused).isGreaterThan(whole.length / STRIDE_BYTES / 2);
    }

    @ParameterizedTest
    @MethodSource("samples")
    void bytesChangedAtRandomGiveAMeshOrASentence(String name) {
        byte[] whole = MeshSamples.bytes(name);
        Random random = new Random(SEED);
        for (int copy = 0; copy < DAMAGED_COPIES; copy++) {
            byte[] damaged = whole.clone();
            for (int change = 0; change <= copy % 4; change++) {
                damaged[random.nextInt(copy % 2 == 0 ? Math.min(700, whole.length) : whole.length)] =
                        (byte) random.nextInt(256);
            }
            TriangleMesh mesh = readOrNull(name, damaged);
            if (mesh != null) {
                assertThat(mesh.triangleCount()).isPositive();
                assertThat(Arrays.stream(mesh.positions()).allMatch(Double::isFinite))
                        .isTrue();
            }
        }
    }

    /** Parses without the detour over a file; null if refused. */
    private static TriangleMesh readOrNull(String name, byte[] bytes) {
        try {
            return switch (name.substring(name.length() - 3)) {
                case "stl" -> StlReader.read(name, bytes);
                case "obj" -> ObjReader.read(name, bytes);
                case "ply" -> PlyReader.read(name, bytes);
                case "vtk" -> VtkReader.read(name, bytes);
                default -> VtpReader.read(name, bytes);
            };
        } catch (BadInputException refused) {
            assertThat(refused.getMessage())
                    .startsWith(name + ": ")
                    .doesNotContain("\n")
                    .contains("found", "expected");
            return null;
        } catch (RuntimeException | OutOfMemoryError other) {
            return fail(name + " gave another exception than BadInputException", other);
        }
    }
}
