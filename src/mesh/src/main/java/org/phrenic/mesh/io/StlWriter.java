package org.phrenic.mesh.io;

import java.nio.file.Path;
import org.phrenic.engine.math.Triangles;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.LittleEndianOutput;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;

/** Writer of binary STL. The format has single-precision coordinates; the normal of a degenerate triangle is 0. */
public final class StlWriter {
    private static final String HEADER = "binary STL, mm; written by Phrenic";
    private static final int HEADER_BYTES = 80;

    private StlWriter() {}

    /**
     * Writes the triangles of {@code mesh}.
     *
     * @throws OutputException if the file cannot be written
     * @throws IllegalArgumentException if a coordinate is not finite in single precision
     */
    public static void write(Path file, TriangleMesh mesh) {
        double[] p = mesh.positions();
        for (int i = 0; i < p.length; i++) {
            if (!Float.isFinite((float) p[i])) {
                throw new IllegalArgumentException("vertex " + i / 3 + ": found coordinate " + p[i]
                        + ", expected a number that single precision can hold");
            }
        }
        AtomicFile.write(file, stream -> {
            LittleEndianOutput out = new LittleEndianOutput(stream);
            out.text(HEADER + " ".repeat(HEADER_BYTES - HEADER.length()));
            out.int32(mesh.triangleCount());
            double[] normal = new double[3];
            int[] corners = mesh.triangles();
            for (int t = 0; t < mesh.triangleCount(); t++) {
                Triangles.normal(p, 3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2], normal);
                for (double component : normal) {
                    out.float32((float) component);
                }
                for (int c = 0; c < 3; c++) {
                    for (int axis = 0; axis < 3; axis++) {
                        out.float32((float) p[3 * corners[3 * t + c] + axis]);
                    }
                }
                out.int16(0);
            }
        });
    }
}
