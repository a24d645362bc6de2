package org.phrenic.study.error;

/**
 * Cost of a solver setting and its error against the reference over one breath.
 *
 * @param settings solver settings
 * @param substeps substeps per time step required by the stability limit
 * @param rmsMm rms distance of the diaphragm's nodes from the reference over all samples, mm
 * @param maxMm maximum distance of the diaphragm's nodes, mm
 * @param allRmsMm rms distance of all nodes, including lungs and sternum, mm
 * @param allMaxMm maximum distance of all nodes, mm
 * @param startRmsMm rms distance of the diaphragm's nodes over the first {@value ErrorStudy#START_S} s, mm
 * @param cpuS processor time, s
 * @param wallS elapsed time, s
 * @param realTime simulated time over {@code cpuS} on one thread, over {@code wallS} on several
 * @param paretoOptimal whether no other setting of the scene has both lower cost and lower error, and this error is
 *     resolved
 * @param isDefault whether it is the scenario's own setting
 */
public record ErrorPoint(
        SolverSettings settings,
        int substeps,
        double rmsMm,
        double maxMm,
        double allRmsMm,
        double allMaxMm,
        double startRmsMm,
        double cpuS,
        double wallS,
        double realTime,
        boolean paretoOptimal,
        boolean isDefault) {
    ErrorPoint withParetoOptimal(boolean optimal) {
        return new ErrorPoint(
                settings,
                substeps,
                rmsMm,
                maxMm,
                allRmsMm,
                allMaxMm,
                startRmsMm,
                cpuS,
                wallS,
                realTime,
                optimal,
                isDefault);
    }
}
