package org.phrenic.study.paper;

import java.util.List;
import java.util.Locale;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;

/**
 * Something that the paper shows or says, and what came of it here.
 *
 * @param statement in a few words
 * @param published what the paper has
 * @param measured what was found here
 * @param verdict of both
 * @param explanation what differs and why, or by what rule it counts as agreed
 */
record Claim(String statement, String published, String measured, Verdict verdict, String explanation) {
    /** How what is here stands to what is printed. */
    enum Verdict {
        AGREES,
        DIFFERS,
        /** There is nothing to agree with: it can be looked at. */
        SHOWN,
        /** Not part of a short reproduction. */
        NOT_MEASURED;

        String label() {
            return name().toLowerCase(Locale.ROOT).replace('_', ' ');
        }

        static Verdict agrees(boolean holds) {
            return holds ? AGREES : DIFFERS;
        }
    }

    /** One that a short reproduction leaves out. */
    static Claim notMeasured(String what, String printed) {
        return new Claim(what, printed, "-", Verdict.NOT_MEASURED, "Left out of a quick reproduction.");
    }

    /** Claims with all that is known of them. */
    static void table(ReportDocument report, String caption, List<Claim> claims) {
        report.table(
                caption,
                List.of(
                        Column.text("claim"),
                        Column.text("the paper"),
                        Column.text("here"),
                        Column.text("verdict"),
                        Column.text("what differs and why")),
                claims.stream()
                        .map(c -> List.of(c.statement, c.published, c.measured, c.verdict.label(), c.explanation))
                        .toList());
    }
}
