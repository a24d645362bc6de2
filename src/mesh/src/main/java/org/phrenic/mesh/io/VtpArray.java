package org.phrenic.mesh.io;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Collections;
import java.util.StringTokenizer;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.apache.commons.compress.compressors.lz4.BlockLZ4CompressorInputStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputLocator;
import org.phrenic.file.Numbers;

/** The decoded values of one DataArray of a VTP file, in any of its formats; a location is the index of a value. */
final class VtpArray implements InputLocator {
    /** Greatest compression ratio of deflate (zlib.net, "Technical details"). */
    private static final long MAX_RATIO = 1032;

    private static final String ZLIB = "vtkZLibDataCompressor";
    private static final String LZ4 = "vtkLZ4DataCompressor";

    private final String file;
    private final VtpDocument document;
    private final VtpDocument.DataArray array;
    private long index;

    VtpArray(String file, VtpDocument document, VtpDocument.DataArray array) {
        this.file = file;
        this.document = document;
        this.array = array;
    }

    @Override
    public long location() {
        return index;
    }

    void setIndex(long value) {
        index = value;
    }

    @Override
    public BadInputException badInput(long where, String problem) {
        return BadInputException.at(
                file, "line " + array.line() + ", array " + array.name() + ", value " + where, problem);
    }

    private BadInputException bad(int value, String found, String expected) {
        return badInput(value, "found " + Numbers.quote(found) + ", expected " + expected);
    }

    private BadInputException badArray(String problem) {
        return BadInputException.at(file, "line " + array.line() + ", array " + array.name(), problem);
    }

    /** The values as real numbers; binary values may be NaN. */
    double[] doubles(byte[] bytes) {
        if (array.format().equals("ascii")) {
            String[] words = words();
            double[] values = new double[words.length];
            Arrays.setAll(values, i -> Numbers.parse(words[i]).orElseThrow(() -> bad(i, words[i], "a finite number")));
            return values;
        }
        ByteBuffer content = content(bytes);
        double[] values = new double[content.capacity() / array.type().size()];
        Arrays.setAll(
                values, i -> array.type().readDouble(content, i * array.type().size()));
        return values;
    }

    /** The values as integers. */
    long[] longs(byte[] bytes) {
        if (!array.type().isInteger()) {
            throw badArray("found real numbers, expected a whole-number type");
        }
        if (array.format().equals("ascii")) {
            String[] words = words();
            long[] values = new long[words.length];
            Arrays.setAll(values, i -> Numbers.parseWhole(words[i], Long.MIN_VALUE, Long.MAX_VALUE)
                    .orElseThrow(() -> bad(i, words[i], "a whole number")));
            return values;
        }
        ByteBuffer content = content(bytes);
        long[] values = new long[content.capacity() / array.type().size()];
        Arrays.setAll(
                values, i -> array.type().readLong(content, i * array.type().size()));
        return values;
    }

    private String[] words() {
        return Collections.list(new StringTokenizer(array.text())).toArray(String[]::new);
    }

    private ByteBuffer content(byte[] bytes) {
        ByteBuffer encoded = encoded(bytes);
        byte[] content = document.compressor.isEmpty() ? take(encoded, headerNumber(encoded)) : unpacked(encoded);
        if (content.length % array.type().size() != 0) {
            throw badArray("found " + content.length + " bytes, expected a multiple of "
                    + array.type().size());
        }
        return ByteBuffer.wrap(content).order(document.order);
    }

    private ByteBuffer encoded(byte[] bytes) {
        if (array.format().equals("binary")) {
            return base64(array.text().getBytes(StandardCharsets.ISO_8859_1), 0);
        }
        if (document.appended < 0) {
            throw badArray("found format 'appended', expected the file to hold AppendedData");
        }
        long from = document.appended + array.offset();
        if (from < 0 || from >= bytes.length) {
            throw badArray("found offset " + array.offset() + ", expected one within the "
                    + (bytes.length - document.appended) + " bytes of appended data");
        }
        return document.appendedRaw
                ? ByteBuffer.wrap(bytes, (int) from, (int) (bytes.length - from))
                : base64(bytes, (int) from);
    }

