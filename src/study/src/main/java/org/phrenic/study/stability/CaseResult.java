package org.phrenic.study.stability;

import org.phrenic.engine.integrator.IntegratorKind;

/**
 * One hard case under one integrator.
 *
 * @param caseKey which case
 * @param integrator the scheme
 * @param outcome how it ended
 * @param sentence what was refused, noticed or passed over; empty for a stable cell
 * @param requestedS simulated time asked for, s
 * @param simulatedS simulated time at the end, s
 * @param dtS time step, s
 * @param substeps parts a step at the end; 0 where it was refused
 * @param kineticFactor largest kinetic energy over that of the trusted run; NaN without one
 * @param speedMmS largest speed of a node, mm/s
 * @param reachMm largest distance of a node from its start, mm
 * @param shapeError largest rms distance from the trusted run over its excursion; NaN without one
 * @param linkError largest relative error of a rigid link's length
 * @param returnMm rms distance from the start at the end, mm
 * @param repeatMm largest distance of a node at the end of any later period from where it was at the end of the first
 *     period after a minute, mm; NaN in shorter runs
 * @param driftMm largest distance of a node from its start after the breath was stopped and the body had come to rest,
 *     mm; NaN where that is not asked for
 */
public record CaseResult(
        String caseKey,
        IntegratorKind integrator,
        CaseOutcome outcome,
        String sentence,
        double requestedS,
        double simulatedS,
        double dtS,
        int substeps,
        double kineticFactor,
        double speedMmS,
        double reachMm,
        double shapeError,
        double linkError,
        double returnMm,
        double repeatMm,
        double driftMm) {

    /** Whether it ended before its time because it had spent what it may. */
    boolean endedEarly() {
        return outcome != CaseOutcome.REFUSED && outcome != CaseOutcome.SILENT_FAILURE && simulatedS < requestedS - dtS;
    }

    static CaseResult refused(StabilityCase hard, IntegratorKind kind, double askedS, String sentence) {
        double none = Double.NaN;
        return new CaseResult(
                hard.key(),
                kind,
                CaseOutcome.REFUSED,
                sentence,
                askedS,
                0,
                none,
                0,
                none,
                none,
                none,
                none,
                none,
                none,
                none,
                none);
    }
}
