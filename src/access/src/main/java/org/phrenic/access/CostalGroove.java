package org.phrenic.access;

import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The lower border of a rib: those of its faces that look down. Intercostal vein, artery and nerve run in the groove
 * there, so a needle goes over the upper border of the rib below; within {@value #NEUROVASCULAR_ZONE_MM} mm of the
 * border counts as the zone of the vessels (a chosen width, not a measured one).
 */
public final class CostalGroove {
    /** Width of the zone, mm. */
    public static final double NEUROVASCULAR_ZONE_MM = 5;

    /** A face looks down where the upward part of its unit normal is less than this. */
    private static final double DOWN = -0.5;

    private final MovingStructure rib;
    private final TriangleTree faces;

    CostalGroove(MovingStructure rib) {
        this.rib = rib;
        faces = new TriangleTree(lowerFaces(rib.surface().rest()));
    }

    private static TriangleMesh lowerFaces(TriangleMesh mesh) {
        int[] t = mesh.triangles();
        int[] kept = new int[t.length];
        int count = 0;
        double[] normal = new double[3];
        for (int k = 0; k < t.length; k += 3) {
            double length = Triangles.cross(mesh.positions(), 3 * t[k], 3 * t[k + 1], 3 * t[k + 2], normal);
            if (normal[2] < DOWN * length) {
                System.arraycopy(t, k, kept, count, 3);
                count += 3;
            }
        }
        return new TriangleMesh(mesh.positions(), java.util.Arrays.copyOf(kept, count));
    }

    public MovingStructure rib() {
        return rib;
    }

    /** Distance of a path from the border, mm, no more than {@code limit}. */
    public double distance(double[] from, double[] to, SegmentProbe probe, double limit) {
        if (rib.boxDistance(from, to) >= limit) {
            return limit;
        }
        rib.setProbe(from, to, probe);
        return probe.distance(faces, limit);
    }
}
