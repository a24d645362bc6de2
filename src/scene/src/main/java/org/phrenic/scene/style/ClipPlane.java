package org.phrenic.scene.style;

/**
 * A plane that cuts the body open: the side the normal points to, {@code n . x > offset}, is removed.
 *
 * @param nx normal in LPS, of unit length
 * @param ny as above
 * @param nz as above
 * @param offsetMm distance of the plane from the origin along the normal, mm
 */
public record ClipPlane(double nx, double ny, double nz, double offsetMm) {
    /** @throws IllegalArgumentException if the normal has no direction */
    public ClipPlane {
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (!(length > 0) || !Double.isFinite(length + offsetMm)) {
            throw new IllegalArgumentException("clip plane: found the normal " + nx + ", " + ny + ", " + nz
                    + " and the offset " + offsetMm + ", expected a direction and a finite distance");
        }
        nx /= length;
        ny /= length;
        nz /= length;
    }

    /** The coronal plane at y; what lies in front of it is removed. */
    public static ClipPlane coronal(double y) {
        return new ClipPlane(0, -1, 0, -y);
    }

    /** The sagittal plane at x; what lies to the patient's left of it is removed. */
    public static ClipPlane sagittal(double x) {
        return new ClipPlane(1, 0, 0, x);
    }

    /** The axial plane at z; what lies above it is removed. */
    public static ClipPlane axial(double z) {
        return new ClipPlane(0, 0, 1, z);
    }
}
