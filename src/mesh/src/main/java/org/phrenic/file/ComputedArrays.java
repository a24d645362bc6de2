package org.phrenic.file;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;

/**
 * Named arrays that take long to compute and depend on one key, kept together in an entry of a {@link UserCache}. An
 * array that the entry holds is not computed again; it has the bits of the computed one. Thread-safe.
 *
 * <p>Content of an entry: of each array the int32 length of its name, the name in UTF-8, the int32 number of values and
 * the values (float64).
 */
public final class ComputedArrays {
    private final UserCache cache;
    private final String kind;
    private final String key;
    private final Map<String, double[]> known = new TreeMap<>();
    private boolean changed;

    private ComputedArrays(UserCache cache, String kind, String key) {
        this.cache = cache;
        this.kind = kind;
        this.key = key;
    }

    /** Arrays of which none is known and none is kept. */
    public static ComputedArrays none() {
        return new ComputedArrays(UserCache.off(), "", "");
    }

    /** The arrays that a cache holds under a key. */
    public static ComputedArrays of(UserCache cache, String kind, String key) {
        ComputedArrays arrays = new ComputedArrays(cache, kind, key);
        cache.read(kind, key).ifPresent(arrays::read);
        return arrays;
    }

    private void read(ByteBuffer in) {
        try {
            while (in.hasRemaining()) {
                String name = EntryContent.text(in);
                known.put(name, EntryContent.numbers(in, in.getInt()));
            }
        } catch (BufferUnderflowException | NegativeArraySizeException e) {
            known.clear();
        }
    }

    /**
     * The array of a name, which is computed if it is not known. The caller owns the array.
     *
     * @param length number of values; an array of another length counts as unknown
     */
    public double[] get(String name, int length, Supplier<double[]> computed) {
        if (cache.isOff()) {
            return computed.get();
        }
        synchronized (known) {
            double[] values = known.get(name);
            if (values != null && values.length == length) {
                return values.clone();
            }
        }
        double[] values = computed.get();
        synchronized (known) {
            known.put(name, values.clone());
            changed = true;
        }
        return values;
    }

    /** Whether an array of this name and length is known. */
    public boolean has(String name, int length) {
        synchronized (known) {
            return known.containsKey(name) && known.get(name).length == length;
        }
    }

    /** Writes the entry if an array was computed, and forgets the arrays. */
    public void keep() {
        synchronized (known) {
            if (changed) {
                cache.write(kind, key, entry());
            }
            changed = false;
            known.clear();
        }
    }

    private ByteBuffer entry() {
        int size = 0;
        for (Map.Entry<String, double[]> array : known.entrySet()) {
            size += EntryContent.size(array.getKey()) + Integer.BYTES + Double.BYTES * array.getValue().length;
        }
        ByteBuffer out = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
        known.forEach((name, values) -> {
            EntryContent.put(out, name);
            EntryContent.put(out.putInt(values.length), values);
        });
        return out.flip();
    }
}
