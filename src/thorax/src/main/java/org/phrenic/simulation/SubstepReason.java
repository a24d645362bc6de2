package org.phrenic.simulation;

import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.file.Numbers;

/**
 * Why each step is split into substeps.
 *
 * @param dtS time step, s
 * @param substeps number of substeps per step
 * @param sternumSubsteps those of sternum and cartilages, as many or more
 * @param limitS largest stable step, s
 * @param integrator label of the integrator
 * @param limitMessage sentence on step and limit
 * @param cause why a step within the limit was too long; empty if the limit is the reason
 */
public record SubstepReason(
        double dtS,
        int substeps,
        int sternumSubsteps,
        double limitS,
        String integrator,
        String limitMessage,
        String cause) {
    static SubstepReason of(Stepper stepper) {
        double dt = stepper.dt();
        IntegratorKind kind = stepper.integrator().kind();
        // Where the sheet takes whole steps, the limit of sternum and cartilages decides.
        StabilityLimit deciding = stepper.substeps() > 1
                ? stepper.limit()
                : stepper.limit().apart().orElse(stepper.limit());
        double limit = deciding.largestStep(kind);
        String message = deciding.describe(kind, dt);
        int sternum = stepper.substeps() * stepper.stepsApart();
        String cause = stepper.substepRefinementReason();
        return new SubstepReason(dt, stepper.substeps(), sternum, limit, kind.label(), message, cause);
    }

    /** One sentence with all values. */
    public String message() {
        String reason = cause.isEmpty()
                ? limitMessage
                : Numbers.format("time step %.6g s is too long for what the scene has become (%s)", dtS, cause);
        if (substeps == 1) {
            return reason + ": sternum and cartilages make " + sternumSubsteps + " substeps";
        }
        String own = sternumSubsteps == substeps ? "" : ", those of sternum and cartilages into " + sternumSubsteps;
        return reason + ": split into " + substeps + " substeps" + own;
    }
}
