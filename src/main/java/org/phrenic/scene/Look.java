package org.phrenic.scene;

/**
 * How one structure is drawn.
 *
 * @param visible whether it is drawn at all
 * @param rgb sRGB red, green, blue, 0 to 1; not to be written to
 * @param opacity 1 hides what lies behind; 0 is clear
 * @param wireframe its edges instead of its faces
 */
public record Look(boolean visible, float[] rgb, float opacity, boolean wireframe) {
    /**
     * @throws IllegalArgumentException if there are not three colours or the opacity is not within 0 and 1
     */
    public Look {
        if (rgb.length != 3) {
            throw new IllegalArgumentException("found " + rgb.length + " colour components, expected 3");
        }
        if (!(opacity >= 0 && opacity <= 1)) {
            throw new IllegalArgumentException("found an opacity of " + opacity + ", expected 0 to 1");
        }
        rgb = rgb.clone();
    }

    /** Drawn with faces in a colour given as {@code 0xRRGGBB}. */
    public static Look of(int colour, float opacity) {
        float[] rgb = {(colour >> 16 & 0xff) / 255f, (colour >> 8 & 0xff) / 255f, (colour & 0xff) / 255f};
        return new Look(true, rgb, opacity, false);
    }

    public Look withVisible(boolean shown) {
        return new Look(shown, rgb, opacity, wireframe);
    }

    public Look withRgb(float[] colour) {
        return new Look(visible, colour, opacity, wireframe);
    }

    public Look withOpacity(float share) {
        return new Look(visible, rgb, share, wireframe);
    }

    public Look withWireframe(boolean edges) {
        return new Look(visible, rgb, opacity, edges);
    }

    boolean translucent() {
        return opacity < 1;
    }
}
