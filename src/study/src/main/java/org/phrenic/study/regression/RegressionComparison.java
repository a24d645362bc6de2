package org.phrenic.study.regression;

import static org.phrenic.file.Numbers.format;

import java.util.Set;
import java.util.TreeSet;
import org.phrenic.simulation.observe.Observation;

/**
 * Comparison of a scene with its references.
 *
 * @param scene name of the scene
 * @param passes whether all values are within the tolerances
 * @param worstMm largest distance of a node from its reference, mm; NaN if a position is NaN
 * @param worstNode that node, in the caller's numbering; -1 if nodes were not compared
 * @param worstNodeTimeS time of that distance, s
 * @param worstObservable observable or report value with the largest error; empty if none was compared
 * @param worstRelativeError its error relative to max(|reference|, 1)
 * @param worstObservableTimeS time of that error, s
 * @param sentence description of the failure; empty if the comparison passes
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

    /** A scene that failed before the comparison. */
    static RegressionComparison failed(RegressionScene scene, String sentence) {
        double none = Double.NaN;
        return new RegressionComparison(scene.name(), false, none, -1, none, "", none, none, sentence);
    }

    /** Comparison of a report, leaf by leaf. */
    static RegressionComparison ofReport(String name, boolean holds, String worst, double share, String sentence) {
        double none = Double.NaN;
        return new RegressionComparison(name, holds, none, -1, none, worst, share, none, sentence);
    }

    /** Largest error so far; NaN counts as larger than any number. */
    private static final class Worst {
        private double error = -1;
        private int index = -1;
        private double timeS;

        void offer(double other, int at, double time) {
            if (!Double.isNaN(error) && !(other <= error)) {
                error = other;
                index = at;
                timeS = time;
            }
        }
    }

    /**
     * Compares computed results with references. Every error must be within its tolerance; NaN fails. Observables that
     * the scene does not have must be unknown in the references.
     */
    static RegressionComparison of(RegressionScene scene, RegressionReference stored, RegressionReference computed) {
        if (stored.nodeCount() != computed.nodeCount()) {
            String counts = "has " + computed.nodeCount() + " nodes, the references are of " + stored.nodeCount();
            return failed(scene, counts + " nodes");
        }
        if (stored.frames().size() != computed.frames().size()) {
            return failed(
                    scene,
                    format(
                            "is compared at %d times, the references are of %d",
                            computed.frames().size(), stored.frames().size()));
        }
        Worst node = new Worst();
        Worst observable = new Worst();
        for (int f = 0; f < stored.frames().size(); f++) {
            RegressionReference.Frame reference = stored.frames().get(f);
            RegressionReference.Frame frame = computed.frames().get(f);
            for (int i = 0; i < stored.nodes().length; i++) {
                double distance = distance(reference.positions(), frame.positions(), 3 * i);
                node.offer(distance, stored.nodes()[i], reference.timeS());
            }
            for (int c = 0; c < Observation.COLUMNS.size(); c++) {
                if (!computed.unknown().contains(Observation.COLUMNS.get(c))) {
                    double error = error(reference.observables()[c], frame.observables()[c]);
                    observable.offer(error, c, reference.timeS());
                }
            }
        }
        String name = Observation.COLUMNS.get(observable.index);
        String sentence = "";
        if (!(node.error <= scene.toleranceMm())) {
            sentence = format(
                    "node %d is %.4g mm from its reference at %.3f s, the tolerance is %s mm",
                    node.index, node.error, node.timeS, scene.toleranceMm());
        } else if (!(observable.error <= scene.observableTolerance())) {
            sentence = format(
                    "%s is off by %.3g of it at %.3f s, the tolerance is %s",
                    name, observable.error, observable.timeS, scene.observableTolerance());
        } else if (!stored.unknown().containsAll(computed.unknown())) {
            Set<String> known = new TreeSet<>(computed.unknown());
            known.removeAll(stored.unknown());
            sentence = String.join(", ", known) + ": known in the references, unknown in the scene, which lacks what is"
                    + " measured; --write-references makes the references anew";
        }
        return new RegressionComparison(
                scene.name(),
                sentence.isEmpty(),
                node.error,
                node.index,
                node.timeS,
                name,
                observable.error,
                observable.timeS,
                sentence);
    }

    /** Relative error of an observable. */
    private static double error(double expected, double computed) {
        return Math.abs(computed - expected) / Math.max(1, Math.abs(expected));
    }

    private static double distance(double[] p, double[] q, int at) {
        double dx = p[at] - q[at];
        double dy = p[at + 1] - q[at + 1];
        double dz = p[at + 2] - q[at + 2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }
}
