package org.phrenic.access;

import java.util.stream.IntStream;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The costal groove of a rib, where intercostal vein, artery and nerve run: its faces that look down. A path within
 * {@value #NEUROVASCULAR_ZONE_MM} mm counts as touching the vessels (a chosen width, not a measured one).
 */
public final class CostalGroove {
    /** Width of the zone of the vessels, mm. */
    public static final double NEUROVASCULAR_ZONE_MM = 5;

    /** Largest z component of the unit normal of a face that looks down. */
    private static final double MAX_NORMAL_Z = -0.5;

    private final MovingStructure rib;
    private final TriangleTree faces;

    CostalGroove(MovingStructure rib) {
        this.rib = rib;
        TriangleMesh mesh = rib.surface().rest();
        int[] t = mesh.triangles();
        double[] normal = new double[3];
        int[] lower = IntStream.range(0, t.length)
                .filter(c -> {
                    int k = c - c % 3;
                    double length = Triangles.cross(mesh.positions(), 3 * t[k], 3 * t[k + 1], 3 * t[k + 2], normal);
                    return normal[2] < MAX_NORMAL_Z * length;
                })
                .map(c -> t[c])
                .toArray();
        faces = new TriangleTree(new TriangleMesh(mesh.positions(), lower));
    }

    /** The rib. */
    public MovingStructure rib() {
        return rib;
    }

    /** Distance of a path from the groove, mm, at most {@code limit}. */
    public double distance(double[] from, double[] to, SegmentProbe probe, double limit) {
        if (rib.boxDistance(from, to) >= limit) {
            return limit;
        }
        rib.setProbe(from, to, probe);
        return probe.distance(faces, limit);
    }
}
