package org.phrenic.mesh.io.image;

import java.util.Map;
import java.util.function.IntFunction;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.voxel.VoxelBox;

/**
 * What a file of voxels holds: one frame or several, each with one number or three a voxel.
 *
 * @param box size and place of the voxels
 * @param components 1, or 3 for displacements in mm, LPS; the components of a voxel lie side by side
 * @param type of the stored numbers: UINT8, UINT16, INT16 or FLOAT32
 * @param times number and times of the frames
 * @param frame values of each frame, asked for once and in order
 * @param about what the values are, as key and text, for the header; "content" is one line of at most 79 characters
 */
public record VoxelSeries(
        VoxelBox box,
        int components,
        ScalarType type,
        Times times,
        IntFunction<float[]> frame,
        Map<String, String> about) {
    /** Key of a line of text that says what the values are. */
    public static final String CONTENT = "content";

    /**
     * Times of frames.
     *
     * @param frames number of frames
     * @param firstS time of the first, s
     * @param intervalS mean time between two frames, s
     */
    public record Times(int frames, double firstS, double intervalS) {
        /** Times that follow one another, s. */
        public static Times of(double[] s) {
            double range = s[s.length - 1] - s[0];
            return new Times(s.length, s[0], s.length > 1 ? range / (s.length - 1) : 0);
        }
    }

    /** One frame without a time. */
    public static VoxelSeries of(
            VoxelBox box, int components, ScalarType type, float[] values, Map<String, String> about) {
        return new VoxelSeries(box, components, type, new Times(1, 0, 0), any -> values, about);
    }

    /** Number of frames. */
    int frames() {
        return times.frames();
    }

    /** Bytes of a range of values of one component. Components are turned by their sign. */
    byte[] encode(float[] values, int component, int from, int to, double sign) {
        byte[] bytes = new byte[(to - from) * type.size()];
        for (int v = from, at = 0; v < to; v++) {
            float value = (float) (sign * values[components * v + component]);
            at = put(value, bytes, at);
        }
        return bytes;
    }

    /** Bytes of a range of voxels, components side by side. */
    byte[] encode(float[] values, int from, int to) {
        byte[] bytes = new byte[(to - from) * components * type.size()];
        for (int k = components * from, at = 0; k < components * to; k++) {
            at = put(values[k], bytes, at);
        }
        return bytes;
    }

    private int put(float value, byte[] bytes, int at) {
        int bits = type == ScalarType.FLOAT32 ? Float.floatToIntBits(value) : Math.round(value);
        for (int b = 0; b < type.size(); b++) {
            bytes[at + b] = (byte) (bits >> (Byte.SIZE * b));
        }
        return at + type.size();
    }
}
