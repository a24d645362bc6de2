package org.phrenic.anatomy;

import java.nio.file.Path;
import java.util.Comparator;
import org.junit.jupiter.api.Assumptions;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.ConnectedComponents;

/** The real thorax and recorded breathing that lie beside the project on some machines. */
public final class SharedThorax {
    private static Thorax loaded;

    private SharedThorax() {}

    /** A file or folder beside the project; the test is skipped where there is none. */
    public static Path path(String name) {
        Path path = Path.of("..", "shared").resolve(name);
        Assumptions.assumeTrue(
                java.nio.file.Files.exists(path), "no " + path + " beside the project: nothing to hold against");
        return path;
    }

    /** The real male thorax, loaded once for all tests. */
    public static synchronized Thorax male() {
        Path folder = path("anatomy/male-thorax");
        if (loaded == null) {
            loaded = ThoraxFolder.load(folder);
        }
        return loaded;
    }

    /** The closed shell of the real diaphragm, the larger of two. */
    public static TriangleMesh diaphragmSheet() {
        TriangleMesh given = male().find("diaphragm").orElseThrow().mesh();
        return ConnectedComponents.of(given).stream()
                .filter(m -> new EdgeTable(m).isClosed())
                .max(Comparator.comparingInt(TriangleMesh::vertexCount))
                .orElseThrow();
    }
}
