package org.phrenic.engine.integrator;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.IntFunction;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/**
 * Detects divergence and keeps a checkpoint to restore. A state has diverged if a value is not finite or a node is
 * faster than {@code MAX_SPEED}; this is checked in every step. An optional bound on node displacement is checked every
 * {@value #STEPS_BETWEEN_MEASURES} steps, because a membrane that inflates without limit is never fast; so is an
 * optional box that some nodes may not leave.
 */
final class DivergenceGuard {
    /** Bound of the speed of a node, mm/s: ten times the roughly 1,000 mm/s of tissue in a cough. */
    private static final double MAX_SPEED = 10_000;

    /** Highest speed of a node in an automatic checkpoint, mm/s. A faster state may be about to diverge. */
    private static final double CALM_SPEED = 2_500;

    private static final long STEPS_BETWEEN_SNAPSHOTS = 256;

    private static final long STEPS_BETWEEN_MEASURES = 16;
    /**
     * Largest displacement in an automatic checkpoint, as a fraction of the bound. A larger one may be about to exceed
     * it.
     */
    private static final double CALM_REACH = 0.8;
    /** Least distance from the sides of the box in an automatic checkpoint, mm. */
    private static final double CALM_MARGIN_MM = 10;
    /**
     * Number of steps after a restored checkpoint, and after that of a change, in which displacement is not checked, so
     * that outward motion can reverse. A run that repeats the changes of another diverges where that does.
     */
    private static final long STEPS_TO_TURN_ROUND = 256;

    private final ParticleSystem system;
    private final double[] checkpointX;
    private final double[] checkpointV;
    private final boolean[] good;
    private long checkpointStep;
    /** First step whose state may replace the checkpoint. */
    private long replaceableFrom;

    private double bound;
    private final Workers.Task scan = this::scan;
    /** Reference positions for displacement, mm; empty without a bound. */
    private double[] reference = {};

    private double maxDisplacement = Double.POSITIVE_INFINITY;
    private IntFunction<String> names = node -> "node " + node;
    private long measuredFrom;
    private double within;
    /** Internal numbers of the nodes that may not leave the box; empty without a box. */
    private int[] confined = {};

    private double[] box = {};
    private String boxName = "";
    private final Workers.Task measure = this::measure;

    DivergenceGuard(ParticleSystem system) {
        this.system = system;
        checkpointX = system.positions().clone();
        checkpointV = system.velocities().clone();
        good = new boolean[system.layout().blockCount()];
    }

    /** Bounds the displacement of every node from its current position, mm. */
    void boundDisplacement(double mm) {
        measuredFrom = 0;
        reference = system.positions().clone();
        maxDisplacement = mm;
    }

    /**
     * Confines nodes to a box.
     *
     * @param nodes caller's numbers
     * @param lowHigh least x, y, z, then greatest x, y, z, mm; may be infinite
     * @param name of the box, in messages
     */
    void confine(int[] nodes, double[] lowHigh, String name) {
        confined = Arrays.stream(nodes).map(system.layout()::internal).toArray();
        box = lowHigh.clone();
        boxName = name;
    }

    /** Names nodes in messages by their number in the caller's order. */
    void nameNodes(IntFunction<String> naming) {
        names = naming;
    }

    private String name(int node) {
        return nameOfCaller(system.layout().caller(node));
    }

    /** Name of a node, by its number in the caller's order. */
    String nameOfCaller(int node) {
        return names.apply(node);
    }

    /** Restarts at step 0 with the current state as checkpoint. */
    void restart() {
        measuredFrom = 0;
        checkpoint(0, 0);
    }

    /** Step of the checkpoint. */
    long checkpointStep() {
        return checkpointStep;
    }

    /**
     * Saves the current state as checkpoint, unless it has diverged.
     *
     * @param kept number of steps in which no automatic checkpoint replaces it; 0 for one that no change follows
     */
    void checkpoint(long step, long kept) {
        measuredFrom = kept > 0 ? step + STEPS_TO_TURN_ROUND : measuredFrom;
        if (isGood()) {
            replaceableFrom = step + Math.max(kept, STEPS_BETWEEN_SNAPSHOTS);
            System.arraycopy(system.positions(), 0, checkpointX, 0, checkpointX.length);
            System.arraycopy(system.velocities(), 0, checkpointV, 0, checkpointV.length);
            system.saveHistory();
            checkpointStep = step;
        }
    }

