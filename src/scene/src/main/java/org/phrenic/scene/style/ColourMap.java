package org.phrenic.scene.style;

/**
 * A colour map of 33 equally spaced sRGB colours with linear interpolation, readable with colour vision deficiency.
 *
 * <p>{@link #VIRIDIS}, for magnitudes: Smith and van der Walt 2015, public domain (CC0), sampled from its 256 values.
 * {@link #COOL_WARM}, for signed values: Moreland 2009 (doi 10.1007/978-3-642-10520-3_9), computed from the equations
 * of the paper with its end points (59, 76, 192) and (180, 4, 38) and a light grey middle.
 */
public enum ColourMap {
    /** From dark blue through green to yellow; lightness increases with the value. */
    VIRIDIS("440154470d6048186a482374472d7b4536814240863f49893b528b375a8d33638d"
            + "2f6a8e2c728e297a8e26818e23898e21908c1f988b1f9f8821a68528ae8031b57b"
            + "3ebc744cc26c5dc9636ece5882d34c96d83fabdc32c0df24d5e21aeae51afde725"),
    /** Diverging map from blue through light grey to red, for ranges centred at zero. */
    COOL_WARM("3b4cc0445acc4e68d75875e16282ea6c8ef1779af782a5fb8db0fe98b9ffa3c2ff"
            + "aec9fdb8d0f9c2d5f4ccd9eed5dbe6dddddde5d8d1ecd3c6f1ccb9f5c4adf7bba0"
            + "f7b194f7a687f49a7bf18d6fec7f63e57057de614cd55042cb3e38c0282fb40426"),
    /**
     * Map for access. Skin colour: never free. Light to deep amber: free in part of a breath. Bluish green: always
     * free. Lightness and hue differ, for readers with colour vision deficiency.
     */
    ACCESS("dbb9a2f6d56bf5d268f4cf65f3cc62f2c95ef1c65bf0c358efc055eebc52edb94e"
            + "ecb64bebb348eab045e9ad42e8aa3fe8a73ce7a438e6a135e59e32e49b2fe3982c"
            + "e29528e19225e08e22df8b1fde881cdd8519dc8216db7f12da7c0fd9790c108a7c");

    private static final int DIGITS = 6;

    /** Six hexadecimal digits per colour. */
    private final String samples;

    ColourMap(String samples) {
        this.samples = samples;
    }

    /**
     * Colour at a fraction of the range.
     *
     * @param share fraction of the range, clamped to 0 to 1
     * @param rgb receives red, green and blue, sRGB, 0 to 1
     */
    public void sample(double share, float[] rgb) {
        int last = samples.length() / DIGITS - 1;
        double place = Math.max(0, Math.min(1, share)) * last;
        int below = Math.min((int) place, last - 1);
        float over = (float) (place - below);
        for (int i = 0; i < 3; i++) {
            float from = channel(below, i);
            rgb[i] = from + over * (channel(below + 1, i) - from);
        }
    }

    /** Colour at a fraction of the range, as {@code 0xRRGGBB}. */
    public int rgb(double share) {
        float[] rgb = new float[3];
        sample(share, rgb);
        return Math.round(rgb[0] * 255) << 16 | Math.round(rgb[1] * 255) << 8 | Math.round(rgb[2] * 255);
    }

    /** Colours at {@code count} equal steps for a one-dimensional texture: sRGB red, green and blue, 0 to 1. */
    public float[] table(int count) {
        float[] table = new float[3 * count];
        float[] rgb = new float[3];
        for (int i = 0; i < count; i++) {
            sample(count == 1 ? 0 : i / (count - 1.0), rgb);
            System.arraycopy(rgb, 0, table, 3 * i, 3);
        }
        return table;
    }

    private float channel(int sample, int channel) {
        int at = DIGITS * sample + 2 * channel;
        return Integer.parseInt(samples, at, at + 2, 16) / 255f;
    }
}
