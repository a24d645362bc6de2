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
 * u = v after {@link #invalidate}. Where the translation of a group of nodes is lighter ({@link SelectiveMass}), the
 * force on the group is smaller in proportion. Evaluations with velocities other than the system's own get no force.
 */
public final class SlowMotionRelease implements ForceField {
    private static final double SAME_TIME_S = 1e-9;

    private final ParticleSystem system;
    private final NodeLayout layout;
    private final double timeS;
    private final double[] velocities;
    private final double[] u;
    /** Nodes of the group whose translation is lighter, block by block. */
    private final int[] relieved;

    private final int[] relievedStart;
    /** Share of the group's mean velocity that is taken off. */
    private final double relief;

    private final double[] groupMean = new double[3];
    private final double[] groupVelocity = new double[3];
    private double now = Double.NaN;
    private boolean active = true;
    /** Weight of v in the next u; 1 sets u to v, 0 keeps it. */
    private double weight;

    /**
     * @param system its viscosities are read at every evaluation
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
        relieved = system.selectiveMass().map(SelectiveMass::nodes).orElse(new int[0]);
        relief = system.selectiveMass().map(SelectiveMass::relief).orElse(0.0);
        relievedStart = new int[layout.blockCount() + 1];
        for (int node : relieved) {
            relievedStart[layout.blockOf(node) + 1]++;
        }
        Arrays.parallelPrefix(relievedStart, Integer::sum);
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
        now = Double.NaN;
    }

    @Override
    public void prepare(double time) {
        double passed = time - now;
        // Times that differ by rounding are one time; an earlier one means that a state was restored.
        weight = Math.abs(passed) < SAME_TIME_S ? 0 : passed > 0 ? -StrictMath.expm1(-passed / timeS) : 1;
        now = weight == 0 ? now : time;
        Optional<SelectiveMass> group = system.selectiveMass();
        if (weight > 0 && group.isPresent()) {
            group.get().mean(velocities, groupVelocity);
            advance(groupMean, groupVelocity, 0, groupMean.length);
        }
    }

    /** Advances means; with weight 1 they are v to the last bit, whatever they were, so a restored state forgets. */
    private void advance(double[] mean, double[] v, int from, int end) {
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
        if (weight > 0) {
            advance(u, v, 3 * layout.start(block), 3 * layout.end(block));
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
