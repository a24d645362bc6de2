package org.phrenic.simulation.assembly;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.constraint.SlidingContact;
import org.phrenic.engine.integrator.Integrator;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.LiveKeys;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScenarioBreathing;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.simulation.Simulation;

/**
 * Changes a scene while it runs, and keeps the log of it. What a change does is a function of the state, the step and
 * the changes before it alone, so that the same changes at the same steps give the same bits; of several changes of a
 * key at one step the last counts.
 *
 * <p>Numbers ramp over 0.2 s. While springs, masses or damping are on their way the substeps are those that the worse
 * of both ends asks for; when they have arrived the limit is measured anew.
 */
public final class LiveTuning {
    private static final Set<String> PATTERN_KEYS = Set.of(
            "preset",
            "trace",
            Parameter.RATE.key(),
            Parameter.DEPTH.key(),
            Parameter.INSPIRATORY_FRACTION.key(),
            Parameter.CHEST_SHARE.key());
    private static final Set<String> NEW_BREATH_KEYS = Set.of("preset", "trace");
    /** A scene is assembled and settled the same whatever these are. */
    private static final Set<String> NOT_ASSEMBLED = Set.of(
            "preset",
            "trace",
            "hold",
            "muscle",
            "ribs",
            "integrator",
            Parameter.RATE.key(),
            Parameter.DEPTH.key(),
            Parameter.INSPIRATORY_FRACTION.key(),
            Parameter.CHEST_SHARE.key(),
            Parameter.RIB_ROTATION.key(),
            Parameter.UPPER_RIB_ROTATION.key(),
            Parameter.LOWER_RIB_ROTATION.key(),
            Parameter.RIB_LEFT_OVER_RIGHT.key(),
            Parameter.BUCKET_HANDLE.key(),
            Parameter.MEDIASTINUM_RIGHT.key(),
            Parameter.MEDIASTINUM_LEFT.key(),
            Parameter.PRESSURE_LEFT_OVER_RIGHT.key(),
            Parameter.MUSCLE_ACTIVATION.key(),
            Parameter.MUSCLE_FORCE.key(),
            Parameter.GREATEST_PRESSURE.key());

    private static final String UNDO = "undo";

    private final Scenario start;
    private final Scene scene;
    private final ParticleSystem system;
    private final Stepper stepper;
    private final RampedValues dials;
    private final TissueTuning tissue;
    private final double[] values;
    private final List<ScheduledChange> log = new ArrayList<>();
    private Scenario settings;
    private Scenario settingsBefore;
    private boolean limitPending;
    private boolean geometryPending;
    private long linksDisabledAtStep = -1;
    private long undoneTo;

    public LiveTuning(Scenario scenario, Scene scene, Stepper stepper, RampedValues dials) {
        this.scene = scene;
        this.system = scene.system();
        this.stepper = stepper;
        this.dials = dials;
        tissue = new TissueTuning(scene, scenario);
        values = tissue.assembledValues();
        start = scenario;
        settings = scenario;
        settingsBefore = scenario;
    }

    public Scenario settings() {
        return settings;
    }

    public List<ScheduledChange> log() {
        return List.copyOf(log);
    }

    /** Makes changes between two steps; see {@link Simulation#change(List)}. */
    public void apply(List<Assignment> assignments) {
        assignments.forEach(LiveKeys::requireLive);
        long step = stepper.steps();
        double now = stepper.time();
        Scenario before = lastChangedStep() == step ? settingsBefore : settings;
        Map<String, Assignment> atThisStep = new LinkedHashMap<>();
        log.stream().filter(c -> c.step() == step).forEach(c -> putLast(atThisStep, c.assignment()));
        assignments.forEach(a -> putLast(atThisStep, a));
        Scenario after = before.with(List.copyOf(atThisStep.values()));

        // What the settings cannot breathe is refused before anything is changed.
        BreathingPattern pattern = atThisStep.keySet().stream().anyMatch(PATTERN_KEYS::contains)
                ? ScenarioBreathing.patternOf(after)
                : null;
        scene.drive().invalidate();
        scene.drive().prepare(now);
        Integrator integrator = stepper.integrator();
        boolean other = after.integrator() != integrator.kind();
        if (other) {
            integrator = after.integrator().create(system);
        }
        boolean material = !dials.hasTissueArrived(now - stepper.dt()) || other || after.timeStepS() != stepper.dt();
        for (Knob knob : Knob.values()) {
            material |= knob.affectsTissue()
                    && Double.compare(knob.valueIn(after), dials.of(knob).target()) != 0;
        }
        if (material || affectsTissue(atThisStep)) {
            StabilityLimit ahead = stabilityLimitFor(after);
            applyTissue(now);
            StabilityLimit here = StabilityLimit.of(system);
            stepper.switchTo(integrator, after.timeStepS(), here, ahead);
        } else {
            stepper.checkpoint();
        }
        commit(after, atThisStep, pattern, step, now);
        settingsBefore = before;
        settings = after;
        log.removeIf(c -> c.step() == step);
        atThisStep.values().forEach(a -> log.add(new ScheduledChange(step, a)));
        system.invalidate();
        stepper.integrator().reset();
    }

    private static void putLast(Map<String, Assignment> all, Assignment assignment) {
        all.remove(assignment.key());
        all.put(assignment.key(), assignment);
    }

    private long lastChangedStep() {
        return log.isEmpty() ? -1 : log.get(log.size() - 1).step();
    }

    private static boolean affectsTissue(Map<String, Assignment> changes) {
        return changes.keySet().stream().anyMatch(key -> !NOT_ASSEMBLED.contains(key) || key.equals("integrator"));
    }

