package org.phrenic.study.paper;

import java.util.List;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.study.ReportNumbers;

/**
 * A statement or value of the paper and the corresponding result of this program.
 *
 * @param statement in a few words
 * @param published value in the paper
 * @param measured result of this program
 * @param verdict of the comparison
 * @param explanation the difference and its reason, or the criterion of agreement
 */
record Claim(String statement, String published, String measured, Verdict verdict, String explanation) {
    /** Outcome of the comparison with the paper. */
    enum Verdict {
        AGREES,
        DIFFERS,
        /** Shown for visual inspection; there is no criterion of agreement. */
        SHOWN,
        /** Omitted in a short reproduction. */
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
