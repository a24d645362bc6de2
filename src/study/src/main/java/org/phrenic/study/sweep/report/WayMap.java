package org.phrenic.study.sweep.report;

import static org.phrenic.file.Numbers.format;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.study.sweep.SweepModel;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.WaySectors;

/** Share of the runs in which a straight way to the target is free during the whole breath, by its direction. */
final class WayMap {
    private static final double PERCENT = 100;

    private final SweepResults results;

    WayMap(SweepResults results) {
        this.results = results;
    }

    private boolean isEmpty() {
        SweepModel model = results.plan().model();
        return model.analysed() == model.responses().size();
    }

    /** Share in per cent of the runs that have skin in reach of the needle in a sector; NaN without one. */
    double sharePercent(int azimuthDeg, int elevationDeg) {
        int column = results.plan().model().responses().indexOf(WaySectors.column(azimuthDeg, elevationDeg));
        return PERCENT
                * Arrays.stream(results.response(column))
                        .filter(Double::isFinite)
                        .average()
                        .orElse(Double.NaN);
    }

    /** The shares for JSON. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int azimuth : isEmpty() ? new int[0] : WaySectors.azimuthsDeg()) {
            for (int elevation : WaySectors.elevationsDeg()) {
                double share = sharePercent(azimuth, elevation);
                if (Double.isFinite(share)) {
                    map.put(WaySectors.column(azimuth, elevation), share);
                }
            }
        }
        return map;
    }

    void addTo(ReportDocument page) {
        if (isEmpty()) {
            return;
        }
        List<Column> columns = new ArrayList<>(List.of(Column.text("from above, degrees")));
        for (int azimuth : WaySectors.azimuthsDeg()) {
            columns.add(Column.number(azimuth + " deg"));
        }
        List<List<String>> rows = new ArrayList<>();
        int[] elevations = WaySectors.elevationsDeg();
        for (int e = elevations.length - 1; e >= 0; e--) {
            List<String> row = new ArrayList<>(List.of(String.valueOf(elevations[e])));
            for (int azimuth : WaySectors.azimuthsDeg()) {
                double share = sharePercent(azimuth, elevations[e]);
                row.add(Double.isFinite(share) ? format("%.0f", share) : "-");
            }
            rows.add(row);
        }
        page.section("Free ways");
        page.table(
                "Share of the runs, in per cent, in which a straight way to the target is free during the whole"
                        + " breath, by its direction seen from the target: 0 degrees is the front, 90 the right side."
                        + " '-': no skin in reach of the needle.",
                columns,
                rows);
    }
}
