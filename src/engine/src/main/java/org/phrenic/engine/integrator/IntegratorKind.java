package org.phrenic.engine.integrator;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.phrenic.engine.ParticleSystem;

/** The integration schemes: their names on the command line, order, cost and amplification matrix. */
public enum IntegratorKind {
    /** Velocity Verlet with semi-implicit viscous damping. */
    VERLET("verlet", 2, 1),
    /** Störmer's formula with second differences: of third order for smooth motion, at the cost of velocity Verlet. */
    STORMER("stormer", 3, 1),
    /** Eq. 6 of Villard, Bourne and Bello 2009 read literally, with a lagged acceleration. */
    LAGGED("lagged", 1, 1),
    /** Midpoint Runge-Kutta. */
    RK2("rk2", 2, 2),
    /** Classical Runge-Kutta. */
    RK4("rk4", 4, 4),
    /** Symplectic Euler: velocity first, then position with the new velocity. */
    SYMPLECTIC_EULER("symplectic-euler", 1, 1),
    /** Backward Euler, one Newton step solved by conjugate gradients. */
    BACKWARD_EULER("backward-euler", 1, 1);

    private final String label;
    private final int order;
    private final int forceEvaluations;

    IntegratorKind(String label, int order, int forceEvaluations) {
        this.label = label;
        this.order = order;
        this.forceEvaluations = forceEvaluations;
    }

    /** Name in scenario files and on the command line. */
    public String label() {
        return label;
    }

    /** Order of convergence in h of positions and velocities. */
    public int order() {
        return order;
    }

    /**
     * Whether nodes apart from the others can make shorter steps. No force may act between the two, and neither
     * constraints nor prescribed motion on the nodes apart.
     */
    public boolean stepsNodesApart() {
        return this == RK2;
    }

    /** Force evaluations a step. */
    public int forceEvaluations() {
        return forceEvaluations;
    }

    /** @throws IllegalArgumentException if there is no scheme of this name; the message lists the valid names */
    public static IntegratorKind of(String name) {
        return Arrays.stream(values())
                .filter(kind -> kind.label.equals(name.toLowerCase(Locale.ROOT)))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("integrator: found '" + name + "', expected one of "
                        + Arrays.stream(values()).map(IntegratorKind::label).collect(Collectors.joining(", "))));
    }

    /** Creates an integrator of this kind for a system. */
    public Integrator create(ParticleSystem system) {
        return switch (this) {
            case VERLET -> new VelocityVerlet(system);
            case STORMER -> new Stormer(system);
            case LAGGED -> new LaggedAcceleration(system);
            case RK2 -> new MidpointRungeKutta(system);
            case RK4 -> new ClassicalRungeKutta(system);
            case SYMPLECTIC_EULER -> new SymplecticEuler(system);
            case BACKWARD_EULER -> new BackwardEuler(system);
        };
    }

    /**
     * The amplification matrix of one step for the oscillator ẍ = -ω² x - d ẋ with state (x, v h, ...), in the
     * dimensionless numbers a = (ω h)² and b = d h.
     */
    public double[][] amplification(double a, double b) {
        return switch (this) {
            case VERLET -> VelocityVerlet.amplification(a, b);
            case STORMER -> Stormer.amplification(a, b, 0);
            case LAGGED -> LaggedAcceleration.amplification(a, b);
            case RK2 -> MidpointRungeKutta.amplification(a, b);
            case RK4 -> ClassicalRungeKutta.amplification(a, b);
            case SYMPLECTIC_EULER -> SymplecticEuler.amplification(a, b);
            case BACKWARD_EULER -> BackwardEuler.amplification(a, b, 0);
        };
    }

    /**
     * As {@link #amplification(double, double)} with a dashpot beside the viscosity: ẍ = -ω² x - d ẋ - e ẋ, c = e h.
     * Verlet, Störmer's formula and backward Euler treat viscosity implicitly where they end a step, and dashpots
     * explicitly, so a strong dashpot limits their step. The other schemes treat both alike.
     */
    public double[][] amplification(double a, double b, double c) {
        if (c == 0) {
            return amplification(a, b);
        }
        return switch (this) {
            case VERLET -> VelocityVerlet.amplification(a, b, c);
            case STORMER -> Stormer.amplification(a, b, c);
            case BACKWARD_EULER -> BackwardEuler.amplification(a, b, c);
            default -> amplification(a, b + c);
        };
    }
}
