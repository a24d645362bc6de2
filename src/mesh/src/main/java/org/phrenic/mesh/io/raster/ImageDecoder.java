package org.phrenic.mesh.io.raster;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import org.phrenic.file.BadInputException;
import org.phrenic.file.ScalarType;
import org.phrenic.mesh.voxel.ImageGrid;

/** Decodes the stored voxels of a volume to real values: slope times the stored value plus intercept. */
final class ImageDecoder {
    private static final int CHUNK = 1 << 15;
    /** Initial capacity in voxels; it grows with the data read, not with what a header promises. */
    private static final int INITIAL_CAPACITY = 1 << 20;

    private ImageDecoder() {}

    /**
     * Reads all voxels of one volume.
     *
     * @param in uncompressed data, positioned at the first voxel
     * @throws BadInputException if the data ends too early or a value is not finite
     */
    static ImageGrid decode(String file, InputStream in, VoxelDecoder voxels, double[] affine) throws IOException {
        voxels.checkMemory(file, Float.BYTES);
        int count = (int) voxels.voxels();
        float[] values = new float[Math.min(count, INITIAL_CAPACITY)];
        ScalarType type = voxels.type();
        byte[] chunk = new byte[CHUNK * type.size()];
        ByteBuffer buffer = ByteBuffer.wrap(chunk).order(voxels.order());
        for (int done = 0; done < count; ) {
            int now = Math.min(CHUNK, count - done);
            if (in.readNBytes(chunk, 0, now * type.size()) < now * type.size()) {
                throw new EOFException();
            }
            if (done + now > values.length) {
                values = Arrays.copyOf(values, (int) Math.min(count, 2L * values.length));
            }
            for (int n = 0; n < now; n++) {
                values[done + n] = value(file, voxels, buffer, n, done);
            }
            done += now;
        }
        // Reading to the end of a compressed file verifies its checksum.
        in.transferTo(OutputStream.nullOutputStream());
        int[] sizes = voxels.sizes();
        return new ImageGrid(sizes[0], sizes[1], sizes[2], values, affine);
    }

    private static float value(String file, VoxelDecoder voxels, ByteBuffer from, int n, int first) {
        float value = (float) (voxels.slope()
                        * voxels.type().readDouble(from, n * voxels.type().size())
                + voxels.intercept());
        if (!Float.isFinite(value)) {
            throw BadInputException.at(file, voxels.place(first + n), "found " + value + ", expected a finite number");
        }
        return value;
    }
}
