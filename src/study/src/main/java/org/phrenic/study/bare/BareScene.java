package org.phrenic.study.bare;

import java.nio.file.Path;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/**
 * Scene of the bare workload: a mesh and the roles of its vertices.
 *
 * @param mesh one particle per vertex, one spring per edge; mm
 * @param fixed vertices held still
 * @param loaded vertices that carry the load
 * @param links disjoint vertex pairs kept at constant distance, two indices per pair; empty for none
 */
public record BareScene(TriangleMesh mesh, int[] fixed, int[] loaded, int[] links) {

    /**
     * @param mesh file of a surface
     * @param fixed file of vertex indices, one per line
     * @param loaded file of vertex indices, one per line
     * @param links file of vertex indices, two per line; null for no links
     * @throws org.phrenic.file.BadInputException with one sentence, if a file is invalid
     */
    public static BareScene read(Path mesh, Path fixed, Path loaded, Path links) {
        TriangleMesh surface = MeshFiles.read(mesh);
        int n = surface.vertexCount();
        return new BareScene(
                surface,
                VertexIndexFile.vertices(fixed, n),
                VertexIndexFile.vertices(loaded, n),
                links == null ? new int[0] : VertexIndexFile.pairs(links, n));
    }
}
