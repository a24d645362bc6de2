package org.phrenic.ui.access.panel;

import java.text.ParseException;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import javax.swing.JFormattedTextField;
import org.phrenic.ui.session.NumberFormats;

/**
 * Reads a diameter as it is typed, with a decimal point or comma and perhaps its unit, in whole millimetres. One out of
 * range is taken as the end of the range, one between as the nearest, with a message.
 */
final class DiameterFormatter extends JFormattedTextField.AbstractFormatter {
    private static final String UNIT = "mm";

    private final int smallestMm;
    private final int largestMm;
    private final transient Consumer<String> message;

    DiameterFormatter(int smallestMm, int largestMm, Consumer<String> message) {
        this.smallestMm = smallestMm;
        this.largestMm = largestMm;
        this.message = message;
    }

    @Override
    public Integer stringToValue(String text) throws ParseException {
        OptionalDouble typed = NumberFormats.parse(text, UNIT);
        if (typed.isEmpty()) {
            String sentence =
                    "Found '" + text + "', expected a diameter from " + smallestMm + " to " + largestMm + " mm.";
            message.accept(sentence);
            throw new ParseException(sentence, 0);
        }
        double mm = typed.getAsDouble();
        int taken = (int) Math.round(Math.max(smallestMm, Math.min(largestMm, mm)));
        if (mm < smallestMm || mm > largestMm) {
            message.accept(NumberFormats.outOfRange(mm, taken, UNIT));
        } else if (mm != taken) {
            message.accept(NumberFormats.withUnit(mm, UNIT) + " is taken as " + NumberFormats.withUnit(taken, UNIT)
                    + ": a target has whole millimetres.");
        }
        return taken;
    }

    @Override
    public String valueToString(Object value) {
        return value == null ? "" : String.valueOf(Math.round(((Number) value).doubleValue()));
    }
}
