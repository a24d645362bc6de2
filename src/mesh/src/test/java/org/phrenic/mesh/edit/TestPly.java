package org.phrenic.mesh.edit;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;
import org.phrenic.mesh.TriangleMesh;

/**
 * Reads just the PLY files of the real thorax: binary little endian, float vertices first, triangles as uchar + int.
 */
final class TestPly {
    private static final Path THORAX = Path.of("..", "shared", "anatomy", "male-thorax");

    private TestPly() {}

    /** The named structure of the real thorax; skips the test where that data is not there. */
    static TriangleMesh thorax(String name) {
        Path file = THORAX.resolve(name + ".ply");
        Assumptions.assumeTrue(Files.exists(file), () -> "no real thorax at " + file + ", test skipped");
        try {
            return read(file);
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    static TriangleMesh read(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        String head = new String(bytes, 0, Math.min(bytes.length, 2000), StandardCharsets.ISO_8859_1);
        int body = head.indexOf("end_header\n") + "end_header\n".length();
        int vertices = count(head, "element vertex ");
        int faces = count(head, "element face ");
        String vertexPart = head.substring(head.indexOf("element vertex"), head.indexOf("element face"));
        int floats = vertexPart.split("property float ", -1).length - 1;
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).position(body);
        double[] p = new double[3 * vertices];
        for (int v = 0; v < vertices; v++) {
            for (int k = 0; k < floats; k++) {
                float value = in.getFloat();
                if (k < 3) {
                    p[3 * v + k] = value;
                }
            }
        }
        int[] t = new int[3 * faces];
        for (int f = 0; f < faces; f++) {
            if (in.get() != 3) {
                throw new IOException(file + ": face " + f + " is no triangle");
            }
            for (int k = 0; k < 3; k++) {
                t[3 * f + k] = in.getInt();
            }
        }
        return new TriangleMesh(p, t);
    }

    private static int count(String head, String key) {
        int at = head.indexOf(key) + key.length();
        return Integer.parseInt(head.substring(at, head.indexOf('\n', at)).trim());
    }
}
