package org.phrenic.document;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.Numbers;

/**
 * A mapping in a YAML document, in file order. A getter throws a {@link BadInputException} that names the file, line
 * and key if a value is missing or has the wrong type: {@code scenario.yaml: line 3, key 'time_step_s': found 'abc',
 * expected a number}. A nested key is named by its path, as {@code muscle.activation}.
 *
 * <p>Numbers are decimal and finite ({@code 1e-3} is allowed). Booleans are {@code true} and {@code false} only, so
 * {@code no} is a text.
 */
public final class YamlMap {
    private final YamlValue.Place place;
    private final Map<String, YamlValue> values;

    YamlMap(YamlValue.Place place, Map<String, YamlValue> values) {
        this.place = place;
        this.values = values;
    }

    /** The keys, in file order. */
    public Set<String> keys() {
        return new LinkedHashSet<>(values.keySet());
    }

    public boolean has(String key) {
        return values.containsKey(key);
    }

    /**
     * Requires that every key is one of {@code known}; an error message suggests the nearest known key.
     *
     * @throws BadInputException for the first unknown key
     */
    public void requireOnly(Collection<String> known) {
        requireOnly(known, key -> KeySuggestion.nearest(key, known)
                .map(near -> "did you mean '" + near + "'?")
                .orElse("expected one of " + String.join(", ", known)));
    }

    /**
     * Requires that every key is one of {@code known}; {@code expected} says what an unknown one may stand for.
     *
     * @throws BadInputException for the first unknown key
     */
    public void requireOnly(Collection<String> known, UnaryOperator<String> expected) {
        for (Map.Entry<String, YamlValue> entry : values.entrySet()) {
            if (!known.contains(entry.getKey())) {
                throw entry.getValue().place().bad("found an unknown key, " + expected.apply(entry.getKey()));
            }
        }
    }

    /** A finite number. */
    public double number(String key) {
        return get(key, "a number").number();
    }

    public double number(String key, double absent) {
        return has(key) ? number(key) : absent;
    }

    /** A whole number. */
    public long integer(String key) {
        return get(key, "a whole number").integer();
    }

    public long integer(String key, long absent) {
        return has(key) ? integer(key) : absent;
    }

    /** A whole number in the range of {@code int}. */
    public int wholeInt(String key) {
        return get(key, "a whole number").wholeInt();
    }

    /** A boolean. */
    public boolean flag(String key) {
        return get(key, "true or false").flag();
    }

    public boolean flag(String key, boolean absent) {
        return has(key) ? flag(key) : absent;
    }

    /** A text; a number is returned as it is written. */
    public String text(String key) {
        return get(key, "text").text();
    }

    public String text(String key, String absent) {
        return has(key) ? text(key) : absent;
    }

    /** The file that a text names, from a folder on. It is there, or cannot be looked at. */
    public Path file(String key, Path folder) {
        String name = text(key);
        if (!FileNames.isUsable(name)) {
            throw bad(key, "found " + Numbers.quote(name) + ", expected a name that a file can have on this system");
        }
        Path file = folder.resolve(name);
        if (isMissing(file)) {
            String where = Path.of(name).isAbsolute() ? "" : " in " + folder;
            throw bad(key, "found no file " + Numbers.quote(name) + where + ", expected one");
        }
        return file;
    }

    private static boolean isMissing(Path file) {
        try {
            Files.readAttributes(file, BasicFileAttributes.class);
            return false;
        } catch (AccessDeniedException hidden) {
            return false;
        } catch (IOException none) {
            return true;
        }
    }

    /** A nested mapping. */
    public YamlMap map(String key) {
        return get(key, "a mapping").map();
    }

    /** A nested mapping; empty if the key is absent. */
    public YamlMap mapOrEmpty(String key) {
        return has(key) ? map(key) : new YamlMap(place.key(key, place.line()), new LinkedHashMap<>());
    }

    /** A list of finite numbers. */
    public double[] numbers(String key) {
        return get(key, "a list of numbers").numbers("a list of numbers", -1);
    }

    /** A list of texts. */
    public List<String> texts(String key) {
        return get(key, "a list of texts").list("a list of texts").stream()
                .map(YamlValue::text)
                .toList();
    }

    /** A list of mappings. */
    public List<YamlMap> maps(String key) {
        return get(key, "a list of mappings").list("a list of mappings").stream()
                .map(YamlValue::map)
                .toList();
    }

    /** Whether the value of {@code key} is a list. */
    public boolean isList(String key) {
        return has(key) && values.get(key).isList();
    }

    /** Whether the value of {@code key} can be read as a finite number. */
    public boolean isNumber(String key) {
        return has(key) && values.get(key).isNumber();
    }

    /** An exception about the value of {@code key}; a problem reads "found -1, expected more than 0". */
    public BadInputException bad(String key, String problem) {
        return (has(key) ? values.get(key).place() : place.key(key, place.line())).bad(problem);
    }

    /**
     * Plain maps, lists, numbers (Long, Double), booleans, texts and nulls in file order, for {@link YamlWriter} or
     * {@link JsonWriter}.
     */
    public Map<String, Object> toMap() {
        Map<String, Object> plain = new LinkedHashMap<>();
        values.forEach((key, value) -> plain.put(key, value.plain()));
        return plain;
    }

    /**
     * Creates a record from this mapping, with one key per component, named by {@link Key} or the component name in
     * snake_case.
     *
     * @throws BadInputException naming file, line and key, for a key that is unknown or missing, or a value that has
     *     the wrong type, is out of range or is rejected by the record constructor
     */
    public <T> T bind(Class<T> type) {
        requireOnly(RecordBinder.keys(type));
        return RecordBinder.bind(this, type);
    }

    /** Creates a record as {@link #bind} does; unknown keys are allowed. */
    public <T> T bindPart(Class<T> type) {
        return RecordBinder.bind(this, type);
    }

    /** The keys that {@link #bindPart} reads. */
    public static List<String> keysOf(Class<?> type) {
        return RecordBinder.keys(type);
    }

    /** An exception about this mapping as a whole. */
    public BadInputException bad(String problem) {
        return place.path().isEmpty() ? new BadInputException(place.file() + ": " + problem) : place.bad(problem);
    }

    Map<String, YamlValue> values() {
        return values;
    }

    /** A default value for an absent key, written as in a file. */
    YamlValue absent(String key, String text) {
        return new YamlValue(place.key(key, place.line()), text, false);
    }

    YamlValue get(String key, String expected) {
        YamlValue value = values.get(key);
        if (value == null) {
            List<String> present = new ArrayList<>(values.keySet());
            String hint = KeySuggestion.nearest(key, present)
                    .map(near -> " (there is '" + near + "')")
                    .orElse("");
            throw place.key(key, place.line()).bad("found no such key" + hint + ", expected " + expected);
        }
        return value;
    }
}
