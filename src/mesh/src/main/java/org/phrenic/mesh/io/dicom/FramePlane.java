package org.phrenic.mesh.io.dicom;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.file.BadInputException;

/**
 * The plane of a frame in LPS axes and mm (PS3.3, C.7.6.2.1.1).
 *
 * @param position centre of the first pixel
 * @param along unit vector along a row, in the direction of columns
 * @param down unit vector down a column, in the direction of rows
 * @param columnSpacing distance of neighbouring columns, mm
 * @param rowSpacing distance of neighbouring rows, mm
 * @param between stated distance of neighbouring planes, mm; NaN if not stated
 * @param thickness stated thickness of the plane, mm; NaN if not stated
 */
public record FramePlane(
        double[] position,
        double[] along,
        double[] down,
        double columnSpacing,
        double rowSpacing,
        double between,
        double thickness) {
    /** Unit vector at right angles to the plane, such that columns, rows and it are right-handed. */
    public double[] normal() {
        return new double[] {
            along[1] * down[2] - along[2] * down[1],
            along[2] * down[0] - along[0] * down[2],
            along[0] * down[1] - along[1] * down[0]
        };
    }

    /** The plane of an image of one frame. */
    public static FramePlane of(DicomDataSet image) {
        return of(image, image, image);
    }

    /**
     * The planes of all frames of an image with functional groups (PS3.3, C.7.6.16), or the only one of a plain image.
     *
     * @throws BadInputException if a position, orientation or spacing is missing or impossible
     */
    public static List<FramePlane> all(DicomDataSet image, FunctionalGroups groups, int frames) {
        if (!groups.arePresent() && frames == 1) {
            return List.of(of(image));
        }
        groups.checkCount(frames);
        List<FramePlane> planes = new ArrayList<>();
        for (int frame = 0; frame < frames; frame++) {
            planes.add(of(
                    groups.item(frame, DicomTag.PLANE_POSITION_SEQUENCE),
                    groups.item(frame, DicomTag.PLANE_ORIENTATION_SEQUENCE),
                    groups.item(frame, DicomTag.PIXEL_MEASURES_SEQUENCE)));
        }
        return planes;
    }

    private static FramePlane of(DicomDataSet position, DicomDataSet orientation, DicomDataSet measures) {
        double[] cosines = orientation.numbers(DicomTag.IMAGE_ORIENTATION, 6);
        double[] spacing = measures.numbers(DicomTag.PIXEL_SPACING, 2);
        if (!(spacing[0] > 0) || !(spacing[1] > 0)) {
            throw measures.badInput(
                    DicomTag.PIXEL_SPACING, "found " + spacing[0] + " and " + spacing[1] + " mm, expected more than 0");
        }
        double[] along = unit(orientation, cosines, 0);
        double[] down = unit(orientation, cosines, 3);
        double between = Math.abs(measures.number(DicomTag.SPACING_BETWEEN_SLICES, Double.NaN));
        double thickness = measures.number(DicomTag.SLICE_THICKNESS, Double.NaN);
        double[] first = position.numbers(DicomTag.IMAGE_POSITION, 3);
        return new FramePlane(first, along, down, spacing[1], spacing[0], between, thickness);
    }

    /** Directions are rounded in files; those whose length is farther than a thousandth from 1 are no unit vectors. */
    private static double[] unit(DicomDataSet orientation, double[] cosines, int first) {
        double x = cosines[first];
        double y = cosines[first + 1];
        double z = cosines[first + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(Math.abs(length - 1) < 1e-3)) {
            throw orientation.badInput(
                    DicomTag.IMAGE_ORIENTATION, "found a direction of length " + length + ", expected 1");
        }
        return new double[] {x / length, y / length, z / length};
    }
}
