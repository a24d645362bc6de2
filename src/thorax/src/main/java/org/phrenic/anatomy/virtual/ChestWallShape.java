package org.phrenic.anatomy.virtual;

import java.util.List;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.SuperellipseTable;
import org.phrenic.anatomy.virtual.shape.VerticalAxis;
import org.phrenic.mesh.Vectors;

/**
 * The inner surface of the chest wall and the upper abdominal wall. Lungs and diaphragm lie inside it; ribs, cartilages
 * and sternum lie outside. Its horizontal section is a superellipse about the axis of the body,
 *
 * <p>{@code r(azimuth) = (|sin/a|^n + |cos/b|^n)^(-1/n)},
 *
 * <p>with half-breadth a and depth b to the front or back; the exponent n differs between front and back. At the spine
 * the section bends forward to the front of the vertebral bodies, which forms the paravertebral gutters. The measures
 * vary smoothly with height.
 */
final class ChestWallShape implements VerticalAxis, ImplicitSurface {
    /** Distance from the vertebral bodies to the wall, mm: ligament and fat. */
    private static final double SPINE_COVER_MM = 3;
    /** Half-breadth of the flat part in front of the vertebral bodies, as a fraction of theirs. */
    private static final double SPINE_FLAT = 0.5;

    private static final double LOW_MM = -160;
    private static final double HIGH_MM = 320;
    private static final double STEP_MM = 0.25;

    private final double exponentFront;
    private final double exponentBack;
    private final SuperellipseTable powers;
    private final double leftFactor;
    /** Measures of the section at heights {@code LOW_MM + i * STEP_MM}: see {@link Section}. */
    private final double[][] table;

    ChestWallShape(VirtualThoraxParameters.ChestWall measures, Spine spine) {
        double axisFraction = measures.axisFraction();
        exponentFront = measures.exponentFront();
        exponentBack = measures.exponentBack();
        powers = new SuperellipseTable(Math.min(exponentFront, exponentBack), Math.max(exponentFront, exponentBack));
        leftFactor = measures.leftBreadthFactor();
        List<ImmutableDoubleArray> rows = measures.sections();
        double[] z = column(rows, 0);
        ProfileCurve halfBreadth = new ProfileCurve(z, column(rows, 1));
        ProfileCurve front = new ProfileCurve(z, column(rows, 2));
        ProfileCurve back = new ProfileCurve(z, column(rows, 3));
        ProfileCurve gutter = new ProfileCurve(z, column(rows, 4));
        int count = (int) ((HIGH_MM - LOW_MM) / STEP_MM) + 1;
        table = new double[count][];
        for (int i = 0; i < count; i++) {
            double height = LOW_MM + i * STEP_MM;
            double spineY = spine.frontY(height) - SPINE_COVER_MM;
            double axisY = axisFraction * front.at(height) + (1 - axisFraction) * spineY;
            table[i] = new double[] {
                axisY,
                Math.max(axisY - front.at(height), 2),
                Math.max(back.at(height) - axisY, 2),
                Math.max(halfBreadth.at(height), 2),
                spineY - axisY,
                StrictMath.atan2(SPINE_FLAT * spine.halfWidth(height), spineY - axisY),
                StrictMath.toRadians(gutter.at(height))
            };
        }
    }

    /** A column of a table of measures. */
    static double[] column(List<ImmutableDoubleArray> rows, int index) {
        return rows.stream().mapToDouble(row -> row.at(index)).toArray();
    }

    @Override
    public double x(double z) {
        return 0;
    }

    @Override
    public double y(double z) {
        double at = tableRow(z);
        int low = (int) at;
        return table[low][0] + (at - low) * (table[low + 1][0] - table[low][0]);
    }

    /** Fractional row of the table at height {@code z}. */
    private double tableRow(double z) {
        return Math.max(0, Math.min(table.length - 1.000001, (z - LOW_MM) / STEP_MM));
    }

    double frontY(double z) {
        Section section = new Section(z);
        return section.axisY - section.frontDepth;
    }

