package org.phrenic.scenario;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.YamlMap;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.ParsedSetting;
import org.phrenic.parameter.Setting;

/** Settings of a run apart from the model: name, body, duration, output and scheduled changes. */
public final class RunSettings {
    /** Built-in virtual bodies. */
    public static final List<String> VIRTUAL_BODIES = List.of("virtual/adult-male", "virtual/adult-female");

    private static final double MAX_DURATION_S = 86_400;
    private static final double MIN_OFFERED_S = 1e-5;
    private static final double RECORD_EVERY_S = 0.02;
    private static final long MAX_STEPS = 1_000_000_000_000L;

    /** Name of the scenario; the preset's name by default. */
    public static final Setting<String> NAME = new ParsedSetting<>(
            "name",
            "Name",
            Effect.ASSEMBLY,
            values -> values.get(Breathing.PRESET).name(),
            (yaml, key, folder) -> yaml.text(key),
            value -> value,
            "What to call it.");
    /** A virtual body, or the path of a thorax folder. */
    public static final Setting<String> ANATOMY = new ParsedSetting<>(
            "anatomy",
            "Body",
            Effect.ASSEMBLY,
            values -> VIRTUAL_BODIES.get(0),
            RunSettings::anatomy,
            value -> VIRTUAL_BODIES.contains(value)
                    ? value
                    : Path.of(value).toAbsolutePath().normalize().toString(),
            "A virtual body, or a folder of meshes.");

    public static final NumberSetting DURATION = time(
            "duration_s",
            "Duration",
            MIN_OFFERED_S,
            Double.NaN,
            "Simulated time; without it two breaths, or as long as a hold or a recording takes.");
    public static final NumberSetting RECORD_EVERY = time(
            "record_every_s",
            "Record every",
            MIN_OFFERED_S,
            RECORD_EVERY_S,
            "Time between samples of the observables.");
    /** Interval of mesh output; 0 for no meshes. */
    public static final NumberSetting MESHES_EVERY =
            time("meshes_every_s", "Meshes every", 0, 0, "Time between meshes that are written; 0 for none.");
    /** Number of steps, which replaces the duration; -1 if not given. */
    public static final Setting<Long> STEPS = new ParsedSetting<>(
            "steps",
            "Steps",
            Effect.ASSEMBLY,
            values -> -1L,
            RunSettings::steps,
            value -> value < 0 ? null : value,
            "Steps to run, whatever the duration.");
    /** Scheduled changes in the order of their steps. */
    public static final Setting<List<ScheduledChange>> CHANGES = new ParsedSetting<>(
            "changes",
            "Changes",
            Effect.ASSEMBLY,
            values -> List.of(),
            RunSettings::changes,
            value -> value.isEmpty()
                    ? null
                    : value.stream().map(ScheduledChange::text).toList(),
            "Changes while it runs, as a list of STEP:key=value.");

    private RunSettings() {}

    private static NumberSetting time(String key, String label, double minS, double defaultS, String description) {
        NumberSetting.Range range = new NumberSetting.Range("s", minS, MAX_DURATION_S);
        return new NumberSetting(key, label, Effect.ASSEMBLY, range, values -> defaultS, description);
    }

    private static String anatomy(YamlMap yaml, String key, Path folder) {
        String found = yaml.text(key);
        if (VIRTUAL_BODIES.contains(found)) {
            return found;
        }
        Path path = ParsedSetting.path(yaml, key, folder);
        if (!Files.isDirectory(path)) {
            String expected = String.join(", ", VIRTUAL_BODIES) + " or a folder of meshes";
            throw yaml.bad(key, "found no folder '" + found + "', expected " + expected);
        }
        return path.toString();
    }

    private static long steps(YamlMap yaml, String key, Path folder) {
        long value = yaml.integer(key);
        if (value < 0 || value > MAX_STEPS) {
            throw yaml.bad(key, "found " + value + ", expected 0 to " + MAX_STEPS);
        }
        return value;
    }

    private static List<ScheduledChange> changes(YamlMap yaml, String key, Path folder) {
        List<ScheduledChange> list = new ArrayList<>();
        for (String text : yaml.texts(key)) {
            String origin = yaml.bad(key, "'" + text + "'").getMessage();
            list.add(ScheduledChange.parse(text, origin, problem -> yaml.bad(key, problem), folder));
        }
        return list;
    }
}
