package org.phrenic.anatomy;

/** Kind of a structure of the thorax. */
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