    /** The limit of the scene as it stands, with the tissue of a scenario. */
    private StabilityLimit stabilityLimitFor(Scenario scenario) {
        for (Knob knob : Knob.values()) {
            values[knob.index()] = knob.valueIn(scenario);
        }
        tissue.apply(values);
        return StabilityLimit.of(system);
    }

    private void commit(
            Scenario after, Map<String, Assignment> changes, BreathingPattern pattern, long step, double now) {
        boolean linksOn = dials.of(Knob.LINKS).target() == 1;
        boolean contactOn = dials.of(Knob.CONTACT).target() == 1;
        for (Knob knob : Knob.values()) {
            dials.of(knob).rampTo(knob.valueIn(after), step, now);
        }
        scene.forces().links().ifPresent(links -> {
            if (after.tensegrity() && !linksOn && linksDisabledAtStep != step) {
                links.captureLengths(system);
            }
            linksDisabledAtStep = linksOn && !after.tensegrity() ? step : linksDisabledAtStep;
            system.setEnabled(links, after.tensegrity());
        });
        scene.forces().contact().ifPresent(contact -> {
            if (contactOn != after.contact()) {
                system.setEnabled(contact, after.contact());
            }
        });
        if (changes.containsKey("hold")) {
            scene.drive().pattern().hold(after.hold(), now);
        }
        if (pattern != null) {
            boolean anew = changes.keySet().stream().anyMatch(NEW_BREATH_KEYS::contains);
            scene.drive().pattern().change(pattern, anew, step, now);
        }
        scene.drive().invalidate();
        limitPending = !dials.hasTissueArrived(now);
        geometryPending = true;
    }

    /** Told before every step: turns what is on its way. Allocates nothing but where something has arrived. */
    public void beforeStep() {
        if (!limitPending && !geometryPending) {
            return;
        }
        double now = stepper.time();
        if (limitPending) {
            applyTissue(now);
            if (dials.hasTissueArrived(now)) {
                limitPending = false;
                scene.drive().prepare(now);
                stepper.measureStabilityLimit();
            }
        }
        if (geometryPending) {
            applyGeometry(now);
            geometryPending = !dials.hasGeometryArrived(now);
        }
    }

    private void applyTissue(double now) {
        for (Knob knob : Knob.values()) {
            values[knob.index()] = dials.of(knob).at(now);
        }
        tissue.apply(values);
    }

    private void applyGeometry(double now) {
        double radius = dials.of(Knob.LINE_RADIUS).at(now);
        for (var line : scene.forces().lines()) {
            line.setRadius(radius);
        }
        if (scene.forces().links().isPresent()) {
            scene.forces().links().get().interpolateLengths(dials.of(Knob.LINKS).at(now));
        }
        if (scene.forces().contact().isPresent()) {
            double speed =
                    SlidingContact.MAX_RETURN_SPEED * dials.of(Knob.CONTACT).at(now);
            scene.forces().contact().get().setMaxReturnSpeed(speed);
        }
    }

    /**
     * What takes back the changes made at the last step that has any; if those were themselves taking something back,
     * which has not helped, the changes of the step before as well, and so on to the start. Empty if nothing is left to
     * take back.
     */
    public List<Assignment> undoAssignments() {
        if (log.isEmpty()) {
            return List.of();
        }
        boolean again = UNDO.equals(log.get(log.size() - 1).assignment().origin());
        long before = again ? undoneTo : Long.MAX_VALUE;
        long cut = log.stream()
                .mapToLong(ScheduledChange::step)
                .filter(step -> step < before)
                .max()
                .orElse(-1);
        if (cut < 0) {
            return List.of();
        }
        undoneTo = cut;
        Scenario then = start.with(log.stream()
                .filter(c -> c.step() < cut)
                .map(ScheduledChange::assignment)
                .toList());
        Map<String, Object> values = then.toMap();
        return log.stream()
                .filter(c -> c.step() >= cut)
                .map(c -> c.assignment().key())
                .distinct()
                .map(key -> new Assignment(UNDO, key, String.valueOf(values.getOrDefault(key, presetValue(key, then)))))
                .toList();
    }

    /** Value of a key that settings leave to the preset. */
    private static Object presetValue(String key, Scenario settings) {
        var breath = settings.breathing().parameters();
        if (key.equals(Parameter.RATE.key())) {
            return breath.ratePerMin();
        }
        if (key.equals(Parameter.INSPIRATORY_FRACTION.key())) {
            return breath.inspiratoryFraction();
        }
        return key.equals(Parameter.CHEST_SHARE.key()) ? breath.chestShare() : "none";
    }

    /**
     * Whether what was changed since the start leaves the scene as it was assembled, so that it can begin anew as it
     * is.
     */
    public boolean isAsAssembled() {
        return log.stream().allMatch(c -> NOT_ASSEMBLED.contains(c.assignment().key()));
    }

    /**
     * Refuses changes of anything but numbers and the hold of the breath.
     *
     * @throws IllegalArgumentException with one sentence
     */
    public static void requireParameters(List<ScheduledChange> changes) {
        for (ScheduledChange change : changes) {
            String key = change.assignment().key();
            if (!key.equals("hold") && !Parameter.keys().contains(key)) {
                throw new IllegalArgumentException(
                        change.text() + ": found key '" + key + "', expected a parameter or hold");
            }
        }
    }

    /** Gives tissue and action lines the numbers that they were assembled with. */
    public void restoreAssembled() {
        tissue.apply(tissue.assembledValues());
        for (var line : scene.forces().lines()) {
            line.setRadius(tissue.assembledValues()[Knob.LINE_RADIUS.index()]);
        }
    }

    /** Which scheme the settings ask for. */
    IntegratorKind integrator() {
        return settings.integrator();
    }
}
