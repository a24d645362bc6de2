package org.phrenic.study.sweep;

import java.util.List;

/**
 * A point of a design.
 *
 * @param index place in the design, from 0
 * @param keys of the factors
 * @param values of the factors, as in a file
 */
public record SweepPoint(int index, List<String> keys, List<String> values) {
    public SweepPoint {
        keys = List.copyOf(keys);
        values = List.copyOf(values);
    }

    /** Keys and values for messages: {@code depth=1.2, anatomy=virtual/adult-male}. */
    public String description() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < keys.size(); i++) {
            text.append(i == 0 ? "" : ", ").append(keys.get(i)).append('=').append(values.get(i));
        }
        return text.toString();
    }
}
