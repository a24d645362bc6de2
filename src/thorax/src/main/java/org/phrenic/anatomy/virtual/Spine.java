package org.phrenic.anatomy.virtual;

import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.mesh.Vectors;

/**
 * The spine T1 to L3 in the midsagittal plane. Its middle line is a kyphotic arc above the disc T12/L1 and a lordotic
 * arc below; bodies and discs are stacked along it. Levels run from 1 (T1) to 15 (L3). A path is the arc length along
 * the middle line above the disc T12/L1, mm; negative below it.
 */
final class Spine {
    private final VirtualThoraxParameters.Spine measures;
    /** Path of the centre of each body, mm. */
    private final double[] middle = new double[VirtualThoraxParameters.VERTEBRAE];

    private final double endLean;
    private final double originY;
    private final ProfileCurve front;
    private final ProfileCurve halfWidth;

    Spine(VirtualThoraxParameters.Spine measures) {
        this.measures = measures;
        ImmutableDoubleArray height = measures.bodyHeightMm();
        ImmutableDoubleArray disc = measures.discHeightMm();
        double path = disc.at(11) / 2;
        for (int i = 11; i >= 0; i--) {
            middle[i] = path + height.at(i) / 2;
            path += height.at(i) + (i > 0 ? disc.at(i - 1) : 0);
        }
        path = -disc.at(11) / 2;
        for (int i = 12; i < middle.length; i++) {
            middle[i] = path - height.at(i) / 2;
            path -= height.at(i) + (i < disc.size() ? disc.at(i) : 0);
        }
        double radius = measures.kyphosisRadiusMm();
        endLean = measures.kyphosisApexMm() / radius;
        originY = measures.apexYMm() - radius * (1 - StrictMath.cos(endLean));

        int n = middle.length;
        double[] z = new double[n];
        double[] y = new double[n];
        double[] half = new double[n];
        for (int i = 0; i < n; i++) {
            double[] centre = centre(middle[n - 1 - i]);
            z[i] = centre[2];
            half[i] = measures.bodyWidthMm().at(n - 1 - i) / 2;
            y[i] = centre[1] - measures.bodyDepthMm().at(n - 1 - i) / 2 / StrictMath.cos(lean(middle[n - 1 - i]));
        }
        front = new ProfileCurve(z, y);
        halfWidth = new ProfileCurve(z, half);
    }

    /** Inclination of the spine from vertical at a path, rad; positive where it runs backward going up. */
    private double lean(double path) {
        return path >= 0 ? endLean - path / measures.kyphosisRadiusMm() : endLean + path / measures.lordosisRadiusMm();
    }

    /** Point of the middle line at a path. */
    double[] centre(double path) {
        double radius = path >= 0 ? measures.kyphosisRadiusMm() : -measures.lordosisRadiusMm();
        double lean = lean(path);
        return Vectors.of(
                0,
                originY + radius * (StrictMath.cos(lean) - StrictMath.cos(endLean)),
                radius * (StrictMath.sin(endLean) - StrictMath.sin(lean)));
    }

    /** Path of the centre of a vertebral body, mm. */
    double bodyPath(int level) {
        return middle[level - 1];
    }

    /** Path of the centre of the disc below a vertebra, mm. */
    double discPath(int level) {
        return middle[level - 1]
                - measures.bodyHeightMm().at(level - 1) / 2
                - measures.discHeightMm().at(level - 1) / 2;
    }

    /** Height z of the centre of a vertebral body, mm. */
    double bodyZ(int level) {
        return centre(bodyPath(level))[2];
    }

    /** y of the anterior surface of the bodies at a height, mm. */
    double frontY(double z) {
        return front.at(z);
    }

    /** Half-width of the bodies at a height, mm. */
    double halfWidth(double z) {
        return halfWidth.at(z);
    }

    /** Converts local coordinates (across to the left, back, up) about the middle line at a path to LPS, mm. */
    double[] local(double path, double across, double back, double up) {
        double[] centre = centre(path);
        double lean = lean(path);
        double sin = StrictMath.sin(lean);
        double cos = StrictMath.cos(lean);
        return Vectors.of(across, centre[1] + back * cos + up * sin, centre[2] - back * sin + up * cos);
    }

    /** Local frame of {@link #local} at one path. It converts points to local coordinates with precomputed axes. */
    static final class Frame {
        private final double y;
        private final double z;
        private final double sin;
        private final double cos;

        private Frame(double[] centre, double lean) {
            y = centre[1];
            z = centre[2];
            sin = StrictMath.sin(lean);
            cos = StrictMath.cos(lean);
        }

        double back(double atY, double atZ) {
            return (atY - y) * cos - (atZ - z) * sin;
        }

        double up(double atY, double atZ) {
            return (atY - y) * sin + (atZ - z) * cos;
        }
    }

    /** Local frame of the spine at a path. */
    Frame frame(double path) {
        return new Frame(centre(path), lean(path));
    }

    VirtualThoraxParameters.Spine measures() {
        return measures;
    }
}
