package org.phrenic.scene.style;

/**
 * A clip plane. The half-space on the side of the normal, {@code n . x > offset}, is removed.
 *
 * @param nx x component of the unit normal in LPS
 * @param ny y component of the unit normal
 * @param nz z component of the unit normal
 * @param offsetMm signed distance of the plane from the origin along the normal, mm
 */
public record ClipPlane(double nx, double ny, double nz, double offsetMm) {
    /** @throws IllegalArgumentException if the normal has zero length */
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

    /** The coronal plane at y (mm); the part in front of it is removed. */
    public static ClipPlane coronal(double y) {
        return new ClipPlane(0, -1, 0, -y);
    }

    /** The sagittal plane at x (mm); the part to the patient's left is removed. */
    public static ClipPlane sagittal(double x) {
        return new ClipPlane(1, 0, 0, x);
    }

    /** The axial plane at z (mm); the part above it is removed. */
    public static ClipPlane axial(double z) {
        return new ClipPlane(0, 0, 1, z);
    }
}
