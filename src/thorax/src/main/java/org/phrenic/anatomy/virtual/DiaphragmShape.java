package org.phrenic.anatomy.virtual;

import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;

/**
 * The middle surface of the diaphragm as an implicit surface; negative below the roof and inside the chest wall. The
 * roof is the log-sum-exp smooth maximum of three paraboloids: two domes and the plateau under the heart. A rounded
 * edge of given radius joins the roof to the zone of apposition, where the sheet runs along the inner wall.
 */
final class DiaphragmShape implements ImplicitSurface {
    private final VirtualThoraxParameters.Diaphragm measures;
    private final ChestWallShape wall;
    private final ProfileCurve rim;
    private final Cap right;
    private final Cap left;
    private final Cap heart;
    private final double blend;
    private final double inset;
    private final double midlineTurn;
    private final double sideTurn;

    DiaphragmShape(VirtualThoraxParameters.Diaphragm measures, ChestWallShape wall) {
        this.measures = measures;
        this.wall = wall;
        right = new Cap(measures.right(), measures.domeRadiusXMm(), measures.domeRadiusYMm());
        left = new Cap(measures.left(), measures.domeRadiusXMm(), measures.domeRadiusYMm());
        heart = new Cap(measures.heart(), measures.heartRadiusXMm(), measures.heartRadiusYMm());
        blend = measures.blendMm();
        inset = wallInset();
        midlineTurn = measures.midlineTurnRadiusMm();
        sideTurn = measures.turnRadiusMm();
        rim = new ProfileCurve(ChestWallShape.column(measures.rim(), 0), ChestWallShape.column(measures.rim(), 1));
    }

    /** Height z of the line of insertion at an azimuth (rad, -pi to pi), mm. */
    double rimZ(double azimuth) {
        return rim.at(StrictMath.toDegrees(azimuth));
    }

    /** Distance from the inner wall to the middle of the sheet in the zone of apposition, mm. */
    double wallInset() {
        return measures.gapMm() + measures.muscleMm() / 2;
    }

    /** A paraboloid {@code z = z0 - u^2 / (2 radiusX) - v^2 / (2 radiusY)}: the roof of one dome or of the plateau. */
    private static final class Cap {
        private final double x;
        private final double y;
        private final double z;
        private final double radiusX;
        private final double radiusY;

        Cap(ImmutableDoubleArray top, double radiusX, double radiusY) {
            x = top.at(0);
            y = top.at(1);
            z = top.at(2);
            this.radiusX = radiusX;
            this.radiusY = radiusY;
        }

        double height(double atX, double atY) {
            double u = atX - x;
            double v = atY - y;
            return z - u * u / (2 * radiusX) - v * v / (2 * radiusY);
        }
    }

    @Override
    public double at(double x, double y, double z) {
        double hr = right.height(x, y);
        double hl = left.height(x, y);
        double hh = heart.height(x, y);
        double most = Math.max(hr, Math.max(hl, hh));
        double r = share(hr, most);
        double l = share(hl, most);
        double h = share(hh, most);
        double sum = r + l + h;
        double roof = most + blend * StrictMath.log(sum);
        double slopeX = (r * (x - right.x) / right.radiusX
                        + l * (x - left.x) / left.radiusX
                        + h * (x - heart.x) / heart.radiusX)
                / sum;
        double slopeY = (r * (y - right.y) / right.radiusY
                        + l * (y - left.y) / left.radiusY
                        + h * (y - heart.y) / heart.radiusY)
                / sum;
        double above = (z - roof) / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY);
        double outside = wall.at(x, y, z) + inset;
        double dy = y - wall.y(z);
        double lateral = Math.abs(x) / Math.max(Math.sqrt(x * x + dy * dy), 1e-9);
        double turn = midlineTurn + (sideTurn - midlineTurn) * SmoothBlends.smoothstep(lateral / (dy > 0 ? 0.7 : 0.95));
        return SmoothBlends.roundIntersection(above, outside, turn);
    }

    /** Unnormalised softmax weight of a cap. The highest cap has weight 1, for which no exponential is computed. */
    private double share(double height, double most) {
        return height == most ? 1 : StrictMath.exp((height - most) / blend);
    }
}
