package org.phrenic.access.ultrasound;

import org.phrenic.access.TargetLesion;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.RingStack;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** A {@link TargetLesion} as a probe meets it: a ball about a centre that moves; its tissue moves with the liver. */
final class SonatedLesion extends SonatedSurface {
    private static final int SEGMENTS = 32;

    private final TargetLesion lesion;
    private final int liver;
    private double[] centre;

    /**
     * @param index of the surface, after those of the scene
     * @param liver index of the liver
     */
    SonatedLesion(int index, TargetLesion lesion, int liver) {
        super(
                index,
                new Surface(
                        "target",
                        StructureKind.LESION,
                        0,
                        Side.MIDLINE,
                        ball(lesion),
                        Surface.Motion.STILL,
                        new boolean[0]));
        this.lesion = lesion;
        this.liver = liver;
        centre = lesion.restMm();
    }

    double[] restCentre() {
        return lesion.restMm();
    }

    /** Moves the centre to a position, LPS, mm. */
    void moveTo(double[] to) {
        centre = to;
    }

    @Override
    void locate(Frame frame, double[] out) {
        double[] rest = surface.rest().positions();
        for (int i = 0; i < out.length; i++) {
            out[i] = rest[i] + centre[i % 3] - lesion.restMm()[i % 3];
        }
    }

    @Override
    int carrier() {
        return liver;
    }

    private static TriangleMesh ball(TargetLesion lesion) {
        TriangleMesh unit = RingStack.unitBall(SEGMENTS);
        double[] p = unit.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] = lesion.restMm()[i % 3] + lesion.radiusMm() * p[i];
        }
        return unit.withPositions(p);
    }
}