    double halfBreadth(double z) {
        return new Section(z).breadth;
    }

    /** Half-breadth, depths and spine at one height; they define the section. */
    private final class Section {
        private final double axisY;
        private final double frontDepth;
        private final double backDepth;
        private final double breadth;
        private final double toSpine;
        private final double inner;
        private final double slope;

        Section(double z) {
            double at = tableRow(z);
            int low = (int) at;
            double t = at - low;
            double[] a = table[low];
            double[] b = table[low + 1];
            axisY = a[0] + t * (b[0] - a[0]);
            frontDepth = a[1] + t * (b[1] - a[1]);
            backDepth = a[2] + t * (b[2] - a[2]);
            breadth = a[3] + t * (b[3] - a[3]);
            toSpine = a[4] + t * (b[4] - a[4]);
            inner = a[5] + t * (b[5] - a[5]);
            slope = a[6] + t * (b[6] - a[6]);
        }

        /** Radius r at an azimuth; writes {@code (dr/d azimuth) / r} to {@code steepness[0]}. */
        double radius(double sin, double cos, boolean withSpine, double[] steepness) {
            double across = Math.max(Math.abs(sin), 1e-9);
            double along = Math.max(Math.abs(cos), 1e-9);
            double n = exponentFront + (exponentBack - exponentFront) * SmoothBlends.smoothstep(cos + 0.5);
            double p = across / (breadth * (sin > 0 ? leftFactor : 1));
            double q = along / (cos > 0 ? backDepth : frontDepth);
            double larger = Math.max(p, q);
            double power = powers.power(Math.min(p, q) / larger, n);
            double radius = powers.root(Math.min(p, q) / larger, n) / larger;
            double shareOfP = (p > q ? 1 : power) / (1 + power);
            steepness[0] = ((1 - shareOfP) * across / along - shareOfP * along / across) * Math.signum(cos);
            if (cos < 0 || !withSpine) {
                return radius;
            }
            double u = (StrictMath.atan2(across, cos) - inner) / slope;
            if (u >= 1) {
                return radius;
            }
            double step = SmoothBlends.smoothstep(u);
            double nearer = Math.min(toSpine, radius);
            double bent = nearer + (radius - nearer) * step;
            double rise = u <= 0 ? 0 : 6 * u * (1 - u) / slope;
            steepness[0] = (steepness[0] * radius * step + (radius - nearer) * rise) / bent;
            return bent;
        }
    }

    /** Azimuth of a point about the axis, rad. */
    double azimuth(double[] p) {
        return StrictMath.atan2(p[0], p[1] - y(p[2]));
    }

    /** First-order distance to the wall within the horizontal plane, mm; negative inside. */
    @Override
    public double at(double x, double y, double z) {
        return at(x, y, z, true);
    }

    private double at(double x, double y, double z, boolean withSpine) {
        Section section = new Section(z);
        double dy = y - section.axisY;
        double distance = Math.sqrt(x * x + dy * dy);
        if (distance < 1e-9) {
            return -section.radius(0, 1, withSpine, new double[1]);
        }
        double[] steepness = new double[1];
        double radius = section.radius(x / distance, dy / distance, withSpine, steepness);
        return (distance - radius) / Math.sqrt(1 + steepness[0] * steepness[0]);
    }

    /**
     * Point of the surface on which ribs and cartilages lie, at an azimuth and a height. The surface is the wall
     * without the spine, offset by {@code outward} mm along its normal.
     */
    double[] boneBed(double azimuth, double z, double outward) {
        double radius = new Section(z).radius(StrictMath.sin(azimuth), StrictMath.cos(azimuth), false, new double[1]);
        double[] p = point(azimuth, radius, z);
        return Vectors.addScaled(p, boneBedNormal(p), outward);
    }

    /** Outward unit normal of that surface at a point. */
    double[] boneBedNormal(double[] p) {
        ImplicitSurface bed = (x, y, z) -> at(x, y, z, false);
        return bed.normal(p);
    }
}
