package org.phrenic.study.regression;

import java.util.List;
import java.util.Locale;
import org.phrenic.simulation.observe.Observation;

/**
 * How far a scene is from its references.
 *
 * @param scene its name
 * @param passes whether all is within the tolerances
 * @param worstMm largest distance of a node from its reference, mm; NaN where a place is no number
 * @param worstNode that node, in the caller's numbering; -1 where it was not reached
 * @param worstNodeTimeS when, s
 * @param worstObservable observable, or number of a report, that is farthest off; empty where it was not reached
 * @param worstRelativeError by how much, as a share of it or of 1
 * @param worstObservableTimeS when, s
 * @param sentence what is wrong; empty if all holds
 */
public record RegressionComparison(
        String scene,
        boolean passes,
        double worstMm,
        int worstNode,
        double worstNodeTimeS,
        String worstObservable,
        double worstRelativeError,
        double worstObservableTimeS,
        String sentence) {

    /** A scene that gave nothing to compare. */
    static RegressionComparison failed(RegressionScene scene, String sentence) {
        double none = Double.NaN;
        return new RegressionComparison(scene.name(), false, none, -1, none, "", none, none, sentence);
    }

    /** A report compared leaf by leaf. */
    static RegressionComparison ofReport(String name, boolean holds, String worst, double share, String sentence) {
        double none = Double.NaN;
        return new RegressionComparison(name, holds, none, -1, none, worst, share, none, sentence);
    }

    /**
     * Compares what a scene gives now with what it gave: everything must be within its tolerance, and what is no number
     * is within none.
     */
    static RegressionComparison of(RegressionScene scene, RegressionReference then, RegressionReference now) {
        if (then.nodeCount() != now.nodeCount()) {
            return failed(
                    scene, "has " + now.nodeCount() + " nodes, the references are of " + then.nodeCount() + " nodes");
        }
        double farthest = -1;
        int node = -1;
        double nodeTime = 0;
        double most = -1;
        String name = "";
        double observableTime = 0;
        for (int f = 0; f < then.frames().size(); f++) {
            RegressionReference.Frame old = then.frames().get(f);
            RegressionReference.Frame fresh = now.frames().get(f);
            for (int i = 0; i < then.nodes().length; i++) {
                double distance = distance(old.positions(), fresh.positions(), 3 * i);
                if (isWorse(distance, farthest)) {
                    farthest = distance;
                    node = then.nodes()[i];
                    nodeTime = old.timeS();
                }
            }
            List<String> columns = Observation.COLUMNS;
            for (int c = 0; c < columns.size(); c++) {
                double reference = old.observables()[c];
                double off = Math.abs(fresh.observables()[c] - reference) / Math.max(1, Math.abs(reference));
                if (isWorse(off, most)) {
                    most = off;
                    name = columns.get(c);
                    observableTime = old.timeS();
                }
            }
        }
        boolean nodesHold = !exceeds(farthest, scene.toleranceMm());
        boolean observablesHold = !exceeds(most, scene.observableTolerance());
        String sentence = nodesHold && observablesHold
                ? ""
                : nodesHold
                        ? String.format(
                                Locale.ROOT,
                                "%s is off by %.3g of it at %.3f s, the tolerance is %s",
                                name,
                                most,
                                observableTime,
                                scene.observableTolerance())
                        : String.format(
                                Locale.ROOT,
                                "node %d is %.4g mm from its reference at %.3f s, the tolerance is %s mm",
                                node,
                                farthest,
                                nodeTime,
                                scene.toleranceMm());
        return new RegressionComparison(
                scene.name(),
                nodesHold && observablesHold,
                farthest,
                node,
                nodeTime,
                name,
                most,
                observableTime,
                sentence);
    }

    /** Beyond the tolerance, or no number at all. */
    private static boolean exceeds(double error, double tolerance) {
        return !(error <= tolerance);
    }

    /** What is no number is worse than any that is. */
    private static boolean isWorse(double error, double worst) {
        return !Double.isNaN(worst) && !(error <= worst);
    }

    private static double distance(double[] p, double[] q, int at) {
        double dx = p[at] - q[at];
        double dy = p[at + 1] - q[at + 1];
        double dz = p[at + 2] - q[at + 2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }
}
