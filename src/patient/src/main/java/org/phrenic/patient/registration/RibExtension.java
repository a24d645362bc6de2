package org.phrenic.patient.registration;

import java.util.Arrays;
import org.phrenic.anatomy.cage.RibCourse;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.Remesher;

/**
 * Gives a rib that ends short of the spine its neck and head. The posterior part of its surface is stretched along a
 * course that runs on to the head: the neck of the placed template, shifted smoothly so that it begins where the rib
 * ends. Cross-sections keep their shape.
 */
final class RibExtension {
    /** Length of the rib of the scan that is stretched, mm. */
    private static final double STRETCHED_MM = 20;

    private final TriangleMesh rib;
    private final RibCourse scan;
    private final double[] course;
    private final double[] path;
    /** Path of the scan's posterior end on the extended course, mm. */
    private final double added;

    private RibExtension(RibFit fit, TriangleMesh rib) {
        this.rib = rib;
        scan = fit.scanCourse();
        double[] neck = fit.neckCourse();
        int joint = neck.length / 3 - 1;
        int tail = (int) Math.ceil(scan.lengthMm() / 3);
        course = Arrays.copyOf(neck, neck.length + 3 * tail);
        for (int i = 1; i <= tail; i++) {
            System.arraycopy(scan.at(scan.lengthMm() * i / tail), 0, course, 3 * (joint + i), 3);
        }
        path = new double[course.length / 3];
        for (int i = 1; i < path.length; i++) {
            path[i] = path[i - 1] + Math.sqrt(Vectors.squaredDistance(course, i - 1, i));
        }
        added = path[joint];
    }

    /** The surface of the rib with neck and head. */
    static TriangleMesh extended(RibFit fit) {
        TriangleMesh rib = fit.shared().scan();
        TriangleMesh longer = new RibExtension(fit, rib).stretched();
        return Remesher.toEdgeLength(longer, MeshQuality.of(rib).meanEdgeMm());
    }

    private TriangleMesh stretched() {
        double window = Math.min(STRETCHED_MM, scan.lengthMm() / 3);
        double[] out = rib.positions().clone();
        double[] stations = scan.stations();
        for (int v = 0; v < stations.length; v++) {
            if (stations[v] * scan.lengthMm() > window + STRETCHED_MM) {
                continue;
            }
            double[] p = {rib.x(v), rib.y(v), rib.z(v)};
            double at = project(p, window + STRETCHED_MM);
            if (at >= window) {
                continue;
            }
            double to = at <= 0 ? at : at * (window + added) / window;
            double[] from = tangent(scan.at(at - 2), scan.at(at + 2));
            double[] turned = RibNeck.turned(from, tangent(at(to - 2), at(to + 2)), Vectors.subtract(p, scan.at(at)));
            double[] place = at(to);
            for (int k = 0; k < 3; k++) {
                out[3 * v + k] = place[k] + turned[k];
            }
        }
        return rib.withPositions(out);
    }

    /** Path of the scan's course nearest to a point; negative before its posterior end. */
    private double project(double[] p, double limit) {
        double best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (double s = -10; s <= limit; s += 0.5) {
            double d = Vectors.distance(scan.at(s), p);
            if (d < least) {
                least = d;
                best = s;
            }
        }
        return best;
    }

    private static double[] tangent(double[] a, double[] b) {
        return Vectors.normalize(Vectors.subtract(b, a));
    }

    private double[] at(double pathMm) {
        int i = 0;
        while (i < path.length - 2 && path[i + 1] < pathMm) {
            i++;
        }
        double t = (pathMm - path[i]) / Math.max(1e-9, path[i + 1] - path[i]);
        double[] p = new double[3];
        for (int k = 0; k < 3; k++) {
            p[k] = course[3 * i + k] + t * (course[3 * i + 3 + k] - course[3 * i + k]);
        }
        return p;
    }
}
