package org.phrenic.document;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.SerializableString;
import com.fasterxml.jackson.core.io.CharacterEscapes;
import com.fasterxml.jackson.core.io.SerializedString;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter.NopIndenter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.core.util.Separators.Spacing;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;

/**
 * Writes maps as JSON (RFC 8259) with Jackson. Indentation is two spaces, lists are on one line and keys keep their
 * order.
 */
public final class JsonWriter {
    /** Surrogates and higher characters are escaped, so that an unpaired surrogate can be written too. */
    private static final int HIGHEST_PLAIN_CHARACTER = Character.MIN_SURROGATE - 1;

    private JsonWriter() {}

    /**
     * Formats {@code values} as JSON, ending with a line break.
     *
     * @param values maps, lists, double arrays, numbers, booleans, texts, enum constants, nulls
     * @throws IllegalArgumentException for NaN, infinity or a value of another type, naming its key
     */
    public static String format(Map<String, ?> values) {
        StringWriter text = new StringWriter();
        try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
            json.setPrettyPrinter(new Layout());
            json.setHighestNonEscapedChar(HIGHEST_PLAIN_CHARACTER);
            json.setCharacterEscapes(new YamlEscapes());
            write(json, PlainValues.copy("", values));
        } catch (IOException impossible) {
            throw new UncheckedIOException("a StringWriter takes all text", impossible);
        }
        return text.append('\n').toString();
    }

    /**
     * Writes {@link #format} to {@code file} atomically.
     *
     * @throws OutputException if the file cannot be written
     */
    public static void write(Path file, Map<String, ?> values) {
        AtomicFile.write(file, format(values));
    }

    private static void write(JsonGenerator json, Object value) throws IOException {
        if (value instanceof Map<?, ?> map) {
            json.writeStartObject();
            for (Map.Entry<?, ?> entry : map.entrySet()) {
                json.writeFieldName((String) entry.getKey());
                write(json, entry.getValue());
            }
            json.writeEndObject();
        } else if (value instanceof List<?> list) {
            json.writeStartArray();
            for (Object item : list) {
                write(json, item);
            }
            json.writeEndArray();
        } else {
            json.writePOJO(value);
        }
    }

    /** Escapes control characters and line breaks that JSON may hold as they are and YAML may not. */
    private static final class YamlEscapes extends CharacterEscapes {
        private static final long serialVersionUID = 1;
        private static final char DELETE = 0x7F;
        private static final char LINE_SEPARATOR = 0x2028;
        private static final char PARAGRAPH_SEPARATOR = 0x2029;

        @Override
        public int[] getEscapeCodesForAscii() {
            int[] codes = standardAsciiEscapesForJSON();
            codes[DELETE] = ESCAPE_STANDARD;
            return codes;
        }

        @Override
        public SerializableString getEscapeSequence(int character) {
            boolean escaped = Character.isISOControl(character)
                    || character == LINE_SEPARATOR
                    || character == PARAGRAPH_SEPARATOR;
            return escaped ? new SerializedString(Numbers.format("\\u%04X", character)) : null;
        }
    }

    /** Maps have one line per key, lists are on one line. Maps inside a list are indented by one level. */
    private static final class Layout extends DefaultPrettyPrinter {
        Layout() {
            super(new Separators(null, ':', Spacing.AFTER, ',', Spacing.NONE, "", ',', Spacing.AFTER, ""));
            indentObjectsWith(new DefaultIndenter("  ", "\n"));
            indentArraysWith(NopIndenter.instance);
        }

        @Override
        public void writeStartArray(JsonGenerator json) throws IOException {
            super.writeStartArray(json);
            _nesting++;
        }

        @Override
        public void writeEndArray(JsonGenerator json, int count) throws IOException {
            _nesting--;
            super.writeEndArray(json, count);
        }
    }
}
