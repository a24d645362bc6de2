package org.phrenic.access.ultrasound;

import org.phrenic.mesh.Vectors;

/**
 * Where an ultrasound probe is and where it looks. Probe coordinates of a point are (lateral, axial, elevation), mm:
 * across the image toward the probe's marker, along its central scan line, and out of the image plane, from the middle
 * of the face. {@code elevation = axial x lateral}.
 *
 * @param face middle of the transducer's face, LPS, mm
 * @param axial unit vector of the central scan line, away from the face
 * @param lateral unit vector in the image plane toward the marker, which is on the left of the image
 */
public record ProbePose(double[] face, double[] axial, double[] lateral) {
    private static final double ORTHOGONAL = 1e-9;

    /**
     * Angles of a probe on the skin, degrees.
     *
     * @param rotationDeg about the normal of the skin, anticlockwise as seen from outside. At 0 the marker is toward
     *     the head (longitudinal section); on the front of the body, at 90 it is toward the patient's right (transverse
     *     section)
     * @param tiltDeg out of the image plane, toward elevation: the scan plane sweeps like a fan
     * @param rockDeg in the image plane, toward the marker
     */
    public record Angles(double rotationDeg, double tiltDeg, double rockDeg) {
        public static final Angles ZERO = new Angles(0, 0, 0);
    }

    public ProbePose {
        if (Math.abs(Vectors.dot(axial, lateral)) > ORTHOGONAL
                || Math.abs(Vectors.length(axial) - 1) > ORTHOGONAL
                || Math.abs(Vectors.length(lateral) - 1) > ORTHOGONAL) {
            throw new IllegalArgumentException("probe: expected axial and lateral unit vectors at a right angle");
        }
    }

    /**
     * The pose of a probe that is put on the skin. Turned to its rotation it is tilted, then rocked, about the middle
     * of its face.
     *
     * @param point where the middle of the face touches the skin, LPS, mm
     * @param normal of the skin there, outward
     * @param pressMm how deep the middle of the face is pressed in, mm, so that its sides touch too
     */
    public static ProbePose onSkin(double[] point, double[] normal, Angles angles, double pressMm) {
        double[] n = Vectors.normalize(normal);
        // Near the crown of the head or the sole of a foot the front takes the place of the head.
        double[] head = Math.abs(n[2]) < 0.99 ? Vectors.of(0, 0, 1) : Vectors.of(0, -1, 0);
        double[] up = Vectors.orthonormalize(head, n);
        double[] lateral = turn(up, Vectors.cross(n, up), angles.rotationDeg());
        double[] inward = Vectors.addScaled(new double[3], n, -1);
        double[] tilted = turn(inward, Vectors.cross(inward, lateral), angles.tiltDeg());
        double[] axial = turn(tilted, lateral, angles.rockDeg());
        double[] across = Vectors.orthonormalize(turn(lateral, tilted, -angles.rockDeg()), axial);
        return new ProbePose(Vectors.addScaled(point, n, -pressMm), Vectors.normalize(axial), across);
    }

    /** {@code cos(angle) from + sin(angle) toward}. */
    private static double[] turn(double[] from, double[] toward, double angleDeg) {
        double angle = StrictMath.toRadians(angleDeg);
        return Vectors.addScaled(
                Vectors.addScaled(new double[3], from, StrictMath.cos(angle)), toward, StrictMath.sin(angle));
    }

    /** Unit vector out of the image plane. */
    public double[] elevation() {
        return Vectors.cross(axial, lateral);
    }

    /** Probe coordinates of a point. */
    public double[] toProbe(double[] world) {
        double[] d = Vectors.subtract(world, face);
        return Vectors.of(Vectors.dot(d, lateral), Vectors.dot(d, axial), Vectors.dot(d, elevation()));
    }

    /** The point with some probe coordinates, LPS, mm. */
    public double[] toWorld(double lateralMm, double axialMm, double elevationMm) {
        double[] p = Vectors.addScaled(face, lateral, lateralMm);
        return Vectors.addScaled(Vectors.addScaled(p, axial, axialMm), elevation(), elevationMm);
    }
}
