package org.phrenic.mesh.io.raster;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/** The "key = value" or "key: value" lines of a volume header, by lower-case key, each with its line number. */
final class VolumeHeader {
    /** Value of a key in place of the name of a file: the word LIST, alone or before a number of axes. */
    private static final Pattern LIST = Pattern.compile("(?i)LIST(\\s.*)?");

    private static final int MAX_LINE = 1 << 20;

    private final String file;
    private final Map<String, String> values = new TreeMap<>();
    private final Map<String, Integer> lines = new TreeMap<>();
    private int line;
    private long bytes;

    VolumeHeader(String file) {
        this.file = file;
    }

    /** Name of the file, for messages. */
    String file() {
        return file;
    }

    /** The next line without its line break, or null at the end of the stream; reads no byte beyond the line. */
    String line(InputStream in) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        int c = in.read();
        if (c < 0) {
            return null;
        }
        line++;
        bytes++;
        while (c >= 0 && c != '\n') {
            text.write(c);
            if (text.size() > MAX_LINE) {
                throw badInput("found a line without end, expected a text header");
            }
            c = in.read();
            bytes += c >= 0 ? 1 : 0;
        }
        String read = text.toString(StandardCharsets.UTF_8);
        return read.endsWith("\r") ? read.substring(0, read.length() - 1) : read;
    }

    /** Number of bytes of all lines read so far, with their line breaks. */
    long bytes() {
        return bytes;
    }

    void put(String key, String value) {
        values.put(key.strip().toLowerCase(Locale.ROOT), value.strip());
        lines.put(key.strip().toLowerCase(Locale.ROOT), line);
    }

    Map<String, String> values() {
        return values;
    }

    boolean has(String key) {
        return values.containsKey(key);
    }

    String text(String key, String absent) {
        return values.getOrDefault(key, absent);
    }

    /** @throws BadInputException if the header has no such key */
    String text(String key) {
        String value = values.get(key);
        if (value == null) {
            throw new BadInputException(file + ": found no '" + key + "' in the header, expected one");
        }
        return value;
    }

    /** Whole numbers separated by spaces. */
    int[] integers(String key) {
        String[] words = text(key).split("\\s+", -1);
        return Arrays.stream(words)
                .mapToInt(word -> (int) Numbers.parseWhole(word, Integer.MIN_VALUE, Integer.MAX_VALUE)
                        .orElseThrow(() -> unexpected(key, word, "a whole number")))
                .toArray();
    }

    /**
     * Numbers separated by spaces.
     *
     * @param count required number of values
     */
    double[] numbers(String key, int count) {
        String[] words = text(key).split("\\s+", -1);
        if (words.length != count) {
            throw badInput(key, "found " + words.length + " numbers, expected " + count);
        }
        double[] numbers = new double[count];
        Arrays.setAll(numbers, i -> number(key, words[i]));
        return numbers;
    }

    double number(String key, String word) {
        return Numbers.parse(word).orElseThrow(() -> unexpected(key, word, "a number"));
    }

    /** Whether the value of a key announces a list of files, which follows it. */
    boolean isList(String key) {
        return LIST.matcher(text(key, "")).matches();
    }

    /** The single file beside the header that a key names. */
    Path fileBeside(Path headerFile, String key) {
        String name = text(key);
        if (isList(key)) {
            throw unexpected(key, name, "one file");
        }
        try {
            Path beside = headerFile.resolveSibling(name);
            if (Files.isRegularFile(beside)) {
                return beside;
            }
        } catch (InvalidPathException none) {
            // Reported below, like a missing file.
        }
        if (name.contains("%")) {
            throw unexpected(key, name, "one file");
        }
        throw badInput(key, "found " + Numbers.quote(name) + ", a file that is not there, expected the voxels' file");
    }

    /** An exception about the value of a key. */
    BadInputException badInput(String key, String problem) {
        return BadInputException.at(file, "line " + lines.getOrDefault(key, line) + ", key '" + key + "'", problem);
    }

    BadInputException unexpected(String key, String found, String expected) {
        return badInput(key, "found " + Numbers.quote(found) + ", expected " + expected);
    }

    /** An exception about the line read last. */
    BadInputException badInput(String problem) {
        return BadInputException.at(file, "line " + line, problem);
    }
}
