package org.phrenic.document;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.file.BadInputException;

/**
 * Creates records from YAML mappings, with one key per component, named by {@link Key} or the component name in
 * snake_case.
 *
 * <p>A component is a number, a boolean, a text, an enum constant (in lower case), a {@code double[]}, a class with a
 * static {@code of(double[])}, another record, or a {@code List} or {@code Optional} of these.
 */
final class RecordBinder {
    private RecordBinder() {}

    /** The keys of a record, in the order of its components. */
    static List<String> keys(Class<?> type) {
        return Arrays.stream(type.getRecordComponents()).map(RecordBinder::key).toList();
    }

    /**
     * Creates a record from a mapping; other keys of the mapping are ignored.
     *
     * @throws BadInputException naming file, line and key, for a value that is missing, has the wrong type, is out of
     *     range or is rejected by the record constructor
     */
    static <T> T bind(YamlMap map, Class<T> type) {
        RecordComponent[] components = type.getRecordComponents();
        Object[] values = new Object[components.length];
        Arrays.setAll(values, i -> component(map, components[i]));
        try {
            Constructor<T> constructor = type.getDeclaredConstructor(
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
            constructor.setAccessible(true);
            return constructor.newInstance(values);
        } catch (InvocationTargetException refused) {
            if (refused.getCause() instanceof IllegalArgumentException reason) {
                throw new BadInputException(map.bad(reason.getMessage()).getMessage(), reason);
            }
            throw refused.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(refused);
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(type + " is no record that can be made", impossible);
        }
    }

    private static String key(RecordComponent component) {
        Key rule = component.getAnnotation(Key.class);
        if (rule != null && !rule.value().isEmpty()) {
            return rule.value();
        }
        StringBuilder key = new StringBuilder();
        for (char c : component.getName().toCharArray()) {
            key.append(Character.isUpperCase(c) ? "_" + Character.toLowerCase(c) : c);
        }
        return key.toString();
    }

    private static Object component(YamlMap map, RecordComponent component) {
        String key = key(component);
        Key rule = component.getAnnotation(Key.class);
        boolean optional = component.getType() == Optional.class;
        if (!map.has(key) && optional) {
            return Optional.empty();
        }
        if (!map.has(key) && rule != null && !rule.absent().equals(Key.REQUIRED)) {
            return component.getType() == List.class
                    ? List.of()
                    : value(map.absent(key, rule.absent()), component.getType(), null);
        }
        YamlValue value = map.get(key, expected(component.getType(), rule));
        return optional
                ? Optional.of(value(value, argument(component.getGenericType()), rule))
                : value(value, component.getGenericType(), rule);
    }

    private static Type argument(Type generic) {
        return ((ParameterizedType) generic).getActualTypeArguments()[0];
    }

    private static String expected(Class<?> type, Key rule) {
        if (type == double.class) {
            return "a number" + range(rule);
        } else if (type == int.class || type == long.class) {
            return "a whole number" + range(rule);
        } else if (type == boolean.class) {
            return "true or false";
        } else if (type.isEnum()) {
            return String.join(", ", labels(type));
        } else if (type == String.class) {
            return "text";
        }
        return type.isRecord() ? "a mapping" : type == List.class ? "a list" : numbers(rule);
    }

    private static String numbers(Key rule) {
        return rule == null || rule.count() < 0 ? "a list of numbers" : "a list of " + rule.count() + " numbers";
    }

    private static Object value(YamlValue value, Type generic, Key rule) {
        if (generic instanceof ParameterizedType list) {
            Type item = argument(list);
            return value.list("a list").stream()
                    .map(one -> value(one, item, rule))
                    .toList();
        }
        Class<?> type = (Class<?>) generic;
        if (type == double.class || type == Double.class) {
            return within(value, value.number(), rule);
        } else if (type == int.class || type == Integer.class) {
            within(value, (double) value.integer(), rule);
            return value.wholeInt();
        } else if (type == long.class || type == Long.class) {
            within(value, (double) value.integer(), rule);
            return value.integer();
        } else if (type == boolean.class || type == Boolean.class) {
            return value.flag();
        } else if (type == String.class) {
            return value.text();
        } else if (type.isEnum()) {
            return constant(value, type);
        } else if (type.isRecord()) {
            return value.map().bind(type);
        }
        double[] numbers = value.numbers(numbers(rule), rule == null ? -1 : rule.count());
        return type == double[].class ? numbers : made(type, numbers);
    }

    private static double within(YamlValue value, double number, Key rule) {
        if (rule != null && (!(number >= rule.min()) || number > rule.max() || outside(number, rule.above()))) {
            throw value.not("a number" + range(rule));
        }
        return number;
    }

    private static boolean outside(double number, double bound) {
        return !Double.isInfinite(bound) && !(number > bound);
    }

    private static String range(Key rule) {
        if (rule == null) {
            return "";
        }
        String low = !Double.isInfinite(rule.above())
                ? " above " + plain(rule.above())
                : Double.isInfinite(rule.min()) ? "" : " from " + plain(rule.min());
        return low + (Double.isInfinite(rule.max()) ? "" : " to " + plain(rule.max()));
    }

    private static String plain(double bound) {
        return bound == Math.rint(bound) ? String.valueOf((long) bound) : String.valueOf(bound);
    }

    private static List<String> labels(Class<?> type) {
        return Arrays.stream(type.getEnumConstants())
                .map(constant -> ((Enum<?>) constant).name().toLowerCase(Locale.ROOT))
                .toList();
    }

    private static Object constant(YamlValue value, Class<?> type) {
        List<String> labels = labels(type);
        int index = labels.indexOf(value.text());
        if (index < 0) {
            throw value.not(String.join(", ", labels));
        }
        return type.getEnumConstants()[index];
    }

    private static Object made(Class<?> type, double[] numbers) {
        try {
            return type.getMethod("of", double[].class).invoke(null, (Object) numbers);
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(type + " cannot be made of numbers", impossible);
        }
    }
}
