package org.phrenic.file;

import java.lang.ref.SoftReference;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/** Values by name, kept while memory allows. Thread-safe: a value is made once while it is kept. */
public final class SoftValues<V> {
    private final Map<String, SoftReference<V>> kept = new ConcurrentHashMap<>();

    /** The value of a name, made if it is not kept. */
    public V get(String name, Supplier<V> made) {
        AtomicReference<V> value = new AtomicReference<>();
        kept.compute(name, (key, known) -> {
            value.set(known == null ? null : known.get());
            if (value.get() != null) {
                return known;
            }
            value.set(made.get());
            return new SoftReference<>(value.get());
        });
        return value.get();
    }
}
