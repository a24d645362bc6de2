package org.phrenic.engine.constraint;

/** A wall, possibly moving, along which nodes may slide but which they may not penetrate. */
public interface ContactSurface {

    /** Called once, on one thread, before planes are evaluated. */
    default void prepare(double time) {}

    /**
     * The tangent plane of the wall near a point: n·x ≥ d on the allowed side. Called from several threads; allocates
     * nothing.
     *
     * @param node index of the contact node in the caller's list
     * @param x point, mm
     * @param y point, mm
     * @param z point, mm
     * @param plane receives nx, ny, nz (unit normal towards the allowed side), d (mm) and the speed of the wall along n
     *     (mm/s)
     * @param at first index in {@code plane}
     */
    void tangentPlane(int node, double x, double y, double z, double[] plane, int at);
}
