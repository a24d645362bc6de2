package org.phrenic.ui.chart;

import java.util.List;
import java.util.Optional;
import org.phrenic.ui.session.NumberFormats;
import org.phrenic.ui.widget.Controls;

/**
 * Peak-to-peak values of some curves in a kept breath and in the last whole breath of the run, and their difference.
 */
public record BreathComparison(String keptName, List<Row> rows) {
    /** One curve; {@code present} is NaN before the first whole breath since the last change. */
    public record Row(String label, String unit, int decimals, double kept, double present) {
        /** The present value less the kept one. */
        public double difference() {
            return present - kept;
        }
    }

    static BreathComparison of(List<PlotCurve> curves, KeptBreath kept, Optional<KeptBreath> present) {
        List<Row> rows = curves.stream()
                .map(curve -> new Row(
                        curve.label(),
                        curve.unit(),
                        curve.decimals(),
                        kept.peakToPeak(curve.index()),
                        present.map(breath -> breath.peakToPeak(curve.index())).orElse(Double.NaN)))
                .filter(row -> !Double.isNaN(row.kept))
                .toList();
        return new BreathComparison(kept.name(), rows);
    }

    /** As a table for a label. */
    public String html() {
        StringBuilder table = new StringBuilder("<html>Peak to peak of a breath; kept: ")
                .append(Controls.escapeHtml(keptName))
                .append("<table cellpadding=1>");
        table.append("<tr><td></td><td align=right>kept</td><td align=right>now</td><td align=right>change</td></tr>");
        for (Row row : rows) {
            String sign = row.difference() > 0 ? "+" : "";
            table.append("<tr><td>")
                    .append(Controls.escapeHtml(row.label + (row.unit.equals("1") ? "" : " (" + row.unit + ")")))
                    .append(cell(NumberFormats.fixedDecimals(row.kept, row.decimals)))
                    .append(cell(NumberFormats.fixedDecimals(row.present, row.decimals)))
                    .append(cell(sign + NumberFormats.fixedDecimals(row.difference(), row.decimals)))
                    .append("</td></tr>");
        }
        return table.append("</table></html>").toString();
    }

    private static String cell(String text) {
        return "</td><td align=right>&nbsp;" + text;
    }
}
