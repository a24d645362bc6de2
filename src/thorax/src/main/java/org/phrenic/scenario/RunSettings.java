package org.phrenic.scenario;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;

/** Settings of a run apart from the model: name, body, duration, output and scheduled changes. */
public final class RunSettings {
    /** Built-in virtual bodies. */
    public static final List<String> VIRTUAL_BODIES = List.of("virtual/adult-male", "virtual/adult-female");

    private static final double MAX_DURATION_S = 86_400;
    private static final double LEAST_OFFERED_S = 1e-5;
    private static final double RECORD_EVERY_S = 0.02;
    private static final long MAX_STEPS = 1_000_000_000_000L;

    public static final Setting<String> NAME = new Name();
    public static final Setting<String> ANATOMY = new Anatomy();
    public static final NumberSetting DURATION = time(
            "duration_s",
            "Duration",
            Double.NaN,
            "Simulated time; without it two breaths, or as long as a hold or a recording takes.");
    public static final NumberSetting RECORD_EVERY =
            time("record_every_s", "Record every", RECORD_EVERY_S, "Time between samples of the observables.");
    public static final Setting<Double> MESHES_EVERY = new MeshesEvery();
    public static final Setting<Long> STEPS = new Steps();
    public static final Setting<List<ScheduledChange>> CHANGES = new Changes();

    private RunSettings() {}

    private static NumberSetting time(String key, String label, double defaultS, String description) {
        return new NumberSetting(
                key,
                label,
                Effect.ASSEMBLY,
                new NumberSetting.Range("s", LEAST_OFFERED_S, MAX_DURATION_S),
                values -> defaultS,
                description);
    }

    private static Path path(Path folder, String text, YamlMap yaml, String key) {
        try {
            return folder.resolve(text);
        } catch (InvalidPathException e) {
            throw new BadInputException(
                    yaml.bad(key, "found '" + text + "', expected a path").getMessage(), e);
        }
    }

    /** Name of the scenario; the preset's name by default. */
    private static final class Name extends Setting<String> {
        Name() {
            super("name", "Name", Effect.ASSEMBLY, "What to call it.");
        }

        @Override
        public String defaultValue(SettingValues values) {
            return values.get(Breathing.PRESET).name();
        }

        @Override
        public String read(YamlMap yaml, Path folder) {
            return yaml.text(key());
        }
    }

    /** A virtual body, or the path of a thorax folder. */
    private static final class Anatomy extends Setting<String> {
        Anatomy() {
            super("anatomy", "Body", Effect.ASSEMBLY, "A virtual body, or a folder of meshes.");
        }

        @Override
        public List<String> options() {
            return VIRTUAL_BODIES;
        }

        @Override
        public String defaultValue(SettingValues values) {
            return VIRTUAL_BODIES.get(0);
        }

        @Override
        public String read(YamlMap yaml, Path folder) {
            String found = yaml.text(key());
            if (VIRTUAL_BODIES.contains(found)) {
                return found;
            }
            Path path = path(folder, found, yaml, key());
            if (!Files.isDirectory(path)) {
                throw yaml.bad(
                        key(),
                        "found no folder '" + found + "', expected " + String.join(", ", VIRTUAL_BODIES)
                                + " or a folder of meshes");
            }
            return path.toString();
        }

        @Override
        public Object toPlain(String value) {
            return VIRTUAL_BODIES.contains(value)
                    ? value
                    : Path.of(value).toAbsolutePath().normalize().toString();
        }
    }

    /** Interval of mesh output; 0 for no meshes. */
    private static final class MeshesEvery extends Setting<Double> {
        private static final NumberSetting ABOVE_ZERO = time("meshes_every_s", "", 0, "");

        MeshesEvery() {
            super(
                    "meshes_every_s",
                    "Meshes every",
                    Effect.ASSEMBLY,
                    "Time between meshes that are written; 0 for none.");
        }

        @Override
        public String unit() {
            return "s";
        }

        @Override
        public Double defaultValue(SettingValues values) {
            return 0.0;
        }

        @Override
        public Double read(YamlMap yaml, Path folder) {
            return yaml.isNumber(key()) && yaml.number(key()) == 0 ? 0 : ABOVE_ZERO.read(yaml, folder);
        }
    }

    /** Number of steps, which replaces the duration; -1 if not given. */
    private static final class Steps extends Setting<Long> {
        Steps() {
            super("steps", "Steps", Effect.ASSEMBLY, "Steps to run, whatever the duration.");
        }

        @Override
        public Long defaultValue(SettingValues values) {
            return -1L;
        }

        @Override
        public Long read(YamlMap yaml, Path folder) {
            long value = yaml.integer(key());
            if (value < 0 || value > MAX_STEPS) {
                throw yaml.bad(key(), "found " + value + ", expected 0 to " + MAX_STEPS);
            }
            return value;
        }

        @Override
        public Object toPlain(Long value) {
            return value < 0 ? null : value;
        }
    }

    /** Scheduled changes in the order of their steps. */
    private static final class Changes extends Setting<List<ScheduledChange>> {
        Changes() {
            super("changes", "Changes", Effect.ASSEMBLY, "Changes while it runs, as a list of STEP:key=value.");
        }

        @Override
        public List<ScheduledChange> defaultValue(SettingValues values) {
            return List.of();
        }

        @Override
        public List<ScheduledChange> read(YamlMap yaml, Path folder) {
            List<ScheduledChange> list = new ArrayList<>();
            for (String text : yaml.texts(key())) {
                String origin = yaml.bad(key(), "'" + text + "'").getMessage();
                list.add(ScheduledChange.parse(text, origin, problem -> yaml.bad(key(), problem), folder));
            }
            return list;
        }

        @Override
        public Object toPlain(List<ScheduledChange> value) {
            return value.isEmpty()
                    ? null
                    : value.stream().map(ScheduledChange::text).toList();
        }
    }
}
