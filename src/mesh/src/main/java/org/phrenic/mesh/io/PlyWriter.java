package org.phrenic.mesh.io;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.LittleEndianOutput;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;

/** Writer of PLY, binary little endian, in double precision. */
public final class PlyWriter {
    private PlyWriter() {}

    /**
     * Writes {@code mesh} with values at its vertices.
     *
     * @param scalars values per vertex by property name, in output order; a name is one word other than x, y, z
     * @throws OutputException if the file cannot be written
     * @throws IllegalArgumentException if a coordinate is not finite, an array length differs from the vertex count, or
     *     a name is not valid in a PLY header
     */
    public static void write(Path file, TriangleMesh mesh, Map<String, double[]> scalars) {
        LittleEndianOutput.requireFinite(mesh.positions());
        StringBuilder header = new StringBuilder("ply\nformat binary_little_endian 1.0\ncomment mm\n");
        header.append("element vertex ").append(mesh.vertexCount()).append('\n');
        header.append("property double x\nproperty double y\nproperty double z\n");
        scalars.forEach((name, values) -> {
            if (!name.matches("[A-Za-z_][A-Za-z0-9_.-]*") || name.matches("[xyz]")) {
                throw new IllegalArgumentException("property '" + name + "', expected one word other than x, y, z");
            }
            if (values.length != mesh.vertexCount()) {
                throw new IllegalArgumentException(
                        "property '" + name + "': " + values.length + " values, expected " + mesh.vertexCount());
            }
            header.append("property double ").append(name).append('\n');
        });
        header.append("element face ").append(mesh.triangleCount()).append('\n');
        header.append("property list uchar int vertex_indices\nend_header\n");
        double[][] columns = scalars.values().toArray(double[][]::new);
        AtomicFile.write(file, stream -> {
            LittleEndianOutput out = new LittleEndianOutput(stream);
            out.text(header.toString());
            for (int v = 0; v < mesh.vertexCount(); v++) {
                out.float64(mesh.x(v));
                out.float64(mesh.y(v));
                out.float64(mesh.z(v));
                for (double[] column : columns) {
                    out.float64(column[v]);
                }
            }
            int[] corners = mesh.triangles();
            for (int t = 0; t < corners.length; t += 3) {
                out.int8(3);
                out.int32(corners[t]);
                out.int32(corners[t + 1]);
                out.int32(corners[t + 2]);
            }
        });
    }
}
