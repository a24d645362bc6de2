package org.phrenic.study.hard;

import org.phrenic.engine.integrator.IntegratorKind;

/**
 * One hard case under one integrator.
 *
 * @param caseKey which case
 * @param kind the scheme
 * @param verdict how it ended
 * @param sentence what was refused, noticed or passed over; empty for a stable cell
 * @param askedS simulated time asked for, s
 * @param simulatedS simulated time at the end, s
 * @param dtS time step, s
 * @param substeps parts a step at the end; 0 where it was refused
 * @param kineticFactor largest kinetic energy over that of the trusted run; NaN without one
 * @param speedMmS largest speed of a node, mm/s
 * @param reachMm largest distance of a node from its start, mm
 * @param shape largest rms distance from the trusted run over its excursion; NaN without one
 * @param linkError largest relative error of a rigid link's length
 * @param returnMm rms distance from the start at the end, mm
 * @param repeatMm largest distance of a node at the end of any later period from where it was at the end of the first period after a minute, mm; NaN in shorter runs
 * @param driftMm largest distance of a node from its start after the breath was stopped and the body had come to rest, mm; NaN where that is not asked for
 */
public record Cell(
        String caseKey,
        IntegratorKind kind,
        Verdict verdict,
        String sentence,
        double askedS,
        double simulatedS,
        double dtS,
        int substeps,
        double kineticFactor,
        double speedMmS,
        double reachMm,
        double shape,
        double linkError,
        double returnMm,
        double repeatMm,
        double driftMm) {

    /** Whether it ended before its time because it had spent what it may. */
    boolean endedEarly() {
        return verdict != Verdict.REFUSED && verdict != Verdict.SILENT_FAILURE && simulatedS < askedS - dtS;
    }

    static Cell refused(HardCase hard, IntegratorKind kind, double askedS, String sentence) {
        double none = Double.NaN;
        return new Cell(
                hard.key(),
                kind,
                Verdict.REFUSED,
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
