package org.phrenic.simulation;

import java.util.Arrays;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.force.SlowMotionRelease;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.model.assembly.Scene;
import org.phrenic.scenario.Scenario;

/**
 * Settles a new scene at end-expiration under strong damping. The shape that it reaches is the rest shape. A settled
 * shape can be kept in a cache: with it the scene continues bit for bit as the scene that settled.
 */
final class Settling {
    /** Time that removes the residual of the prestress. */
    private static final double SETTLE_S = 0.5;

    /** Settling time of a diaphragm of more than usual size, whose modes are slower. */
    private static final double LARGE_SETTLE_S = 2;

    /** Steps of the paper's scene, which is in equilibrium from the start. They verify this. */
    private static final long MIN_STEPS = 300;

    /**
     * Damping rate, 1/s. Of 2.5 to 20 1/s it leaves the least creep in later breaths, because the softest folds are
     * then about critically damped.
     */
    private static final double DAMPING = 6;

    private static final int STEPS_BETWEEN_TELLINGS = 100;

    private static final String SHAPE = "settled shape";

    private final Scenario scenario;
    private final Scene scene;
    private final StabilityLimit limit;
    private final SimulationRun.Progress progress;

    Settling(Scenario scenario, Scene scene, StabilityLimit limit, SimulationRun.Progress progress) {
        this.scenario = scenario;
        this.scene = scene;
        this.limit = limit;
        this.progress = progress;
    }

    /**
     * Settles the scene, or puts it into the settled shape that is known, which is then its rest shape.
     *
     * @return displacement, rms mm
     */
    double settled() {
        int numbers = rest().length;
        boolean known = scene.computed().has(SHAPE, numbers + 1);
        double[] shape = scene.computed().get(SHAPE, numbers + 1, () -> {
            double moved = settle();
            double[] all = Arrays.copyOf(rest(), numbers + 1);
            all[numbers] = moved;
            return all;
        });
        if (known) {
            System.arraycopy(shape, 0, rest(), 0, numbers);
            putAtRest();
        }
        return shape[numbers];
    }

    private double settle() {
        ParticleSystem system = scene.system();
        double[] viscosity = system.viscosities().clone();
        system.setViscosityPerMass(DAMPING);
        SlowMotionRelease.setActive(system, false);
        scene.drive().holdAtExpiration(true);
        Stepper stepper =
                new Stepper(IntegratorKind.VERLET.create(system), scenario.timeStepS(), StepPolicy.SUBSTEP, limit);
        stepper.nameNodes(node -> NodeNames.of(scene, node));
        double settleS = scene.diaphragm().relativeSize() > 1 ? LARGE_SETTLE_S : SETTLE_S;
        long steps = Math.max(MIN_STEPS, Math.round(settleS / scenario.timeStepS()));
        for (long i = 0; i < steps; i++) {
            stepper.step();
            if (i % STEPS_BETWEEN_TELLINGS == 0) {
                progress.settling(stepper.time(), steps * scenario.timeStepS());
            }
        }
        scene.drive().holdAtExpiration(false);
        SlowMotionRelease.setActive(system, true);
        System.arraycopy(viscosity, 0, system.viscosities(), 0, viscosity.length);
        double[] before = rest().clone();
        system.layout().toCaller(system.positions(), rest());
        putAtRest();
        double sum = 0;
        for (int i = 0; i < before.length; i++) {
            sum += (rest()[i] - before[i]) * (rest()[i] - before[i]);
        }
        return Math.sqrt(3 * sum / before.length);
    }

    private double[] rest() {
        return scene.restPositions();
    }

    /** Puts all nodes into the rest shape, without velocity or anything that remembers an earlier state. */
    private void putAtRest() {
        ParticleSystem system = scene.system();
        double[] rest = system.layout().toInternal(rest());
        System.arraycopy(rest, 0, system.positions(), 0, rest.length);
        Arrays.fill(system.velocities(), 0);
        system.invalidate();
        scene.liver().ifPresent(liver -> liver.settleUnder(rest()));
    }
}
