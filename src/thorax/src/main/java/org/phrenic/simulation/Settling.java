package org.phrenic.simulation;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.force.SlowMotionRelease;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.file.Hashes;
import org.phrenic.file.UserCache;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.RunSettings;
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

    private static final String KIND = "settled";

    private final Scenario scenario;
    private final Scene scene;
    private final StabilityLimit limit;

    Settling(Scenario scenario, Scene scene, StabilityLimit limit) {
        this.scenario = scenario;
        this.scene = scene;
        this.limit = limit;
    }

    /**
     * Settles the scene, or puts it into the shape that the cache knows, which is then its rest shape.
     *
     * @return displacement, rms mm
     */
    double settle(UserCache cache) {
        if (cache.isOff()) {
            return settle();
        }
        String key = key();
        Optional<ByteBuffer> known =
                cache.read(KIND, key).filter(shape -> shape.remaining() == Double.BYTES * (1 + rest().length));
        if (known.isPresent()) {
            double moved = known.get().getDouble();
            known.get().asDoubleBuffer().get(rest());
            putAtRest();
            return moved;
        }
        double moved = settle();
        ByteBuffer shape =
                ByteBuffer.allocate(Double.BYTES * (1 + rest().length)).order(ByteOrder.LITTLE_ENDIAN);
        shape.putDouble(moved).asDoubleBuffer().put(rest());
        cache.write(KIND, key, shape.rewind());
        return moved;
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
    }

    /**
     * Everything that decides the settled shape: the body and all settings but those of the run's length and output.
     */
    private String key() {
        Map<String, Object> settings = scenario.toMap();
        for (var setting : List.of(
                RunSettings.NAME,
                RunSettings.ANATOMY,
                RunSettings.DURATION,
                RunSettings.STEPS,
                RunSettings.RECORD_EVERY,
                RunSettings.MESHES_EVERY,
                RunSettings.CHANGES,
                Numerics.THREADS)) {
            settings.remove(setting.key());
        }
        String trace = scenario.trace().map(Hashes::sha256).orElse("");
        return body() + "\n" + settings + "\n" + trace;
    }

    /** A virtual body by its name, another by its content. */
    private String body() {
        Thorax thorax = scene.thorax();
        if (scenario.isVirtual() && thorax == SimulationRun.loadThorax(scenario)) {
            return scenario.anatomy() + " " + OrganSettings.budget(scenario).vertices();
        }
        StringBuilder text = new StringBuilder();
        for (Structure s : thorax.structures()) {
            text.append(s.name())
                    .append(' ')
                    .append(s.kind())
                    .append(' ')
                    .append(s.level())
                    .append(' ');
            text.append(s.side())
                    .append(' ')
                    .append(Hashes.sha256(s.mesh().positions()))
                    .append(' ');
            text.append(Hashes.sha256(s.mesh().triangles())).append('\n');
        }
        return text.append(thorax.notInScan().stream().sorted().toList()).toString();
    }
}
