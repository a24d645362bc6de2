package org.phrenic.study.body;

import java.util.function.Supplier;
import org.phrenic.anatomy.Thorax;

/**
 * A body to check.
 *
 * @param name name in the report
 * @param origin how the body was made, one phrase
 * @param thorax loads or makes the body; throws an exception with one sentence if that is not possible
 */
public record BodyCase(String name, String origin, Supplier<Thorax> thorax) {}
