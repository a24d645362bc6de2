package org.phrenic.mesh.io;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.OptionalDouble;
import java.util.StringTokenizer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputLocator;
import org.phrenic.file.Numbers;

/** The values of one DataArray of a VTP file, decoded from any of its formats. */
final class VtpArray implements InputLocator {
    /**
     * Deflate cannot shrink data more than this (zlib.net, "Technical details"): a header that promises more is wrong.
     */
    private static final long LARGEST_RATIO = 1032;

    private final String file;
    private final VtpDocument document;
    private final VtpDocument.DataArray array;
    private long place;

    VtpArray(String file, VtpDocument document, VtpDocument.DataArray array) {
        this.file = file;
        this.document = document;
        this.array = array;
    }

    /** The index of the value spoken about. */
    @Override
    public long location() {
        return place;
    }

    void setIndex(long index) {
        place = index;
    }

    @Override
    public BadInputException badInput(long where, String problem) {
        return BadInputException.at(
                file, "line " + array.line() + ", array " + array.name() + ", value " + where, problem);
    }

    private BadInputException badArray(String problem) {
        return BadInputException.at(file, "line " + array.line() + ", array " + array.name(), problem);
    }

    /** The values as real numbers; those from binary data may be NaN. */
    double[] doubles(byte[] bytes) {
        if (array.format().equals("ascii")) {
            StringTokenizer words = new StringTokenizer(array.text());
            double[] values = new double[words.countTokens()];
            for (int i = 0; i < values.length; i++) {
                String word = words.nextToken();
                OptionalDouble value = Numbers.parse(word);
                if (value.isEmpty()) {
                    throw badInput(i, "found " + Numbers.quote(word) + ", expected a finite number");
                }
                values[i] = value.getAsDouble();
            }
            return values;
        }
        ByteBuffer content = content(bytes);
        int size = array.type().size();
        double[] values = new double[content.capacity() / size];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.type().readDouble(content, i * size);
        }
        return values;
    }

    /** The values as whole numbers. */
    long[] longs(byte[] bytes) {
        if (!array.type().isInteger()) {
            throw badArray("found real numbers, expected a whole-number type");
        }
        if (array.format().equals("ascii")) {
            StringTokenizer words = new StringTokenizer(array.text());
            long[] values = new long[words.countTokens()];
            for (int i = 0; i < values.length; i++) {
                String word = words.nextToken();
                try {
                    values[i] = Long.parseLong(word);
                } catch (NumberFormatException notWhole) {
                    throw badInput(i, "found " + Numbers.quote(word) + ", expected a whole number");
                }
            }
            return values;
        }
        ByteBuffer content = content(bytes);
        int size = array.type().size();
        long[] values = new long[content.capacity() / size];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.type().readLong(content, i * size);
        }
        return values;
    }

    private ByteBuffer content(byte[] bytes) {
        VtpBytes source = source(bytes);
        byte[] content = document.compressed() ? inflated(source) : plain(source);
        if (content.length % array.type().size() != 0) {
            throw badArray("found " + content.length + " bytes, expected a multiple of "
                    + array.type().size());
        }
        return ByteBuffer.wrap(content).order(document.order());
    }

    private VtpBytes source(byte[] bytes) {
        if (array.format().equals("binary")) {
            return VtpBytes.base64(array.text().getBytes(StandardCharsets.ISO_8859_1), 0);
        }
        if (document.appended() < 0) {
            throw badArray("found format 'appended', expected the file to hold AppendedData");
        }
        long from = document.appended() + array.offset();
        if (from < 0 || from >= bytes.length) {
            throw badArray("found offset " + array.offset() + ", expected one within the "
                    + (bytes.length - document.appended()) + " bytes of appended data");
        }
        return document.appendedRaw() ? VtpBytes.raw(bytes, (int) from) : VtpBytes.base64(bytes, (int) from);
    }

    private byte[] plain(VtpBytes source) {
        return take(source, headerNumber(source));
    }

    private byte[] inflated(VtpBytes source) {
        long blocks = headerNumber(source);
        long blockSize = headerNumber(source);
        long lastSize = headerNumber(source);
        if (blocks == 0) {
            return new byte[0];
        }
        if (blocks < 0 || blocks > source.remaining() / document.headerType().size()) {
            throw badArray("found " + blocks + " compressed blocks promised, expected what the file can hold");
        }
        long[] packed = new long[(int) blocks];
        long packedTotal = 0;
        for (int b = 0; b < blocks; b++) {
            packed[b] = headerNumber(source);
            packedTotal += packed[b];
            if (packed[b] < 0 || packedTotal > source.remaining()) {
                throw badArray("found the end of the data, expected " + blocks + " compressed blocks");
            }
        }
        boolean sane = blockSize >= 0 && lastSize >= 0 && blockSize <= Integer.MAX_VALUE && lastSize <= blockSize;
        long total = sane ? (lastSize == 0 ? blocks * blockSize : (blocks - 1) * blockSize + lastSize) : -1;
        if (!sane || total > Integer.MAX_VALUE - 8 || total > LARGEST_RATIO * packedTotal) {
            throw badArray("found blocks of " + blockSize + " bytes promised from " + packedTotal
                    + " compressed bytes, expected what zlib can pack");
        }
        byte[] content = new byte[(int) total];
        int filled = 0;
        for (int b = 0; b < blocks; b++) {
            int expected = (int) (b == blocks - 1 && lastSize > 0 ? lastSize : blockSize);
            inflate(take(source, packed[b]), content, filled, expected);
            filled += expected;
        }
        return content;
    }

    private void inflate(byte[] packed, byte[] content, int from, int expected) {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed);
            int got = 0;
            while (got < expected) {
                int more = inflater.inflate(content, from + got, expected - got);
                if (more == 0) {
                    break;
                }
                got += more;
            }
            // One more call lets the inflater meet the checksum at the end of the block.
            boolean whole = got == expected && (inflater.inflate(new byte[1]) == 0) && inflater.finished();
            if (!whole) {
                throw badArray("found a compressed block of " + got + " bytes, expected " + expected);
            }
        } catch (DataFormatException broken) {
            throw new BadInputException(
                    badArray("found compressed data that is damaged, expected zlib")
                            .getMessage(),
                    broken);
        } finally {
            inflater.end();
        }
    }

    private long headerNumber(VtpBytes source) {
        byte[] number = take(source, document.headerType().size());
        return document.headerType().readLong(ByteBuffer.wrap(number).order(document.order()), 0);
    }

    private byte[] take(VtpBytes source, long count) {
        byte[] taken = count < 0 || count > source.remaining() ? null : source.take((int) count);
        if (taken == null) {
            throw badArray("found the end of the data, expected " + count + " more bytes");
        }
        return taken;
    }
}
