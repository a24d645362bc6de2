package org.phrenic.scene;

import java.awt.geom.Path2D;
import java.util.Optional;
import org.phrenic.access.plan.ProbeState;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.mesh.RingStack;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.surface.Markers;
import org.phrenic.simulation.observe.Surface;

/** The ultrasound probe in a scene: its housing, and the outline of its image plane. */
public final class ProbeMarker {
    static final String HOUSING = Markers.PREFIX + "probe";
    static final String MARK = Markers.PREFIX + "probe_mark";
    static final int HOUSING_RGB = 0xe9ebee;
    static final int MARK_RGB = 0x2f86d6;

    private static final double MARK_MM = 3;
    /** Where the marker is on the housing: lateral and axial, mm. */
    private static final double[] MARK_AT = {25, -34};

    private static final int SEGMENTS = 32;
    private static final int ARC_POINTS = 16;
    /** Rings of the housing: half width, half thickness, axial place, share of the face's curve. */
    private static final double[][] RINGS = {
        {16, 5, 0, 1},
        {30, 9, 0, 1},
        {31, 11, -10, 0.7},
        {28, 11, -26, 0.2},
        {17, 11, -46, 0},
        {15, 11, -70, 0},
        {15, 11, -112, 0},
        {9, 7, -118, 0}
    };

    private ProbeMarker() {}

    static Surface housing() {
        return Markers.movingShape(HOUSING, housingMesh());
    }

    static Surface mark() {
        return Markers.movingBall(MARK);
    }

    /** The housing is symmetric in elevation: its third axis is the one that makes the axes right-handed. */
    static float[] housingPose(ProbePose pose) {
        return Markers.shapePose(
                pose.face(), pose.lateral(), pose.axial(), Vectors.cross(pose.lateral(), pose.axial()));
    }

    static float[] markPose(ProbePose pose) {
        return Markers.ballPose(pose.toWorld(MARK_AT[0], MARK_AT[1], 0), MARK_MM);
    }

    /** Lateral, axial and elevation coordinates from the middle of the face. */
    private static TriangleMesh housingMesh() {
        int rings = RINGS.length;
        double[] p = new double[3 * (rings * SEGMENTS + 2)];
        double radius = CurvilinearProbe.abdominal().radiusMm();
        for (int r = 0; r < rings; r++) {
            for (int k = 0; k < SEGMENTS; k++) {
                double angle = 2 * Math.PI * k / SEGMENTS;
                double x = RINGS[r][0] * rounded(StrictMath.cos(angle));
                double curve = Math.sqrt(radius * radius - x * x) - radius;
                int v = 3 * (r * SEGMENTS + k);
                p[v] = x;
                p[v + 1] = RINGS[r][2] + RINGS[r][3] * curve;
                p[v + 2] = RINGS[r][1] * rounded(StrictMath.sin(angle));
            }
        }
        int face = rings * SEGMENTS;
        p[3 * face + 4] = RINGS[rings - 1][2];
        return RingStack.mesh(p, SEGMENTS);
    }

    /** Between a circle and a square. */
    private static double rounded(double unit) {
        return Math.signum(unit) * Math.sqrt(Math.abs(unit));
    }

    /** Outline of the image plane as a camera sees it, pixels; empty if it is not all before the camera. */
    static Optional<Path2D> outline(ProbeState probe, Camera camera, int width, int height) {
        CurvilinearProbe shape = CurvilinearProbe.abdominal();
        double half = StrictMath.toRadians(0.5 * shape.sectorDeg());
        double far = shape.radiusMm() + probe.hold().settings().depthMm();
        Path2D path = new Path2D.Double();
        for (int i = 0; i <= 2 * ARC_POINTS + 1; i++) {
            boolean back = i > ARC_POINTS;
            double share = (back ? 2 * ARC_POINTS + 1 - i : i) / (double) ARC_POINTS;
            double angle = half * (2 * share - 1);
            double range = back ? far : shape.radiusMm();
            double[] at = probe.pose()
                    .toWorld(range * StrictMath.sin(angle), range * StrictMath.cos(angle) - shape.radiusMm(), 0);
            double[] xy = new double[2];
            if (!camera.project(at[0], at[1], at[2], width, height, xy)) {
                return Optional.empty();
            }
            if (i == 0) {
                path.moveTo(xy[0], xy[1]);
            } else {
                path.lineTo(xy[0], xy[1]);
            }
        }
        path.closePath();
        return Optional.of(path);
    }

    /** Distance of a pixel from the housing as a camera sees it, pixels; infinite if it is not before the camera. */
    public static double distancePx(ProbePose pose, Camera camera, int width, int height, double x, double y) {
        double[] a = new double[2];
        double[] b = new double[2];
        double[] face = pose.face();
        double[] end = Vectors.addScaled(face, pose.axial(), RINGS[RINGS.length - 1][2]);
        if (!camera.project(face[0], face[1], face[2], width, height, a)
                || !camera.project(end[0], end[1], end[2], width, height, b)) {
            return Double.POSITIVE_INFINITY;
        }
        return java.awt.geom.Line2D.ptSegDist(a[0], a[1], b[0], b[1], x, y);
    }
}
