package org.phrenic.mesh.io;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.mesh.TriangleMesh;

/**
 * Reads and writes surface files. The extension, in upper or lower case, gives the format. Units and axes are not
 * converted.
 */
public final class MeshFiles {
    /** Extensions of the formats that can be read. */
    public static final List<String> READABLE = List.of("stl", "obj", "ply", "vtk", "vtp");

    /** Extensions of the formats that can be written. */
    public static final List<String> WRITABLE = List.of("stl", "ply", "vtp");

    private MeshFiles() {}

    /** Whether {@code file} has a mesh file extension; the file need not exist. */
    public static boolean isMesh(Path file) {
        return READABLE.contains(extension(file));
    }

    /**
     * Reads a surface. Polygons and strips are triangulated in file order. Corners of an STL file with the same
     * coordinates become one vertex. Unused vertices and degenerate triangles are kept.
     *
     * @throws BadInputException if the file cannot be read, has another format, is truncated or damaged, has
     *     coordinates that are not finite or indices out of range, or has no triangle
     */
    public static TriangleMesh read(Path file) {
        String extension = extension(file);
        if (!READABLE.contains(extension)) {
            throw new BadInputException(file + ": found extension " + Numbers.quote(extension) + ", expected one of "
                    + String.join(", ", READABLE));
        }
        byte[] bytes = InputBytes.read(file);
        String name = file.toString();
        return switch (extension) {
            case "stl" -> StlReader.read(name, bytes);
            case "obj" -> ObjReader.read(name, bytes);
            case "ply" -> PlyReader.read(name, bytes);
            case "vtk" -> VtkReader.read(name, bytes);
            default -> VtpReader.read(name, bytes);
        };
    }

    /**
     * Writes a surface as STL (binary), PLY (binary, little endian) or VTP (appended raw), by the extension.
     *
     * @throws BadInputException if the extension is not in {@link #WRITABLE}
     * @throws OutputException if the file cannot be written
     */
    public static void write(Path file, TriangleMesh mesh) {
        switch (extension(file)) {
            case "stl" -> StlWriter.write(file, mesh);
            case "ply" -> PlyWriter.write(file, mesh, Map.of());
            case "vtp" -> VtpWriter.write(file, mesh, Map.of());
            default ->
                throw new BadInputException(file + ": found extension " + Numbers.quote(extension(file))
                        + ", expected one of " + String.join(", ", WRITABLE));
        }
    }

    private static String extension(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot + 1).toLowerCase(Locale.ROOT);
    }
}
