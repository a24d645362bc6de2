package org.phrenic.mesh.io.dicom;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.phrenic.file.JavaMemory;

/**
 * A DICOM file (PS3.10).
 *
 * @param dataSet elements of the object
 * @param transferSyntax identifier of the encoding of elements and pixels
 */
public record DicomFile(DicomDataSet dataSet, String transferSyntax) {
    private static final int PREAMBLE = 128;
    private static final byte[] MAGIC = "DICM".getBytes(StandardCharsets.US_ASCII);
    private static final int META_GROUP = 2;
    /** Greatest fraction of the Java heap for the bytes of one file. */
    private static final double MAX_MEMORY = 0.4;

    private static final String IMPLICIT = "1.2.840.10008.1.2";
    private static final String EXPLICIT = "1.2.840.10008.1.2.1";
    private static final String DEFLATED = "1.2.840.10008.1.2.1.99";
    private static final String BIG_ENDIAN = "1.2.840.10008.1.2.2";
    private static final String RUN_LENGTH = "1.2.840.10008.1.2.5";
    private static final Set<String> PLAIN = Set.of(IMPLICIT, EXPLICIT, DEFLATED, BIG_ENDIAN);

    /** Whether an existing file begins as a DICOM file does. */
    public static boolean isDicom(Path file) {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] start = in.readNBytes(PREAMBLE + MAGIC.length);
            return hasMagic(start);
        } catch (IOException unreadable) {
            return false;
        }
    }

    private static boolean hasMagic(byte[] content) {
        int end = PREAMBLE + MAGIC.length;
        return content.length >= end && Arrays.equals(content, PREAMBLE, end, MAGIC, 0, MAGIC.length);
    }

    /**
     * Reads a file.
     *
     * @throws BadInputException if it is no DICOM file or damaged; the message is one sentence
     */
    public static DicomFile read(Path path) {
        String file = path.toString();
        checkMemory(file, InputBytes.size(path));
        byte[] content = InputBytes.read(path);
        if (!hasMagic(content)) {
            throw BadInputException.at(file, "byte " + PREAMBLE, "found no 'DICM', expected a DICOM file");
        }
        ByteBuffer buffer = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        DicomBytes meta = new DicomBytes(file, buffer, true);
        int start = PREAMBLE + MAGIC.length;
        int end = endOfMeta(meta, start, content.length);
        DicomDataSet head = new DicomDataSet(meta, start, end, false, null);
        if (!head.has(DicomTag.TRANSFER_SYNTAX_UID)) {
            throw new BadInputException(file + ": found no transfer syntax (0002,0010), expected the one of its data;"
                    + " export it again as a DICOM segmentation or structure set, or as NIfTI");
        }
        String syntax = head.text(DicomTag.TRANSFER_SYNTAX_UID);
        DicomBytes bytes =
                switch (syntax) {
                    case IMPLICIT -> new DicomBytes(file, buffer, false);
                    case BIG_ENDIAN ->
                        new DicomBytes(file, ByteBuffer.wrap(content).order(ByteOrder.BIG_ENDIAN), true);
                    case DEFLATED -> {
                        byte[] inflated = inflated(file, content, end);
                        end = 0;
                        yield new DicomBytes(file, ByteBuffer.wrap(inflated).order(ByteOrder.LITTLE_ENDIAN), true);
                    }
                    // All others have explicit elements, and pixels packed in a way of their own.
                    default -> meta;
                };
        DicomDataSet dataSet = new DicomDataSet(bytes, end, bytes.bytes().capacity(), false, null);
        return new DicomFile(dataSet, syntax);
    }

    /** Whether pixels are packed in run lengths (PS3.5, annex G). */
    boolean isRunLength() {
        return transferSyntax.equals(RUN_LENGTH);
    }

    /** Whether pixels follow one another as they are. */
    boolean isPlain() {
        return PLAIN.contains(transferSyntax);
    }

    private static void checkMemory(String file, long size) {
        long memory = Runtime.getRuntime().maxMemory();
        if (size > MAX_MEMORY * memory) {
            throw new BadInputException(file + ": found more than " + (int) (100 * MAX_MEMORY)
                    + " % of Java's memory, which is " + JavaMemory.inWords(memory) + ", expected less");
        }
    }

    /** The place after the elements of group 2, which precede the data set. */
    private static int endOfMeta(DicomBytes bytes, int start, int end) {
        int next = start;
        while (end - next >= 8 && bytes.tag(next) >>> 16 == META_GROUP) {
            Map<Integer, DicomElement> one = new HashMap<>();
            next = bytes.step(next, end, 0, one);
        }
        return next;
    }

    private static byte[] inflated(String file, byte[] content, int from) {
        Inflater inflater = new Inflater(true);
        try {
            inflater.setInput(content, from, content.length - from);
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            byte[] chunk = new byte[1 << 16];
            while (!inflater.finished()) {
                int now = inflater.inflate(chunk);
                if (now == 0 && (inflater.needsInput() || inflater.needsDictionary())) {
                    throw new BadInputException(
                            file + ": found deflated data that ends too early, expected a whole DICOM file");
                }
                out.write(chunk, 0, now);
                // The stream holds its bytes up to three times while it grows and is copied.
                checkMemory(file, 3L * out.size());
            }
            return out.toByteArray();
        } catch (DataFormatException damaged) {
            throw new BadInputException(
                    file + ": found damaged deflated data (" + damaged.getMessage() + "), expected what was packed",
                    damaged);
        } finally {
            inflater.end();
        }
    }
}
