package org.phrenic.engine.constraint;

/** A (moving) wall that nodes may slide along but not pass. */
public interface ContactSurface {

    /** Told once, on one thread, before planes are asked for. */
    default void prepare(double time) {}

    /**
     * The wall near a point, as a plane: n·x ≥ d on the allowed side. Called from several threads; allocates nothing.
     *
     * @param node which contact node asks, as numbered when the contact was made
     * @param x point, mm
     * @param y point, mm
     * @param z point, mm
     * @param plane where to write nx, ny, nz (unit, into the allowed side), d (mm) and the wall's own speed along n
     *     (mm/s)
     * @param at first index in {@code plane}
     */
    void tangentPlane(int node, double x, double y, double z, double[] plane, int at);
}
