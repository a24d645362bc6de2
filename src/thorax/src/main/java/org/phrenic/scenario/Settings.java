package org.phrenic.scenario;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.phrenic.document.KeySuggestion;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.RigidTendon;
import org.phrenic.model.material.SheetBending;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.model.material.WallContact;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;

/**
 * Registry of all settings of a scenario: those that the parts of a simulation declare, and those of the run and its
 * output.
 */
public final class Settings {
    private static final List<Setting<?>> ALL = Stream.concat(
                    Stream.of(
                            RunSettings.NAME,
                            Breathing.PRESET,
                            Breathing.TRACE,
                            Materials.MATERIAL,
                            RunSettings.ANATOMY,
                            OrganSettings.RESOLUTION,
                            OrganSettings.MESH_VERTICES,
                            RunSettings.DURATION,
                            Numerics.TIME_STEP,
                            Numerics.INTEGRATOR,
                            Numerics.STEP_POLICY,
                            Numerics.PROJECTION_SWEEPS,
                            Numerics.REFRESH,
                            Numerics.MASS_SCALING,
                            Numerics.TENDON_LIGHTNESS,
                            Numerics.DAMPING_TIME,
                            SheetBending.BENDING_STIFFNESS,
                            Numerics.THREADS,
                            RunSettings.RECORD_EVERY,
                            RunSettings.MESHES_EVERY,
                            Muscle.MUSCLE,
                            TransdiaphragmaticPressure.PRESSURE,
                            RibRotation.RIBS,
                            RigidTendon.TENSEGRITY,
                            WallContact.CONTACT,
                            OrganSettings.STERNUM,
                            OrganSettings.LUNGS,
                            OrganSettings.LIVER,
                            RigidTendon.LINKS_PER_NODE,
                            RigidTendon.TENDON,
                            Breathing.HOLD,
                            Breathing.REPEAT,
                            RunSettings.STEPS,
                            RunSettings.CHANGES),
                    Materials.parameters().stream())
            .toList();

    /** Keys that are named where none is near. */
    private static final int NAMED = 5;

    private static final Map<String, Setting<?>> BY_KEY = byKey();

    private Settings() {}

    private static Map<String, Setting<?>> byKey() {
        Map<String, Setting<?>> map = new LinkedHashMap<>();
        ALL.forEach(setting -> map.put(setting.key(), setting));
        return map;
    }

    /** All settings, in the order of the documentation. */
    public static List<Setting<?>> all() {
        return ALL;
    }

    /** All keys, in the order of the documentation. */
    public static List<String> keys() {
        return List.copyOf(BY_KEY.keySet());
    }

    /** Keys of the settings that can change during a run. */
    public static List<String> liveKeys() {
        List<String> keys = new ArrayList<>();
        ALL.stream().filter(Setting::isLive).forEach(setting -> keys.add(setting.key()));
        return keys;
    }

    /** The setting with a key; null if there is none. */
    static Setting<?> find(String key) {
        return BY_KEY.get(key);
    }

    /**
     * The parameter with a key.
     *
     * @throws IllegalArgumentException if there is none; the message suggests the nearest key
     */
    public static Parameter parameter(String key) {
        if (BY_KEY.get(key) instanceof Parameter parameter) {
            return parameter;
        }
        List<String> keys = Materials.parameters().stream().map(Setting::key).toList();
        throw new IllegalArgumentException("found an unknown parameter '" + key + "', " + expected(key, keys));
    }

    /**
     * Requires that every key is that of a setting.
     *
     * @throws BadInputException for the first unknown key; suggests the nearest one, or names a few
     */
    public static void requireKeys(YamlMap yaml) {
        List<String> keys = keys();
        yaml.requireOnly(keys, key -> expected(key, keys));
    }

    /** Message part that says what was expected instead of an unknown key. */
    private static String expected(String key, List<String> known) {
        return KeySuggestion.nearest(key, known)
                .map(near -> "did you mean '" + near + "'?")
                .orElseGet(() -> "expected a key such as "
                        + String.join(", ", known.subList(0, Math.min(NAMED, known.size())))
                        + " (docs/parameters.md has all)");
    }
}
