package org.phrenic.scene.style;

/**
 * How one structure is drawn.
 *
 * @param visible whether it is drawn at all
 * @param rgb sRGB red, green, blue, 0 to 1; not to be written to
 * @param opacity 1 opaque, 0 invisible
 * @param wireframe its edges instead of its faces
 */
public record Appearance(boolean visible, float[] rgb, float opacity, boolean wireframe) {
    /** @throws IllegalArgumentException if there are not three colours or the opacity is not within 0 and 1 */
    public Appearance {
        if (rgb.length != 3) {
            throw new IllegalArgumentException("found " + rgb.length + " colour components, expected 3");
        }
        if (!(opacity >= 0 && opacity <= 1)) {
            throw new IllegalArgumentException("found an opacity of " + opacity + ", expected 0 to 1");
        }
        rgb = rgb.clone();
    }

    /** Drawn with faces in a colour given as {@code 0xRRGGBB}. */
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
