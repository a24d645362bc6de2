package org.phrenic.mesh.io.dicom;

import java.util.Arrays;

/** Frames packed in run lengths (PS3.5, annex G): one segment a byte of a pixel, the most significant first. */
final class RunLength {
    private static final int HEADER = 64;
    private static final int MAX_SEGMENTS = 15;
    /** Two bytes give 128 at most. */
    static final long MAX_RATIO = 64;

    private final DicomBytes bytes;
    private final int from;
    private final int to;

    /** The fragment from {@code from} to {@code to}. */
    RunLength(DicomBytes bytes, int from, int to) {
        this.bytes = bytes;
        this.from = from;
        this.to = to;
    }

    /** Unpacks all segments into {@code pixels}, each pixel the number that its bytes make. */
    void unpack(int segments, int[] pixels) {
        if (to - from < HEADER) {
            throw bytes.badInput(from, "found a frame of " + (to - from) + " bytes, expected at least " + HEADER);
        }
        int stated = bytes.bytes().getInt(from);
        if (stated != segments || segments > MAX_SEGMENTS) {
            throw bytes.badInput(from, "found " + stated + " segments of run lengths, expected " + segments);
        }
        Arrays.fill(pixels, 0);
        for (int s = 0; s < segments; s++) {
            int start = bytes.bytes().getInt(from + 4 + 4 * s);
            int end = s + 1 < segments ? bytes.bytes().getInt(from + 8 + 4 * s) : to - from;
            if (start < HEADER || end < start || end > to - from) {
                throw bytes.badInput(
                        from,
                        "found a segment from " + start + " to " + end + ", expected one within " + (to - from)
                                + " bytes");
            }
            unpack(from + start, from + end, pixels);
        }
    }

    private void unpack(int start, int end, int[] pixels) {
        int at = start;
        int pixel = 0;
        while (pixel < pixels.length) {
            if (at + 1 >= end) {
                throw bytes.badInput(
                        at, "found the end of a segment after " + pixel + " pixels, expected " + pixels.length);
            }
            int code = bytes.bytes().get(at++);
            if (code >= 0) {
                int literal = Math.min(code + 1, pixels.length - pixel);
                if (literal > end - at) {
                    throw bytes.badInput(at, "found the end of a segment, expected " + literal + " bytes");
                }
                for (int n = 0; n < literal; n++) {
                    pixels[pixel + n] = shifted(pixels[pixel + n], at + n);
                }
                pixel += literal;
                at += code + 1;
            } else if (code != Byte.MIN_VALUE) {
                int run = Math.min(1 - code, pixels.length - pixel);
                for (int n = 0; n < run; n++) {
                    pixels[pixel + n] = shifted(pixels[pixel + n], at);
                }
                pixel += run;
                at++;
            }
        }
    }

    private int shifted(int pixel, int at) {
        return (pixel << Byte.SIZE) | (bytes.bytes().get(at) & 0xFF);
    }
}
