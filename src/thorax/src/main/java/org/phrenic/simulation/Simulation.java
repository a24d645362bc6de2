package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.Hashes;
import org.phrenic.model.assembly.BreathDrive;
import org.phrenic.model.assembly.LiveBreathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.material.SceneAssembly;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.model.organ.SternumModel;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValues;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/**
 * A thorax that breathes: a scenario and a body put together, settled at end-expiration, and stepped. Positions are
 * those of all nodes that springs move, in the order diaphragm, sternum and cartilages, lungs.
 */
public final class Simulation implements AutoCloseable {
    /** What the prestress leaves open settles in this time under strong damping; then the shape is the rest shape. */
    private static final double SETTLE_S = 0.5;

    /**
     * The paper's scene is at rest as it stands; these few steps show it, and that the machine has made the code fast
     * before the clock of a run starts.
     */
    private static final long FEWEST_STEPS = 300;

    /**
     * Of 2.5 to 20 1/s the one that leaves least to creep in later breaths: the softest folds are then about critically
     * damped.
     */
    private static final double SETTLE_DAMPING = 6;

    private final Scene scene;
    private final Stepper stepper;
    private final Workers workers;
    private final double settlingDisplacementMm;
    private final StabilityLimit firstLimit;
    private List<ScheduledChange> scheduled;
    private Scenario start;
    private LiveTuning tuning;
    private int nextScheduled;

    private Simulation(
            Scenario scenario,
            Scene scene,
            Stepper stepper,
            Workers workers,
            StabilityLimit firstLimit,
            double settledBy) {
        this.scene = scene;
        this.stepper = stepper;
        this.workers = workers;
        this.firstLimit = firstLimit;
        this.settlingDisplacementMm = settledBy;
        scheduled = scenario.changes();
        start = scenario.withChanges(List.of());
        scene.tuning().settled();
        tuning = new LiveTuning(start, scene, stepper);
    }

    /**
     * Puts a simulation together.
     *
     * @param scenario what to simulate
     * @param thorax the body, already at hand
     */
    public static Simulation of(Scenario scenario, Thorax thorax) {
        BreathDrive drive = new BreathDrive(new LiveBreathing(scenario));
        RibCage cage = RibCage.of(
                thorax,
                RibAxisTable.preset(RibAxisTable.WILSON_CT),
                scenario.get(OrganSettings.STERNUM) != SternumModel.OFF);
        Workers workers = Workers.of(scenario.threads());
        try {
            Scene scene = SceneAssembly.assemble(scenario, thorax, new RampedValues(scenario), drive, cage, workers);
            StabilityLimit limit = StabilityLimit.of(scene.system());
            double moved = settle(scenario, scene, limit);
            Stepper stepper = new Stepper(
                    scenario.integrator().create(scene.system()),
                    scenario.timeStepS(),
                    scenario.get(Numerics.STEP_POLICY),
                    limit);
            if (Double.isFinite(scenario.material().maxDisplacementMm())) {
                stepper.boundDisplacement(scenario.material().maxDisplacementMm());
            }
            return new Simulation(scenario, scene, stepper, workers, limit, moved);
        } catch (RuntimeException e) {
            workers.close();
            throw e;
        }
    }

    /**
     * Lets the scene come to rest at end-expiration and takes that as its rest shape; returns how far it went, rms mm.
     */
    private static double settle(Scenario scenario, Scene scene, StabilityLimit limit) {
        ParticleSystem system = scene.system();
        double[] viscosity = system.viscosities().clone();
        system.setViscosityPerMass(SETTLE_DAMPING);
        scene.drive().holdAtExpiration(true);
        Stepper stepper =
                new Stepper(IntegratorKind.VERLET.create(system), scenario.timeStepS(), StepPolicy.SUBSTEP, limit);
        long steps = Math.max(FEWEST_STEPS, Math.round(SETTLE_S / scenario.timeStepS()));
        for (long i = 0; i < steps; i++) {
            stepper.step();
        }
        scene.drive().holdAtExpiration(false);
        System.arraycopy(viscosity, 0, system.viscosities(), 0, viscosity.length);
        Arrays.fill(system.velocities(), 0);
        double[] before = scene.restPositions().clone();
        system.layout().toCaller(system.positions(), scene.restPositions());
        double sum = 0;
        for (int i = 0; i < before.length; i++) {
            sum += (scene.restPositions()[i] - before[i]) * (scene.restPositions()[i] - before[i]);
        }
        return Math.sqrt(3 * sum / before.length);
    }

    /** Carries the thorax over one time step, after the changes that the scenario has for this step. */
    public void step() {
        if (nextScheduled < scheduled.size()) {
            makeScheduled();
        }
        tuning.beforeStep();
        stepper.step();
    }

    private void makeScheduled() {
        List<Assignment> now = new ArrayList<>();
        while (nextScheduled < scheduled.size() && scheduled.get(nextScheduled).step() <= steps()) {
            now.add(scheduled.get(nextScheduled++).assignment());
        }
        if (!now.isEmpty()) {
            tuning.apply(now);
        }
    }

