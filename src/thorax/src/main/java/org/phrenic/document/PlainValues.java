package org.phrenic.document;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;

/**
 * Values allowed in a summary or scenario: maps, lists, finite numbers, booleans, texts and nulls, in a stable order.
 */
final class PlainValues {
    private PlainValues() {}

    /**
     * A deep copy that consists of LinkedHashMap, ArrayList, Long, Double, Boolean, String and null only. Arrays of
     * numbers become lists; paths and enum constants become their names.
     *
     * @throws IllegalArgumentException for NaN, infinity or another type, naming the path of keys
     */
    static Object copy(String path, Object value) {
        if (value instanceof Map<?, ?> map) {
            Map<String, Object> copy = new LinkedHashMap<>();
            map.forEach((key, item) -> copy.put(String.valueOf(key), copy(join(path, String.valueOf(key)), item)));
            return copy;
        }
        if (value instanceof List<?> list) {
            List<Object> copy = new ArrayList<>();
            list.forEach(item -> copy.add(copy(path + "[" + copy.size() + "]", item)));
            return copy;
        }
        if (value instanceof double[] numbers) {
            return copy(path, DoubleStream.of(numbers).boxed().toList());
        }
        if (value instanceof Double || value instanceof Float) {
            double number = ((Number) value).doubleValue();
            if (!Double.isFinite(number)) {
                throw new IllegalArgumentException(path + ": found " + number + ", expected a finite number");
            }
            return number;
        }
        if (value instanceof Long || value instanceof Integer || value instanceof Short || value instanceof Byte) {
            return ((Number) value).longValue();
        }
        if (value == null || value instanceof Boolean || value instanceof String) {
            return value;
        }
        if (value instanceof Enum<?> || value instanceof Path) {
            return value.toString();
        }
        throw new IllegalArgumentException(
                path + ": found a " + value.getClass().getName() + ", expected a map, list, number, boolean or text");
    }

    private static String join(String path, String key) {
        return path.isEmpty() ? key : path + "." + key;
    }
}
