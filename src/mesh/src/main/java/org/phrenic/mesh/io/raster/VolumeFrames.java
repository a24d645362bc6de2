package org.phrenic.mesh.io.raster;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import org.phrenic.file.BadInputException;

/**
 * The volumes of one size that a file holds, such as the phases of a breath.
 *
 * @param count number of volumes
 * @param interleaved whether all values of a voxel are stored side by side; otherwise volume follows volume
 */
record VolumeFrames(int count, boolean interleaved) {
    static final VolumeFrames ONE = new VolumeFrames(1, false);
    /** The most volumes of a file, so that sizes in bytes fit into a long. */
    private static final int MAX_COUNT = 100_000;

    private static final int BLOCK = 1 << 16;

    /**
     * The number of the volume that is read.
     *
     * @throws BadInputException if one of several has to be named, or the file has none of this number
     */
    int choose(VolumeSource source) {
        Path file = source.path();
        if (count < 1 || count > MAX_COUNT) {
            throw new BadInputException(
                    file + ": found " + count + " volumes, expected from 1 to " + MAX_COUNT + " of them");
        }
        if (source.phase().isEmpty() && count > 1) {
            throw new SeveralValuesException(
                    new BadInputException(file + ": found " + count + " volumes, expected the number of one, #0 to #"
                            + (count - 1) + ", after the name: " + file.getFileName() + "#0"));
        }
        int chosen = source.phase().orElse(0);
        if (chosen >= count) {
            throw new BadInputException(file + ": found " + count + (count == 1 ? " volume" : " volumes")
                    + " and none with the number " + chosen + ", expected a number from 0 to " + (count - 1));
        }
        return chosen;
    }

    /** The values of one volume; {@code in} is positioned at the first voxel of the first. */
    InputStream select(InputStream in, VoxelDecoder voxels, int frame) throws IOException {
        if (count == 1) {
            return in;
        }
        if (interleaved) {
            return new Interleaved(in, count, frame, voxels.type().size());
        }
        in.skipNBytes(frame * voxels.bytes());
        return in;
    }

    /** Every {@code count}th value of a stream. */
    private static final class Interleaved extends InputStream {
        private final InputStream in;
        private final int frame;
        private final int size;
        private final byte[] block;
        private final byte[] picked;
        private final int tuple;
        private int at;
        private int end;

        Interleaved(InputStream in, int count, int frame, int size) {
            this.in = in;
            this.frame = frame;
            this.size = size;
            tuple = count * size;
            int tuples = Math.max(1, BLOCK / tuple);
            block = new byte[tuples * tuple];
            picked = new byte[tuples * size];
        }

        @Override
        public int read() throws IOException {
            return isFilled() ? picked[at++] & 0xFF : -1;
        }

        @Override
        public int read(byte[] to, int offset, int length) throws IOException {
            if (length == 0) {
                return 0;
            }
            if (!isFilled()) {
                return -1;
            }
            int now = Math.min(length, end - at);
            System.arraycopy(picked, at, to, offset, now);
            at += now;
            return now;
        }

        private boolean isFilled() throws IOException {
            if (at < end) {
                return true;
            }
            int tuples = in.readNBytes(block, 0, block.length) / tuple;
            for (int t = 0; t < tuples; t++) {
                System.arraycopy(block, t * tuple + frame * size, picked, t * size, size);
            }
            at = 0;
            end = tuples * size;
            return end > 0;
        }
    }
}
