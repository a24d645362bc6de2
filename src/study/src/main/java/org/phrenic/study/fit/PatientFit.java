package org.phrenic.study.fit;

import java.nio.file.Path;
import java.util.Optional;
import org.phrenic.fit.Fit;
import org.phrenic.fit.FitHalf;
import org.phrenic.fit.FitProgress;
import org.phrenic.fit.FitResult;
import org.phrenic.fit.FitSetup;
import org.phrenic.fit.FitTarget;
import org.phrenic.fit.Landmarks;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.scenario.Scenario;

/**
 * Three fits of a patient: to the whole surfaces, and to either half of them.
 *
 * @param whole fitted to the whole surfaces
 * @param even fitted to every other square of 40 mm, seen from above, and judged on the rest
 * @param odd fitted to the rest, and judged on those squares
 */
public record PatientFit(String name, FitResult whole, FitResult even, FitResult odd) {
    /**
     * Fits a patient.
     *
     * @param base scenario with resolution and settings that are not fitted
     * @param landmarks file of pairs of points inside the lungs
     * @param folder folder for the journals; the same fits in the same folder go on where they ended
     */
    public static PatientFit of(
            PatientImport patient,
            Scenario base,
            Optional<Path> landmarks,
            FitSearch.Settings search,
            int threads,
            Path folder,
            FitProgress progress) {
        Optional<Landmarks> inside = landmarks.map(file -> Landmarks.read(file, patient.alignment()));
        FitResult[] results = new FitResult[FitHalf.values().length];
        for (FitHalf half : FitHalf.values()) {
            progress.note(patient.name() + ", fitted to: " + label(half));
            FitSetup setup = new FitSetup(
                    base,
                    patient.body(),
                    FitTarget.withBases(patient.targets()),
                    FitParameter.defaults(base),
                    new FitSetup.Options(half, patient.alignment().sentence(), search, threads, false, inside));
            results[half.ordinal()] =
                    Fit.run(setup, folder.resolve(patient.name() + "-" + label(half) + ".csv"), progress);
        }
        return new PatientFit(
                patient.name(),
                results[FitHalf.ALL.ordinal()],
                results[FitHalf.EVEN.ordinal()],
                results[FitHalf.ODD.ordinal()]);
    }

    private static String label(FitHalf half) {
        return half == FitHalf.ALL ? "whole" : half == FitHalf.EVEN ? "even" : "odd";
    }

    /** Mean distance on the half that is not fitted, after over before, over all targets. */
    public static double heldOutRatio(FitResult fit) {
        double before = 0;
        double after = 0;
        for (FitResult.TargetResult target : fit.targets()) {
            before += target.initialHeldOut().mean();
            after += target.residualHeldOut().mean();
        }
        return after / before;
    }
}
