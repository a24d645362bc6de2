package org.phrenic.mesh.io;

/**
 * A block of LZ4 (Collet, "LZ4 Block Format Description", github.com/lz4/lz4/blob/dev/doc/lz4_Block_format.md):
 * sequences of literal bytes and of copies of bytes that came before. The last sequence has literals alone.
 */
final class Lz4Block {
    private static final int SHORTEST_COPY = 4;
    /** A length of 15 in a token goes on in the bytes after it, up to the first that is not 255. */
    private static final int MORE = 15;

    private final byte[] packed;
    private final byte[] out;
    private final int start;
    private final int end;
    private int from;
    private int to;

    private Lz4Block(byte[] packed, byte[] out, int start, int length) {
        this.packed = packed;
        this.out = out;
        this.start = start;
        this.end = start + length;
        this.to = start;
    }

    /**
     * Unpacks a block.
     *
     * @param out receives the bytes from {@code start} on
     * @param length number of bytes that the block holds
     * @return whether the block is whole and holds as many
     */
    static boolean unpack(byte[] packed, byte[] out, int start, int length) {
        return new Lz4Block(packed, out, start, length).unpack();
    }

    private boolean unpack() {
        while (from < packed.length) {
            int token = packed[from++] & 0xFF;
            long literals = length(token >> 4);
            if (literals > packed.length - from || literals > end - to) {
                return false;
            }
            System.arraycopy(packed, from, out, to, (int) literals);
            from += (int) literals;
            to += (int) literals;
            if (from == packed.length) {
                return to == end;
            }
            if (!copy(token & MORE)) {
                return false;
            }
        }
        return false;
    }

    private boolean copy(int first) {
        if (packed.length - from < 2) {
            return false;
        }
        int back = (packed[from] & 0xFF) | (packed[from + 1] & 0xFF) << 8;
        from += 2;
        long length = length(first) + SHORTEST_COPY;
        if (back == 0 || back > to - start || length > end - to) {
            return false;
        }
        // A copy may reach into the bytes that it makes.
        for (int n = 0; n < length; n++, to++) {
            out[to] = out[to - back];
        }
        return true;
    }

    private long length(int first) {
        long length = first;
        int more = first == MORE ? 0xFF : 0;
        while (more == 0xFF && from < packed.length) {
            more = packed[from++] & 0xFF;
            length += more;
        }
        return length;
    }
}
