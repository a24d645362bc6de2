package org.phrenic.mesh.io;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.InputBytes;

/**
 * The index of a time series of mesh files for ParaView (.pvd, a VTK XML Collection). File names are relative to the
 * folder of the index, so the folder can be moved as a whole.
 */
public final class PvdSeries {
    private static final Pattern FILE = Pattern.compile("<DataSet [^>]*file=\"([^\"]*)\"");

    private final Path index;
    private final List<String> entries = new ArrayList<>();

    /**
     * Creates a series without entries; writes no file.
     *
     * @param index the .pvd file to be written
     */
    public PvdSeries(Path index) {
        this.index = index;
    }

    /**
     * The mesh files that an index names, with the folder of the index before their names; none where there is no
     * index, or another file has its name.
     */
    public static List<Path> files(Path index) {
        if (!Files.isRegularFile(index)) {
            return List.of();
        }
        List<Path> files = new ArrayList<>();
        Matcher names = FILE.matcher(new String(InputBytes.read(index), StandardCharsets.UTF_8));
        while (names.find()) {
            files.add(index.resolveSibling(VtpWriter.unescape(names.group(1))));
        }
        return files;
    }

    /** Adds one mesh at one time. */
    public void add(double time_s, Path file) {
        add(time_s, 0, file);
    }

    /**
     * Adds one of several meshes at one time.
     *
     * @param part number of the structure, the same at every time
     */
    public void add(double time_s, int part, Path file) {
        if (!Double.isFinite(time_s)) {
            throw new IllegalArgumentException("time_s: found " + time_s + ", expected a finite number");
        }
        Path folder = index.toAbsolutePath().normalize().getParent();
        String relative =
                folder.relativize(file.toAbsolutePath().normalize()).toString().replace('\\', '/');
        entries.add("<DataSet timestep=\"" + time_s + "\" group=\"\" part=\"" + part + "\" file=\""
                + VtpWriter.escape(relative) + "\"/>");
    }

    /** Writes the index with all entries so far; may be called repeatedly. */
    public void write() {
        StringBuilder xml = new StringBuilder(
                """
                <?xml version="1.0"?>
                <VTKFile type="Collection" version="0.1" byte_order="LittleEndian">
                <Collection>
                """);
        entries.forEach(entry -> xml.append(entry).append('\n'));
        AtomicFile.write(index, xml.append("</Collection>\n</VTKFile>\n").toString());
    }
}
