package org.phrenic.access;

import java.util.stream.IntStream;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The costal groove of a rib, which holds the intercostal vein, artery and nerve. It is approximated by the downward
 * facing faces of the rib. A path closer than {@value #NEUROVASCULAR_ZONE_MM} mm counts as touching the vessels. This
 * width is chosen, not measured.
 */
public final class CostalGroove {
    /** Width of the zone around the groove that counts as vessels, mm. */
    public static final double NEUROVASCULAR_ZONE_MM = 5;

    /** A face is downward facing if the z component of its unit normal is less than this value. */
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

    /** The rib that the groove belongs to. */
    public MovingStructure rib() {
        return rib;
    }

    /** Distance from a path to the groove, mm, at most {@code limit}. */
    public double distance(double[] from, double[] to, SegmentProbe probe, double limit) {
        if (rib.boxDistance(from, to) >= limit) {
            return limit;
        }
        rib.setProbe(from, to, probe);
        return probe.distance(faces, limit);
    }
}
