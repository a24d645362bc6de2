package org.phrenic.study.body;

import java.util.function.Supplier;
import org.phrenic.anatomy.Thorax;

/**
 * A body to check.
 *
 * @param name name in the report
 * @param origin how the body was made, one phrase
 * @param height height of the body relative to an adult's; the wanted excursion of the domes goes with it
 * @param thorax loads or makes the body; throws an exception with one sentence if that is not possible
 */
public record BodyCase(String name, String origin, double height, Supplier<Thorax> thorax) {}
