package org.phrenic.study;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.phrenic.document.Key;

/** Converts records to values for JSON. */
public final class ReportValues {
    private ReportValues() {}

    /**
     * The components of a record by name, in snake_case or as given by {@link Key}. NaN and infinity are left out.
     *
     * @param row public record of numbers, booleans and texts
     */
    public static Map<String, Object> of(Record row) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (RecordComponent component : row.getClass().getRecordComponents()) {
            try {
                Object value = component.getAccessor().invoke(row);
                if (!(value instanceof Double number) || Double.isFinite(number)) {
                    values.put(key(component), value);
                }
            } catch (ReflectiveOperationException impossible) {
                throw new IllegalStateException(row.getClass() + " is not public", impossible);
            }
        }
        return values;
    }

    private static String key(RecordComponent component) {
        Key named = component.getAnnotation(Key.class);
        return named != null && !named.value().isEmpty()
                ? named.value()
                : component.getName().replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
    }
}
