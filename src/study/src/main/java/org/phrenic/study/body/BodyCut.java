package org.phrenic.study.body;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.patient.label.LabelTable;

/** What a scan of a body shows: its field of view, its labels, its voxels and its damage. None labels the diaphragm. */
public enum BodyCut {
    WHOLE("bones, lungs, liver and further organs in voxels of 1.5 mm"),
    ABDOMEN("from the lowest vertebra to 25 mm above the liver"),
    BONES("ribs, cartilages, sternum and vertebrae alone"),
    BONE_MESHES("meshes of ribs, cartilages, sternum and vertebrae alone"),
    LUNGS("lungs alone"),
    LUNGS_LIVER("lungs and liver alone"),
    RIGHT_SIDE("the right side to 10 mm beyond the midline"),
    CUT_ENDS("from the middle of the liver to T3"),
    RIBS_10("ribs end 10 mm short of the spine"),
    RIBS_20("ribs end 20 mm short of the spine"),
    RIBS_30("ribs end 30 mm short of the spine"),
    EFFUSION("the lower half of the right lung missing, as above fluid"),
    DROPPED("5 % of the voxels of bones missing at random"),
    SLICES_5("slices of 5 mm"),
    OBLIQUE("the grid of voxels rotated by 15 degrees about (1, 1, 1)"),
    TURNED("the patient turned by 15 degrees about the long axis"),
    INSPIRED("at the full inspiration of a deep breath"),
    HALF_INSPIRED("half way to the full inspiration of a deep breath"),
    INSPIRED_ABDOMEN("at full inspiration, from the lowest vertebra to 25 mm above the liver"),
    COMMON_LABELS("all bones under one label, both lungs under one, both kidneys under one, liver"),
    COMMON_ABDOMEN("the same labels, from the lowest vertebra to 25 mm above the liver");

    static final double VOXEL_MM = 1.5;
    static final double TURN_DEG = 15;
    static final double DROPPED_SHARE = 0.05;
    static final double FLUID_SHARE = 0.5;
    private static final double THICK_SLICE_MM = 5;
    private static final Set<StructureKind> BONE_KINDS = EnumSet.of(
            StructureKind.RIB, StructureKind.COSTAL_CARTILAGE, StructureKind.STERNUM, StructureKind.VERTEBRA);

    private final String description;

    BodyCut(String description) {
        this.description = description;
    }

    /** Name in reports and files, such as {@code ribs-20}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** What the scan shows, one phrase. */
    public String description() {
        return description;
    }

    /** Whether the scan labels structures of a kind. */
    boolean shows(StructureKind kind) {
        boolean bone = BONE_KINDS.contains(kind);
        return switch (this) {
            case BONES, BONE_MESHES -> bone;
            case LUNGS -> kind == StructureKind.LUNG;
            case COMMON_LABELS, COMMON_ABDOMEN ->
                (bone && kind != StructureKind.COSTAL_CARTILAGE) || isLungOrLiver(kind) || kind == StructureKind.ORGAN;
            case LUNGS_LIVER -> isLungOrLiver(kind);
            default -> bone || isLungOrLiver(kind) || kind.isNamed();
        };
    }

    private static boolean isLungOrLiver(StructureKind kind) {
        return kind == StructureKind.LUNG || kind == StructureKind.LIVER;
    }

    /** The tool or data set whose label numbers the scan has. */
    String numbers() {
        return hasCommonLabels() ? "ct-org" : LabelTable.TOTALSEGMENTATOR;
    }

    /** Whether several structures share a label. */
    boolean hasCommonLabels() {
        return this == COMMON_LABELS || this == COMMON_ABDOMEN;
    }

    static boolean isBone(StructureKind kind) {
        return BONE_KINDS.contains(kind);
    }

    /** Length by which ribs end short of the spine, mm. */
    double ribsShortMm() {
        return switch (this) {
            case RIBS_10 -> 10;
            case RIBS_20 -> 20;
            case RIBS_30 -> 30;
            default -> 0;
        };
    }

    /** Breath level of the scan as a share of the descent of the domes in a deep breath, 0 at end-expiration. */
    double inspiration() {
        return switch (this) {
            case INSPIRED, INSPIRED_ABDOMEN -> 1;
            case HALF_INSPIRED -> 0.5;
            default -> 0;
        };
    }

    double sliceMm() {
        return this == SLICES_5 ? THICK_SLICE_MM : VOXEL_MM;
    }
}
