package org.phrenic.scenario;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.phrenic.anatomy.Resolution;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.assembly.TissueMaterial;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;

/**
 * Description of a simulation: values for some of the {@link Settings}. All others have defaults, so an empty scenario
 * is a quiet breath of the virtual adult male. Immutable. Two scenarios are equal if all their settings have equal
 * values, stated or by default.
 */
public final class Scenario implements SettingValues {
    private static final Scenario DEFAULTS = new Scenario(Map.of());

    private final Map<Setting<?>, Object> stated;

    private Scenario(Map<Setting<?>, Object> stated) {
        this.stated = Collections.unmodifiableMap(stated);
    }

    /** The default scenario: a quiet breath of the virtual adult male. */
    public static Scenario defaults() {
        return DEFAULTS;
    }

    /**
     * Reads a scenario file. Relative paths in it are resolved against its folder.
     *
     * @throws BadInputException with one sentence that names file, line and key
     */
    public static Scenario read(Path file) {
        LabelVolumeFiles.refuse(file, "a scenario");
        YamlMap yaml = YamlDocument.read(file);
        if (yaml.keys().isEmpty()) {
            throw new BadInputException(file + ": found no keys, expected 'key: value' lines such as 'preset: quiet'");
        }
        Settings.requireKeys(yaml);
        Path folder = file.toAbsolutePath().getParent();
        Map<Setting<?>, Object> values = new LinkedHashMap<>();
        values.put(RunSettings.NAME, RunSettings.nameOf(file));
        for (Setting<?> setting : Settings.all()) {
            if (yaml.has(setting.key())) {
                values.put(setting, setting.read(yaml, folder));
            }
        }
        Scenario scenario = new Scenario(values);
        return ScenarioChecks.require(
                scenario, values.keySet(), (setting, problem) -> yaml.bad(setting.key(), problem));
    }

    /**
     * Copy of this scenario with other values. If a setting is assigned twice, the last value applies. With another
     * material, what is stated as the default of the present one becomes the default of the other.
     *
     * @throws BadInputException with one sentence that names the origin of the value and the key
     */
    public Scenario with(List<Assignment> assignments) {
        return assigned(assignments, setting -> setting.isLive() && !isOfPreset(setting));
    }

    /**
     * Copy of this scenario after changes during a run: what the preset gives as well is given by it again.
     *
     * @throws BadInputException with one sentence that names the origin of the value and the key
     */
    public Scenario changed(List<Assignment> assignments) {
        return assigned(assignments, Setting::isLive);
    }

    /**
     * Copy of this scenario that states other values as a file would: a value that is the default of the material stays
     * with any other material.
     *
     * @throws BadInputException with one sentence that names the origin of the value and the key
     */
    public Scenario stating(List<Assignment> assignments) {
        Map<Setting<?>, Object> values = new LinkedHashMap<>(stated);
        return assigned(values, assignments, setting -> false);
    }

    private Scenario assigned(List<Assignment> assignments, Predicate<Setting<?>> leftAtDefault) {
        Map<Setting<?>, Object> values = new LinkedHashMap<>(stated);
        values.keySet().removeAll(MaterialDefaults.leftBy(this, assignments));
        return assigned(values, assignments, leftAtDefault);
    }

    /** @param leftAtDefault settings that are not stated where their value is the default of material and preset */
    private static Scenario assigned(
            Map<Setting<?>, Object> values, List<Assignment> assignments, Predicate<Setting<?>> leftAtDefault) {
        Map<Setting<?>, String> origins = new LinkedHashMap<>();
        for (Assignment assignment : assignments) {
            values.put(assignment.setting(), assignment.value());
            origins.put(assignment.setting(), assignment.origin());
        }
        values.keySet()
                .removeIf(setting -> origins.containsKey(setting)
                        && leftAtDefault.test(setting)
                        && values.get(setting).equals(new Scenario(values).defaultOf(setting)));
        Scenario scenario = new Scenario(values);
        return ScenarioChecks.require(scenario, origins.keySet(), (setting, problem) -> {
            String origin = origins.getOrDefault(setting, "");
            return new BadInputException(
                    (origin.isEmpty() ? "" : origin + ": ") + "key '" + setting.key() + "': " + problem);
        });
    }

    private static boolean isOfPreset(Setting<?> setting) {
        return setting instanceof Parameter parameter && parameter.isGivenByPreset();
    }

    /** Copy of this scenario with other values, each as {@code key=value}. */
    public Scenario with(String... assignments) {
        return with(Arrays.stream(assignments).map(Assignment::parse).toList());
    }

    /** Copy of this scenario with another value of a setting. */
    public <T> Scenario with(Setting<T> setting, T value) {
        return with(List.of(Assignment.of("", setting, value)));
    }

    /** Copy of this scenario with a setting reset to its default. */
    public Scenario without(Setting<?> setting) {
        Map<Setting<?>, Object> values = new LinkedHashMap<>(stated);
        values.remove(setting);
        return new Scenario(values);
    }

    /**
     * Copy of this scenario with another material. Stated values are kept, except those that the material does not use
     * and those that are defaults of the present one alone.
     */
    public Scenario withMaterial(TissueMaterial material) {
        Map<Setting<?>, Object> values = new LinkedHashMap<>(stated);
        values.keySet().removeIf(setting -> !Materials.isUsed(setting, material));
        values.keySet().removeAll(MaterialDefaults.leftBy(this, material));
        values.put(Materials.MATERIAL, material);
        return new Scenario(values);
    }

