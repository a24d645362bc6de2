package org.phrenic.engine.integrator;

import java.util.Locale;
import java.util.Optional;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.parallel.NodeLayout;

/**
 * The largest time step for which a scheme is stable on an assembled system.
 *
 * <p>The highest frequency of M⁻¹K at the current state ({@link HighestFrequency}) is raised by 3 % and bounded by
 * Gershgorin's estimate ω² ≤ max Σ|K_ij| / m_i. The limit is the largest h at which no oscillator grows, for ω from 0
 * to ω_max and the least viscosity γ/m of the system: the spectral radius of the scheme's amplification matrix is at
 * most 1. For example, the paper's parameters with midpoint Runge-Kutta are unstable at the published step, although h
 * &lt; 2/ω_max.
 *
 * @param omegaMax highest angular frequency, 1/s
 * @param omegaBound Gershgorin's bound of it, 1/s
 * @param minDamping least γ/m of any free node, 1/s
 * @param maxDamping largest sum of γ/m and dashpot row sum over mass of any free node, 1/s
 * @param maxDashpot largest dashpot row sum over mass of any free node, 1/s; schemes with implicit viscosity treat
 *     dashpots explicitly
 * @param contacts whether the system has contact constraints. Backward Euler solves for the motion under forces alone
 *     and contacts are projected afterwards, which at long steps gives a different equilibrium. With contacts its step
 *     is limited to ω h ≤ 3 (on the thorax an error of 1 % of a quiet breath's excursion)
 * @param apart limit of the nodes apart, on which schemes that cannot step them apart depend as well; empty if there
 *     are none
 */
