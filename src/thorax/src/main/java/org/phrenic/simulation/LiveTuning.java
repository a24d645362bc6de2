package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.SceneTuning;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValues;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;

/**
 * Applies live changes to a scene and logs them. The effect of a change depends only on the state, the step and the
 * changes before it, so that equal changes at equal steps give equal bits. If a setting changes several times at one
 * step, the last value applies.
 *
 * <p>Numbers ramp over 0.2 s. While springs, masses or damping ramp, the number of substeps is that of the stricter end
 * of the ramp. After the ramp the stability limit is measured again.
 */
final class LiveTuning {
    private static final String UNDO = "undo";
    /** Changes of the same settings in shorter intervals are one, such as the drag of a slider, s. */
    private static final double SAME_DRAG_S = 1;

    private final Scenario start;
    private final Scene scene;
    private final SceneTuning tuning;
    private final RampedValues values;
    private final ParticleSystem system;
    private final Stepper stepper;
    private final List<ScheduledChange> log = new ArrayList<>();
    private Scenario settings;
    private Scenario settingsBefore;
    private boolean tissueRamps;
    private boolean sceneRamps;
    private long undoneTo;

    LiveTuning(Scenario scenario, Scene scene, Stepper stepper) {
        this.scene = scene;
        this.stepper = stepper;
        tuning = scene.tuning();
        values = tuning.values();
        system = scene.system();
        start = scenario;
        settings = scenario;
        settingsBefore = scenario;
    }

    Scenario settings() {
        return settings;
    }

    List<ScheduledChange> log() {
        return List.copyOf(log);
    }

    /** Applies changes between two steps; see {@link Simulation#change(List)}. */
    void apply(List<Assignment> assignments) {
        assignments.forEach(Assignment::requireLive);
        long step = stepper.steps();
        double now = stepper.time();
        Scenario before = lastChangedStep(Long.MAX_VALUE) == step ? settingsBefore : settings;
        Map<Setting<?>, Assignment> changes = new LinkedHashMap<>();
        log.stream().filter(c -> c.step() == step).forEach(c -> putLast(changes, c.assignment()));
        assignments.forEach(a -> putLast(changes, a));
        Scenario after = before.changed(List.copyOf(changes.values()));

        // Invalid breathing settings are refused before anything changes.
        boolean newPattern = hasEffect(changes, Effect.NEW_PATTERN);
        boolean breathes =
                changes.keySet().stream().anyMatch(setting -> setting.effect().isOfPattern());
        BreathingPattern pattern = breathes ? Breathing.patternOf(after) : null;
        scene.drive().invalidate();
        scene.drive().prepare(now);
        setUpSteps(after, changes, now);
        tuning.rampTo(after, system, step, now);
        if (changes.containsKey(Breathing.HOLD)) {
            scene.drive().pattern().hold(after.hold(), now);
        }
        if (pattern != null) {
            scene.drive().pattern().change(pattern, newPattern, step, now);
        }
        scene.drive().invalidate();
        scene.pose().invalidate();
        scene.wall().ifPresent(MovingChestWall::invalidate);
        tissueRamps = !values.hasTissueArrived(now);
        sceneRamps = true;
        settingsBefore = before;
        settings = after;
        log.removeIf(c -> c.step() == step);
        changes.values().forEach(a -> log.add(new ScheduledChange(step, a)));
        system.invalidate();
        stepper.integrator().reset();
    }

    private static void putLast(Map<Setting<?>, Assignment> all, Assignment assignment) {
        all.remove(assignment.setting());
        all.put(assignment.setting(), assignment);
    }

    private static boolean hasEffect(Map<Setting<?>, Assignment> changes, Effect effect) {
        return changes.keySet().stream().anyMatch(setting -> setting.effect() == effect);
    }

    /** Sets integrator and substeps for the tissue before and after the changes of this step. */
    private void setUpSteps(Scenario after, Map<Setting<?>, Assignment> changes, double now) {
        long step = stepper.steps();
        Integrator integrator = stepper.integratorBeforeChange();
        boolean other = after.integrator() != integrator.kind();
        if (other) {
            integrator = after.integrator().create(system);
        }
        boolean measure = other
                || after.timeStepS() != stepper.dtBeforeChange()
                || !values.hadTissueArrived(step, now - stepper.dtBeforeChange())
                || values.differsInTissue(after, step)
                || changes.keySet().stream()
                        .anyMatch(setting -> setting.effect().affectsStability());
        if (measure) {
            tuning.applyTissue(after);
            StabilityLimit ahead = StabilityLimit.of(system);
            tuning.applyTissue(now);
            stepper.switchTo(integrator, after.timeStepS(), StabilityLimit.of(system), ahead);
        } else {
            stepper.checkpoint();
        }
    }