    /**
     * Copy of this scenario with other scheduled changes.
     *
     * @throws BadInputException with one sentence, if a change is invalid or they are not in order
     */
    public Scenario withChanges(List<ScheduledChange> others) {
        Map<Setting<?>, Object> values = new LinkedHashMap<>(stated);
        values.put(RunSettings.CHANGES, List.copyOf(others));
        return ScenarioChecks.requireValidChanges(new Scenario(values));
    }

    /** Copy of this scenario with a number of steps. */
    public Scenario withSteps(long steps) {
        Map<Setting<?>, Object> values = new LinkedHashMap<>(stated);
        values.put(RunSettings.STEPS, steps);
        return new Scenario(values);
    }

    @Override
    @SuppressWarnings("unchecked") // a value of the setting's type was put there
    public <T> T get(Setting<T> setting) {
        Object value = stated.get(setting);
        if (value != null) {
            return (T) value;
        }
        return defaultOf(setting);
    }

    /** Default value of a setting: that of the material or the breathing preset. */
    @SuppressWarnings("unchecked") // a parameter is a setting of Double
    public <T> T defaultOf(Setting<T> setting) {
        return setting instanceof Parameter parameter
                ? (T) (Double) material().defaultOf(parameter, this)
                : setting.defaultValue(this);
    }

    @Override
    public boolean states(Setting<?> setting) {
        return stated.containsKey(setting);
    }

    public String name() {
        return get(RunSettings.NAME);
    }

    /** The built-in breathing preset, without this scenario's rate, depth and other values. */
    public BreathingPreset breathing() {
        return get(Breathing.PRESET);
    }

    /** Name of the breathing preset. */
    public String preset() {
        return breathing().name();
    }

    /** Recording whose curve replaces the preset's. */
    public Optional<Path> trace() {
        return get(Breathing.TRACE);
    }

    /** Whether the breath is held. */
    public boolean hold() {
        return get(Breathing.HOLD);
    }

    /** Material model. */
    public TissueMaterial material() {
        return get(Materials.MATERIAL);
    }

    /** Name of a virtual body, or path of a thorax folder. */
    public String anatomy() {
        return get(RunSettings.ANATOMY);
    }

    /** Whether the body is a built-in virtual one; otherwise {@link #anatomy} is a folder. */
    public boolean isVirtual() {
        return RunSettings.VIRTUAL_BODIES.contains(anatomy());
    }

    /** Mesh resolution. */
    public Resolution resolution() {
        return get(OrganSettings.RESOLUTION);
    }

    /** Number of threads; it does not affect the results. */
    public int threads() {
        return get(Numerics.THREADS);
    }

    /** Time step, s. */
    public double timeStepS() {
        return get(Numerics.TIME_STEP);
    }

    public IntegratorKind integrator() {
        return get(Numerics.INTEGRATOR);
    }

    /** Stated simulated time, s; NaN if not given. */
    public double durationS() {
        return get(RunSettings.DURATION);
    }

    /**
     * Simulated time, s: the stated one, or the time that covers the complete breathing pattern
     * ({@link BreathingPattern#fullDurationS}).
     */
    public double durationS(BreathingPattern pattern) {
        return Double.isNaN(durationS()) ? pattern.fullDurationS() : durationS();
    }

    /** Number of steps, which replaces the duration; -1 if not given. */
    public long steps() {
        return get(RunSettings.STEPS);
    }

    /** Scheduled changes in the order of their steps. */
    public List<ScheduledChange> changes() {
        return get(RunSettings.CHANGES);
    }

    /** Value of a setting as in a scenario file; null if the file omits it. */
    public <T> Object plain(Setting<T> setting) {
        return setting.toPlain(get(setting));
    }

    /** Value of a setting as text. */
    public <T> String text(Setting<T> setting) {
        return setting.format(get(setting));
    }

    /**
     * All keys and values in the order of the documentation. A scenario read from the map equals this one. Keys whose
     * value comes from the preset are omitted.
     */
    public Map<String, Object> toMap() {
        return toMap(false);
    }

    private Map<String, Object> toMap(boolean ofPresetToo) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (Setting<?> setting : Settings.all()) {
            boolean ofPreset = !ofPresetToo && isOfPreset(setting) && !states(setting);
            Object plain =
                    ofPreset || setting == RunSettings.CHANGES || setting == RunSettings.STEPS ? null : plain(setting);
            if (plain != null) {
                map.put(setting.key(), plain);
            }
            if (setting == RunSettings.DURATION && steps() >= 0) {
                map.put(RunSettings.STEPS.key(), steps());
            }
        }
        if (!changes().isEmpty()) {
            map.put(RunSettings.CHANGES.key(), plain(RunSettings.CHANGES));
        }
        return map;
    }

    /** The part of {@link #toMap} that this scenario states, so that all other settings keep their defaults open. */
    public Map<String, Object> statedMap() {
        Map<String, Object> map = toMap();
        Settings.all().stream()
                .filter(setting -> !states(setting))
                .map(Setting::key)
                .forEach(map::remove);
        return map;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Scenario scenario && toMap(true).equals(scenario.toMap(true));
    }

    @Override
    public int hashCode() {
        return toMap(true).hashCode();
    }

    @Override
    public String toString() {
        return toMap().toString();
    }
}
