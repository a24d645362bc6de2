package org.phrenic.breathing.pattern;

import java.io.IOException;
import java.io.Reader;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;

/** The keys of a flat YAML file, each asked for once; what nobody asked for is an error. */
final class YamlKeys {
    private final String name;
    private final Map<String, Object> left = new TreeMap<>();
    private final List<String> asked = new ArrayList<>();

    YamlKeys(Reader reader, String name) throws IOException {
        this.name = name;
        StringWriter text = new StringWriter();
        reader.transferTo(text);
        try {
            left.putAll(YamlDocument.parse(name, text.toString()).toMap());
        } catch (BadInputException e) {
            throw new IOException(e.getMessage(), e);
        }
        if (left.isEmpty()) {
            throw new IOException(name + ": no keys, expected lines of 'key: value'");
        }
    }

    String text(String key) throws IOException {
        return String.valueOf(take(key));
    }

    double number(String key) throws IOException {
        Object value = take(key);
        if (value instanceof Number number && Double.isFinite(number.doubleValue())) {
            return number.doubleValue();
        }
        throw new IOException(name + ": " + key + " '" + value + "', expected a number");
    }

    int whole(String key) throws IOException {
        double value = number(key);
        if (value != Math.rint(value) || Math.abs(value) > Integer.MAX_VALUE) {
            throw new IOException(name + ": " + key + " " + value + ", expected a whole number");
        }
        return (int) value;
    }

    boolean truth(String key) throws IOException {
        Object value = take(key);
        if (value instanceof Boolean truth) {
            return truth;
        }
        throw new IOException(name + ": " + key + " '" + value + "', expected true or false");
    }

    boolean has(String key) {
        return left.containsKey(key);
    }

    /** Refuses what was not asked for. */
    void done() throws IOException {
        if (!left.isEmpty()) {
            throw new IOException(name + ": unknown key '"
                    + left.keySet().iterator().next() + "', expected " + String.join(", ", asked));
        }
    }

    private Object take(String key) throws IOException {
        if (!left.containsKey(key)) {
            throw new IOException(name + ": no key '" + key + "'");
        }
        asked.add(key);
        return left.remove(key);
    }
}
