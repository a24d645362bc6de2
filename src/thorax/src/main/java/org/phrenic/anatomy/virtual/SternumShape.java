package org.phrenic.anatomy.virtual;

import java.util.List;
import org.phrenic.anatomy.virtual.shape.ProfileCurve;
import org.phrenic.anatomy.virtual.shape.Tube;
import org.phrenic.mesh.Polyline;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;

/** The sternum: manubrium, body and xiphoid as flat bars along a middle line that bends at the sternal angle. */
final class SternumShape {
    /**
     * Abscissae of the outline: path from the jugular notch over the length of manubrium plus body (above 1: xiphoid).
     * The ordinates are half-widths in mm for a body of 101.1 mm.
     */
    private static final double[] FRACTION = {0, 0.06, 0.14, 0.25, 0.345, 0.40, 0.55, 0.75, 0.90, 1.0, 1.02, 1.12, 1.25
    };

    private static final double[] HALF_WIDTH = {22, 27, 29, 22, 17, 16, 17.5, 20, 20, 13, 10, 9, 4};

    private final VirtualThoraxParameters.Sternum measures;
    private final double widthFactor;
    private final double[] notch;
    private final double[] angle;
    private final double[] joint;
    private final double[] tip;
    private final ProfileCurve halfWidth = new ProfileCurve(FRACTION, HALF_WIDTH);

    SternumShape(VirtualThoraxParameters.Sternum measures, Spine spine) {
        this.measures = measures;
        widthFactor = measures.bodyMm() / 101.1;
        double lean = StrictMath.toRadians(measures.bodyLeanDeg());
        double upper = lean + StrictMath.toRadians(180 - measures.angleDeg());
        joint = Vectors.of(0, measures.jointY(), spine.bodyZ(measures.jointLevel()));
        angle = Vectors.addScaled(joint, Vectors.of(0, StrictMath.sin(lean), StrictMath.cos(lean)), measures.bodyMm());
        notch = Vectors.addScaled(
                angle, Vectors.of(0, StrictMath.sin(upper), StrictMath.cos(upper)), measures.manubriumMm());
        tip = Vectors.addScaled(
                joint, Vectors.of(0, StrictMath.sin(0.02), -StrictMath.cos(0.02)), measures.xiphoidMm());
    }

    /** Point of the middle line; {@code fraction} is the path from the notch over the length of manubrium plus body. */
    private double[] middle(double fraction) {
        double path = fraction * (measures.manubriumMm() + measures.bodyMm());
        if (path < measures.manubriumMm()) {
            return Vectors.lerp(notch, angle, path / measures.manubriumMm());
        }
        return Vectors.lerp(angle, joint, (path - measures.manubriumMm()) / measures.bodyMm());
    }

    /** Point of the lateral edge where a cartilage attaches; {@code sign} is the sign of x. */
    double[] edge(double fraction, int sign) {
        return Vectors.addScaled(middle(fraction), Vectors.of(sign, 0, 0), halfWidth.at(fraction) * widthFactor);
    }

    TriangleMesh manubrium(Tube tube) {
        return bar(tube, notch, angle, 0, measures.manubriumMm(), measures.thicknessMm() * 1.1);
    }

    TriangleMesh body(Tube tube) {
        return bar(tube, angle, joint, measures.manubriumMm(), measures.bodyMm(), measures.thicknessMm());
    }

    TriangleMesh xiphoid(Tube tube) {
        double start = measures.manubriumMm() + measures.bodyMm();
        return bar(tube, joint, tip, start, measures.xiphoidMm(), measures.thicknessMm() * 0.6);
    }

    private TriangleMesh bar(Tube tube, double[] from, double[] to, double start, double length, double thickness) {
        double whole = measures.manubriumMm() + measures.bodyMm();
        double[] direction = Vectors.normalize(Vectors.subtract(to, from));
        Polyline course = new Polyline(List.of(
                Vectors.addScaled(from, direction, -0.2),
                Vectors.lerp(from, to, 0.5),
                Vectors.addScaled(to, direction, 0.2)));
        return tube.mesh(
                course,
                t -> new Tube.Section(widthFactor * halfWidth.at((start + t * length) / whole), thickness / 2),
                p -> Vectors.of(0, -1, 0));
    }
}
