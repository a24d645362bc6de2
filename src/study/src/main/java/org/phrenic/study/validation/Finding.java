package org.phrenic.study.validation;

/**
 * Result of one row of the physiology table on one body.
 *
 * @param range the quantity
 * @param verdict whether the value lies in the range
 * @param value in the row's unit; NaN where there is none
 * @param reason why there is none, or why it lies outside its range; empty for what lies within
 */
public record Finding(ReferenceRange range, Verdict verdict, double value, String reason) {
    /** Reason of a value outside its range where the table gives none. */
    static final String UNEXPLAINED = "no reason is known yet";

    /** Whether a value lies in its range. */
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

    /** Whether it makes a validation fail. */
    public boolean isMiss() {
        return verdict == Verdict.OUT && range.confidence().isBinding();
    }
}
