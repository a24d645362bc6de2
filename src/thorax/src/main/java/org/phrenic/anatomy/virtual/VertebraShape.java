package org.phrenic.anatomy.virtual;

import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.TaperedCapsule;
import org.phrenic.mesh.Vectors;

/**
 * A vertebra as an implicit surface: the smooth union of a waisted body, pedicles, laminae and the spinous, transverse
 * and articular processes. The vertebral canal stays open. Coordinates are relative to the body: across, back, up.
 */
final class VertebraShape implements ImplicitSurface {
    private static final double FILLET_MM = 4;

    private final Spine spine;
    private final double path;
    private final double halfWidth;
    private final double halfDepth;
    private final double height;
    private final double[] transverse;
    private final Spine.Frame frame;
    private final TaperedCapsule pedicle;
    private final TaperedCapsule lamina;
    private final TaperedCapsule spinous;
    /** Second capsule that makes the spinous process of a lumbar vertebra tall. */
    private final TaperedCapsule spinousAbove;

    private final TaperedCapsule transverseBar;
    private final TaperedCapsule articularUp;
    private final TaperedCapsule articularDown;
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
        double[] pedicleFrom = Vectors.of(halfWidth * 0.62, halfDepth * 0.6, height * 0.18);
        double[] pedicleTo = Vectors.of(13, halfDepth + 10, height * 0.10);
        double[] laminaTo = Vectors.of(0, halfDepth + 21, -height * 0.12);
        double[] spinousTo =
                Vectors.addScaled(laminaTo, Vectors.of(0, StrictMath.cos(drop), -StrictMath.sin(drop)), length - 4);
        transverse = Vectors.of(
                m.transverseReachMm().at(i) - 4.5,
                halfDepth + m.transverseBackMm().at(i),
                height * (lumbar ? 0 : 0.25));
        frame = spine.frame(path);
        pedicle = new TaperedCapsule(pedicleFrom, pedicleTo, 4.2, 4.0);
        lamina = new TaperedCapsule(pedicleTo, laminaTo, 4.2, 4.0);
        spinous = new TaperedCapsule(laminaTo, spinousTo, 4.5, lumbar ? 4.5 : 3.2);
        spinousAbove = new TaperedCapsule(laminaTo, spinousTo, 4.5, 4.5);
        transverseBar = new TaperedCapsule(pedicleTo, transverse, 4.6, 4.8);
        articularUp = new TaperedCapsule(pedicleTo, Vectors.of(14, halfDepth + 11, height * 0.62), 4.0, 3.4);
        articularDown = new TaperedCapsule(pedicleTo, Vectors.of(11, halfDepth + 16, -height * 0.60), 4.0, 3.4);
    }

    /** Centre of the tip of the transverse process on one side, mm. */
    double[] transverseTip(int sign) {
        return spine.local(path, sign * transverse[0], transverse[1], transverse[2]);
    }

    /** First point from {@code inside} along a direction where the implicit function equals {@code value}. */
    double[] fromInside(double[] inside, double[] direction, double value) {
        double low = 0;
        double high = 1;
        while (at(Vectors.addScaled(inside, direction, high)) < value) {
            low = high;
            high += 1;
        }
        for (int i = 0; i < 40; i++) {
            double middle = (low + high) / 2;
            if (at(Vectors.addScaled(inside, direction, middle)) < value) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return Vectors.addScaled(inside, direction, low);
    }

    @Override
    public double at(double x, double y, double z) {
        double across = Math.abs(x);
        double back = frame.back(y, z);
        double up = frame.up(y, z);
        double arch = pedicle.at(across, back, up);
        arch = SmoothBlends.smoothUnion(arch, lamina.at(across, back, up), FILLET_MM);
        double process = spinous.at(across, back, up);
        if (lumbar) {
            process = SmoothBlends.smoothUnion(process, spinousAbove.at(across, back, up + 7), FILLET_MM);
        }
        arch = SmoothBlends.smoothUnion(arch, process, FILLET_MM);
        arch = SmoothBlends.smoothUnion(arch, transverseBar.at(across, back, up), FILLET_MM);
        arch = SmoothBlends.smoothUnion(arch, articularUp.at(across, back, up), FILLET_MM);
        arch = SmoothBlends.smoothUnion(arch, articularDown.at(across, back, up), FILLET_MM);
        return SmoothBlends.smoothUnion(body(across, back, up), arch, FILLET_MM);
    }

    private double body(double across, double back, double up) {
        double t = Math.min(1, Math.abs(2 * up / height));
        double waist = 0.92 + 0.08 * t * t;
        double u = across / (halfWidth * waist);
        double v = back / (halfDepth * waist);
        double radial = Math.sqrt(u * u + v * v) - 1;
        return SmoothBlends.roundIntersection(radial * Math.min(halfWidth, halfDepth), Math.abs(up) - height / 2, 1.5);
    }
}
