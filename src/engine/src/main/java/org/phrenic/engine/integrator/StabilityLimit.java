package org.phrenic.engine.integrator;

import java.util.Locale;
import org.phrenic.engine.ParticleSystem;

/**
 * The largest step that is stable for a scheme on an assembled system.
 *
 * <p>The highest frequency of M⁻¹K at the current state ({@link HighestFrequency}) is raised by 3 %, and held against
 * Gershgorin's bound ω² ≤ max Σ|K_ij| / m_i, which it may not pass. The step is then the largest h for which no
 * oscillator of the system, ω from 0 to ω_max with the least viscosity γ/m there is, grows: spectral radius of the
 * scheme's amplification matrix at most 1. So the paper's parameters with midpoint Runge-Kutta come out as unstable at
 * the published step, although 2/ω_max would allow it.
 *
 * @param omegaMax highest angular frequency, 1/s
 * @param omegaBound Gershgorin's bound of it, 1/s
 * @param minDamping least γ/m of any free node, 1/s
 * @param maxDamping most γ/m plus dashpot row sum over mass of any free node, 1/s
 * @param maxDashpot most dashpot row sum over mass of any free node, 1/s; schemes that take viscosity implicitly take
 *     dashpots explicitly
 * @param contacts whether nodes may lean on walls. Backward Euler solves for where forces alone would carry the nodes,
 *     and walls push back afterwards: at long steps that is another equilibrium, so that with walls its step is held to
 *     ω h ≤ 3 (on the thorax an error of 1 % of a quiet breath's excursion)
 */
public record StabilityLimit(
        double omegaMax, double omegaBound, double minDamping, double maxDamping, double maxDashpot, boolean contacts) {
    /** ω h that backward Euler may have where nodes lean on walls. */
    private static final double LEANING = 3;

    /** {@link HighestFrequency} comes from below: what it leaves out on the meshes measured is under 1 %. */
    private static final double MARGIN = 1.03;

    private static final int FREQUENCIES = 64;
    /** Growth that rounding alone explains. */
    private static final double ROUNDING = 1e-9;
    /**
     * ω h at which a scheme that always grows without damping shows it, and far below the limit of one that does not.
     */
    private static final double TELLING = 0.02;
    /** ω h of a step shorter than any that is used. */
    private static final double SHORT = 1e-6;

    /** Measures a system at its current state. */
    public static StabilityLimit of(ParticleSystem system) {
        int n = system.nodeCount();
        double[] stiffness = new double[n];
        double[] damping = new double[n];
        system.addRowSums(stiffness, damping);
        double bound = 0;
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        double dashpot = 0;
        for (int i = 0; i < n; i++) {
            double w = system.inverseMasses()[i];
            if (w > 0) {
                bound = Math.max(bound, w * stiffness[i]);
                least = Math.min(least, w * system.viscosities()[i]);
                most = Math.max(most, w * (system.viscosities()[i] + damping[i]));
                dashpot = Math.max(dashpot, w * damping[i]);
            }
        }
        double highest = MARGIN * Math.sqrt(HighestFrequency.omegaSquared(system));
        // Also where the state at hand gives no number.
        boolean usable = highest <= Math.sqrt(bound);
        return new StabilityLimit(
                usable ? highest : Math.sqrt(bound),
                Math.sqrt(bound),
                least == Double.POSITIVE_INFINITY ? 0 : least,
                most,
                dashpot,
                system.hasContacts());
    }

    /** Largest stable step of a scheme on this system, s; 0 if none is, infinite if every one is. */
    public double largestStep(IntegratorKind kind) {
        double top = Math.max(omegaMax, maxDamping);
        if (top == 0 || isStable(kind, 1e6 / top)) {
            return Double.POSITIVE_INFINITY;
        }
        boolean undamped = minDamping == 0 && maxDashpot == 0;
        double low = SHORT / top;
        if ((undamped && grows(kind, omegaMax, 0, 0, TELLING / omegaMax)) || !isStable(kind, low)) {
            return 0;
        }
        double high = low;
        while (isStable(kind, high)) {
            low = high;
            high *= 1.5;
        }
        for (int i = 0; i < 40; i++) {
            double middle = 0.5 * (low + high);
            if (isStable(kind, middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Whether no oscillator of this system grows under the scheme with this step. */
    public boolean isStable(IntegratorKind kind, double h) {
        if (contacts && kind == IntegratorKind.BACKWARD_EULER && !(omegaMax * h <= LEANING)) {
            return false;
        }
        for (int i = 0; i <= FREQUENCIES; i++) {
            double omega = omegaMax * i / FREQUENCIES;
            if (grows(kind, omega, minDamping, 0, h)
                    || grows(kind, omega, maxDamping - maxDashpot, maxDashpot, h)
                    || grows(kind, omega, minDamping, maxDashpot, h)) {
                return false;
            }
        }
        return true;
    }

    private static boolean grows(IntegratorKind kind, double omega, double viscous, double dashpot, double h) {
        double[][] matrix = kind.amplification(omega * h * omega * h, viscous * h, dashpot * h);
        return !(SpectralRadius.of(matrix) <= 1 + ROUNDING);
    }

    /**
     * Into how many equal parts a step must be split to be stable.
     *
     * @param safety share of the largest stable step that may be used, such as 0.9
     * @throws IllegalArgumentException if no step is stable; the sentence says why
     */
    public int substeps(IntegratorKind kind, double dt, double safety) {
        double limit = largestStep(kind);
        if (limit == 0) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "integrator %s grows at every step on this system (highest frequency %.4g 1/s, least damping %.4g"
                            + " 1/s): add damping or choose verlet",
                    kind.label(),
                    omegaMax,
                    minDamping));
        }
        return isStable(kind, dt) && dt <= limit * safety ? 1 : (int) Math.ceil(dt / (limit * safety));
    }

    /** One sentence that states the step and the limit. */
    public String describe(IntegratorKind kind, double dt) {
        return String.format(
                Locale.ROOT,
                "time step %.6g s is beyond the stability limit %.6g s of %s for this scene (highest frequency %.4g"
                        + " 1/s, Gershgorin bound %.4g 1/s)",
                dt,
                largestStep(kind),
                kind.label(),
                omegaMax,
                omegaBound);
    }
}
