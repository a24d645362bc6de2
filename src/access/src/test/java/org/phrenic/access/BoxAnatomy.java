package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

/**
 * A body of stacked boxes, so that every depth is known: skin from x = 0, a lung from 20 to 30 above z = 10, a rib from
 * 10 to 16 whose lower face is at z = 30, another from 10 to 16 whose upper face is at z = -30, a liver from 40 to 140.
 * All are 200 mm wide in y; the liver moves by a shift.
 */
public final class BoxAnatomy {
    public static final double LIVER_FROM = 40;

    public final List<Surface> surfaces = new ArrayList<>();
    private final double[] liverRest;

    public BoxAnatomy() {
        add("skin", StructureKind.SKIN, 0, box(0, -100, -150, 200, 100, 150), Surface.Motion.STILL);
        TriangleMesh liver = box(LIVER_FROM, -90, -120, 140, 90, 120);
        liverRest = liver.positions();
        add("liver", StructureKind.LIVER, 0, liver, Surface.Motion.DEFORMING);
        add("rib_08_R", StructureKind.RIB, 8, box(10, -100, 30, 16, 100, 42), Surface.Motion.RIGID);
        add("rib_09_R", StructureKind.RIB, 9, box(10, -100, -42, 16, 100, -30), Surface.Motion.STILL);
        add("lung_R", StructureKind.LUNG, 0, box(20, -100, 10, 30, 100, 140), Surface.Motion.DEFORMING);
    }

    /** A body with a liver of this size, mm, alone. */
    public static MovingAnatomy withLiver(double x, double y, double z) {
        return new MovingAnatomy(List.of(
                new Surface(
                        "skin",
                        StructureKind.SKIN,
                        0,
                        Side.RIGHT,
                        box(-50, -50, -50, 50, 50, 50),
                        Surface.Motion.STILL,
                        new boolean[0]),
                new Surface(
                        "liver",
                        StructureKind.LIVER,
                        0,
                        Side.RIGHT,
                        box(0, 0, 0, x, y, z),
                        Surface.Motion.DEFORMING,
                        new boolean[0])));
    }

    private void add(String name, StructureKind kind, int level, TriangleMesh mesh, Surface.Motion motion) {
        surfaces.add(new Surface(name, kind, level, Side.RIGHT, mesh, motion, new boolean[0]));
    }

    /** A box that faces outward. */
    static TriangleMesh box(double x0, double y0, double z0, double x1, double y1, double z1) {
        double[] p = {x0, y0, z0, x1, y0, z0, x1, y1, z0, x0, y1, z0, x0, y0, z1, x1, y0, z1, x1, y1, z1, x0, y1, z1};
        int[] t = {
            0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
        };
        return new TriangleMesh(p, t);
    }

    /** The body with liver and lung shifted, and the upper rib raised. */
    public Frame frame(double timeS, double phase, double[] liverShift, double lungDown, double ribUp) {
        return frame(timeS, phase, liverShift, lungDown, new double[] {0, 0, ribUp});
    }

    /** The body with liver, lung and the upper rib shifted. */
    public Frame frame(double timeS, double phase, double[] liverShift, double lungDown, double[] ribShift) {
        double[] pose = {1, 0, 0, ribShift[0], 0, 1, 0, ribShift[1], 0, 0, 1, ribShift[2]};
        return TestFrames.of(
                surfaces,
                timeS,
                0,
                phase,
                new double[0],
                shifted(liverRest, liverShift),
                pose,
                new double[0],
                shifted(surfaces.get(4).rest().positions(), new double[] {0, 0, -lungDown}));
    }

    public Frame still(double timeS) {
        return frame(timeS, 0, new double[3], 0, 0);
    }

    private static double[] shifted(double[] p, double[] by) {
        double[] out = new double[p.length];
        for (int i = 0; i < p.length; i++) {
            out[i] = p[i] + by[i % 3];
        }
        return out;
    }
}
