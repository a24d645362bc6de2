package org.phrenic.mesh.io;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.LittleEndianOutput;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;

/**
 * Writer of VTK XML PolyData for ParaView and other VTK programs: one piece in double precision. Arrays are appended as
 * raw little-endian bytes with 64-bit lengths.
 */
public final class VtpWriter {
    private VtpWriter() {}

    /**
     * Writes {@code mesh} with values at its vertices.
     *
     * @param pointData values per vertex by name, in output order; the length is the vertex count (scalars) or three
     *     times it (vectors, x y z in turn), and NaN is a missing value
     * @throws OutputException if the file cannot be written
     * @throws IllegalArgumentException if a coordinate is not finite or an array has another length
     */
    public static void write(Path file, TriangleMesh mesh, Map<String, double[]> pointData) {
        LittleEndianOutput.requireFinite(mesh.positions());
        int vertices = mesh.vertexCount();
        int triangles = mesh.triangleCount();
        StringBuilder xml = new StringBuilder("<?xml version=\"1.0\"?>\n"
                + "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                + "<PolyData>\n<Piece NumberOfPoints=\"" + vertices + "\" NumberOfVerts=\"0\" NumberOfLines=\"0\""
                + " NumberOfStrips=\"0\" NumberOfPolys=\"" + triangles + "\">\n<Points>\n");
        long offset = array(xml, "Points", "Float64", 3, 0, 24L * vertices);
        xml.append("</Points>\n<Polys>\n");
        offset = array(xml, "connectivity", "Int32", 1, offset, 12L * triangles);
        offset = array(xml, "offsets", "Int32", 1, offset, 4L * triangles);
        xml.append("</Polys>\n<PointData>\n");
        for (Map.Entry<String, double[]> entry : pointData.entrySet()) {
            int length = entry.getValue().length;
            if (length != vertices && length != 3L * vertices) {
                throw new IllegalArgumentException("array '" + entry.getKey() + "': " + length + " values, expected "
                        + vertices + " or " + 3L * vertices);
            }
            offset = array(xml, entry.getKey(), "Float64", length == vertices ? 1 : 3, offset, 8L * length);
        }
        xml.append("</PointData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
        AtomicFile.write(file, stream -> {
            LittleEndianOutput out = new LittleEndianOutput(stream);
            out.text(xml.toString());
            out.int64(24L * vertices);
            out.float64(mesh.positions());
            out.int64(12L * triangles);
            for (int corner : mesh.triangles()) {
                out.int32(corner);
            }
            out.int64(4L * triangles);
            for (int t = 1; t <= triangles; t++) {
                out.int32(3 * t);
            }
            for (double[] values : pointData.values()) {
                out.int64(8L * values.length);
                out.float64(values);
            }
            out.text("\n</AppendedData>\n</VTKFile>\n");
        });
    }

    private static long array(StringBuilder xml, String name, String type, int components, long offset, long bytes) {
        xml.append("<DataArray type=\"").append(type);
        xml.append("\" Name=\"").append(escape(name));
        xml.append("\" NumberOfComponents=\"").append(components);
        xml.append("\" format=\"appended\" offset=\"").append(offset).append("\"/>\n");
        return offset + 8 + bytes;
    }

    /** Escapes {@code text} for an XML attribute in double quotes. */
    static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** The text of XML without its five entities, such as {@link #escape} was given. */
    public static String unescape(String escaped) {
        return escaped.replace("&apos;", "'")
                .replace("&quot;", "\"")
                .replace("&gt;", ">")
                .replace("&lt;", "<")
                .replace("&amp;", "&");
    }
}
