package org.phrenic.scene.style;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.anatomy.StructureKind;

/**
 * Appearance and specular reflection of a kind of structure in the atlas style.
 *
 * @param appearance colour and opacity
 * @param specular strength of the specular highlight
 * @param shininess exponent of the specular highlight; a larger value makes it smaller and sharper
 */
public record SurfaceMaterial(Appearance appearance, float specular, float shininess) {
    /** Colour of the central tendon. The appearance of the diaphragm holds the colour of its muscle. */
    public static final int TENDON_RGB = 0xe2d6bf;

    /**
     * Colours of organs and vessels by a part of their names, the first that fits, as anatomical atlases paint them.
     */
    private static final List<Map.Entry<String, Integer>> ORGAN_RGB = List.of(
            Map.entry("gallbladder", 0x5f8f3f),
            Map.entry("stomach", 0xd9a38c),
            Map.entry("duodenum", 0xd9b36f),
            Map.entry("colon", 0xbf9a72),
            Map.entry("small_bowel", 0xd8b08e),
            Map.entry("spleen", 0x6b3550),
            Map.entry("pancreas", 0xe0c27a),
            Map.entry("kidney", 0x8f4a3c),
            Map.entry("heart", 0xa83f3a),
            Map.entry("aorta", 0xc0392f),
            Map.entry("mammary", 0xc0392f),
            Map.entry("epigastric", 0xc0392f));

    /** The material of a structure; organs are told by their names. */
    public static SurfaceMaterial of(StructureKind kind, String name) {
        if (kind != StructureKind.ORGAN && kind != StructureKind.VESSEL) {
            return of(kind);
        }
        String lower = name.toLowerCase(Locale.ROOT);
        return ORGAN_RGB.stream()
                .filter(organ -> lower.contains(organ.getKey()))
                .findFirst()
                .map(organ -> new SurfaceMaterial(Appearance.of(organ.getValue(), 1), 0.25f, 40))
                .orElse(of(kind));
    }

    public static SurfaceMaterial of(StructureKind kind) {
        return switch (kind) {
            case RIB -> new SurfaceMaterial(Appearance.of(0xecd9ae, 1), 0.20f, 30);
            case STERNUM -> new SurfaceMaterial(Appearance.of(0xead5aa, 1), 0.20f, 30);
            case VERTEBRA -> new SurfaceMaterial(Appearance.of(0xe3cda0, 1), 0.14f, 24);
            case COSTAL_CARTILAGE -> new SurfaceMaterial(Appearance.of(0xb9cdd2, 1), 0.30f, 48);
            case DISC -> new SurfaceMaterial(Appearance.of(0xa9bcc0, 1), 0.20f, 32);
            case DIAPHRAGM -> new SurfaceMaterial(Appearance.of(0x8d3c35, 1), 0.11f, 22);
            case LUNG -> new SurfaceMaterial(Appearance.of(0xd98f8d, 0.42f), 0.22f, 36);
            case LIVER -> new SurfaceMaterial(Appearance.of(0x68352a, 1), 0.42f, 55);
            case SKIN -> new SurfaceMaterial(Appearance.of(0xd8a283, 0.15f), 0.25f, 40);
            case PLEURA -> new SurfaceMaterial(Appearance.of(0x9fb8c8, 0.14f), 0.25f, 40);
            case ORGAN -> new SurfaceMaterial(Appearance.of(0xa8685a, 1), 0.25f, 40);
            case VESSEL -> new SurfaceMaterial(Appearance.of(0x5d6f9e, 1), 0.25f, 40);
            case MUSCLE -> new SurfaceMaterial(Appearance.of(0x9a5a4a, 1).withVisible(false), 0.11f, 22);
            case BONE -> new SurfaceMaterial(Appearance.of(0xe3cda0, 1), 0.14f, 24);
            case LESION -> new SurfaceMaterial(Appearance.of(0xc9b84a, 1), 0.25f, 40);
            case OTHER -> new SurfaceMaterial(Appearance.of(0xb9a98f, 1), 0.15f, 30);
        };
    }
}
