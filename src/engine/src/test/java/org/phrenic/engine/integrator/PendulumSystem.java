package org.phrenic.engine.integrator;

import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.SampleSystems;
import org.phrenic.engine.constraint.RigidLinks;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.engine.parallel.Workers;

/** A mass of 0.1 kg on a rigid link of 100 mm that hangs from a held node in gravity, let go at 1 rad. */
final class PendulumSystem {
    static final double LENGTH = 100;
    static final double GRAVITY = 9810;
    static final double MASS = 0.1;
    static final double START = 1;

    private PendulumSystem() {}

    static ParticleSystem create() {
        double[] x = {0, 0, 0, LENGTH * Math.sin(START), 0, -LENGTH * Math.cos(START)};
        ParticleSystem system =
                new ParticleSystem(NodeLayout.natural(2), x, SampleSystems.masses(2, MASS), Workers.of(1));
        system.fix(0);
        system.add(new ConstantLoad(system.layout(), new double[] {0, 0, 0, 0, 0, -MASS * GRAVITY}));
        system.add(RigidLinks.gaussSeidel(system.layout(), new int[] {0}, new int[] {1}, x, 1e-12, 1));
        return system;
    }

    /** Error of the angle after 0.3 s in n steps, against θ̈ = -g/l sin θ solved with 30,000 steps of leapfrog; rad. */
    static double angleError(IntegratorKind kind, int n) {
        ParticleSystem system = create();
        IntegratorContract.run(kind.create(system), 0.3, n);
        double angle = START;
        double rate = 0;
        double h = 1e-5;
        for (int i = 0; i < 30_000; i++) {
            rate -= h / 2 * GRAVITY / LENGTH * Math.sin(angle);
            angle += h * rate;
            rate -= h / 2 * GRAVITY / LENGTH * Math.sin(angle);
        }
        return Math.abs(Math.atan2(system.positions()[3], -system.positions()[5]) - angle);
    }

    /** Energy above the lowest point, µJ. */
    static double energy(ParticleSystem system) {
        return system.kineticEnergy() + MASS * GRAVITY * (LENGTH + system.positions()[5]);
    }
}
