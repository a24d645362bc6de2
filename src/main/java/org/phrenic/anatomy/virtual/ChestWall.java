package org.phrenic.anatomy.virtual;

import java.util.List;

/**
 * The inner surface of the chest and upper belly wall: what lungs and diaphragm lie against, and what ribs, cartilages and
 * sternum lie outside of. In each horizontal plane it is a closed curve about the body's axis,
 *
 * <p>{@code r(azimuth) = (|sin/a|^n + |cos/b|^n)^(-1/n)},
 *
 * <p>half-breadth a, depth b to the front or back, with a squarer back than front; around the spine the curve comes forward to
 * the front of the vertebral bodies, and so forms the gutter beside them. Breadth and depths go smoothly with height.
 */
final class ChestWall implements Axis, Field {
    /** Between wall and vertebral bodies, mm: ligament and fat. */
    private static final double SPINE_COVER_MM = 3;
    /** Half-width of the flat in front of the vertebral bodies, mm. */
    private static final double SPINE_FLAT_MM = 10;

    private final Spine spine;
    private final double axisFraction;
    private final double exponentFront;
    private final double exponentBack;
    private final double leftFactor;
    private final Curve halfBreadth;
    private final Curve front;
    private final Curve back;
    private final Curve gutter;

    ChestWall(VirtualThoraxParameters.ChestWall measures, Spine spine) {
        this.spine = spine;
        axisFraction = measures.axisFraction();
        exponentFront = measures.exponentFront();
        exponentBack = measures.exponentBack();
        leftFactor = measures.leftBreadthFactor();
        List<double[]> rows = measures.sections();
        double[] z = column(rows, 0);
        halfBreadth = new Curve(z, column(rows, 1));
        front = new Curve(z, column(rows, 2));
        back = new Curve(z, column(rows, 3));
        gutter = new Curve(z, column(rows, 4));
    }

    private static double[] column(List<double[]> rows, int index) {
        return rows.stream().mapToDouble(row -> row[index]).toArray();
    }

    @Override
    public double x(double z) {
        return 0;
    }

    @Override
    public double y(double z) {
        return axisFraction * front.at(z) + (1 - axisFraction) * spineFront(z);
    }

    private double spineFront(double z) {
        return spine.frontY(z) - SPINE_COVER_MM;
    }

    double frontY(double z) {
        return front.at(z);
    }

    double halfBreadth(double z) {
        return halfBreadth.at(z);
    }

    /** Distance from the axis to the wall at this azimuth (rad) and height, mm. */
    double radius(double azimuth, double z) {
        return radius(StrictMath.sin(azimuth), StrictMath.cos(azimuth), z);
    }

    private double radius(double sin, double cos, double z) {
        double frontY = front.at(z);
        double spineY = spineFront(z);
        double axisY = axisFraction * frontY + (1 - axisFraction) * spineY;
        double a = Math.max(halfBreadth.at(z) * (sin > 0 ? leftFactor : 1), 2);
        double b = Math.max(cos > 0 ? back.at(z) - axisY : axisY - frontY, 2);
        double n = exponentFront + (exponentBack - exponentFront) * V3.smoothstep((cos + 0.5) / 1.0);
        double radius =
                StrictMath.pow(StrictMath.pow(Math.abs(sin) / a, n) + StrictMath.pow(Math.abs(cos) / b, n), -1 / n);
        if (cos < 0) {
            return radius;
        }
        double toSpine = spineY - axisY;
        double inner = StrictMath.atan2(SPINE_FLAT_MM, toSpine);
        double outer = inner + StrictMath.toRadians(gutter.at(z));
        double away = StrictMath.atan2(Math.abs(sin), cos);
        if (away >= outer) {
            return radius;
        }
        return radius + (Math.min(toSpine, radius) - radius) * (1 - V3.smoothstep((away - inner) / (outer - inner)));
    }

    /** Azimuth of a point about the axis, rad. */
    double azimuth(double[] p) {
        return StrictMath.atan2(p[0], p[1] - y(p[2]));
    }

    /** Distance to the wall along the horizontal, negative inside, mm. */
    @Override
    public double at(double x, double y, double z) {
        double dy = y - y(z);
        double distance = Math.sqrt(x * x + dy * dy);
        return distance < 1e-9 ? -radius(0, 1, z) : distance - radius(x / distance, dy / distance, z);
    }

    /** The point of the wall at this azimuth and height, moved {@code outward} mm along the wall's normal. */
    double[] surface(double azimuth, double z, double outward) {
        double[] p = point(azimuth, radius(azimuth, z), z);
        return outward == 0 ? p : V3.add(p, normal(p), outward);
    }
}
