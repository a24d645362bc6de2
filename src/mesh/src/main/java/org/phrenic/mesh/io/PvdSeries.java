package org.phrenic.mesh.io;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.file.AtomicFile;

/**
 * The index of a time series of mesh files for ParaView (.pvd, a VTK XML Collection). File names are relative to the
 * folder of the index, so the folder can be moved as a whole.
 */
public final class PvdSeries {
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
