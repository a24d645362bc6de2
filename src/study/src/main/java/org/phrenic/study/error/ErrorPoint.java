package org.phrenic.study.error;

/**
 * What a setting costs and how far it is from the reference, over one breath.
 *
 * @param settings what was run
 * @param substeps into which the stability limit splits a step
 * @param rmsMm root mean square distance of the diaphragm's nodes from the reference, over all samples, mm
 * @param maxMm greatest of these distances, mm
 * @param allRmsMm root mean square distance of all nodes, those of lungs and sternum too, mm
 * @param allMaxMm greatest of these distances, mm
 * @param cpuS processor time, s
 * @param wallS elapsed time, s
 * @param realTime simulated time over {@code wallS}
 * @param paretoOptimal whether no other setting of the scene is both cheaper and nearer
 * @param isDefault whether it is the scenario's own
 */
public record ErrorPoint(
        SolverSettings settings,
        int substeps,
        double rmsMm,
        double maxMm,
        double allRmsMm,
        double allMaxMm,
        double cpuS,
        double wallS,
        double realTime,
        boolean paretoOptimal,
        boolean isDefault) {
    ErrorPoint withParetoOptimal(boolean optimal) {
        return new ErrorPoint(
                settings, substeps, rmsMm, maxMm, allRmsMm, allMaxMm, cpuS, wallS, realTime, optimal, isDefault);
    }
}
