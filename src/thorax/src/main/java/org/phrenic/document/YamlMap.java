package org.phrenic.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.phrenic.file.BadInputException;

/**
 * A mapping of a YAML document, in the order of the file. Getters name the key and line in their one sentence when a
 * value is missing or of another kind: {@code scenario.yaml: line 3, key 'time_step_s': found 'abc', expected a
 * number}. A key inside another mapping is told with the path to it, as {@code muscle.activation}.
 *
 * <p>Numbers are decimal and finite ({@code 1e-3} too); truth is {@code true} or {@code false}, so a text {@code no}
 * stays text.
 */
public final class YamlMap {
    private final YamlValue.Place place;
    private final Map<String, YamlValue> values;

    YamlMap(YamlValue.Place place, Map<String, YamlValue> values) {
        this.place = place;
        this.values = values;
    }

    /** The keys, in the order of the file. */
    public Set<String> keys() {
        return new LinkedHashSet<>(values.keySet());
    }

    public boolean has(String key) {
        return values.containsKey(key);
    }

    /**
     * Refuses any key that is not one of {@code known}, with the nearest of them as a suggestion.
     *
     * @throws BadInputException for the first unknown key
     */
    public void requireOnly(Collection<String> known) {
        for (Map.Entry<String, YamlValue> entry : values.entrySet()) {
            if (!known.contains(entry.getKey())) {
                String hint = KeySuggestion.nearest(entry.getKey(), known)
                        .map(near -> "did you mean '" + near + "'?")
                        .orElse("expected one of " + String.join(", ", known));
                throw entry.getValue().place().bad("found an unknown key, " + hint);
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

    /** A whole number that an {@code int} holds. */
    public int wholeInt(String key) {
        return get(key, "a whole number").wholeInt();
    }

    /** True or false. */
    public boolean flag(String key) {
        return get(key, "true or false").flag();
    }

    public boolean flag(String key, boolean absent) {
        return has(key) ? flag(key) : absent;
    }

    /** Text; a number is given as it is written. */
    public String text(String key) {
        return get(key, "text").text();
    }

    public String text(String key, String absent) {
        return has(key) ? text(key) : absent;
    }

    /** A mapping inside this one. */
    public YamlMap map(String key) {
        return get(key, "a mapping").map();
    }

    /** A mapping inside this one, an empty one where there is none. */
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

    /** Whether the value of {@code key} can be read as a finite number. */
    public boolean isNumber(String key) {
        return has(key) && values.get(key).isNumber();
    }

    /** An exception that says of {@code key} what the caller found wrong: "found -1, expected more than 0". */
    public BadInputException bad(String key, String problem) {
        return (has(key) ? values.get(key).place() : place.key(key, place.line())).bad(problem);
    }

    /**
     * Plain maps, lists, numbers (Long, Double), booleans, texts and nulls, in order, for {@link YamlWriter} or
     * {@link JsonWriter}.
     */
    public Map<String, Object> toMap() {
        Map<String, Object> plain = new LinkedHashMap<>();
        values.forEach((key, value) -> plain.put(key, value.plain()));
        return plain;
    }

    /**
     * The record whose components are the keys of this mapping, each named by {@link Key} or by the component in
     * snake_case.
     *
     * @throws BadInputException naming file, line and key, for a key that is unknown or absent, and a value that is of
     *     another kind, out of range, or refused by the constructor of the record
     */
    public <T> T bind(Class<T> type) {
        requireOnly(RecordBinder.keys(type));
        return RecordBinder.bind(this, type);
    }

    /** As {@link #bind}, where the mapping has other keys besides those of the record. */
    public <T> T bindPart(Class<T> type) {
        return RecordBinder.bind(this, type);
    }

    /** The keys that {@link #bindPart} looks at. */
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

    /** A value for a key that is absent, written as in a file. */
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
