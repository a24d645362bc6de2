package org.phrenic.document;

import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;

/** Writes maps as JSON (RFC 8259), two spaces a level, keys in their order. */
public final class JsonWriter {
    private JsonWriter() {}

    /**
     * The text of {@code values}, ending with a line break.
     *
     * @param values maps, lists, double arrays, numbers, booleans, texts, enum constants, nulls
     * @throws IllegalArgumentException for NaN, infinity or a value of another type, naming its key
     */
    public static String format(Map<String, ?> values) {
        StringBuilder text = new StringBuilder();
        append(text, PlainValues.copy("", values), "\n");
        return text.append('\n').toString();
    }

    /**
     * Writes {@link #format} to {@code file} as a whole or not at all.
     *
     * @throws OutputException if the file cannot be written
     */
    public static void write(Path file, Map<String, ?> values) {
        AtomicFile.write(file, format(values));
    }

    private static void append(StringBuilder text, Object value, String lineBreak) {
        if (value instanceof Map<?, ?> map) {
            String inner = lineBreak + "  ";
            text.append('{');
            for (Iterator<? extends Map.Entry<?, ?>> entries = map.entrySet().iterator(); entries.hasNext(); ) {
                Map.Entry<?, ?> entry = entries.next();
                text.append(inner);
                appendText(text, (String) entry.getKey());
                text.append(": ");
                append(text, entry.getValue(), inner);
                text.append(entries.hasNext() ? "," : lineBreak);
            }
            text.append('}');
        } else if (value instanceof List<?> list) {
            String separator = "";
            text.append('[');
            for (Object item : list) {
                text.append(separator);
                append(text, item, lineBreak + "  ");
                separator = ", ";
            }
            text.append(']');
        } else if (value instanceof String word) {
            appendText(text, word);
        } else {
            text.append(value);
        }
    }

    private static void appendText(StringBuilder text, String word) {
        text.append('"');
        for (int i = 0; i < word.length(); i++) {
            char c = word.charAt(i);
            switch (c) {
                case '"', '\\' -> text.append('\\').append(c);
                case '\n' -> text.append("\\n");
                case '\t' -> text.append("\\t");
                default -> {
                    if (c < ' ' || Character.isSurrogate(c)) {
                        text.append("\\u")
                                .append(Integer.toHexString(0x10000 | c).substring(1));
                    } else {
                        text.append(c);
                    }
                }
            }
        }
        text.append('"');
    }
}
