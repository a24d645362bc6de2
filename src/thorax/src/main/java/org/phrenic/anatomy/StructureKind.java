package org.phrenic.anatomy;

/** What a structure of the thorax is. */
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
    OTHER
}
