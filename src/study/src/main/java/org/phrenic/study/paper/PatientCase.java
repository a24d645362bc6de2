package org.phrenic.study.paper;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.fit.FitDistances;
import org.phrenic.fit.FitPart;
import org.phrenic.fit.FitResult;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;

/**
 * A patient at two breath levels with the result of a fit.
 *
 * @param name of the patient
 * @param data source of the two levels
 * @param synthetic whether the patient is synthetic
 * @param body at end-expiration: structures of the scan, completed from a virtual body
 * @param notes on the derivation of body and targets
 * @param fit from end-expiration to end-inspiration
 * @param paperFit the same with the paper's method: ribs still, force along action lines; empty if it was not run
 */
public record PatientCase(
        String name,
        String data,
        boolean synthetic,
        Thorax body,
        List<String> notes,
        FitResult fit,
        Optional<FitResult> paperFit) {
    static final List<FitPart> LUNGS = List.of(FitPart.LUNG_RIGHT, FitPart.LUNG_LEFT);
    private static final List<FitPart> BASES = List.of(FitPart.LUNG_BASE_RIGHT, FitPart.LUNG_BASE_LEFT);

    public PatientCase {
        notes = List.copyOf(notes);
    }

    /** Distance summaries before and after the fit, mm. */
    record DistanceChange(DistanceSummary before, DistanceSummary after) {
        /** Mean distance after over mean distance before. */
        double ratio() {
            return after.mean() / before.mean();
        }
    }

    /** Distances from the target at the vertices of the body's lungs, before and after. */
    public List<FitResult.TargetResult> lungs() {
        return of(fit, LUNGS);
    }

    /** The diaphragm at end-expiration. */
    public TriangleMesh diaphragm() {
        return body.structures().stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .map(Structure::mesh)
                .findFirst()
                .orElseThrow();
    }

    /** Distance change of both whole lungs. */
    DistanceChange lungChange() {
        return change(lungs());
    }

    /** Distance change of the lung bases, if they are fit targets. */
    Optional<DistanceChange> lungBaseChange() {
        return change(fit, BASES);
    }

    /** Distance change of both whole lungs with the paper's method. */
    Optional<DistanceChange> paperLungChange() {
        return paperFit.flatMap(result -> change(result, LUNGS));
    }

    /** Distance change of the lung bases with the paper's method. */
    Optional<DistanceChange> paperBaseChange() {
        return paperFit.flatMap(result -> change(result, BASES));
    }

    private static Optional<DistanceChange> change(FitResult fit, List<FitPart> parts) {
        List<FitResult.TargetResult> targets = of(fit, parts);
        return targets.isEmpty() ? Optional.empty() : Optional.of(change(targets));
    }

    private static List<FitResult.TargetResult> of(FitResult fit, List<FitPart> parts) {
        return fit.targets().stream()
                .filter(t -> parts.contains(t.target().part()))
                .toList();
    }

    private static DistanceChange change(List<FitResult.TargetResult> targets) {
        return new DistanceChange(
                together(targets.stream().map(FitResult.TargetResult::initial).toList()),
                together(targets.stream().map(FitResult.TargetResult::residual).toList()));
    }

    private static DistanceSummary together(List<FitDistances> parts) {
        int count = parts.stream()
                .mapToInt(d -> d.toTarget().length + d.toModel().length)
                .sum();
        double[] distances = new double[count];
        double[] weights = new double[count];
        int at = 0;
        for (FitDistances d : parts) {
            System.arraycopy(d.toTarget(), 0, distances, at, d.toTarget().length);
            System.arraycopy(d.modelWeights(), 0, weights, at, d.toTarget().length);
            at += d.toTarget().length;
            System.arraycopy(d.toModel(), 0, distances, at, d.toModel().length);
            System.arraycopy(d.targetWeights(), 0, weights, at, d.toModel().length);
            at += d.toModel().length;
        }
        return DistanceSummary.of(distances, weights);
    }
}
