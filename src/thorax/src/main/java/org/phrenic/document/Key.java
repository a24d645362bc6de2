package org.phrenic.document;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Declares how a record component is read from a file, in addition to its type. Without this annotation the key is the
 * component name in snake_case ({@code bodyHeightMm}: {@code body_height_mm}) and is required.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Key {
    /** Value of {@link #absent} for a required key. */
    String REQUIRED = "\0";

    /** The key, if it differs from the component name. */
    String value() default "";

    /** Default value of an absent key, written as in the file; any text for an empty list. */
    String absent() default REQUIRED;

    /** Least allowed number, inclusive. */
    double min() default Double.NEGATIVE_INFINITY;

    /** Exclusive lower bound. */
    double above() default Double.NEGATIVE_INFINITY;

    /** Greatest allowed number, inclusive. */
    double max() default Double.POSITIVE_INFINITY;

    /** Required length of a list of numbers, or of each row in a list of lists; negative for any length. */
    int count() default -1;
}
