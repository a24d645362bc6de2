package org.phrenic.scene.style;

/**
 * Visibility, colour, opacity and wireframe mode of one structure.
 *
 * @param visible whether the structure is drawn
 * @param rgb sRGB red, green, blue, 0 to 1; must not be modified
 * @param opacity 0 (invisible) to 1 (opaque)
 * @param wireframe whether edges are drawn instead of faces
 */
public record Appearance(boolean visible, float[] rgb, float opacity, boolean wireframe) {
    /** @throws IllegalArgumentException if {@code rgb} has not three components or the opacity is outside 0 to 1 */
    public Appearance {
        if (rgb.length != 3) {
            throw new IllegalArgumentException("found " + rgb.length + " colour components, expected 3");
        }
        if (!(opacity >= 0 && opacity <= 1)) {
            throw new IllegalArgumentException("found an opacity of " + opacity + ", expected 0 to 1");
        }
        rgb = rgb.clone();
    }

    /** A visible appearance with faces in the colour {@code 0xRRGGBB}. */
    public static Appearance of(int colour, float opacity) {
        float[] rgb = {(colour >> 16 & 0xff) / 255f, (colour >> 8 & 0xff) / 255f, (colour & 0xff) / 255f};
        return new Appearance(true, rgb, opacity, false);
    }

    public Appearance withVisible(boolean shown) {
        return new Appearance(shown, rgb, opacity, wireframe);
    }

    public Appearance withRgb(float[] colour) {
        return new Appearance(visible, colour, opacity, wireframe);
    }

    public Appearance withOpacity(float share) {
        return new Appearance(visible, rgb, share, wireframe);
    }

    public Appearance withWireframe(boolean edges) {
        return new Appearance(visible, rgb, opacity, edges);
    }

    /** The colour as {@code 0xRRGGBB}. */
    public int packedRgb() {
        return Math.round(255 * rgb[0]) << 16 | Math.round(255 * rgb[1]) << 8 | Math.round(255 * rgb[2]);
    }

    public boolean isTranslucent() {
        return opacity < 1;
    }
}
