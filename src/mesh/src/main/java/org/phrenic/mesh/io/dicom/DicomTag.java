package org.phrenic.mesh.io.dicom;

import java.util.Locale;
import org.phrenic.file.Numbers;

/** Elements that are read, with their value representation in files that do not state it. */
public enum DicomTag {
    TRANSFER_SYNTAX_UID(0x00020010, "UI"),
    SPECIFIC_CHARACTER_SET(0x00080005, "CS"),
    SOP_CLASS_UID(0x00080016, "UI"),
    SERIES_INSTANCE_UID(0x0020000E, "UI"),
    REFERENCED_FRAME_OF_REFERENCE_SEQUENCE(0x30060010, "SQ"),
    RT_REFERENCED_STUDY_SEQUENCE(0x30060012, "SQ"),
    RT_REFERENCED_SERIES_SEQUENCE(0x30060014, "SQ"),
    IMAGE_POSITION(0x00200032, "DS"),
    IMAGE_ORIENTATION(0x00200037, "DS"),
    SAMPLES_PER_PIXEL(0x00280002, "US"),
    NUMBER_OF_FRAMES(0x00280008, "IS"),
    ROWS(0x00280010, "US"),
    COLUMNS(0x00280011, "US"),
    PIXEL_SPACING(0x00280030, "DS"),
    BITS_ALLOCATED(0x00280100, "US"),
    BITS_STORED(0x00280101, "US"),
    PIXEL_REPRESENTATION(0x00280103, "US"),
    RESCALE_INTERCEPT(0x00281052, "DS"),
    RESCALE_SLOPE(0x00281053, "DS"),
    PIXEL_DATA(0x7FE00010, "OW"),
    SHARED_FUNCTIONAL_GROUPS_SEQUENCE(0x52009229, "SQ"),
    PER_FRAME_FUNCTIONAL_GROUPS_SEQUENCE(0x52009230, "SQ"),
    PLANE_POSITION_SEQUENCE(0x00209113, "SQ"),
    PLANE_ORIENTATION_SEQUENCE(0x00209116, "SQ"),
    PIXEL_MEASURES_SEQUENCE(0x00289110, "SQ"),
    PIXEL_VALUE_TRANSFORMATION_SEQUENCE(0x00289145, "SQ"),
    SPACING_BETWEEN_SLICES(0x00180088, "DS"),
    SLICE_THICKNESS(0x00180050, "DS"),
    SEGMENTATION_TYPE(0x00620001, "CS"),
    SEGMENT_SEQUENCE(0x00620002, "SQ"),
    SEGMENT_NUMBER(0x00620004, "US"),
    SEGMENT_LABEL(0x00620005, "LO"),
    SEGMENTED_PROPERTY_TYPE_CODE_SEQUENCE(0x0062000F, "SQ"),
    SEGMENTED_PROPERTY_TYPE_MODIFIER_CODE_SEQUENCE(0x00620011, "SQ"),
    CODE_MEANING(0x00080104, "LO"),
    MAXIMUM_FRACTIONAL_VALUE(0x0062000E, "US"),
    SEGMENT_IDENTIFICATION_SEQUENCE(0x0062000A, "SQ"),
    REFERENCED_SEGMENT_NUMBER(0x0062000B, "US"),
    STRUCTURE_SET_ROI_SEQUENCE(0x30060020, "SQ"),
    ROI_NUMBER(0x30060022, "IS"),
    ROI_NAME(0x30060026, "LO"),
    ROI_CONTOUR_SEQUENCE(0x30060039, "SQ"),
    CONTOUR_SEQUENCE(0x30060040, "SQ"),
    CONTOUR_GEOMETRIC_TYPE(0x30060042, "CS"),
    CONTOUR_DATA(0x30060050, "DS"),
    REFERENCED_ROI_NUMBER(0x30060084, "IS");

    private final int number;
    private final String representation;

    DicomTag(int number, String representation) {
        this.number = number;
        this.representation = representation;
    }

    /** Group and element as one number. */
    int number() {
        return number;
    }

    String representation() {
        return representation;
    }

    /** The element in a message: "element (0028,0010) rows". */
    String place() {
        String words = name().toLowerCase(Locale.ROOT).replace('_', ' ');
        return Numbers.format("element (%04X,%04X) %s", number >>> 16, number & 0xFFFF, words);
    }
}
