package org.phrenic.mesh.io;

import java.util.Arrays;

/** Bytes of a VTP array taken one after the other, from raw or base64 content. */
interface VtpBytes {
    /** How many bytes can be taken at most. */
    long remaining();

    /** The next {@code count} bytes, null if there are not so many (or no base64) left. */
    byte[] take(int count);

    static VtpBytes raw(byte[] content, int from) {
        return new VtpBytes() {
            private int at = from;

            @Override
            public long remaining() {
                return (long) content.length - at;
            }

            @Override
            public byte[] take(int count) {
                if (count > remaining()) {
                    return null;
                }
                at += count;
                return Arrays.copyOfRange(content, at - count, at);
            }
        };
    }

    /**
     * Base64 in groups of four characters, white space between them passed over. A group that ends with '=' does not
     * end the content: VTK encodes the header of compressed data by itself, and the data right behind it.
     */
    static VtpBytes base64(byte[] content, int from) {
        return new VtpBytes() {
            private final byte[] group = new byte[3];
            private int groupSize;
            private int groupAt;
            private int at = from;

            @Override
            public long remaining() {
                return 3L * (content.length - at) / 4 + 3 + groupSize - groupAt;
            }

            @Override
            public byte[] take(int count) {
                if (count > remaining()) {
                    return null;
                }
                byte[] taken = new byte[count];
                for (int i = 0; i < count; i++) {
                    if (groupAt == groupSize && !nextGroup()) {
                        return null;
                    }
                    taken[i] = group[groupAt++];
                }
                return taken;
            }

            private boolean nextGroup() {
                int bits = 0;
                int padding = 0;
                for (int i = 0; i < 4; i++) {
                    while (at < content.length && content[at] <= ' ' && content[at] >= 0) {
                        at++;
                    }
                    if (at == content.length) {
                        return false;
                    }
                    byte character = content[at++];
                    if (character == '=' && i >= 2) {
                        padding++;
                        bits <<= 6;
                        continue;
                    }
                    int value = sixBits(character);
                    if (value < 0 || padding > 0) {
                        return false;
                    }
                    bits = bits << 6 | value;
                }
                group[0] = (byte) (bits >> 16);
                group[1] = (byte) (bits >> 8);
                group[2] = (byte) bits;
                groupSize = 3 - padding;
                groupAt = 0;
                return true;
            }
        };
    }

    private static int sixBits(byte c) {
        if (c >= 'A' && c <= 'Z') {
            return c - 'A';
        }
        if (c >= 'a' && c <= 'z') {
            return c - 'a' + 26;
        }
        if (c >= '0' && c <= '9') {
            return c - '0' + 52;
        }
        return c == '+' ? 62 : c == '/' ? 63 : -1;
    }
}
