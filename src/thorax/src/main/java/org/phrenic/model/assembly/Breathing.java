package org.phrenic.model.assembly;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.BreathingTraceReader;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.breathing.pattern.TracePattern;
import org.phrenic.document.KeySuggestion;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;
import org.phrenic.parameter.SwitchSetting;

/** The breathing pattern: a preset or a recording, with rate, depth and balance from the settings. */
public final class Breathing extends ScenePart {
    /** A preset from {@code data/breathing} that is part of the program. */
    public static final Setting<BreathingPreset> PRESET = new PresetSetting();
    /** A recording whose curve replaces the preset's. */
    public static final Setting<Optional<Path>> TRACE = new TraceSetting();
    /** Whether the breath is held. */
    public static final SwitchSetting HOLD =
            new SwitchSetting("hold", "Hold", Effect.DRIVE, false, "The breath is held where it is.");

    public static final Parameter RATE = Parameter.named("rate_per_min", "Rate")
            .unit("1/min")
            .range(2, 150)
            .initialOfPreset(values -> values.get(PRESET).parameters().ratePerMin())
            .group(Group.BREATHING)
            .effect(Effect.PATTERN)
            .describedAs("Breaths a minute.");
    public static final Parameter DEPTH = Parameter.named("depth", "Depth")
            .range(0, 2)
            .initial(1)
            .group(Group.BREATHING)
            .effect(Effect.PATTERN)
            .describedAs("Multiplies all drives of the breathing preset, each at most to full.");
    public static final Parameter INSPIRATORY_FRACTION = Parameter.named("inspiratory_fraction", "Inspiratory fraction")
            .range(0.1, 0.8)
            .initialOfPreset(values -> values.get(PRESET).parameters().inspiratoryFraction())
            .group(Group.BREATHING)
            .effect(Effect.PATTERN)
            .describedAs("Ti / Ttot.");
    public static final Parameter CHEST_SHARE = Parameter.named("chest_share", "Chest share")
            .range(0, 1)
            .initialOfPreset(values -> values.get(PRESET).parameters().chestShare())
            .group(Group.BREATHING)
            .effect(Effect.PATTERN)
            .fitted(0.3, 0.7)
            .describedAs("Balance of chest and abdomen: 0 breathes with the diaphragm alone, 1 with the ribs alone, 0.5"
                    + " leaves both as they stand.");

public Breathing() {
    super(Stage.LOADS, RATE, DEPTH, INSPIRATORY_FRACTION, CHEST_SHARE);
}

    /**
     * The breathing pattern for given settings.
     *
     * @throws BadInputException if the recording cannot be read
     */
    public static BreathingPattern patternOf(SettingValues values) {
        BreathingPreset preset = values.get(PRESET);
        BreathingParameters p = preset.parameters();
        if (values.states(RATE)) {
            p = p.withRatePerMin(values.get(RATE));
        }
        if (values.states(INSPIRATORY_FRACTION)) {
            p = p.withInspiratoryFraction(values.get(INSPIRATORY_FRACTION));
        }
        if (values.states(CHEST_SHARE)) {
            p = p.withChestShare(values.get(CHEST_SHARE));
        }
        if (values.states(DEPTH)) {
            p = p.withDepth(values.get(DEPTH));
        }
        Optional<Path> trace = values.get(TRACE);
        if (trace.isEmpty()) {
            return preset.pattern(p);
        }
        return new TracePattern(BreathingTraceReader.read(trace.get()), p, true);
    }

    private static BreathingPreset preset(String name) {
        return BreathingPreset.named(name);
    }

    /** The preset, given by name. */
    private static final class PresetSetting extends Setting<BreathingPreset> {
        PresetSetting() {
            super("preset", "Breathing", Effect.NEW_PATTERN, "Way to breathe, from data/breathing.");
        }

        /** Lazy holder of the default preset. */
        private static final class Quiet {
            static final BreathingPreset PRESET = preset("quiet");
        }

        @Override
        public List<String> options() {
            return BreathingPreset.names();
        }

        @Override
        public BreathingPreset defaultValue(SettingValues values) {
            return Quiet.PRESET;
        }

        @Override
        public BreathingPreset read(YamlMap yaml, Path folder) {
            String found = yaml.text(key());
            if (!options().contains(found)) {
                String hint = KeySuggestion.nearest(found, options())
                        .map(near -> " (did you mean '" + near + "'?)")
                        .orElse("");
                throw yaml.bad(key(), "found '" + found + "', expected one of " + String.join(", ", options()) + hint);
            }
            return preset(found);
        }

        @Override
        public Object toPlain(BreathingPreset value) {
            return value.name();
        }
    }

    /** The recording, given by path; {@code none} for no recording. */
    private static final class TraceSetting extends Setting<Optional<Path>> {
        private static final String NONE = "none";

        TraceSetting() {
            super("trace", "Recorded breath", Effect.NEW_PATTERN, "CSV file of recorded breathing, or none.");
        }

        @Override
        public Optional<Path> defaultValue(SettingValues values) {
            return Optional.empty();
        }

        @Override
        public Optional<Path> read(YamlMap yaml, Path folder) {
            String found = yaml.text(key());
            if (found.equals(NONE)) {
                return Optional.empty();
            }
            try {
                Path path = folder.resolve(found);
                if (!Files.isRegularFile(path)) {
                    throw yaml.bad(key(), "found no file '" + found + "', expected a CSV file of recorded breathing");
                }
                BreathingTraceReader.read(path);
                return Optional.of(path);
            } catch (InvalidPathException e) {
                throw new BadInputException(
                        yaml.bad(key(), "found '" + found + "', expected a path")
                                .getMessage(),
                        e);
            }
        }

        @Override
        public Object toPlain(Optional<Path> value) {
            return value.map(file -> file.toAbsolutePath().normalize().toString())
                    .orElse(null);
        }

        @Override
        public String format(Optional<Path> value) {
            return value.isEmpty() ? NONE : String.valueOf(toPlain(value));
        }
    }
}