public record StabilityLimit(
        double omegaMax,
        double omegaBound,
        double minDamping,
        double maxDamping,
        double maxDashpot,
        boolean contacts,
        Optional<StabilityLimit> apart) {
    /** Largest ω h of backward Euler with contacts. */
    private static final double LEANING = 3;

    /** Factor on {@link HighestFrequency}, which is a lower bound; its error on the measured meshes is under 1 %. */
    private static final double MARGIN = 1.03;

    private static final int FREQUENCIES = 64;
    /** Tolerance of the spectral radius for rounding. */
    private static final double ROUNDING = 1e-9;
    /**
     * Value of ω h for testing whether a scheme grows without damping at every step; far below the limit of schemes
     * that do not.
     */
    private static final double TELLING = 0.02;
    /** Value of ω h below any practical step. */
    private static final double SHORT = 1e-6;
    /** Value of ω h at which a scheme that has a limit grows. */
    private static final double FAR = 1e6;

    /** A limit without nodes apart. */
    public StabilityLimit(
            double omegaMax,
            double omegaBound,
            double minDamping,
            double maxDamping,
            double maxDashpot,
            boolean contacts) {
        this(omegaMax, omegaBound, minDamping, maxDamping, maxDashpot, contacts, Optional.empty());
    }

    /** Computes the limit of a system at its current state. */
    public static StabilityLimit of(ParticleSystem system) {
        NodeLayout layout = system.layout();
        int n = system.nodeCount();
        double[] stiffness = new double[n];
        double[] damping = new double[n];
        system.addRowSums(stiffness, damping);
        if (!layout.hasNodesApart()) {
            return of(system, 0, n, stiffness, damping, Optional.empty());
        }
        int firstApart = layout.start(layout.firstBlockApart());
        StabilityLimit apart = of(system, firstApart, n, stiffness, damping, Optional.empty());
        return of(system, 0, firstApart, stiffness, damping, Optional.of(apart));
    }

    private static StabilityLimit of(
            ParticleSystem system,
            int first,
            int end,
            double[] stiffness,
            double[] damping,
            Optional<StabilityLimit> apart) {
        double bound = 0;
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        double dashpot = 0;
        for (int i = first; i < end; i++) {
            double w = system.inverseMasses()[i];
            if (w > 0) {
                bound = Math.max(bound, w * stiffness[i]);
                least = Math.min(least, w * system.viscosities()[i]);
                most = Math.max(most, w * (system.viscosities()[i] + damping[i]));
                dashpot = Math.max(dashpot, w * damping[i]);
            }
        }
        double lighter = first > 0
                ? 0
                : system.selectiveMass()
                        .map(group -> group.addedOmegaSquared(system))
                        .orElse(0.0);
        double root = Math.sqrt(bound + lighter);
        double highest = MARGIN * Math.sqrt(HighestFrequency.omegaSquared(system, first, end));
        // The comparison is also false if the highest frequency is NaN.
        double omega = highest <= root ? highest : root;
        double damped = least == Double.POSITIVE_INFINITY ? 0 : least;
        return new StabilityLimit(omega, root, damped, most, dashpot, system.hasContacts(), apart);
    }

    /**
     * Largest stable step of a scheme on this system, s; 0 if no step is stable, infinite if every step is. A scheme
     * that steps nodes apart is not limited by them.
     */
    public double largestStep(IntegratorKind kind) {
        return apart.isEmpty() || kind.stepsNodesApart()
                ? largestStepHere(kind)
                : Math.min(largestStepHere(kind), apart.get().largestStep(kind));
    }

    private double largestStepHere(IntegratorKind kind) {
        double top = Math.max(omegaMax, maxDamping);
        if (top == 0 || isStable(kind, FAR / top)) {
            return Double.POSITIVE_INFINITY;
        }
        boolean undamped = minDamping == 0 && maxDashpot == 0;
        double low = SHORT / top;
        if ((undamped && grows(kind, omegaMax, 0, 0, TELLING / omegaMax)) || !isStable(kind, low)) {
            return 0;
        }
        if (!isStable(kind, FAR / top, FREQUENCIES)) {
            double ofHighest = limit(kind, low, FREQUENCIES);
            if (isStable(kind, ofHighest)) {
                return ofHighest;
            }
        }
        return limit(kind, low, 0);
    }

    /**
     * The largest step at which no frequency from the {@code first} of {@value #FREQUENCIES} on grows, by bisection.
     * The highest one limits the step as a rule. Each frequency is stable up to a step of its own, so a limit of the
     * highest one that suits the lower ones is the limit of all, bit for bit.
     */
    private double limit(IntegratorKind kind, double stable, int first) {
        double low = stable;
        double high = low;
        while (isStable(kind, high, first)) {
            low = high;
            high *= 1.5;
        }
        for (int i = 0; i < 40; i++) {
            double middle = 0.5 * (low + high);
            if (isStable(kind, middle, first)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Whether no oscillator of this system grows under the scheme with this step. */
    public boolean isStable(IntegratorKind kind, double h) {
        return isStable(kind, h, 0);
    }

    private boolean isStable(IntegratorKind kind, double h, int first) {
        if (apart.isPresent() && !kind.stepsNodesApart() && !apart.get().isStable(kind, h, first)) {
            return false;
        }
        if (contacts && kind == IntegratorKind.BACKWARD_EULER && !(omegaMax * h <= LEANING)) {
            return false;
        }
        for (int i = FREQUENCIES; i >= first; i--) {
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
     * Number of equal substeps into which a step must be split to be stable.
     *
     * @param safety fraction of the largest stable step that may be used, such as 0.9
     * @throws IllegalArgumentException if no step is stable; the message gives the reason
     */
    public int substeps(IntegratorKind kind, double dt, double safety) {
        double limit = largestStep(kind);
        if (limit == 0) {
            String pattern =
                    "integrator %s grows at every step on this system (highest frequency %.4g 1/s, least damping %.4g"
                            + " 1/s): add damping or choose verlet";
            throw new IllegalArgumentException(String.format(Locale.ROOT, pattern, kind.label(), omegaMax, minDamping));
        }
        return isStable(kind, dt) && dt <= limit * safety ? 1 : (int) Math.ceil(dt / (limit * safety));
    }

    /**
     * Number of equal steps that nodes apart make in a step of the others; 1 for schemes that cannot.
     *
     * @param safety as for {@link #substeps}
     */
    public int stepsApart(IntegratorKind kind, double h, double safety) {
        return apart.isEmpty() || !kind.stepsNodesApart() ? 1 : apart.get().substeps(kind, h, safety);
    }

    /** One sentence that states the step and the limit. */
    public String describe(IntegratorKind kind, double dt) {
        String pattern =
                "time step %.6g s is %s the stability limit %.6g s of %s for this scene (highest frequency %.4g"
                        + " 1/s, Gershgorin bound %.4g 1/s)";
        String where = dt > largestStep(kind) ? "beyond" : "too near to";
        return String.format(Locale.ROOT, pattern, dt, where, largestStep(kind), kind.label(), omegaMax, omegaBound);
    }
}
