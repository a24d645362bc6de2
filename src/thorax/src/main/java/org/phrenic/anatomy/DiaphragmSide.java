package org.phrenic.anatomy;

import java.util.Locale;
import java.util.regex.Pattern;

/** The side of the diaphragm on which an organ lies wholly. */
public enum DiaphragmSide {
    /** Above the thoracic face. */
    ABOVE,
    /** Below the abdominal face. */
    BELOW,
    /** Passes through the diaphragm, is far from it, or is no organ. */
    NEITHER;

    private static final Pattern THORACIC =
            Pattern.compile("heart|atrial_appendage_[rl]|" + OrganNames.STOMACH_IN_CHEST);
    private static final Pattern ABDOMINAL =
            Pattern.compile("spleen|stomach|(kidney_cyst|adrenal_gland)_[rl]|gallbladder|duodenum|pancreas"
                    + "|(portal|splenic|hepatic)_vein|portal_and_splenic_vein|liver_.*");

    /** The side of a structure by its kind and name. */
    public static DiaphragmSide of(StructureKind kind, String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        if (kind == StructureKind.LUNG || THORACIC.matcher(lower).matches()) {
            return ABOVE;
        }
        boolean isBelow = kind == StructureKind.LIVER
                || ABDOMINAL.matcher(lower).matches()
                || OrganNames.isKidney(lower)
                || OrganNames.BOWEL.contains(lower);
        return isBelow ? BELOW : NEITHER;
    }
}
