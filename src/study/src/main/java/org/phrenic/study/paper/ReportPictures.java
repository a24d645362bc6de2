package org.phrenic.study.paper;

import java.util.List;
import java.util.Map;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Figure;
import org.phrenic.document.report.ReportDocument.Picture;

/**
 * Pictures of a report.
 *
 * @param figures pictures of figures 1 to 3, by figure number
 * @param segmented pictures of figure 4, by patient name
 * @param distances pictures of figure 5, by patient name
 * @param reason why figures have no pictures, in one sentence; empty if all have
 */
public record ReportPictures(
        Map<Integer, List<Picture>> figures,
        Map<String, List<Picture>> segmented,
        Map<String, List<Picture>> distances,
        String reason) {
    public ReportPictures {
        figures = Map.copyOf(figures);
        segmented = Map.copyOf(segmented);
        distances = Map.copyOf(distances);
    }

    /** Adds the pictures of a figure, or the reason why there are none. */
    void add(ReportDocument report, int number, List<Picture> pictures, String caption) {
        if (pictures == null || pictures.isEmpty()) {
            report.remark("Fig. " + number + " has no picture here. " + reason);
        } else {
            report.add(new Figure(caption, pictures));
        }
    }
}