    /**
     * Advances by one time step, before which all ramping values are updated. Allocates only when a ramp ends.
     *
     * @throws DivergenceException as {@link Stepper#step}; the ramps go on from the restored time
     */
    void step() {
        beforeStep();
        try {
            stepper.step();
        } catch (DivergenceException e) {
            tissueRamps = !values.hasTissueArrived(stepper.time());
            sceneRamps = true;
            throw e;
        }
    }

    private void beforeStep() {
        if (!tissueRamps && !sceneRamps) {
            return;
        }
        double now = stepper.time();
        if (tissueRamps) {
            tuning.applyTissue(now);
            if (values.hasTissueArrived(now)) {
                tissueRamps = false;
                scene.drive().prepare(now);
                stepper.measureStabilityLimit();
            }
        }
        if (sceneRamps) {
            tuning.applyRamps(now);
            sceneRamps = !values.hasSceneArrived(now);
        }
    }

    /**
     * Assignments that undo the changes of the last step that has any, and those of the same settings shortly before.
     * If they were themselves an undo, which did not help, the changes of the step before are undone as well, and so on
     * to the start. Empty if there is nothing to undo.
     */
    List<Assignment> undoAssignments() {
        boolean again = made().stream()
                .reduce((first, second) -> second)
                .map(c -> UNDO.equals(c.assignment().origin()))
                .orElse(false);
        long before = again ? undoneTo : Long.MAX_VALUE;
        long last = lastChangedStep(before);
        if (last < 0) {
            return List.of();
        }
        long cut = startOfDrag(last);
        undoneTo = cut;
        Scenario then = start.changed(log.stream()
                .filter(c -> c.step() < cut)
                .map(ScheduledChange::assignment)
                .toList());
        return made().stream()
                .filter(c -> c.step() >= cut)
                .map(c -> c.assignment().setting())
                .distinct()
                .map(setting -> new Assignment(UNDO, setting, then.get(setting)))
                .toList();
    }

    /** What notes that a run goes on from here, where no change does; empty where one does. */
    List<Assignment> goingOn() {
        boolean changed = log.stream().anyMatch(c -> c.step() == stepper.steps());
        return changed ? List.of() : List.of(Assignment.of(ScheduledChange.GOING_ON, Breathing.HOLD, settings.hold()));
    }

    /** The changes, without those that only note where the run goes on. */
    private List<ScheduledChange> made() {
        return log.stream().filter(c -> !c.isOnlyGoingOn()).toList();
    }

    /** The last step before a step that has changes; -1 if none has. */
    private long lastChangedStep(long before) {
        return made().stream()
                .mapToLong(ScheduledChange::step)
                .filter(step -> step < before)
                .max()
                .orElse(-1);
    }

    /** First step of the changes of the same settings that lead to those of a step. */
    private long startOfDrag(long last) {
        long first = last;
        long earlier = lastChangedStep(first);
        while (earlier >= 0
                && (first - earlier) * stepper.dt() < SAME_DRAG_S
                && changedAt(earlier).equals(changedAt(last))) {
            first = earlier;
            earlier = lastChangedStep(first);
        }
        return first;
    }

    private Set<Setting<?>> changedAt(long step) {
        return made().stream()
                .filter(c -> c.step() == step && !UNDO.equals(c.assignment().origin()))
                .map(c -> c.assignment().setting())
                .collect(Collectors.toSet());
    }

    /**
     * Whether the changes since the start leave the assembly valid, so that the scene can restart without a new one.
     */
    boolean isAsAssembled() {
        return log.stream().noneMatch(c -> c.assignment().setting().effect().isAssembled());
    }

    /**
     * Refuses changes of anything except parameters and the breath hold.
     *
     * @throws IllegalArgumentException with one sentence
     */
    static void requireParameters(List<ScheduledChange> changes) {
        for (ScheduledChange change : changes) {
            Setting<?> setting = change.assignment().setting();
            if (setting != Breathing.HOLD && !(setting instanceof Parameter)) {
                throw new IllegalArgumentException(
                        change.text() + ": found key '" + setting.key() + "', expected a parameter or hold");
            }
        }
    }
}
