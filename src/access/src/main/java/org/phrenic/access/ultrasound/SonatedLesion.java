package org.phrenic.access.ultrasound;

import org.phrenic.access.TargetLesion;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
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

    /** Closed mesh of circles of latitude, its poles last. */
    private static TriangleMesh ball(TargetLesion lesion) {
        int rings = SEGMENTS / 2 - 1;
        double[] p = new double[3 * (rings * SEGMENTS + 2)];
        for (int ring = 0; ring <= rings + 1; ring++) {
            double polar = Math.PI * ring / (rings + 1);
            boolean pole = ring == 0 || ring > rings;
            int first = ring == 0 ? rings * SEGMENTS : ring > rings ? rings * SEGMENTS + 1 : (ring - 1) * SEGMENTS;
            for (int k = 0; k < (pole ? 1 : SEGMENTS); k++) {
                double azimuth = 2 * Math.PI * k / SEGMENTS;
                double[] unit = {
                    StrictMath.sin(polar) * StrictMath.cos(azimuth),
                    StrictMath.sin(polar) * StrictMath.sin(azimuth),
                    StrictMath.cos(polar)
                };
                for (int axis = 0; axis < 3; axis++) {
                    p[3 * (first + k) + axis] = lesion.restMm()[axis] + lesion.radiusMm() * unit[axis];
                }
            }
        }
        return new TriangleMesh(p, triangles(rings));
    }

    private static int[] triangles(int rings) {
        int[] t = new int[3 * 2 * rings * SEGMENTS];
        int top = rings * SEGMENTS;
        int n = 0;
        for (int k = 0; k < SEGMENTS; k++) {
            int next = (k + 1) % SEGMENTS;
            int last = (rings - 1) * SEGMENTS;
            n = add(t, n, top, k, next);
            n = add(t, n, top + 1, last + next, last + k);
            for (int r = 0; r < last; r += SEGMENTS) {
                n = add(t, n, r + k, r + SEGMENTS + k, r + next);
                n = add(t, n, r + next, r + SEGMENTS + k, r + SEGMENTS + next);
            }
        }
        return t;
    }

    private static int add(int[] t, int at, int a, int b, int c) {
        t[at] = a;
        t[at + 1] = b;
        t[at + 2] = c;
        return at + 3;
    }
}