    /**
     * Decompresses blocks. The header has the number of blocks, the block size, the size of the last partial block or
     * 0, and the compressed sizes.
     */
    private byte[] unpacked(ByteBuffer encoded) {
        if (!document.compressor.equals(ZLIB) && !document.compressor.equals(LZ4)) {
            String found = "found data packed by " + Numbers.quote(document.compressor);
            throw badArray(found + ", expected " + ZLIB + ", " + LZ4 + " or none");
        }
        long blocks = headerNumber(encoded);
        long blockSize = headerNumber(encoded);
        long lastSize = headerNumber(encoded);
        if (blocks == 0) {
            return new byte[0];
        }
        if (blocks < 0 || blocks > encoded.remaining() / document.headerType.size()) {
            throw badArray("found " + blocks + " compressed blocks promised, expected what the file can hold");
        }
        long[] packed = new long[(int) blocks];
        long packedTotal = 0;
        for (int b = 0; b < blocks; b++) {
            packed[b] = headerNumber(encoded);
            packedTotal += packed[b];
            if (packed[b] < 0 || packedTotal > encoded.remaining()) {
                throw badArray("found the end of the data, expected " + blocks + " compressed blocks");
            }
        }
        boolean sane = blockSize >= 0 && lastSize >= 0 && blockSize <= Integer.MAX_VALUE && lastSize <= blockSize;
        long total = sane ? (lastSize == 0 ? blocks * blockSize : (blocks - 1) * blockSize + lastSize) : -1;
        if (!sane || total > Integer.MAX_VALUE - 8 || total > MAX_RATIO * packedTotal) {
            throw badArray("found blocks of " + blockSize + " bytes promised from " + packedTotal
                    + " compressed bytes, expected what these can hold");
        }
        byte[] content = new byte[(int) total];
        int filled = 0;
        for (int b = 0; b < blocks; b++) {
            int expected = (int) (b == blocks - 1 && lastSize > 0 ? lastSize : blockSize);
            byte[] block = take(encoded, packed[b]);
            if (document.compressor.equals(ZLIB)) {
                inflate(block, content, filled, expected);
            } else {
                unpackLz4(block, content, filled, expected);
            }
            filled += expected;
        }
        return content;
    }

    private void unpackLz4(byte[] packed, byte[] content, int from, int expected) {
        try (InputStream block = new BlockLZ4CompressorInputStream(new ByteArrayInputStream(packed))) {
            int got = block.readNBytes(content, from, expected);
            if (got < expected || block.read() >= 0) {
                throw badArray("found a compressed block of another size, expected " + expected + " bytes");
            }
        } catch (IOException | IllegalArgumentException | IndexOutOfBoundsException broken) {
            throw damaged("LZ4", broken);
        }
    }

    private BadInputException damaged(String expected, Exception broken) {
        String problem = "found compressed data that is damaged, expected " + expected;
        return new BadInputException(badArray(problem).getMessage(), broken);
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
            // Another call makes the inflater verify the checksum at the end of the block.
            boolean whole = got == expected && (inflater.inflate(new byte[1]) == 0) && inflater.finished();
            if (!whole) {
                throw badArray("found a compressed block of " + got + " bytes, expected " + expected);
            }
        } catch (DataFormatException broken) {
            throw damaged("zlib", broken);
        } finally {
            inflater.end();
        }
    }

    private long headerNumber(ByteBuffer encoded) {
        byte[] number = take(encoded, document.headerType.size());
        return document.headerType.readLong(ByteBuffer.wrap(number).order(document.order), 0);
    }

    private byte[] take(ByteBuffer encoded, long count) {
        if (count < 0 || count > encoded.remaining()) {
            throw badArray("found the end of the data, expected " + count + " more bytes");
        }
        byte[] taken = new byte[(int) count];
        encoded.get(taken);
        return taken;
    }

    /**
     * Decodes base64 (RFC 4648) from an index to the first character outside its alphabet; white space is skipped.
     * Decoding continues after padding, because VTK encodes the header of compressed data separately from the data
     * after it.
     */
    private static ByteBuffer base64(byte[] content, int from) {
        ByteArrayOutputStream decoded = new ByteArrayOutputStream();
        byte[] segment = new byte[content.length - from];
        int length = 0;
        for (int i = from; i < content.length; i++) {
            byte c = content[i];
            if (c >= 0 && c <= ' ') {
                continue;
            }
            boolean afterPadding = length % 4 != 0 && segment[length - 1] == '=';
            if (c == '=' ? length % 4 < 2 : afterPadding || !isBase64(c)) {
                break;
            }
            segment[length++] = c;
            if (c == '=' && length % 4 == 0) {
                decoded.writeBytes(Base64.getDecoder().decode(Arrays.copyOf(segment, length)));
                length = 0;
            }
        }
        decoded.writeBytes(Base64.getDecoder().decode(Arrays.copyOf(segment, length - length % 4)));
        return ByteBuffer.wrap(decoded.toByteArray());
    }

    private static boolean isBase64(byte c) {
        boolean letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        return letter || (c >= '0' && c <= '9') || c == '+' || c == '/';
    }
}
