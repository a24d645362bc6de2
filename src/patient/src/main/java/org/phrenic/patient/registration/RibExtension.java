package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.Remesher;

/**
 * Gives a rib that ends short of the spine its neck and head. The posterior part of its surface is stretched along a
 * course that runs on to the head. Cross-sections keep their shape.
 */
final class RibExtension {
    /** Length of the rib of the scan that is stretched, mm. */
    private static final double STRETCHED_MM = 20;
    /** Length of the rib whose middle line is that of the stump, mm; from there it bends to that of the rib. */
    private static final double STRAIGHT_MM = 12;

    /** Length of the scan's middle line, from its posterior end, onto which vertices are projected, mm. */
    private static final double TAIL_MM = 60;
    /** Distance of the first whole section from the end, which may be oblique or hollow; it becomes the head, mm. */
    private static final double SECTION_MM = 4;
    /** Tip of a head beyond its middle, mm. */
    private static final double TIP_MM = 2.5;

    private final TriangleMesh rib;
    private final RibFit fit;
    private final double window;
    /** Middle line of the scan's rib from its posterior end. */
    private final Polyline course;
    /** The same line, with the neck before it. */
    private final Polyline extended;

    private final double added;

    private RibExtension(RibFit fit, TriangleMesh rib) {
        this.rib = rib;
        this.fit = fit;
        double length = fit.scanCourse().lengthMm();
        window = Math.min(STRETCHED_MM, length / 3);
        List<double[]> points = new ArrayList<>();
        RibStump stump = fit.stump();
        for (double s = 0; s <= Math.min(TAIL_MM, length); s += 1) {
            double share = Math.max(0, Math.min(1, (s - STRAIGHT_MM) / STRAIGHT_MM));
            double[] straight = Vectors.addScaled(stump.end(), stump.direction(), s);
            points.add(Vectors.lerp(straight, fit.scanCourse().at(s), share));
        }
        course = new Polyline(points);
        Polyline neck = Polyline.of(fit.neckCourse());
        added = neck.length();
        List<double[]> all = new ArrayList<>();
        for (int i = 0; i < added; i++) {
            all.add(neck.pointAt(i));
        }
        all.addAll(points);
        extended = new Polyline(all);
    }

    /** The surface of the rib with neck and head. */
    static TriangleMesh extended(RibFit fit) {
        TriangleMesh rib = fit.shared().scan();
        TriangleMesh longer = new RibExtension(fit, rib).stretched();
        return Remesher.toEdgeLength(longer, MeshQuality.of(rib).meanEdgeMm());
    }

    private TriangleMesh stretched() {
        double[] out = rib.positions().clone();
        double[] stations = fit.scanCourse().stations();
        for (int v = 0; v < stations.length; v++) {
            if (stations[v] * fit.scanCourse().lengthMm() > window + STRETCHED_MM) {
                continue;
            }
            double[] p = {rib.x(v), rib.y(v), rib.z(v)};
            double at = project(p);
            if (at >= window) {
                continue;
            }
            double to = at > SECTION_MM
                    ? (at - SECTION_MM) * (window + added) / (window - SECTION_MM)
                    : -TIP_MM * (1 - StrictMath.exp((at - SECTION_MM) / TIP_MM));
            double[] turned =
                    RibNeck.turned(tangent(course, at), tangent(extended, to), Vectors.subtract(p, course.pointAt(at)));
            System.arraycopy(Vectors.addScaled(extended.pointAt(to), turned, roundness(to)), 0, out, 3 * v, 3);
        }
        return rib.withPositions(out);
    }

    /** Factor on the radius of a cross-section near the tip of the head, which is round. */
    private static double roundness(double path) {
        double toMiddle = Math.max(0, TIP_MM - path) / (2 * TIP_MM);
        return Math.max(0.2, Math.sqrt(Math.max(0, 1 - toMiddle * toMiddle)));
    }

    /** Path of the course nearest to a point; negative before its posterior end. */
    private double project(double[] p) {
        double best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (double s = -10; s <= window + STRETCHED_MM; s += 0.5) {
            double d = Vectors.distance(course.pointAt(s), p);
            if (d < least) {
                least = d;
                best = s;
            }
        }
        return best;
    }

    private static double[] tangent(Polyline line, double at) {
        return Vectors.normalize(Vectors.subtract(line.pointAt(at + 2), line.pointAt(at - 2)));
    }
}
