package org.phrenic.anatomy.virtual;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.Vectors;

/** Centre lines of ribs and costal cartilages along the chest wall, and the middle line of the sternum. */
@SuppressWarnings("ArrayRecordComponent") // read only
record RibCageCourses(
        VirtualThoraxParameters parameters,
        Spine spine,
        ChestWallShape wall,
        VertebraShape[] vertebrae,
        SternumShape sternum) {
    /** Gap between the inner chest wall and the bones on it, mm: pleura and fascia. */
    private static final double CLEARANCE_MM = 0.6;
    /** Overlap of adjoining parts, mm. */
    static final double OVERLAP_MM = 0.4;

    private static final int PUSHES = 3;
    private static final int SMOOTHING_PASSES = 6;

    /** Centre line of a rib from its head to its anterior end. */
    Polyline ribCourse(int level, Side side) {
        int sign = side.sign();
        VertebraShape vertebra = vertebrae[level - 1];
        double path = spine.bodyPath(level);
        ImmutableDoubleArray height = parameters.spine().bodyHeightMm();
        double up = level >= 2 && level <= 9 ? 0.40 : level == 1 ? 0.2 : 0.15;
        double depth = parameters.spine().bodyDepthMm().at(level - 1);
        double width = parameters.spine().bodyWidthMm().at(level - 1);
        double[] tip = vertebra.transverseTip(sign);
        double[] tubercle = Vectors.addScaled(tip, Vectors.of(sign * 2.0, -9.5, 1.0), 1);

        double[] inward = spine.local(path, sign * 0.6 * width / 2, depth * 0.15, up * height.at(level - 1));
        double[] head = vertebra.fromInside(inward, Vectors.normalize(Vectors.subtract(tubercle, inward)), -OVERLAP_MM);

        double arc = parameters.ribs().arcMm().at(level - 1)
                * (side == Side.LEFT ? parameters.ribs().leftArcFactor() : 1);
        double offset = CLEARANCE_MM + parameters.ribs().thicknessMm() / 2;
        double headAzimuth = Math.abs(wall.azimuth(head));
        double tubercleAzimuth = Math.abs(wall.azimuth(tubercle));
        double nominalZ = head[2] - 30;
        double reach = wall.frontY(nominalZ) * -0.5 + 45;
        double pump =
                StrictMath.tan(StrictMath.toRadians(parameters.ribs().pumpDeg().at(level - 1)));
        double bucket = StrictMath.tan(
                        StrictMath.toRadians(parameters.ribs().bucketDeg().at(level - 1)))
                * wall.halfBreadth(nominalZ);
        List<double[]> knots = new ArrayList<>();
        knots.add(head);
        boolean floating = level >= 11;
        if (!floating) {
            knots.add(Vectors.addScaled(Vectors.lerp(head, tubercle, 0.5), Vectors.of(0, 0, 1), 1));
            knots.add(tubercle);
        }
        double end = Math.PI * 0.985;
        double first = floating ? headAzimuth + StrictMath.toRadians(16) : tubercleAzimuth + StrictMath.toRadians(9);
        int steps = 60;
        for (int i = 0; i <= steps; i++) {
            double azimuth = first + (end - first) * i / steps;
            double drop = pump * reach * (StrictMath.cos(headAzimuth) - StrictMath.cos(azimuth))
                    + bucket * SmoothBlends.smoothstep((azimuth - headAzimuth) / (Math.PI * 0.33));
            knots.add(
                    wall.boneBed(sign * azimuth, (floating ? head[2] : Math.min(tubercle[2], head[2])) - drop, offset));
        }
        Polyline whole = pushOutside(Polyline.catmullRom(knots, 6), offset);
        return whole.resample(0, Math.min(arc, whole.length()), 120);
    }

    /** Pushes a curve away from the wall to at least {@code offset} and smooths it; its ends are fixed. */
    private Polyline pushOutside(Polyline course, double offset) {
        int n = (int) Math.ceil(course.length() / 2);
        double[][] points = new double[n + 1][];
        for (int i = 0; i <= n; i++) {
            points[i] = course.pointAt(course.length() * i / n);
        }
        for (int round = 0; round < PUSHES; round++) {
            for (int i = 1; i < n; i++) {
                double missing = offset * SmoothBlends.smoothstep(i * 2 / 12.0) - wallOffset(points[i]);
                points[i] = missing > 0 ? Vectors.addScaled(points[i], wall.normal(points[i]), missing) : points[i];
            }
            for (int pass = 0; pass < SMOOTHING_PASSES; pass++) {
                for (int i = 1; i < n; i++) {
                    points[i] = Vectors.lerp(points[i], Vectors.lerp(points[i - 1], points[i + 1], 0.5), 0.6);
                }
            }
        }
        return new Polyline(List.of(points));
    }

    /** Centre line of a costal cartilage 1-7 from its rib to the sternum. */
    Polyline trueCartilage(int level, Side side, Polyline rib) {
        double[] notch = sternum.edge(parameters.sternum().notchFraction().at(level - 1), side.sign());
        double[] end = Vectors.addScaled(notch, Vectors.of(side.sign(), 0, 0), -0.5);
        return alongWall(rib, end, side, StrictMath.toRadians(level <= 2 ? 5 : 12 + 6 * (level - 3)));
    }

    /** Centre line of a cartilage 8-10 from its rib to the cartilage above. */
    Polyline falseCartilage(int level, Side side, Polyline rib, Polyline above) {
        double path = parameters.cartilages().joinFraction().at(level - 8) * above.length();
        double[] on = above.pointAt(path);
        double[] along = above.direction(path);
        double[] out = wall.normal(on);
        double[] below = Vectors.cross(out, along);
        if (below[2] > 0) {
            below = Vectors.of(-below[0], -below[1], -below[2]);
        }
        double apart = parameters.cartilages().heightMm() / 2 - 1.5;
        return alongWall(rib, Vectors.addScaled(on, Vectors.normalize(below), apart), side, StrictMath.toRadians(40));
    }

    /**
     * Smooth curve on the wall from a rib's end to a point; {@code rise} is its final angle (rad) above the horizontal.
     */
    private Polyline alongWall(Polyline rib, double[] end, Side side, double rise) {
        double overlap = OVERLAP_MM;
        double[] start = Vectors.addScaled(rib.last(), rib.direction(rib.length()), -overlap);
        double[] before = rib.pointAt(rib.length() - 6);
        double from = Math.abs(wall.azimuth(start));
        double to = Math.abs(wall.azimuth(end));
        double radius = Vectors.length(Vectors.of(end[0] - start[0], end[1] - start[1], 0))
                / Math.max(Math.abs(to - from), 0.05);
        double span = Vectors.distance(start, end);
        double ribAzimuth = (from - Math.abs(wall.azimuth(before))) * radius / 6;
        double ribDrop = (start[2] - before[2]) / 6;
        double offsetFrom = wallOffset(start);
        double offsetTo = wallOffset(end);
        double endAzimuth = StrictMath.cos(rise);
        double endRise = StrictMath.sin(rise);
        int n = 24;
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i <= n; i++) {
            double u = (double) i / n;
            double v = 1 - u;
            double h = u * u * (3 - 2 * u);
            double azimuth = from + (to - from) * h + span / radius * (ribAzimuth * u * v * v - endAzimuth * u * u * v);
            double z = start[2] + (end[2] - start[2]) * h + span * (ribDrop * u * v * v - endRise * u * u * v);
            points.add(wall.boneBed(side.sign() * azimuth, z, offsetFrom + (offsetTo - offsetFrom) * h));
        }
        points.set(0, start);
        points.set(n, end);
        return Polyline.catmullRom(points, 3);
    }

    private double wallOffset(double[] p) {
        return wall.at(p) / Vectors.length(wall.gradient(p));
    }
}
