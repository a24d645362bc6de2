package org.phrenic.document;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;

/** Reads text files in UTF-8, with or without byte order mark. */
public final class TextFile {
    private TextFile() {}

    /**
     * Reads {@code file}.
     *
     * @param expected description of the content for error messages
     * @throws BadInputException if it cannot be read or is not UTF-8
     */
    public static String read(Path file, String expected) {
        return decode(file, InputBytes.read(file), expected);
    }

    /**
     * The text of bytes of {@code file}.
     *
     * @param expected description of the content for error messages
     * @throws BadInputException if they are not UTF-8
     */
    public static String decode(Path file, byte[] bytes, String expected) {
        try {
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException notUtf8) {
            throw new BadInputException(file + ": found bytes that are not UTF-8, expected " + expected, notUtf8);
        }
    }
}