    /** Checks the state after a step; returns the cause of divergence, or null. */
    String check(long step) {
        if (!isGood()) {
            return describe();
        }
        String unmet = system.violation();
        if (unmet != null) {
            return unmet;
        }
        if (step >= measuredFrom && step % STEPS_BETWEEN_MEASURES == 0 && !isNear(maxDisplacement)) {
            measuredFrom = checkpointStep + STEPS_TO_TURN_ROUND;
            return describeFarthest();
        }
        int outside = step >= measuredFrom && step % STEPS_BETWEEN_MEASURES == 0 ? firstOutside(0) : -1;
        if (outside >= 0) {
            measuredFrom = checkpointStep + STEPS_TO_TURN_ROUND;
            return name(confined[outside]) + " is outside " + boxName;
        }
        if (step >= replaceableFrom
                && isWithin(CALM_SPEED)
                && isNear(CALM_REACH * maxDisplacement)
                && firstOutside(CALM_MARGIN_MM) < 0) {
            checkpoint(step, 0);
        }
        return null;
    }

    private boolean isGood() {
        return isWithin(MAX_SPEED);
    }

    private boolean isWithin(double mmS) {
        bound = mmS;
        return areAllGood(scan);
    }

    private boolean isNear(double mm) {
        within = mm;
        return reference.length == 0 || areAllGood(measure);
    }

    private boolean areAllGood(Workers.Task task) {
        system.workers().run(good.length, task);
        for (boolean block : good) {
            if (!block) {
                return false;
            }
        }
        return true;
    }

    private void scan(int block) {
        int end = system.layout().end(block);
        boolean all = true;
        for (int from = system.layout().start(block); from < end; from += NodeLayout.LOOP_CHUNK) {
            all &= areSlow(from, Math.min(end, from + NodeLayout.LOOP_CHUNK));
        }
        good[block] = all;
    }

    private boolean areSlow(int from, int end) {
        double[] v = system.velocities();
        double[] x = system.positions();
        double most = bound * bound;
        boolean all = true;
        // No early exit: it is rarely taken, and testing for it costs more.
        for (int i = 3 * from; i < 3 * end; i += 3) {
            // 0 x is NaN if x is not finite, so the comparison below also detects invalid positions.
            double speed = v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2] + 0 * (x[i] + x[i + 1] + x[i + 2]);
            all &= speed <= most;
        }
        return all;
    }

    private void measure(int block) {
        int end = system.layout().end(block);
        boolean all = true;
        for (int n = system.layout().start(block); n < end && all; n++) {
            all = squaredWay(n) <= within * within;
        }
        good[block] = all;
    }

    /** Index of the first confined node that is not within the box less a margin, mm; -1 if all are. */
    private int firstOutside(double marginMm) {
        double[] x = system.positions();
        for (int i = 0; i < confined.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double at = x[3 * confined[i] + axis];
                if (!(at >= box[axis] + marginMm && at <= box[3 + axis] - marginMm)) {
                    return i;
                }
            }
        }
        return -1;
    }

    private double squaredWay(int node) {
        double[] x = system.positions();
        double sum = 0;
        for (int i = 3 * node; i < 3 * node + 3; i++) {
            sum += (x[i] - reference[i]) * (x[i] - reference[i]);
        }
        return sum;
    }

    private String describeFarthest() {
        int farthest = 0;
        for (int n = 1; n < system.nodeCount(); n++) {
            farthest = squaredWay(n) > squaredWay(farthest) ? n : farthest;
        }
        String pattern = "%s is %.3g mm from where it was at rest, the bound is %.3g mm";
        double distance = Math.sqrt(squaredWay(farthest));
        return String.format(Locale.ROOT, pattern, name(farthest), distance, maxDisplacement);
    }

    private String describe() {
        double[] v = system.velocities();
        double[] x = system.positions();
        for (int n = 0; n < system.nodeCount(); n++) {
            double speed = 0;
            boolean finite = true;
            for (int i = 3 * n; i < 3 * n + 3; i++) {
                speed += v[i] * v[i];
                finite &= Double.isFinite(x[i]) && Double.isFinite(v[i]);
            }
            if (!finite) {
                return "position or velocity of " + name(n) + " is not a finite number";
            }
            if (speed > MAX_SPEED * MAX_SPEED) {
                String pattern = "%s moves at %.3g mm/s, the bound is %.3g mm/s";
                return String.format(Locale.ROOT, pattern, name(n), Math.sqrt(speed), MAX_SPEED);
            }
        }
        return "speed beyond all bounds";
    }

    /** Restores the checkpoint and returns its step. */
    long restore() {
        System.arraycopy(checkpointX, 0, system.positions(), 0, checkpointX.length);
        System.arraycopy(checkpointV, 0, system.velocities(), 0, checkpointV.length);
        system.restoreHistory();
        return checkpointStep;
    }
}
