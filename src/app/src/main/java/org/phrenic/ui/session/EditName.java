package org.phrenic.ui.session;

/**
 * What a change is called in the Edit menu.
 *
 * @param label what was changed: {@code Muscle stiffness}
 * @param from value before it, with its unit if that differs; empty for a change that is no value
 * @param to value after it
 */
public record EditName(String label, String from, String to) {
    /** A change that is named by one label: {@code Settings 'deep'}. */
    public static EditName of(String label) {
        return new EditName(label, "", "");
    }

    /** A change of a number: {@code Muscle stiffness 300 -> 450 N/m}. */
    public static EditName of(String label, double from, double to, String unit) {
        return new EditName(label, NumberFormats.format(from), NumberFormats.withUnit(to, unit));
    }

    /** The name of this change and a later one of the same setting together. */
    EditName mergedWith(EditName later) {
        return from.isEmpty() || later.from.isEmpty() ? later : new EditName(label, from, later.to);
    }

    /** {@code Muscle stiffness 300 -> 450 N/m}. */
    public String text() {
        return from.isEmpty() ? label : label + " " + from + " -> " + to;
    }
}
