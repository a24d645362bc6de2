package org.phrenic.anatomy.virtual;

/**
 * The middle surface of the diaphragm as the border of a region (negative below it and inside the chest wall): two domes and the
 * plateau under the heart, each a paraboloid, flow into one roof; roof and inner wall meet in a turn of a given radius, below
 * which the sheet runs along the wall.
 */
final class DiaphragmShape implements Field {
    private final VirtualThoraxParameters.Diaphragm measures;
    private final ChestWall wall;
    private final Curve rim;

    DiaphragmShape(VirtualThoraxParameters.Diaphragm measures, ChestWall wall) {
        this.measures = measures;
        this.wall = wall;
        rim = new Curve(
                measures.rim().stream().mapToDouble(row -> row.at(0)).toArray(),
                measures.rim().stream().mapToDouble(row -> row.at(1)).toArray());
    }

    /** Height of the line of insertion at this azimuth (rad, -pi to pi). */
    double rimZ(double azimuth) {
        return rim.at(StrictMath.toDegrees(azimuth));
    }

    /** From the inner wall to the middle of the sheet in the zone of apposition, mm. */
    double wallInset() {
        return measures.gapMm() + measures.muscleMm() / 2;
    }

    private static double cap(Values top, double x, double y, double radiusX, double radiusY) {
        double u = x - top.at(0);
        double v = y - top.at(1);
        return top.at(2) - u * u / (2 * radiusX) - v * v / (2 * radiusY);
    }

    @Override
    public double at(double x, double y, double z) {
        double k = measures.blendMm();
        double right = cap(measures.right(), x, y, measures.domeRadiusXMm(), measures.domeRadiusYMm());
        double left = cap(measures.left(), x, y, measures.domeRadiusXMm(), measures.domeRadiusYMm());
        double heart = cap(measures.heart(), x, y, measures.heartRadiusXMm(), measures.heartRadiusYMm());
        double most = Math.max(right, Math.max(left, heart));
        double r = StrictMath.exp((right - most) / k);
        double l = StrictMath.exp((left - most) / k);
        double h = StrictMath.exp((heart - most) / k);
        double sum = r + l + h;
        double roof = most + k * StrictMath.log(sum);
        double slopeX = (r * (x - measures.right().at(0)) / measures.domeRadiusXMm()
                        + l * (x - measures.left().at(0)) / measures.domeRadiusXMm()
                        + h * (x - measures.heart().at(0)) / measures.heartRadiusXMm())
                / sum;
        double slopeY = (r * (y - measures.right().at(1)) / measures.domeRadiusYMm()
                        + l * (y - measures.left().at(1)) / measures.domeRadiusYMm()
                        + h * (y - measures.heart().at(1)) / measures.heartRadiusYMm())
                / sum;
        double above = (z - roof) / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY);
        double outside = wall.at(x, y, z) + wallInset();
        double dy = y - wall.y(z);
        double lateral = Math.abs(x) / Math.max(Math.sqrt(x * x + dy * dy), 1e-9);
        double turn = measures.midlineTurnRadiusMm()
                + (measures.turnRadiusMm() - measures.midlineTurnRadiusMm())
                        * Blends.smoothstep(lateral / (dy > 0 ? 0.7 : 0.95));
        return Blends.roundMax(above, outside, turn);
    }
}
