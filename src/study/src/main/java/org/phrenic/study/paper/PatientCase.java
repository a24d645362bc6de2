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
 * A patient at two breath levels, and what a fit made of it.
 *
 * @param name of the patient
 * @param data where the two levels come from
 * @param synthetic whether no real patient lies behind it
 * @param body at the end of exhale: what the scan shows, and what it lacks from a virtual body
 * @param notes on how body and targets came about
 * @param fit from the end of exhale to the end of inhale
 */
public record PatientCase(String name, String data, boolean synthetic, Thorax body, List<String> notes, FitResult fit) {
    private static final List<FitPart> LUNGS = List.of(FitPart.LUNG_RIGHT, FitPart.LUNG_LEFT);
    private static final List<FitPart> BASES = List.of(FitPart.LUNG_BASE_RIGHT, FitPart.LUNG_BASE_LEFT);

    public PatientCase {
        notes = List.copyOf(notes);
    }

    /** Distances before and after the model, mm. */
    record DistanceChange(DistanceSummary before, DistanceSummary after) {
        /** Mean distance left, as a share of what it was. */
        double ratio() {
            return after.mean() / before.mean();
        }
    }

    /** The lungs before and after: vertices of the body's lungs with their distance from the target. */
    public List<FitResult.TargetResult> lungs() {
        return of(LUNGS);
    }

    /** The diaphragm at the end of exhale. */
    public TriangleMesh diaphragm() {
        return body.structures().stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .map(Structure::mesh)
                .findFirst()
                .orElseThrow();
    }

    /** Distances of both lungs, whole. */
    DistanceChange lungChange() {
        return change(lungs());
    }

    /** Distances of their bases, if those were fitted to. */
    Optional<DistanceChange> lungBaseChange() {
        List<FitResult.TargetResult> bases = of(BASES);
        return bases.isEmpty() ? Optional.empty() : Optional.of(change(bases));
    }

    private List<FitResult.TargetResult> of(List<FitPart> parts) {
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
