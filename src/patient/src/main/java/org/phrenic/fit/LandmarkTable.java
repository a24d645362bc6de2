package org.phrenic.fit;

import java.util.List;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.query.DistanceSummary;

/** Errors of landmarks as a table, a sentence and JSON values. */
public record LandmarkTable(Landmarks.Errors errors) {
    /** Columns of {@link #rows}. */
    public static final List<Column> COLUMNS =
            Column.list("landmarks | # mean | # SD | # RMS | # 95 % | # over aligned");

    /** Errors, mm, one row per way to predict the points. */
    public List<List<String>> rows() {
        return List.of(
                row("as scanned", errors.scanned()),
                row("scans aligned: no model", errors.rigid()),
                row("aligned, less the mean displacement", errors.rigidLessMean()),
                row("moved as the nearest surface", errors.bySurface().nearest()),
                row("attached to the fitted surface", errors.bySurface().attached()),
                row("carried by the fitted lung", errors.fitted()),
                row("carried, less the mean error", errors.fittedLessMean()));
    }

    private List<String> row(String what, DistanceSummary d) {
        double ratio = d.mean() / errors.rigid().mean();
        return List.of(
                what,
                FitReport.mm(d.mean()),
                FitReport.mm(d.deviation()),
                FitReport.mm(d.rms()),
                FitReport.mm(d.percentile95()),
                FitReport.ratio(ratio));
    }

    /** The shift of the patient between the scans and the displacement that is left, as a sentence. */
    public String shifts() {
        Landmarks.Shifts shifts = errors.shifts();
        return "Mean displacement of the landmarks (left, back, up): " + vector(shifts.byAlignment())
                + " mm by the alignment, " + vector(shifts.left()) + " mm left; " + shifts.outside() + " of "
                + errors.rigid().points() + " lie outside the lungs at end-expiration.";
    }

    private static String vector(double[] v) {
        return Numbers.format("%.1f, %.1f, %.1f", v[0], v[1], v[2]);
    }

    /** The errors as JSON values. */
    OrderedValues values() {
        return new OrderedValues()
                .with("as_scanned", errors.scanned().values())
                .with("aligned", errors.rigid().values())
                .with("aligned_less_mean", errors.rigidLessMean().values())
                .with("nearest_surface", errors.bySurface().nearest().values())
                .with("attached", errors.bySurface().attached().values())
                .with("fitted", errors.fitted().values())
                .with("fitted_less_mean", errors.fittedLessMean().values())
                .with("shift_by_alignment_mm", errors.shifts().byAlignment())
                .with("shift_left_mm", errors.shifts().left())
                .with("outside", errors.shifts().outside());
    }
}
