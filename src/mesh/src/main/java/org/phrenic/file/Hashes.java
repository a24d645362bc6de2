package org.phrenic.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * SHA-256 hashes (FIPS 180-4) as 64 lower-case hexadecimal digits. They identify inputs and compare final states bit
 * for bit.
 */
public final class Hashes {
    private static final int CHUNK_BYTES = 1 << 16;

    private Hashes() {}

    /**
     * The hash of the bytes of {@code file}.
     *
     * @throws BadInputException if it cannot be read
     */
    public static String sha256(Path file) {
        if (Files.isDirectory(file)) {
            throw new BadInputException(file + ": found a folder, expected a file");
        }
        MessageDigest digest = digest();
        byte[] chunk = new byte[CHUNK_BYTES];
        try (InputStream in = Files.newInputStream(file)) {
            for (int count = in.read(chunk); count >= 0; count = in.read(chunk)) {
                digest.update(chunk, 0, count);
            }
        } catch (IOException failure) {
            throw new BadInputException(file + ": found a file that cannot be read, expected one to hash", failure);
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    /** The hash of the bits of all numbers (IEEE 754 binary64, big endian), one array after the other. */
    public static String sha256(double[]... arrays) {
        MessageDigest digest = digest();
        ByteBuffer chunk = ByteBuffer.allocate(CHUNK_BYTES);
        for (double[] array : arrays) {
            for (int from = 0; from < array.length; from += CHUNK_BYTES / Double.BYTES) {
                int count = Math.min(CHUNK_BYTES / Double.BYTES, array.length - from);
                chunk.clear().asDoubleBuffer().put(array, from, count);
                digest.update(chunk.array(), 0, Double.BYTES * count);
            }
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    /** The hash of numbers (big endian). */
    public static String sha256(int[] numbers) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * numbers.length);
        bytes.asIntBuffer().put(numbers);
        return sha256(bytes.array());
    }

    /** The hash of bytes. */
    public static String sha256(byte[] bytes) {
        return HexFormat.of().formatHex(digest().digest(bytes));
    }

    private static MessageDigest digest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException missing) {
            throw new IllegalStateException("every Java platform has SHA-256", missing);
        }
    }
}
