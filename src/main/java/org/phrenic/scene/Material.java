package org.phrenic.scene;

import org.phrenic.anatomy.StructureKind;

/**
 * What a kind of structure looks like in an atlas: colour, and how it shines.
 *
 * @param look colour and opacity
 * @param gloss strength of the highlight
 * @param shininess exponent of the highlight: larger is smaller and sharper
 */
record Material(Look look, float gloss, float shininess) {
    /** Colour of the central tendon; the diaphragm's own colour is that of its muscle. */
    static final int TENDON = 0xe2d6bf;

    static Material of(StructureKind kind) {
        return switch (kind) {
            case RIB -> new Material(Look.of(0xecd9ae, 1), 0.20f, 30);
            case STERNUM -> new Material(Look.of(0xead5aa, 1), 0.20f, 30);
            case VERTEBRA -> new Material(Look.of(0xe3cda0, 1), 0.14f, 24);
            case COSTAL_CARTILAGE -> new Material(Look.of(0xb9cdd2, 1), 0.30f, 48);
            case DISC -> new Material(Look.of(0xa9bcc0, 1), 0.20f, 32);
            case DIAPHRAGM -> new Material(Look.of(0x8d3c35, 1), 0.11f, 22);
            case LUNG -> new Material(Look.of(0xd98f8d, 0.42f), 0.22f, 36);
            case LIVER -> new Material(Look.of(0x68352a, 1), 0.42f, 55);
            case SKIN -> new Material(Look.of(0xd8a283, 0.15f), 0.25f, 40);
            case OTHER -> new Material(Look.of(0xb9a98f, 1), 0.15f, 30);
        };
    }
}
