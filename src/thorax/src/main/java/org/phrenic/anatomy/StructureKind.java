package org.phrenic.anatomy;

/** Kind of a structure of the trunk. */
public enum StructureKind {
    RIB,
    COSTAL_CARTILAGE,
    STERNUM,
    VERTEBRA,
    DISC,
    DIAPHRAGM,
    LUNG,
    LIVER,
    SKIN,
    /** The parietal pleura of one side, from its reflection to its cupola: an open surface. */
    PLEURA,
    /** An organ other than lungs and liver, such as heart, kidney or colon. */
    ORGAN,
    /** A large vessel, such as the aorta or the portal vein. */
    VESSEL,
    /** A muscle other than the diaphragm. */
    MUSCLE,
    /** A bone outside the model of the chest wall, such as a scapula or a cervical vertebra. */
    BONE,
    /** A lesion, such as a tumour of the liver. */
    LESION,
    /** Any other structure, such as the trachea. */
    OTHER;

    /** Whether a thorax may have many structures of this kind that differ in their names only. */
    public boolean isNamed() {
        return compareTo(ORGAN) >= 0;
    }
}
