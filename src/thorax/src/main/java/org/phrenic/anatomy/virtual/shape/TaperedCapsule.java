package org.phrenic.anatomy.virtual.shape;

import org.phrenic.mesh.Vectors;

/**
 * A capsule whose radius varies linearly between its ends. The evaluation allocates no arrays, since it runs at every
 * point of a grid.
 */
public final class TaperedCapsule implements ImplicitSurface {
    private final double fromX;
    private final double fromY;
    private final double fromZ;
    private final double axisX;
    private final double axisY;
    private final double axisZ;
    private final double axisSquare;
    private final double radiusFrom;
    private final double widening;

    public TaperedCapsule(double[] from, double[] to, double radiusFrom, double radiusTo) {
        fromX = from[0];
        fromY = from[1];
        fromZ = from[2];
        double[] axis = Vectors.subtract(to, from);
        axisX = axis[0];
        axisY = axis[1];
        axisZ = axis[2];
        axisSquare = Vectors.dot(axis, axis);
        this.radiusFrom = radiusFrom;
        widening = radiusTo - radiusFrom;
    }

    /** Distance to the capsule, mm; negative inside. */
    @Override
    public double at(double x, double y, double z) {
        double qx = x - fromX;
        double qy = y - fromY;
        double qz = z - fromZ;
        double t = Math.max(0, Math.min(1, (qx * axisX + qy * axisY + qz * axisZ) / axisSquare));
        double dx = qx - t * axisX;
        double dy = qy - t * axisY;
        double dz = qz - t * axisZ;
        return Math.sqrt(dx * dx + dy * dy + dz * dz) - (radiusFrom + t * widening);
    }
}
