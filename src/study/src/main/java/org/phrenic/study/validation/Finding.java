package org.phrenic.study.validation;

/**
 * Result of one row of the physiology table for one body.
 *
 * @param range row of the table
 * @param verdict whether the value lies in the range
 * @param value in the row's unit; NaN if not available
 * @param reason why the value is not available or lies outside the range; empty if it lies in the range
 */
public record Finding(ReferenceRange range, Verdict verdict, double value, String reason) {
    /** Reason for a value outside its range if the table gives none. */
    static final String UNEXPLAINED = "no reason is known yet";

    /** Outcome of the comparison with the range. */
    public enum Verdict {
        WITHIN("within"),
        OUT("out"),
        NOT_MEASURABLE("not measurable here");

        private final String label;

        Verdict(String label) {
            this.label = label;
        }

        public String label() {
            return label;
        }
    }

    /** Whether this result makes the validation fail. */
    public boolean isMiss() {
        return verdict == Verdict.OUT && range.confidence().isBinding();
    }
}
