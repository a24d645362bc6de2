package org.phrenic.study.bare;

import java.nio.file.Path;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;

/**
 * The scene of the bare workload: a mesh and the roles of its vertices.
 *
 * @param mesh a particle a vertex, a spring an edge; mm
 * @param fixed vertices held still
 * @param loaded vertices that carry the load
 * @param links disjoint pairs of vertices kept at their distance, two numbers a pair; empty for none
 */
public record BareScene(TriangleMesh mesh, int[] fixed, int[] loaded, int[] links) {

    /**
     * @param mesh file of a surface
     * @param fixed file of vertex indices, one a line
     * @param loaded file of vertex indices, one a line
     * @param links file of vertex indices, two a line; null for no links
     * @throws org.phrenic.format.BadInputException if a file is not as it should be; one sentence says where and how
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