    /**
     * Makes a live change now, with a ramp of 0.2 s where it is a number, and logs it.
     *
     * @throws org.phrenic.file.BadInputException with one sentence, if the key is none or not live, or the value cannot
     *     be; nothing has changed then
     * @throws IllegalArgumentException with one sentence, if no time step is stable after it, or the one set is
     *     refused; nothing has changed then
     */
    public void change(Assignment assignment) {
        change(List.of(assignment));
    }

    /** Makes several live changes at once; parameters and exceptions as for one. */
    public void change(List<Assignment> assignments) {
        tuning.apply(assignments);
    }

    /** What was changed since the start, in order. */
    public List<ScheduledChange> changes() {
        return tuning.log();
    }

    /** What is set now. */
    public Scenario settings() {
        return tuning.settings();
    }

    /** Hash over the bits of positions, then velocities, in the caller's order: {@code state_sha256} of a run. */
    public String stateHash() {
        double[] x = new double[scene.restPositions().length];
        double[] v = new double[scene.restPositions().length];
        system().layout().toCaller(system().positions(), x);
        system().layout().toCaller(system().velocities(), v);
        return Hashes.sha256(x, v);
    }

    /** Simulated time that all of the scenario takes, s. */
    public double durationS() {
        return settings().steps() >= 0
                ? settings().steps() * stepper.dt()
                : settings().durationS(scene.drive().pattern());
    }

    /** Seconds after which the breathing repeats itself; infinite if it does not. */
    public double breathPeriodS() {
        return scene.drive().pattern().periodS();
    }

    /**
     * How long it takes to see all of the breathing, s: a period, or what is simulated of a breathing that has none.
     */
    public double breathDurationS() {
        return Double.isInfinite(breathPeriodS()) ? durationS() : breathPeriodS();
    }

    /** Simulated time, s. */
    public double time() {
        return stepper.time();
    }

    public Stepper stepper() {
        return stepper;
    }

    public ParticleSystem system() {
        return scene.system();
    }

    /** How far the given shape moved until it was in equilibrium, rms mm. */
    public double settlingDisplacementMm() {
        return settlingDisplacementMm;
    }

    /** Steps since the start. */
    public long steps() {
        return stepper.steps();
    }

    /**
     * Back to the start with what is set now, at once; the bits that follow are those of a scene that was put together
     * with it. False, and nothing done, if what was changed since asks for another assembly or the scenario has changes
     * of its own.
     */
    public boolean restart() {
        if (!scheduled.isEmpty() || !tuning.isAsAssembled()) {
            return false;
        }
        start = tuning.settings();
        restartFrom();
        return true;
    }

    /**
     * Back to the start as it was put together, to breathe with other changes; the bits that follow are those of a new
     * simulation of its scenario with them. Costs no assembly, and so serves who asks for many breaths of one scene.
     *
     * @param changes in the order of their steps, instead of those of the scenario and those made since
     * @throws IllegalArgumentException if one of them, or one made since, changes anything but {@link Parameter}s and
     *     {@code hold}
     */
    public void rerun(List<ScheduledChange> changes) {
        LiveTuning.requireParameters(tuning.log());
        LiveTuning.requireParameters(changes);
        scheduled = start.withChanges(changes).changes();
        nextScheduled = 0;
        restartFrom();
    }

    private void restartFrom() {
        // The cage keeps the pose of the last time it was asked for: none that comes again.
        scene.pose().update(-1);
        scene.tuning().restart(start, system());
        scene.drive().restart(new LiveBreathing(start));
        System.arraycopy(
                system().layout().toInternal(scene.restPositions()),
                0,
                system().positions(),
                0,
                scene.restPositions().length);
        Arrays.fill(system().velocities(), 0);
        system().invalidate();
        stepper.restart(start.integrator().create(system()), firstLimit);
        tuning = new LiveTuning(start, scene, stepper);
    }

    /**
     * Takes back the changes made at the last step that has any, by changes that are made now: after a divergence, from
     * the state that was restored. Where that was done already and the scene diverged again, those of the step before
     * too.
     *
     * @return whether there was anything to take back
     */
    public boolean undoLastChange() {
        List<Assignment> back = tuning.undoAssignments();
        if (back.isEmpty()) {
            return false;
        }
        tuning.apply(back);
        return true;
    }

    /** The scenario of the start, without changes. */
    public Scenario start() {
        return start;
    }

    /** How many springs there are. */
    public int springCount() {
        return scene.springCount();
    }

    /** Largest relative length error of the rigid links that are switched on; 0 where there are none. */
    public double linkError() {
        return scene.activeLinks().map(links -> links.error(system())).orElse(0.0);
    }

    /** What the breath is doing. */
    public RespiratoryPhase breathLabel() {
        return scene.drive().breathAt(time()).respiratoryPhase;
    }

    /** The step as the stability limit has it: empty if it is within, else a sentence. */
    public String stabilityMessage() {
        return substepReason().map(SubstepReason::message).orElse("");
    }

    /** Why steps are split into substeps; empty if they are not. */
    public Optional<SubstepReason> substepReason() {
        return stepper.substeps() == 1 ? Optional.empty() : Optional.of(SubstepReason.of(stepper));
    }

    public Scene scene() {
        return scene;
    }

    /** Ends the worker threads. */
    @Override
    public void close() {
        workers.close();
    }
}
