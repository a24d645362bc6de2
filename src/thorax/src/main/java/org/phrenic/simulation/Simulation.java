package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.anatomy.cage.RibAxisTable;
import org.phrenic.anatomy.cage.RibCage;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.ComputedArrays;
import org.phrenic.file.Hashes;
import org.phrenic.file.UserCache;
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
 * A simulation of a breathing thorax: assembled from a scenario and a body, settled at end-expiration, then stepped.
 * Positions include all nodes with springs, in the order diaphragm, sternum and cartilages, lungs.
 */
public final class Simulation implements AutoCloseable {
    private final Scene scene;
    private final Stepper stepper;
    private final Workers workers;
    private final double settlingDisplacementMm;
    private final StabilityLimit firstLimit;
    private List<ScheduledChange> scheduled;
    private Scenario start;
    private LiveTuning tuning;
    private BreathRepetition repetition;
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
        repetition = new BreathRepetition(start, scene, stepper);
    }

    /**
     * Assembles a simulation.
     *
     * @param scenario what to simulate
     * @param thorax the loaded body
     */
    public static Simulation of(Scenario scenario, Thorax thorax) {
        return of(scenario, thorax, UserCache.off());
    }

    /**
     * Assembles a simulation. What takes long to compute (fibres, tensions at rest, stability limit, settled shape) is
     * read from a cache or kept there; the results are the same bit for bit.
     */
    public static Simulation of(Scenario scenario, Thorax thorax, UserCache cache) {
        return of(scenario, thorax, cache, (at, total, perS) -> {});
    }

    /**
     * Assembles a simulation as {@link #of(Scenario, Thorax, UserCache)} does.
     *
     * @param progress told how far the scene has settled
     */
    public static Simulation of(Scenario scenario, Thorax thorax, UserCache cache, SimulationRun.Progress progress) {
        SceneAssembly.requireBreathing(thorax);
        BreathDrive drive = new BreathDrive(new LiveBreathing(scenario));
        RibCage cage = RibCage.of(
                thorax,
                RibAxisTable.preset(RibAxisTable.WILSON_CT),
                scenario.get(OrganSettings.STERNUM) != SternumModel.OFF);
        ComputedArrays computed = SceneKey.arrays(cache, scenario, thorax);
        Workers workers = Workers.of(scenario.threads());
        // Threads that wait for work take processor time from the assembly.
        workers.useCallerOnly(true);
        try {
            Scene scene = SceneAssembly.assemble(
                    scenario, thorax, new RampedValues(scenario), drive, cage, workers, computed);
            workers.useCallerOnly(false);
            StabilityLimit limit = StoredLimit.of(scene.system(), computed);
            double moved = new Settling(scenario, scene, limit, progress).settled();
            computed.keep();
            Stepper stepper = new Stepper(
                    scenario.integrator().create(scene.system()),
                    scenario.timeStepS(),
                    scenario.get(Numerics.STEP_POLICY),
                    limit);
            if (Double.isFinite(scenario.material().maxDisplacementMm())) {
                stepper.boundDisplacement(scenario.material().maxDisplacementMm());
            }
            ChestBox.confineLungs(scene, stepper);
            stepper.nameNodes(node -> NodeNames.of(scene, node));
            return new Simulation(scenario, scene, stepper, workers, limit, moved);
        } catch (RuntimeException | Error e) {
            workers.close();
            throw e;
        }
    }

    /**
     * Applies the changes that the scenario schedules for this step, then advances by one time step: by the record of a
     * breath where {@link BreathRepetition} has one to repeat, else by the equations of motion.
     */
    public void step() {
        if (nextScheduled < scheduled.size()) {
            makeScheduled();
        }
        if (!repetition.step()) {
            tuning.step();
            repetition.stepped();
        }
    }

    /** Number of steps since the start that repeated the record of a breath. */
    public long repeatedSteps() {
        return repetition.repeatedSteps();
    }

    /** Whether steps repeat the record of a breath. */
    public boolean isRepeating() {
        return repetition.isRepeating();
    }

    private void makeScheduled() {
        List<Assignment> now = new ArrayList<>();
        while (nextScheduled < scheduled.size() && scheduled.get(nextScheduled).step() <= steps()) {
            now.add(scheduled.get(nextScheduled++).assignment());
        }
        if (!now.isEmpty()) {
            change(now);
        }
    }

    /**
     * Applies and logs a live change. A number ramps over 0.2 s.
     *
     * @throws org.phrenic.file.BadInputException with one sentence, if the key is unknown or not live, or the value is
     *     invalid; then nothing has changed
     * @throws IllegalArgumentException with one sentence, if no time step is stable after it, or the given one is
     *     refused; then nothing has changed
     */
    public void change(Assignment assignment) {
        change(List.of(assignment));
    }

    /** Applies several live changes at once; exceptions as for {@link #change(Assignment)}. */
    public void change(List<Assignment> assignments) {
        tuning.apply(assignments);
        repetition.changed(tuning.settings(), assignments);
    }

    /** Changes made since the start, in order. */
    public List<ScheduledChange> changes() {
        return tuning.log();
    }

    /** Current settings. */
    public Scenario settings() {
        return tuning.settings();
    }

    /** Hash of the bits of positions, then velocities, in the caller's order: {@code state_sha256} of a run. */
    public String stateHash() {
        double[] x = new double[scene.restPositions().length];
        double[] v = new double[scene.restPositions().length];
        system().layout().toCaller(system().positions(), x);
        system().layout().toCaller(system().velocities(), v);
        return Hashes.sha256(x, v);
    }

    /** Total simulated time of the scenario, s. */
    public double durationS() {
        return settings().steps() >= 0
                ? stepTimes().lastS()
                : settings().durationS(scene.drive().pattern());
    }

    /** When the steps of the scenario are made, with the changes made and those to come. */
    public StepTimes stepTimes() {
        double totalS = settings().durationS(scene.drive().pattern());
        List<ScheduledChange> coming = scheduled.subList(nextScheduled, scheduled.size());
        return new StepTimes(start, totalS).with(changes()).with(coming);
    }

    /** Period of the breathing pattern, s; infinite if it is not periodic. */
    public double breathPeriodS() {
        return scene.drive().pattern().periodS();
    }

    /** Period of the breathing pattern that was set last, or the duration with one that is not periodic, s. */
    public double breathDurationS() {
        double periodS = scene.drive().pattern().patternPeriodS();
        return Double.isInfinite(periodS) ? durationS() : periodS;
    }

    /** Simulated time, s. */
    public double time() {
        return stepper.time();
    }

    /** Present time step, s. */
    public double timeStepS() {
        return stepper.dt();
    }

    public Stepper stepper() {
        return stepper;
    }

    public ParticleSystem system() {
        return scene.system();
    }

    /** Displacement of the input shape during settling, rms mm. */
    public double settlingDisplacementMm() {
        return settlingDisplacementMm;
    }

    /** Number of steps since the start. */
    public long steps() {
        return stepper.steps();
    }

    /**
     * Restarts at time 0 with the current settings, without assembly. The results equal bit for bit those of a new
     * simulation with these settings. Returns false and does nothing if the changes since the start require another
     * assembly or the scenario schedules changes.
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
     * Restarts at time 0 with the initial settings and other scheduled changes, without assembly. The results equal bit
     * for bit those of a new simulation of the scenario with these changes. Use it to simulate many breaths of one
     * scene.
     *
     * @param changes in the order of their steps; they replace those of the scenario and those made since the start
     * @throws IllegalArgumentException if one of them, or one made since the start, changes anything except
     *     {@link Parameter}s and {@code hold}
     */
    public void rerun(List<ScheduledChange> changes) {
        LiveTuning.requireParameters(tuning.log());
        LiveTuning.requireParameters(changes);
        scheduled = start.withChanges(changes).changes();
        nextScheduled = 0;
        restartFrom();
    }

    private void restartFrom() {
        scene.pose().invalidate();
        scene.wall().ifPresent(MovingChestWall::invalidate);
        scene.tuning().restart(start, system());
        scene.drive().restart(new LiveBreathing(start));
        double[] rest = system().layout().toInternal(scene.restPositions());
        System.arraycopy(rest, 0, system().positions(), 0, rest.length);
        Arrays.fill(system().velocities(), 0);
        system().invalidate();
        stepper.restart(start.integrator().create(system()), firstLimit);
        tuning = new LiveTuning(start, scene, stepper);
        repetition = new BreathRepetition(start, scene, stepper);
    }

    /**
     * Undoes the changes of the last step that has any, by new changes at the current step; used after a divergence,
     * when the last valid state has been restored. If the scene diverges again after an undo, the changes of the step
     * before are undone too.
     *
     * @return whether there was anything to undo
     */
    public boolean undoLastChange() {
        List<Assignment> back = tuning.undoAssignments();
        if (!back.isEmpty()) {
            change(back);
        }
        return !back.isEmpty();
    }

    /** To be called where steps follow a divergence: a run that repeats {@link #changes} then goes the same way. */
    public void goOn() {
        tuning.goingOn().forEach(this::change);
    }

    /** The initial scenario, without changes. */
    public Scenario start() {
        return start;
    }

    /** Largest relative length error of the active rigid links; 0 if there are none. */
    public double linkError() {
        return scene.activeLinks().map(links -> links.error(system())).orElse(0.0);
    }

    /** Current respiratory phase. */
    public RespiratoryPhase breathLabel() {
        return scene.drive().breathAt(time()).respiratoryPhase;
    }

    /** Sentence on a step beyond the stability limit; empty if the step is within it. */
    public String stabilityMessage() {
        return substepReason().map(SubstepReason::message).orElse("");
    }

    /** Why steps are split into substeps; empty without substeps. */
    public Optional<SubstepReason> substepReason() {
        return stepper.substeps() * stepper.stepsApart() == 1
                ? Optional.empty()
                : Optional.of(SubstepReason.of(stepper));
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
