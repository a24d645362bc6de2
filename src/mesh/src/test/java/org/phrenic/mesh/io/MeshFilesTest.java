package org.phrenic.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;

class MeshFilesTest {
    private static final String PLY_HEAD =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    private static final String VTK_HEAD = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n";

    @TempDir
    Path folder;

    private void refused(String name, String content, String... words) {
        refused(name, content.getBytes(StandardCharsets.ISO_8859_1), words);
    }

    private void refused(String name, byte[] content, String... words) {
        Path file = MeshSamples.write(folder, name, content);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> MeshFiles.read(file))
                .satisfies(e -> assertThat(e.getMessage())
                        .startsWith(file + ": ")
                        .contains(words)
                        .contains("expected")
                        .doesNotContain("\n"));
    }

    @Test
    void theExtensionTellsTheFormatWhateverItsCase() {
        assertThat(MeshFiles.isMesh(Path.of("a/Liver.STL"))).isTrue();
        assertThat(MeshFiles.isMesh(Path.of("lung.vtp"))).isTrue();
        assertThat(MeshFiles.isMesh(Path.of("notes.txt"))).isFalse();
        assertThat(MeshFiles.isMesh(Path.of("stl"))).isFalse();
        Path upper = MeshSamples.write(folder, "SPHERE.STL", MeshSamples.bytes("sphere_binary.stl"));
        assertThat(MeshFiles.read(upper).triangleCount()).isEqualTo(64);
    }

    @ParameterizedTest
    @ValueSource(strings = {"stl", "obj", "ply", "vtk", "vtp"})
    void noFileAnEmptyFileAFolderAndAnotherContentAreRefused(String extension) throws IOException {
        Path missing = folder.resolve("missing." + extension);
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> MeshFiles.read(missing))
                .withMessage(missing + ": found no such file, expected one to read");
        Path directory = Files.createDirectory(folder.resolve("folder." + extension));
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> MeshFiles.read(directory))
                .withMessage(directory + ": found a folder, expected a file");
        refused("empty." + extension, "", "found an empty file");
        refused("letter." + extension, "Dear colleague,\nplease find attached\n", "found");
        refused("picture." + extension, new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13}, "found");
    }

    @Test
    void anotherExtensionIsRefusedWithTheOnesThatCanBeRead() {
        refused("scan.dcm", "x", "'dcm'", "stl, obj, ply, vtk, vtp");
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> MeshFiles.write(folder.resolve("a.obj"), MeshSamples.tetrahedron()))
                .withMessageContaining("stl, ply, vtp");
    }

    @Test
    void aBinaryStlThatBeginsWithSolidIsReadAsBinary() {
        byte[] bytes = MeshSamples.bytes("sphere_binary.stl");
        byte[] title = "solid facet normal exported by a program".getBytes(StandardCharsets.US_ASCII);
        System.arraycopy(title, 0, bytes, 0, title.length);
        Path file = MeshSamples.write(folder, "solid.stl", bytes);

        assertThat(MeshFiles.read(file).triangleCount()).isEqualTo(64);
    }

    @Test
    void stlCornersWithEqualCoordinatesBecomeOneVertexInTheOrderTheyAreSeen() {
        String facet = "facet normal nan nan nan\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n";
        Path file = MeshSamples.write(
                folder,
                "two.stl",
                "solid two of them\n" + String.format(facet, "0 0 0", "1 0 0", "0 1 0")
                        + String.format(facet, "1 0 -0.0", "1 1 0", "0 1 0") + "endsolid two of them\n");
        TriangleMesh mesh = MeshFiles.read(file);

        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 1, 3, 2);
    }

    @Test
    void stlProblemsAreToldWithLineOrByte() {
        String begin = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
        refused("nan.stl", begin + "vertex 1 NaN 0\n", "line 5", "'NaN'");
        refused("huge.stl", begin + "vertex 1 1e999 0\n", "line 5", "'1e999'");
        refused("cut.stl", begin, "line 5", "the end of the file", "'vertex'");
        refused("none.stl", "solid s\nendsolid s\n", "found no triangles");
        byte[] bytes = MeshSamples.bytes("sphere_binary.stl");
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putFloat(84 + 50 + 12, Float.NaN);
        refused("nan2.stl", bytes, "byte 154", "NaN");
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(80, -1);
        refused("many.stl", bytes, "byte 80", "4294967295 triangles", "3200 bytes");
    }

    @Test
    void objTakesPolygonsNegativeIndicesTexturesNormalsCommentsAndJoinedLines() {
        Path file = MeshSamples.write(
                folder,
                "all.obj",
                """
                # a square and a triangle
                mtllib none.mtl
                o square
                v 0 0 0 1.0
                v 1 0 0
                v 1 1 0  # a corner
                v 0 1 0
                vt 0 0
                vn 0 0 1
                s off
                f 1/1/1 2//1 3/1 \\
                  4
                f -4 -3 5
                v 0 0 1e-3
                l 1 2
                """);
        TriangleMesh mesh = MeshFiles.read(file);

        assertThat(mesh.vertexCount()).isEqualTo(5);
        assertThat(mesh.z(4)).isEqualTo(1e-3);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 0, 2, 3, 0, 1, 4);
    }

    /** A path of Windows may end a comment, and does not take the first vertex with it. */
    @Test
    void aBackslashThatEndsACommentOfObjJoinsNothing() {
        String square = "v 0 0 0\nv 1 0 0 # in C:\\\nv 0 1 0\nf 1 2 \\\n3 # of C:\\\nf 3 2 1\n";
        TriangleMesh mesh = MeshFiles.read(MeshSamples.write(folder, "c.obj", "# from C:\\models\\\n" + square));
        assertThat(mesh.vertexCount()).isEqualTo(3);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 2, 1, 0);
    }

    @Test
    void objCoordinatesKeepDoublePrecision() {
        Path file = MeshSamples.write(folder, "d.obj", "v 0.1 123.456789012345 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assertThat(MeshFiles.read(file).y(0)).isEqualTo(123.456789012345);
    }

    @Test
    void objProblemsAreToldWithTheLine() {
        String square = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        refused("range.obj", square + "f 1 2 4\nf 1 2 3\n", "line 4", "vertex index 3", "3 vertices");
        refused("zero.obj", square + "f 0 1 2\n", "line 4", "'0'");
        refused("back.obj", square + "f -4 1 2\n", "line 4", "-4");
        refused("word.obj", square + "f 1 2 x/1\n", "line 4", "'x/1'");
        refused("slash.obj", square + "f 1/a 2 3\n", "line 4", "'1/a'");
        refused("line.obj", square + "f 1 2\n", "line 4", "2 corners");
        refused("flat.obj", "v 1 2\n", "line 1", "2 coordinates");
        refused("nan.obj", "v 1 2 nan\n", "line 1", "'nan'");
        refused("points.obj", square, "found no triangles");
    }

    @Test
    void plyTakesAnyOrderOfPropertiesAndSkipsOtherElements() {
        Path file = MeshSamples.write(
                folder,
                "odd.ply",
                """
                ply
                format ascii 1.0
                comment from a scanner
                element camera 2
                property list uchar float matrix
                property char on
                element vertex 4
                property uchar red
                property double z
                property short y
                property list uchar int seen_by
                property int8 x
                element face 1
                property float quality
                property list uint16 uint32 vertex_index
                end_header
                2 0.5 nan 1
                0 0
                255 0 0 0 0
                255 0 0 2 1 2 1
                255 0.25 1 0 1
                255 0 1 0 0
                0.9 4 0 1 2 3
                """);
        TriangleMesh mesh = MeshFiles.read(file);

        assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0.25, 0, 1, 0);
        assertThat(mesh.triangleCount()).isEqualTo(2);
    }

    @Test
    void plyProblemsAreToldWithTheLine() {
        refused("range.ply", PLY_HEAD + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 13", "vertex index 3");
        refused("negative.ply", PLY_HEAD + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 13", "vertex index -1");
        refused("nan.ply", PLY_HEAD + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "line 11", "'nan'");
        refused("short.ply", PLY_HEAD + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "the end of the file");
        refused("two.ply", PLY_HEAD + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "2 corners");
        refused("more.ply", PLY_HEAD + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "line 14", "more content");
        refused("absurd.ply", PLY_HEAD.replace("vertex 3", "vertex 2000000000"), "2000000000 elements 'vertex'");
        refused("minus.ply", PLY_HEAD.replace("vertex 3", "vertex -3"), "line 3", "'-3'");
        refused("type.ply", PLY_HEAD.replace("float y", "half y"), "line 5", "'half'");
        refused("axis.ply", PLY_HEAD.replace("float z", "float w") + "0 0 0 ".repeat(9), "property 'z'");
        refused("format.ply", PLY_HEAD.replace("ascii", "text"), "line 2", "'text'");
        refused("faces.ply", PLY_HEAD.replace("vertex_indices", "corners") + "0 0 0 ".repeat(9), "'vertex_indices'");
        refused("none.ply", PLY_HEAD.replace("face 1", "face 0") + "0 0 0\n1 0 0\n0 1 0\n", "found no triangles");
    }

    @Test
    void vtkProblemsAreToldWithTheLine() {
        String points = VTK_HEAD + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
        refused("grid.vtk", VTK_HEAD.replace("POLYDATA", "RECTILINEAR_GRID"), "line 4", "'RECTILINEAR_GRID'");
        refused("range.vtk", points + "POLYGONS 1 4\n3 0 1 3\n", "line 8", "vertex index 3");
        refused("long.vtk", points + "POLYGONS 1 4\n7 0 1 2\n", "line 8", "a cell of 7 points");
        refused("left.vtk", points + "POLYGONS 1 5\n3 0 1 2 0\n", "leave 1 of 5");
        refused("absurd.vtk", VTK_HEAD + "POINTS 900000000 double\n0 0 0\n", "line 6", "900000000 points");
        refused("minus.vtk", VTK_HEAD + "POINTS -1 double\n0 0 0\n", "line 5", "-1");
        refused("nan.vtk", VTK_HEAD + "POINTS 1 double\n0 nan 0\n", "line 6", "'nan'");
        refused("word.vtk", points + "POLYGON 1 4\n3 0 1 2\n", "line 7", "'POLYGON'");
        refused("strip.vtk", points + "TRIANGLE_STRIPS 1 3\n2 0 1\n", "strip of 2 points");
        refused("none.vtk", points, "found no triangles");
        String offsets = points.replace("3.0", "5.1") + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 %s\n"
                + "CONNECTIVITY vtktypeint64\n0 1 2\n";
        refused("offset.vtk", String.format(offsets, "4"), "line 9", "0 to 4", "0 to 3");
        refused("offsets.vtk", String.format(offsets.replace("2 3", "3 3"), "-2 3"), "line 9", "offset -2");
    }

    @Test
    void vtpProblemsAreToldWithTheLineAndTheArray() {
        String ascii = new String(MeshSamples.bytes("sphere_ascii.vtp"), StandardCharsets.UTF_8);
        refused("kind.vtp", ascii.replace("type=\"PolyData\"", "type=\"ImageData\""), "line 2", "'ImageData'");
        refused("nan.vtp", ascii.replace("1 2 13 1 2 -7", "1 2 13 1 nan -7"), "array Points, value 4", "'nan'");
        refused("count.vtp", ascii.replace("NumberOfPoints=\"34\"", "NumberOfPoints=\"35\""), "102 coordinates");
        refused("polys.vtp", ascii.replace("NumberOfPolys=\"64\"", "NumberOfPolys=\"2147483648\""), "64 offsets");
        refused("minus.vtp", ascii.replace("NumberOfPolys=\"64\"", "NumberOfPolys=\"-1\""), "line 4", "'-1'");
        refused("none.vtp", ascii.replace("NumberOfPolys=\"64\"", "NumberOfPolys=\"0\""), "found no triangles");
        refused(
                "entity.vtp",
                ascii.replace("<VTKFile", "<!DOCTYPE VTKFile [<!ENTITY x SYSTEM \"file:///etc/hostname\">]>\n<VTKFile"),
                "line 2",
                "DOCTYPE");
        String raw = new String(MeshSamples.bytes("sphere_appended_raw.vtp"), StandardCharsets.ISO_8859_1);
        refused("offset.vtp", raw.replaceAll("offset=\"\\d+\"", "offset=\"99999999\""), "Points", "offset 99999999");
        refused("nowhere.vtp", raw.replace("_", "-"), "no '_'");
    }

    @Test
    void aCompressedArrayThatPromisesMoreThanItCanHoldIsRefusedBeforeMemoryIsTaken() {
        byte[] bytes = MeshSamples.bytes("sphere_appended_raw_zlib.vtp");
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        int begin = text.indexOf("_", text.indexOf("<AppendedData")) + 1;
        // Header of the first array: blocks, block size, size of the last block, 64 bits each.
        for (int at = begin; at + 24 < bytes.length; at++) {
            ByteBuffer header = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
            if (header.getLong(at + 8) == 256) {
                header.putLong(at + 8, 1L << 30);
                header.putLong(at + 16, 0);
            }
        }
        refused("bomb.vtp", bytes, "what these can hold");
    }

    @ParameterizedTest
    @ValueSource(strings = {"ply", "vtp"})
    void whatIsWrittenIsReadBackBitForBit(String extension) {
        TriangleMesh mesh = MeshSamples.tetrahedron();
        Path file = folder.resolve("mesh." + extension);
        MeshFiles.write(file, mesh);
        TriangleMesh back = MeshFiles.read(file);

        assertThat(back.positions()).containsExactly(mesh.positions());
        assertThat(back.triangles()).containsExactly(mesh.triangles());
    }

    @Test
    void stlIsReadBackInSinglePrecision() {
        TriangleMesh mesh = MeshSamples.tetrahedron();
        Path file = folder.resolve("mesh.stl");
        MeshFiles.write(file, mesh);
        TriangleMesh back = MeshFiles.read(file);

        assertThat(back.vertexCount()).isEqualTo(4);
        assertThat(back.triangleCount()).isEqualTo(4);
        assertThat(MeshSamples.volume(back)).isCloseTo(MeshSamples.volume(mesh), withinPercentage(1e-4));
    }

    @Test
    void manyVerticesAreWeldedInTheOrderTheyAreSeen() {
        int side = 60;
        double[] positions = new double[3 * side * side];
        int[] triangles = new int[6 * (side - 1) * (side - 1)];
        int filled = 0;
        for (int v = 0; v < side * side; v++) {
            positions[3 * v] = v % side;
            positions[3 * v + 1] = v / side;
            if (v % side > 0 && v >= side) {
                for (int corner : new int[] {v - side - 1, v - side, v, v - side - 1, v, v - 1}) {
                    triangles[filled++] = corner;
                }
            }
        }
        TriangleMesh grid = new TriangleMesh(positions, triangles);
        Path file = folder.resolve("grid.stl");
        MeshFiles.write(file, grid);
        TriangleMesh back = MeshFiles.read(file);

        assertThat(back.vertexCount()).isEqualTo(side * side);
        int seen = -1;
        for (int i = 0; i < filled; i++) {
            int corner = back.triangles()[i];
            assertThat(corner).isLessThanOrEqualTo(seen + 1);
            seen = Math.max(seen, corner);
            assertThat(back.x(corner)).isEqualTo(grid.x(triangles[i]));
            assertThat(back.y(corner)).isEqualTo(grid.y(triangles[i]));
        }
    }

    @Test
    void valuesAtVerticesMustBeAsManyAsVertices() {
        TriangleMesh mesh = MeshSamples.tetrahedron();
        Map<String, double[]> three = Map.of("u", new double[3]);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PlyWriter.write(folder.resolve("a.ply"), mesh, three))
                .withMessage("property 'u': 3 values, expected 4");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> VtpWriter.write(folder.resolve("a.vtp"), mesh, three))
                .withMessage("array 'u': 3 values, expected 4 or 12");
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void valuesAtVerticesStandBesideTheSurface() throws IOException {
        TriangleMesh mesh = MeshSamples.tetrahedron();
        Map<String, double[]> values = new LinkedHashMap<>();
        values.put("distance_mm", new double[] {1, 2, Double.NaN, 4});
        PlyWriter.write(folder.resolve("a.ply"), mesh, values);
        double[] vectors = IntStream.range(0, 12).mapToDouble(i -> 10 + i).toArray();
        values.put("a < \"b\" & c", vectors);
        VtpWriter.write(folder.resolve("a.vtp"), mesh, values);

        byte[] ply = Files.readAllBytes(folder.resolve("a.ply"));
        double[] rows = doubles(ply, text(ply).indexOf("end_header\n") + "end_header\n".length(), 16);
        assertThat(new double[] {rows[3], rows[7], rows[11], rows[15]}).containsExactly(1, 2, Double.NaN, 4);
        assertThat(vtpValues("distance_mm")).containsExactly(1, 2, Double.NaN, 4);
        assertThat(vtpValues("a &lt; &quot;b&quot; &amp; c")).containsExactly(vectors);
        assertThat(MeshFiles.read(folder.resolve("a.ply")).positions()).containsExactly(mesh.positions());
        assertThat(MeshFiles.read(folder.resolve("a.vtp")).positions()).containsExactly(mesh.positions());
    }

    /** Values of an array, as a reader finds them by the offset that the header states. */
    private double[] vtpValues(String array) throws IOException {
        byte[] vtp = Files.readAllBytes(folder.resolve("a.vtp"));
        Matcher header = Pattern.compile(Pattern.quote("Name=\"" + array + "\"") + "[^>]*offset=\"(\\d+)\"")
                .matcher(text(vtp));
        assertThat(header.find()).isTrue();
        String begin = "<AppendedData encoding=\"raw\">\n_";
        int at = text(vtp).indexOf(begin) + begin.length() + Integer.parseInt(header.group(1));
        long bytes = ByteBuffer.wrap(vtp).order(ByteOrder.LITTLE_ENDIAN).getLong(at);
        return doubles(vtp, at + Long.BYTES, (int) bytes / Double.BYTES);
    }

    private static String text(byte[] bytes) {
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private static double[] doubles(byte[] bytes, int at, int count) {
        double[] values = new double[count];
        ByteBuffer.wrap(bytes)
                .order(ByteOrder.LITTLE_ENDIAN)
                .position(at)
                .asDoubleBuffer()
                .get(values);
        return values;
    }

    @ParameterizedTest
    @ValueSource(strings = {"stl", "ply", "vtp"})
    void aMeshWithoutFiniteCoordinatesIsNotWritten(String extension) {
        double[] broken = {0, 0, 0, 1, 0, 0, 0, Double.NaN, 0};
        TriangleMesh mesh = new TriangleMesh(broken, new int[] {0, 1, 2});
        assertThatIllegalArgumentException()
                .isThrownBy(() -> MeshFiles.write(folder.resolve("a." + extension), mesh))
                .withMessageContaining("vertex 2");
        assertThat(folder).isEmptyDirectory();
    }
}
