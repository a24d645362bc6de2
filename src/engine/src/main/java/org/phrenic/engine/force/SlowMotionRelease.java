package org.phrenic.engine.force;

import java.util.Arrays;
import java.util.Optional;
import org.phrenic.engine.ForceField;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SelectiveMass;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * Relieves slow motion of the viscous force -γ v of the nodes: with u the mean of a node's velocity over the last τ
 * seconds, weighted exponentially, it adds γ u, so that node and field together feel
 *
 * <pre>
 * -γ (v - u),     du/dt = (v - u) / τ
 * </pre>
 *
 * <p>A motion of frequency ω is damped at the rate γ/m (ωτ)² / (1 + (ωτ)²): as by γ alone where ωτ is large, hardly
 * where it is small. There the force is -γ τ dv/dt, an added mass γ τ. The pair is passive: it never adds energy.
 *
 * <p>u is advanced once for each later time at which forces are evaluated, by the exact solution for a constant v, from
 * u = v after {@link #invalidate}; that of nodes apart goes with their own steps. Where the translation of a group of
 * nodes is lighter ({@link SelectiveMass}), the force on the group is smaller in proportion. Evaluations with
 * velocities other than the system's own get no force.
 */
public final class SlowMotionRelease implements ForceField {
    private static final double SAME_TIME_S = 1e-9;

    private final ParticleSystem system;
    private final NodeLayout layout;
    private final double timeS;
    private final double[] velocities;
    private final double[] u;
    private final Optional<SelectiveMass> group;
    /** Nodes of the group whose translation is lighter, block by block. */
    private final int[] relieved;

    private final int[] relievedStart;
    /** Block of the first node of the group; the others are in step with it. */
    private final int firstRelievedBlock;
    /** Share of the group's mean velocity that is taken off. */
    private final double relief;

    private final double[] groupMean = new double[3];
    private final double[] groupVelocity = new double[3];
    private boolean active = true;
    private final Clock clock = new Clock();
    /** Clock of the nodes apart, which may be at another time than the others. */
    private final Clock clockApart = new Clock();

    /** Time up to which u has been advanced. */
    private final class Clock {
        private double now = Double.NaN;
        /** Weight of v in the next u; 1 sets u to v, 0 keeps it. */
        private double weight;

        void advanceTo(double time) {
            double passed = time - now;
            // Times that differ by rounding are one time; an earlier one means that a state was restored.
            weight = Math.abs(passed) < SAME_TIME_S ? 0 : passed > 0 ? -StrictMath.expm1(-passed / timeS) : 1;
            now = weight == 0 ? now : time;
        }
    }

    /**
     * @param system its viscosities are read at every evaluation, its group with a lighter translation once: call
     *     {@link ParticleSystem#setSelectiveMass} before
     * @param timeS τ, s, more than 0
     */
    public SlowMotionRelease(ParticleSystem system, double timeS) {
        if (!(timeS > 0) || Double.isInfinite(timeS)) {
            throw new IllegalArgumentException("damping time: found " + timeS + " s, expected more than 0");
        }
        this.system = system;
        this.timeS = timeS;
        layout = system.layout();
        velocities = system.velocities();
        u = new double[velocities.length];
        group = system.selectiveMass();
        relieved = group.map(SelectiveMass::nodes).orElse(new int[0]);
        relief = group.map(SelectiveMass::relief).orElse(0.0);
        relievedStart = new int[layout.blockCount() + 1];
        for (int node : relieved) {
            relievedStart[layout.blockOf(node) + 1]++;
        }
        Arrays.parallelPrefix(relievedStart, Integer::sum);
        firstRelievedBlock = relieved.length == 0 ? 0 : layout.blockOf(relieved[0]);
    }

    /** Switches all such fields of a system off, so that slow motion is damped as well, or on. */
    public static void setActive(ParticleSystem system, boolean on) {
        for (ForceField field : system.fields()) {
            if (field instanceof SlowMotionRelease release) {
                release.active = on;
                release.invalidate();
            }
        }
    }

    @Override
    public void invalidate() {
        clock.now = Double.NaN;
        clockApart.now = Double.NaN;
    }

    @Override
    public void prepare(double time) {
        prepare(time, 0, layout.blockCount());
    }

    @Override
    public void prepare(double time, int from, int end) {
        if (!system.selectiveMass().equals(group)) {
            throw new IllegalStateException(
                    "release of slow motion: found another group with a lighter translation than when the field was"
                            + " made, expected setSelectiveMass before it");
        }
        if (from < layout.firstBlockApart()) {
            clock.advanceTo(time);
        }
        if (end > layout.firstBlockApart()) {
            clockApart.advanceTo(time);
        }
        if (group.isPresent() && from <= firstRelievedBlock && firstRelievedBlock < end) {
            double weight = clockOf(firstRelievedBlock).weight;
            if (weight > 0) {
                group.get().mean(velocities, groupVelocity);
                advance(groupMean, groupVelocity, weight, 0, groupMean.length);
            }
        }
    }

    private Clock clockOf(int block) {
        return block < layout.firstBlockApart() ? clock : clockApart;
    }

    /** Advances means; with weight 1 they are v to the last bit, whatever they were, so a restored state forgets. */
    private static void advance(double[] mean, double[] v, double weight, int from, int end) {
        if (weight == 1) {
            System.arraycopy(v, from, mean, from, end - from);
        } else {
            addShare(mean, v, weight, from, end);
        }
    }

    private static void addShare(double[] mean, double[] v, double share, int from, int end) {
        for (int i = from; i < end; i++) {
            mean[i] += share * (v[i] - mean[i]);
        }
    }

    private static void addProducts(double[] gamma, double[] u, double[] force, int from, int end) {
        for (int n = from; n < end; n++) {
            double g = gamma[n];
            int i = 3 * n;
            force[i] += g * u[i];
            force[i + 1] += g * u[i + 1];
            force[i + 2] += g * u[i + 2];
        }
    }

    @Override
    public void addForces(double[] x, double[] v, double[] force, int block) {
        if (!active || v != velocities) {
            return;
        }
        double weight = clockOf(block).weight;
        if (weight > 0) {
            advance(u, v, weight, 3 * layout.start(block), 3 * layout.end(block));
        }
        double[] gamma = system.viscosities();
        addProducts(gamma, u, force, layout.start(block), layout.end(block));
        for (int k = relievedStart[block]; k < relievedStart[block + 1]; k++) {
            int n = relieved[k];
            double g = relief * gamma[n];
            force[3 * n] -= g * groupMean[0];
            force[3 * n + 1] -= g * groupMean[1];
            force[3 * n + 2] -= g * groupMean[2];
        }
    }
}
