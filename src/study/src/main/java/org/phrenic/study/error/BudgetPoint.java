package org.phrenic.study.error;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Whole error of a setting against its speed. The whole is the sum of its three parts, an upper bound of their
 * combination. Percentages are of the domes' excursion.
 *
 * @param row the setting's measurement of the error in time
 * @param timePercent rms distance from the reference, and the reference's uncertainty
 * @param resolved whether that distance is at least three times the reference's uncertainty
 * @param spacePercent difference of the default's excursion on the same mesh from that extrapolated to edge length 0,
 *     or from the mean of those on the three finest meshes if no order of convergence is observed; NaN if not measured
 * @param extrapolated whether an order of convergence in space is observed
 * @param equilibriumPercent largest rms distance from equilibrium at the phases; NaN if not measured
 */
public record BudgetPoint(
        BudgetRow row,
        double timePercent,
        boolean resolved,
        double spacePercent,
        boolean extrapolated,
        double equilibriumPercent) {
    /** Number of meshes of the mean that stands for the limit without an order. */
    private static final int FINEST = 3;

    /** Sum of the parts, per cent; NaN if one of them was not measured. */
    public double wholePercent() {
        return timePercent + spacePercent + equilibriumPercent;
    }

    /** Name of the integrator. */
    public String integrator() {
        return row.setting().substring(0, row.setting().indexOf(','));
    }

    /** The points of all settings of which the error in time was measured. */
    public static List<BudgetPoint> of(BudgetTable table) {
        List<BudgetPoint> points = new ArrayList<>();
        for (BudgetRow row : table.rows()) {
            if (row.part() == BudgetPart.TIME) {
                points.add(new BudgetPoint(
                        row,
                        100 * (row.rmsMm() + row.uncertaintyMm()) / row.excursionMm(),
                        row.rmsMm() >= ErrorStudy.RESOLVED * row.uncertaintyMm(),
                        space(table, row),
                        convergence(table, row.body(), row.breath())
                                .map(RichardsonFit::hasOrder)
                                .orElse(false),
                        equilibrium(table, row)));
            }
        }
        return points;
    }

    /** Convergence of the excursion of a body's breath in space, if at least three meshes were measured. */
    static Optional<RichardsonFit> convergence(BudgetTable table, String body, String breath) {
        List<BudgetRow> meshes = measured(table, body, breath);
        return meshes.size() < RichardsonFit.LEAST_MESHES
                ? Optional.empty()
                : Optional.of(RichardsonFit.of(
                        meshes.stream().mapToDouble(BudgetRow::edgeMm).toArray(),
                        meshes.stream().mapToDouble(BudgetRow::excursionMm).toArray()));
    }

    /** Of the measurements on meshes of different edge lengths, those that did not diverge. */
    private static List<BudgetRow> measured(BudgetTable table, String body, String breath) {
        return meshes(table, body, breath).stream()
                .filter(m -> !Double.isNaN(m.excursionMm()))
                .toList();
    }

    /** Measurements on meshes of different edge lengths, coarsest first. */
    static List<BudgetRow> meshes(BudgetTable table, String body, String breath) {
        return table.rows().stream()
                .filter(r -> r.isOf(BudgetPart.SPACE, body, breath, r.mesh()))
                .sorted((a, b) -> Double.compare(b.edgeMm(), a.edgeMm()))
                .toList();
    }

    private static double space(BudgetTable table, BudgetRow row) {
        double usualMm = table.usual(BudgetPart.TIME, row.body(), row.breath(), row.mesh())
                .map(BudgetRow::excursionMm)
                .orElse(Double.NaN);
        return convergence(table, row.body(), row.breath())
                .map(fit -> fit.hasOrder() ? fit.limit() : finest(table, row.body(), row.breath()))
                .map(limit -> 100 * Math.abs(usualMm - limit) / Math.abs(limit))
                .orElse(Double.NaN);
    }

    /** Mean excursion on the finest meshes, mm: it scatters less than that on one. */
    private static double finest(BudgetTable table, String body, String breath) {
        List<BudgetRow> meshes = measured(table, body, breath);
        return meshes.subList(meshes.size() - FINEST, meshes.size()).stream()
                .mapToDouble(BudgetRow::excursionMm)
                .average()
                .orElseThrow();
    }

    private static double equilibrium(BudgetTable table, BudgetRow row) {
        return table.rows(BudgetPart.EQUILIBRIUM, row.body(), row.breath(), row.mesh()).stream()
                .filter(r -> !r.isOfNewton())
                .mapToDouble(BudgetRow::percent)
                .max()
                .orElse(Double.NaN);
    }
}
