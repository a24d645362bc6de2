package org.phrenic.anatomy.cage;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.phrenic.anatomy.Side;
import org.phrenic.mesh.TriangleMesh;

/** The ribs of a real thorax and measured motions, where this machine has them beside the project. */
final class SharedRibs {
    private static final Path SHARED = Path.of("..", "shared");

    private SharedRibs() {}

    static Path file(String path) {
        Path file = SHARED.resolve(path);
        Assumptions.assumeTrue(Files.exists(file), "no " + file + " beside the project: nothing to hold against");
        return file;
    }

    /** A rib in LPS; the file is little-endian PLY with x left, y superior, z anterior. */
    static TriangleMesh rib(String folder, int level, Side side) throws IOException {
        byte[] bytes = Files.readAllBytes(file(
                String.format("%s/rib_%02d_%s.ply", folder, level, side.name().charAt(0))));
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        int vertices = count(text, "vertex");
        int faces = count(text, "face");
        ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        data.position(text.indexOf("end_header\n") + "end_header\n".length());
        double[] positions = new double[3 * vertices];
        for (int v = 0; v < vertices; v++) {
            double left = data.getFloat();
            double superior = data.getFloat();
            double anterior = data.getFloat();
            positions[3 * v] = left;
            positions[3 * v + 1] = -anterior;
            positions[3 * v + 2] = superior;
        }
        int[] triangles = new int[3 * faces];
        for (int f = 0; f < faces; f++) {
            data.get();
            for (int k = 0; k < 3; k++) {
                triangles[3 * f + k] = data.getInt();
            }
        }
        return new TriangleMesh(positions, triangles);
    }

    private static int count(String text, String element) {
        Matcher matcher = Pattern.compile("element " + element + " (\\d+)").matcher(text);
        if (!matcher.find()) {
            throw new IllegalStateException("no element " + element);
        }
        return Integer.parseInt(matcher.group(1));
    }
}
