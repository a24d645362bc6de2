package org.phrenic.document;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * What a component of a record takes from a file, where its type does not say it all. Without it the key is the name of
 * the component in snake_case ({@code bodyHeightMm}: {@code body_height_mm}) and has to be there.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Key {
    /** Stands for "there has to be one". */
    String REQUIRED = "\0";

    /** The key, where it is not the name of the component. */
    String value() default "";

    /** The value of an absent key, written as in the file; any text for an empty list. */
    String absent() default REQUIRED;

    /** Least number allowed. */
    double min() default Double.NEGATIVE_INFINITY;

    /** A bound that the number has to exceed. */
    double above() default Double.NEGATIVE_INFINITY;

    /** Greatest number allowed. */
    double max() default Double.POSITIVE_INFINITY;

    /** How many numbers a list has, or each row of a list of lists; negative for any. */
    int count() default -1;
}
