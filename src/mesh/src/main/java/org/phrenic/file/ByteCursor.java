package org.phrenic.file;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A forward cursor over a file in memory that reads words and lines (text) or typed values (binary). Each read method
 * takes a description of the expected value, which error messages contain together with the line or byte.
 */
public final class ByteCursor implements InputLocator {
    private static final byte[] BYTE_ORDER_MARK = "\uFEFF".getBytes(StandardCharsets.UTF_8);

    private final String file;
    private final ByteBuffer bytes;
    private boolean binary;
    private int place;

    public ByteCursor(String file, byte[] content) {
        this.file = file;
        this.bytes = ByteBuffer.wrap(content);
    }

    /** A cursor over a file that begins with text; a byte order mark of UTF-8 is skipped. */
    public static ByteCursor ofText(String file, byte[] content) {
        ByteCursor cursor = new ByteCursor(file, content);
        cursor.bytes.position(textStart(content));
        return cursor;
    }

    /** Number of bytes before the text of a file: 3 of a byte order mark of UTF-8, else 0. */
    public static int textStart(byte[] content) {
        int length = BYTE_ORDER_MARK.length;
        boolean marked = content.length >= length && Arrays.equals(content, 0, length, BYTE_ORDER_MARK, 0, length);
        return marked ? length : 0;
    }

    /** Switches to binary values in this byte order; error messages then name bytes instead of lines. */
    public void binary(ByteOrder order) {
        binary = true;
        bytes.order(order);
    }

    public boolean isBinary() {
        return binary;
    }

    public int remaining() {
        return bytes.remaining();
    }

    @Override
    public long location() {
        return place;
    }

    @Override
    public BadInputException badInput(long where, String problem) {
        if (binary) {
            return BadInputException.at(file, "byte " + where, problem);
        }
        int line = 1;
        for (int i = 0; i < where; i++) {
            if (bytes.get(i) == '\n') {
                line++;
            }
        }
        return BadInputException.at(file, "line " + line, problem);
    }

    private BadInputException ended(String expected) {
        return badInput(bytes.position(), "found the end of the file, expected " + expected);
    }

    /** The next word delimited by white space, or null at the end of the file. */
    public String wordOrNull() {
        while (bytes.hasRemaining() && isSpace(bytes.get(bytes.position()))) {
            bytes.get();
        }
        place = bytes.position();
        while (bytes.hasRemaining() && !isSpace(bytes.get(bytes.position()))) {
            bytes.get();
        }
        return place == bytes.position() ? null : text(place, bytes.position());
    }

    public String word(String expected) {
        String word = wordOrNull();
        if (word == null) {
            throw ended(expected);
        }
        return word;
    }

    /** Reads a keyword, in upper or lower case. */
    public void expect(String keyword) {
        String word = word("'" + keyword + "'");
        if (!word.equalsIgnoreCase(keyword)) {
            throw unexpected(word, "'" + keyword + "'");
        }
    }

    /** The rest of the line without its line break, or null at the end of the file. */
    public String lineOrNull() {
        if (!bytes.hasRemaining()) {
            return null;
        }
        place = bytes.position();
        int end = place;
        while (end < bytes.limit() && bytes.get(end) != '\n') {
            end++;
        }
        bytes.position(Math.min(end + 1, bytes.limit()));
        int last = end > place && bytes.get(end - 1) == '\r' ? end - 1 : end;
        return text(place, last);
    }

    public String line(String expected) {
        String line = lineOrNull();
        if (line == null) {
            throw ended(expected);
        }
        return line;
    }

    /** Reads a finite decimal number from a word. */
    public double number(String what) {
        String word = word(what);
        return Numbers.parse(word).orElseThrow(() -> unexpected(word, what + " as a finite number"));
    }

    /** Reads a whole number from a word. */
    long integer(String what) {
        String word = word(what);
        return Numbers.parseWhole(word, Long.MIN_VALUE, Long.MAX_VALUE)
                .orElseThrow(() -> unexpected(word, what + " as a whole number"));
    }

    /** Reads a count from a word, 0 to {@code Integer.MAX_VALUE}. */
    public int count(String what) {
        long count = integer(what);
        if (count < 0 || count > Integer.MAX_VALUE) {
            throw badInput("found " + count + ", expected " + what + " from 0 to " + Integer.MAX_VALUE);
        }
        return (int) count;
    }

    /** Checks, before anything is allocated, that the file has at least {@code count} more bytes. */
    public void require(long count, String what) {
        if (count < 0 || count > bytes.remaining()) {
            throw badInput(
                    bytes.position(),
                    "found " + bytes.remaining() + " more bytes, expected " + count + " or more for " + what);
        }
    }

    /** {@link #require} for binary or text values; a text value takes at least a digit and a separator. */
    public void requireValues(long count, ScalarType type, String what) {
        require(binary ? count * type.size() : Math.max(0, 2 * count - 1), what);
    }

    /** Reads a number of {@code type}, or a word in a text file. A binary value may be NaN. */
    public double readDouble(ScalarType type, String what) {
        return binary ? type.readDouble(bytes, next(type, what)) : number(what);
    }

    /** Reads a whole number of {@code type}, or a word in a text file. */
    public long readLong(ScalarType type, String what) {
        return binary ? type.readLong(bytes, next(type, what)) : integer(what);
    }

    /** Advances past a binary value and returns its place. */
    private int next(ScalarType type, String what) {
        require(type.size(), what);
        place = bytes.position();
        bytes.position(place + type.size());
        return place;
    }

    public void skip(long count, String what) {
        require(count, what);
        bytes.position(bytes.position() + (int) count);
    }

    private String text(int from, int to) {
        return new String(bytes.array(), from, to - from, StandardCharsets.ISO_8859_1);
    }

    private static boolean isSpace(byte b) {
        return b == ' ' || (b >= '\t' && b <= '\r');
    }
}
