package org.phrenic.document;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/**
 * A value in a YAML document with its location.
 *
 * @param content a {@link YamlMap}, a list of {@link YamlValue}, a {@code String}, or null for no value
 * @param quoted whether a text is in quotes and therefore never a number or boolean
 */
record YamlValue(Place place, Object content, boolean quoted) {
    /** File, line (from 1; 0 if unknown) and path of keys. */
    record Place(String file, int line, String path) {
        Place key(String key, int keyLine) {
            return new Place(file, keyLine, path.isEmpty() ? key : path + "." + key);
        }

        Place item(int index, int itemLine) {
            return new Place(file, itemLine, path + "[" + index + "]");
        }

        BadInputException bad(String problem) {
            String at = line > 0 ? "line " + line : "";
            String key = path.isEmpty() ? "" : "key '" + path + "'";
            return BadInputException.at(file, at + (at.isEmpty() || key.isEmpty() ? "" : ", ") + key, problem);
        }
    }

    BadInputException not(String expected) {
        String found = "nothing";
        if (content instanceof YamlMap) {
            found = "a mapping";
        } else if (content instanceof List<?>) {
            found = "a list";
        } else if (content instanceof String text) {
            found = quoted ? "the quoted text " + Numbers.quote(text) : Numbers.quote(text);
        }
        return place.bad("found " + found + ", expected " + expected);
    }

    private OptionalDouble numberIfAny() {
        return content instanceof String text && !quoted ? Numbers.parse(text) : OptionalDouble.empty();
    }

    boolean isList() {
        return content instanceof List<?>;
    }

    boolean isNumber() {
        return numberIfAny().isPresent();
    }

    double number() {
        return numberIfAny().orElseThrow(() -> not("a number"));
    }

    long integer() {
        return wholeIfAny().orElseThrow(() -> not("a whole number"));
    }

    private OptionalLong wholeIfAny() {
        return content instanceof String text && !quoted
                ? Numbers.parseWhole(text, Long.MIN_VALUE, Long.MAX_VALUE)
                : OptionalLong.empty();
    }

    /** A whole number in the range of {@code int}. */
    int wholeInt() {
        long value = integer();
        if (value != (int) value) {
            throw not("a whole number that is not so large");
        }
        return (int) value;
    }

    /** A list of finite numbers, exactly {@code count} of them unless {@code count} is negative. */
    double[] numbers(String expected, int count) {
        List<YamlValue> items = list(expected);
        if (count >= 0 && items.size() != count) {
            throw place.bad("found a list of " + items.size() + ", expected " + expected);
        }
        return items.stream().mapToDouble(YamlValue::number).toArray();
    }

    boolean flag() {
        if (!quoted && "true".equals(content)) {
            return true;
        }
        if (!quoted && "false".equals(content)) {
            return false;
        }
        throw not("true or false");
    }

    String text() {
        if (content instanceof String text) {
            return text;
        }
        throw not("text");
    }

    YamlMap map() {
        if (content instanceof YamlMap map) {
            return map;
        }
        throw not("a mapping");
    }

    List<YamlValue> list(String expected) {
        if (content instanceof List<?> items) {
            List<YamlValue> values = new ArrayList<>();
            items.forEach(item -> values.add((YamlValue) item));
            return values;
        }
        throw not(expected);
    }

    Object plain() {
        if (content instanceof YamlMap map) {
            return map.toMap();
        }
        if (content instanceof List<?>) {
            List<Object> plain = new ArrayList<>();
            list("").forEach(item -> plain.add(item.plain()));
            return plain;
        }
        if (content instanceof String text && !quoted) {
            return plainWord(text);
        }
        return content;
    }

    private Object plainWord(String text) {
        if (text.equals("true") || text.equals("false")) {
            return flag();
        }
        if (!isNumber()) {
            return text;
        }
        OptionalLong whole = wholeIfAny();
        return whole.isPresent() ? (Object) whole.getAsLong() : (Object) number();
    }
}
