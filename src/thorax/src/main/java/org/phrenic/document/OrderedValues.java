package org.phrenic.document;

import java.util.LinkedHashMap;

/** Keys and values of a JSON or YAML file, in insertion order. */
public final class OrderedValues extends LinkedHashMap<String, Object> {
    private static final long serialVersionUID = 1;

    /** Adds a key with its value. */
    public OrderedValues with(String key, Object value) {
        put(key, value);
        return this;
    }
}
