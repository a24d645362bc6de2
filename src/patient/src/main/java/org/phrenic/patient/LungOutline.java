package org.phrenic.patient;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.phrenic.anatomy.Structure;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;

/**
 * The outer surface of a lung. Lobes touch at fissures, whose surfaces belong neither to the wall nor to the base of
 * the lung; of several lobes, closed or open at the fissures, the outline is the surface around all of them. Pieces
 * that lie farther apart, as with fluid between them, have an outline each.
 */
public final class LungOutline {
    /** Half of the widest gap between lobes, mm. */
    private static final double RADIUS_MM = 7.5;

    private static final double CELL_MM = 2.5;
    private static final double EDGE_MM = 6;

    private LungOutline() {}

    /** Outline of the lobes of one lung; a lung of one part is its own outline. Empty without a part. */
    public static Optional<TriangleMesh> of(Stream<Structure> lobes) {
        return of(lobes.map(Structure::mesh).toList());
    }

    /** Outline of the surfaces of the lobes of one lung, as above. */
    public static Optional<TriangleMesh> of(List<TriangleMesh> parts) {
        if (parts.size() < 2) {
            return parts.stream().findFirst();
        }
        SurfaceEnvelope envelope = new SurfaceEnvelope(MeshMerge.merge(parts).bounds(), RADIUS_MM, CELL_MM);
        envelope.mark(parts);
        TriangleMesh outer = envelope.closedParts(RADIUS_MM, 0, EDGE_MM);
        // The outermost cells have their centres on the surface, so that their border lies half a cell outside it.
        double[] normals = MeshMeasure.vertexNormals(outer);
        double[] p = outer.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] -= CELL_MM / 2 * normals[i];
        }
        return Optional.of(outer.withPositions(p));
    }
}
