package org.phrenic.anatomy.virtual;

import org.phrenic.geometry.Vectors;

/**
 * A vertebra as one region: waisted body, pedicles, laminae, spinous, transverse and articular processes, flowing into each
 * other; the canal stays open between them. Described in the frame of its own body: across, back, up.
 */
final class VertebraShape implements Field {
    private static final double FILLET_MM = 4;

    private final Spine spine;
    private final double path;
    private final double halfWidth;
    private final double halfDepth;
    private final double height;
    private final double[] pedicleFrom;
    private final double[] pedicleTo;
    private final double[] laminaTo;
    private final double[] spinousTo;
    private final double[] transverse;
    private final double[] articularUp;
    private final double[] articularDown;
    private final boolean lumbar;

    VertebraShape(Spine spine, int level) {
        this.spine = spine;
        VirtualThoraxParameters.Spine m = spine.measures();
        int i = level - 1;
        path = spine.bodyPath(level);
        halfWidth = m.bodyWidthMm().at(i) / 2;
        halfDepth = m.bodyDepthMm().at(i) / 2;
        height = m.bodyHeightMm().at(i);
        lumbar = level > 12;
        double drop = StrictMath.toRadians(m.spinousDropDeg().at(i));
        double length = m.spinousLengthMm().at(i);
        pedicleFrom = Vectors.of(halfWidth * 0.62, halfDepth * 0.6, height * 0.18);
        pedicleTo = Vectors.of(13, halfDepth + 10, height * 0.10);
        laminaTo = Vectors.of(0, halfDepth + 21, -height * 0.12);
        spinousTo = Vectors.add(laminaTo, Vectors.of(0, StrictMath.cos(drop), -StrictMath.sin(drop)), length - 4);
        transverse = Vectors.of(
                m.transverseReachMm().at(i) - 4.5,
                halfDepth + m.transverseBackMm().at(i),
                height * (lumbar ? 0 : 0.25));
        articularUp = Vectors.of(14, halfDepth + 11, height * 0.62);
        articularDown = Vectors.of(11, halfDepth + 16, -height * 0.60);
    }

    /** Middle of the end of the transverse process of this side, mm. */
    double[] transverseTip(int sign) {
        return spine.local(path, sign * transverse[0], transverse[1], transverse[2]);
    }

    /** The first point from {@code inside} in this direction where the region's value is {@code value}. */
    double[] fromInside(double[] inside, double[] direction, double value) {
        double low = 0;
        double high = 1;
        while (at(Vectors.add(inside, direction, high)) < value) {
            low = high;
            high += 1;
        }
        for (int i = 0; i < 40; i++) {
            double middle = (low + high) / 2;
            if (at(Vectors.add(inside, direction, middle)) < value) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return Vectors.add(inside, direction, low);
    }

    private double at(double[] p) {
        return at(p[0], p[1], p[2]);
    }

    @Override
    public double at(double x, double y, double z) {
        double[] p = spine.toLocal(path, Math.abs(x), y, z);
        double arch = capsule(p, pedicleFrom, pedicleTo, 4.2, 4.0);
        arch = Blends.smoothMin(arch, capsule(p, pedicleTo, laminaTo, 4.2, 4.0), FILLET_MM);
        double spinous = capsule(p, laminaTo, spinousTo, 4.5, lumbar ? 4.5 : 3.2);
        if (lumbar) {
            double[] q = Vectors.of(p[0], p[1], p[2] + 7);
            spinous = Blends.smoothMin(spinous, capsule(q, laminaTo, spinousTo, 4.5, 4.5), FILLET_MM);
        }
        arch = Blends.smoothMin(arch, spinous, FILLET_MM);
        arch = Blends.smoothMin(arch, capsule(p, pedicleTo, transverse, 4.6, 4.8), FILLET_MM);
        arch = Blends.smoothMin(arch, capsule(p, pedicleTo, articularUp, 4.0, 3.4), FILLET_MM);
        arch = Blends.smoothMin(arch, capsule(p, pedicleTo, articularDown, 4.0, 3.4), FILLET_MM);
        return Blends.smoothMin(body(p), arch, FILLET_MM);
    }

    private double body(double[] p) {
        double t = Math.min(1, Math.abs(2 * p[2] / height));
        double waist = 0.92 + 0.08 * t * t;
        double u = p[0] / (halfWidth * waist);
        double v = p[1] / (halfDepth * waist);
        double radial = Math.sqrt(u * u + v * v) - 1;
        return Blends.roundMax(radial * Math.min(halfWidth, halfDepth), Math.abs(p[2]) - height / 2, 1.5);
    }

    /** Distance to a bar with round ends whose radius goes from one end's to the other's. */
    private static double capsule(double[] p, double[] from, double[] to, double radiusFrom, double radiusTo) {
        double[] axis = Vectors.minus(to, from);
        double[] q = Vectors.minus(p, from);
        double t = Math.max(0, Math.min(1, Vectors.dot(q, axis) / Vectors.dot(axis, axis)));
        return Vectors.length(Vectors.add(q, axis, -t)) - (radiusFrom + t * (radiusTo - radiusFrom));
    }
}
