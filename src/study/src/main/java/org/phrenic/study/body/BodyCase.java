package org.phrenic.study.body;

import java.util.Optional;
import java.util.function.Supplier;
import org.phrenic.anatomy.Thorax;

/**
 * A body to check.
 *
 * @param name name in the report
 * @param origin how the body was made, one phrase
 * @param height height of the body relative to an adult's; the wanted excursion of the domes goes with it
 * @param thorax loads or makes the body; throws an exception with one sentence if that is not possible
 * @param original loads the body of which the scan was simulated; empty if there is none
 */
public record BodyCase(
        String name, String origin, double height, Supplier<Thorax> thorax, Optional<Supplier<Thorax>> original) {
    /** A body that is not the import of a simulated scan. */
    public BodyCase(String name, String origin, double height, Supplier<Thorax> thorax) {
        this(name, origin, height, thorax, Optional.empty());
    }
}
