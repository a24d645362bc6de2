package org.phrenic.mesh.io.raster;

import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.zip.ZipException;
import org.apache.commons.compress.compressors.bzip2.BZip2CompressorInputStream;

/** Voxels packed by bzip2, in one stream or several. Damage is told as that of other packed data is. */
final class Bzip2Voxels extends FilterInputStream {
    private Bzip2Voxels(InputStream unpacked) {
        super(unpacked);
    }

    static Bzip2Voxels of(InputStream packed) throws IOException {
        boolean severalStreams = true;
        try {
            return new Bzip2Voxels(new BZip2CompressorInputStream(packed, severalStreams));
        } catch (EOFException ended) {
            throw ended;
        } catch (IOException damaged) {
            throw damage(damaged);
        }
    }

    private static IOException damage(IOException of) {
        ZipException damage = new ZipException(of.getMessage());
        damage.initCause(of);
        return damage;
    }

    @Override
    public int read(byte[] into, int from, int count) throws IOException {
        try {
            return super.read(into, from, count);
        } catch (EOFException ended) {
            throw ended;
        } catch (IOException damaged) {
            throw damage(damaged);
        }
    }
}
