package org.phrenic.study.body;

import java.util.List;
import java.util.stream.Stream;

/**
 * What the check of a body gave.
 *
 * @param name name of the body
 * @param origin how the body was made
 * @param refusal why the body cannot be simulated, one sentence; empty if it can
 * @param breaths results in the order of {@link BreathDepth}; empty after a refusal
 */
public record BodyResult(String name, String origin, String refusal, List<BreathResult> breaths) {
    public BodyResult {
        breaths = List.copyOf(breaths);
    }

    /** What is beyond the limits, one phrase each. */
    public List<String> faults() {
        return refusal.isEmpty()
                ? breaths.stream().flatMap(b -> b.faults().stream()).distinct().toList()
                : Stream.of(refusal).toList();
    }

    /** Whether the body breathes within all limits. */
    public boolean passes() {
        return faults().isEmpty();
    }
}
