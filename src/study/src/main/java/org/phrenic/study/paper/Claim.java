package org.phrenic.study.paper;

import java.util.List;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.study.ReportNumbers;

/**
 * A statement or figure of the paper and its counterpart here.
 *
 * @param statement in a few words
 * @param published what the paper has
 * @param measured what was found here
 * @param verdict of both
 * @param explanation what differs and why, or by what rule it counts as agreed
 */
record Claim(String statement, String published, String measured, Verdict verdict, String explanation) {
    /** How what is here compares with what is published. */
    enum Verdict {
        AGREES,
        DIFFERS,
        /** Nothing can agree: it is shown to be looked at. */
        SHOWN,
        /** Not part of a short reproduction. */
        NOT_MEASURED;

        String label() {
            return ReportNumbers.label(this).replace('_', ' ');
        }

        static Verdict agrees(boolean holds) {
            return holds ? AGREES : DIFFERS;
        }
    }

    static void addTable(ReportDocument report, List<Claim> claims) {
        report.table(
                "",
                PaperTexts.columns(5, "claim", "the paper", "here", "verdict", "what differs and why"),
                claims.stream()
                        .map(c -> List.of(c.statement, c.published, c.measured, c.verdict.label(), c.explanation))
                        .toList());
    }
}
