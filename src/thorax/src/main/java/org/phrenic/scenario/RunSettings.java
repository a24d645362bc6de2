package org.phrenic.scenario;

import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.file.UnreadableException;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.NumberSetting;
import org.phrenic.parameter.ParsedSetting;
import org.phrenic.parameter.Setting;

/** Settings of a run apart from the model: name, body, duration, output and scheduled changes. */
public final class RunSettings {
    /** The virtual man, the body without another. */
    public static final String VIRTUAL_MAN = "virtual/adult-male";

    public static final String VIRTUAL_WOMAN = "virtual/adult-female";

    /** Built-in virtual bodies. */
    public static final List<String> VIRTUAL_BODIES = List.of(VIRTUAL_MAN, VIRTUAL_WOMAN, "virtual/high-colon-male");

    private static final double MAX_DURATION_S = 86_400;
    private static final double MIN_OFFERED_S = 1e-5;
    private static final double RECORD_EVERY_S = 0.02;
    private static final long MAX_STEPS = 1_000_000_000_000L;

    /** Name of the scenario; the preset's name by default. */
    public static final Setting<String> NAME = Setting.named("name", "Name", Effect.ASSEMBLY)
            .describedAs("What to call it.")
            .parsed(values -> values.get(Breathing.PRESET).name(), RunSettings::name, value -> value);
    /** A virtual body, or the path of a thorax folder. */
    public static final Setting<String> ANATOMY = Setting.named("anatomy", "Body", Effect.ASSEMBLY)
            .describedAs("A virtual body, or a folder of meshes.")
            .parsed(
                    values -> VIRTUAL_MAN,
                    RunSettings::anatomy,
                    value -> VIRTUAL_BODIES.contains(value)
                            ? value
                            : Path.of(value).toAbsolutePath().normalize().toString());

    public static final NumberSetting DURATION = Setting.named("duration_s", "Duration", Effect.ASSEMBLY)
            .describedAs("Simulated time; without it two breaths or cycles, or as long as a hold or a recording takes.")
            .number("s", MIN_OFFERED_S, MAX_DURATION_S, values -> Double.NaN);
    public static final NumberSetting RECORD_EVERY = Setting.named("record_every_s", "Record every", Effect.ASSEMBLY)
            .describedAs("Time between samples of the observables, rounded to whole steps.")
            .number("s", MIN_OFFERED_S, MAX_DURATION_S, values -> RECORD_EVERY_S);
    /** Interval of mesh output; 0 for no meshes. */
    public static final NumberSetting MESHES_EVERY = Setting.named("meshes_every_s", "Meshes every", Effect.ASSEMBLY)
            .describedAs("Time between meshes that are written; 0 for none.")
            .number("s", 0, MAX_DURATION_S, values -> 0);
    /** Number of steps, which replaces the duration; -1 if not given. */
    public static final Setting<Long> STEPS = Setting.named("steps", "Steps", Effect.ASSEMBLY)
            .describedAs("Steps to run, whatever the duration.")
            .parsed(values -> -1L, RunSettings::steps, value -> value < 0 ? null : value);
    /** Scheduled changes in the order of their steps. */
    public static final Setting<List<ScheduledChange>> CHANGES = Setting.named("changes", "Changes", Effect.ASSEMBLY)
            .describedAs("Changes while it runs, as a list of STEP:key=value.")
            .parsed(
                    values -> List.of(),
                    RunSettings::changes,
                    value -> value.isEmpty()
                            ? null
                            : value.stream().map(ScheduledChange::text).toList());

    private RunSettings() {}

    private static String name(YamlMap yaml, String key, Path folder) {
        String found = yaml.text(key);
        if (found.isBlank() || found.chars().anyMatch(Character::isISOControl)) {
            throw yaml.bad(
                    key,
                    "found " + (found.isBlank() ? "an empty name" : "a name with a control character")
                            + ", expected one line of text");
        }
        return found;
    }

    private static String anatomy(YamlMap yaml, String key, Path folder) {
        String found = yaml.text(key);
        if (VIRTUAL_BODIES.contains(found)) {
            return found;
        }
        Path path = ParsedSetting.path(yaml, key, folder);
        if (!Files.isDirectory(path)) {
            String expected = String.join(", ", VIRTUAL_BODIES) + " or a folder of meshes";
            LabelVolumeFiles.refuse(path, expected);
            BadInputException missing = yaml.bad(key, "found no folder '" + found + "', expected " + expected);
            throw new UnreadableException(missing.getMessage(), new NoSuchFileException(found));
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

    /** The name of a scenario in a file that states none. */
    public static String nameOf(Path file) {
        return FileNames.withoutExtension(file).replaceAll("\\p{Cntrl}", "_");
    }

    /** A body in a report: the name of a virtual one, of any other that of its folder without where it lies. */
    public static String bodyLabel(String anatomy) {
        return VIRTUAL_BODIES.contains(anatomy) ? anatomy : FileNames.ofBody(Path.of(anatomy));
    }
}
