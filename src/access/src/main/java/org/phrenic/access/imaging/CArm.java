package org.phrenic.access.imaging;

import org.phrenic.mesh.Vectors;

/**
 * A C-arm: an X-ray source and a flat detector that turn about an isocentre. At angles of zero the detector is in front
 * of the patient and its rows run from the patient's right to the left, as a reader sees a radiograph of the chest.
 *
 * @param isocentre centre of rotation, LPS, mm
 * @param leftObliqueDeg primary angle: the detector turns toward the patient's left (LAO positive, RAO negative)
 * @param cranialDeg secondary angle: the detector turns toward the head (cranial positive, caudal negative)
 * @param sourceDetectorMm distance from source to detector
 * @param sourceIsocentreMm distance from source to isocentre
 * @param detector the flat detector
 */
public record CArm(
        double[] isocentre,
        double leftObliqueDeg,
        double cranialDeg,
        double sourceDetectorMm,
        double sourceIsocentreMm,
        Detector detector) {
    public static final double SOURCE_DETECTOR_MM = 1000;
    public static final double SOURCE_ISOCENTRE_MM = 700;

    /**
     * A flat detector with square pixels.
     *
     * @param fieldMm width
     * @param columns pixels in a row
     * @param rows number of rows
     */
    public record Detector(double fieldMm, int columns, int rows) {}

    public CArm {
        isocentre = isocentre.clone();
        if (!(sourceDetectorMm > sourceIsocentreMm && sourceIsocentreMm > 0 && detector.fieldMm() > 0)) {
            throw new IllegalArgumentException("C-arm: found source to detector " + sourceDetectorMm
                    + " mm, source to isocentre " + sourceIsocentreMm + " mm, field " + detector.fieldMm()
                    + " mm, expected positive lengths, the first the greater");
        }
    }

    /** From the source to the detector, unit vector. */
    double[] axis() {
        double a = StrictMath.toRadians(leftObliqueDeg);
        double b = StrictMath.toRadians(cranialDeg);
        return Vectors.of(
                StrictMath.sin(a) * StrictMath.cos(b), -StrictMath.cos(a) * StrictMath.cos(b), StrictMath.sin(b));
    }

    /** Along the rows of the image, to the patient's left at zero angles, unit vector. */
    public double[] right() {
        double a = StrictMath.toRadians(leftObliqueDeg);
        return Vectors.of(StrictMath.cos(a), StrictMath.sin(a), 0);
    }

    /** Up the columns of the image, toward the head at zero angles, unit vector. */
    public double[] up() {
        return Vectors.cross(axis(), right());
    }

    /** Position of the source, LPS, mm. */
    public double[] source() {
        return Vectors.addScaled(isocentre, axis(), -sourceIsocentreMm);
    }

    /** Pixels in a row. */
    public int columns() {
        return detector.columns();
    }

    /** Number of rows. */
    public int rows() {
        return detector.rows();
    }

    /** Width of a pixel on the detector, mm. */
    public double pixelMm() {
        return detector.fieldMm() / columns();
    }

    /**
     * Where a point is seen: column and row in pixels, whole numbers at centres of pixels, row 0 on top; and its
     * distance from the source along the axis, mm.
     */
    public double[] project(double x, double y, double z) {
        double[] from = Vectors.subtract(Vectors.of(x, y, z), source());
        double depth = Vectors.dot(from, axis());
        double scale = sourceDetectorMm / depth / pixelMm();
        return Vectors.of(
                (columns() - 1) / 2.0 + scale * Vectors.dot(from, right()),
                (rows() - 1) / 2.0 - scale * Vectors.dot(from, up()),
                depth);
    }

    /** From the source to the centre of a pixel on the detector, mm. */
    public double[] ray(double column, double row) {
        double[] ray = Vectors.addScaled(new double[3], axis(), sourceDetectorMm);
        ray = Vectors.addScaled(ray, right(), pixelMm() * (column - (columns() - 1) / 2.0));
        return Vectors.addScaled(ray, up(), pixelMm() * ((rows() - 1) / 2.0 - row));
    }
}
