package org.phrenic.model.assembly;

import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.BreathingTraceReader;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.breathing.pattern.TracePattern;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.file.UnreadableException;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.ParsedSetting;
import org.phrenic.parameter.Setting;
import org.phrenic.parameter.SettingValues;
import org.phrenic.parameter.SwitchSetting;

/** The breathing pattern: a preset or a recording, with rate, depth and balance from the settings. */
public final class Breathing extends ScenePart {
    /** Value of {@link #TRACE} for a breath without a recording. */
    public static final String NO_TRACE = "none";

    private static final BreathingPreset QUIET = BreathingPreset.named("quiet");

    /** A preset from {@code data/breathing} that is part of the program. */
    public static final Setting<BreathingPreset> PRESET = Setting.named("preset", "Breathing", Effect.NEW_PATTERN)
            .describedAs("Way to breathe, from data/breathing.")
            .choice(
                    BreathingPreset.names().stream().map(BreathingPreset::named).toList(),
                    BreathingPreset::name,
                    values -> QUIET);
    /** A recording whose curve replaces the preset's. */
    public static final Setting<Optional<Path>> TRACE = Setting.named("trace", "Recorded breath", Effect.NEW_PATTERN)
            .describedAs("CSV file of recorded breathing, or none.")
            .parsed(values -> Optional.empty(), Breathing::trace, value -> value.map(
                            file -> file.toAbsolutePath().normalize().toString())
                    .orElse(null));
    /** Whether the breath is held. */
    public static final SwitchSetting HOLD = Setting.named("hold", "Hold", Effect.DRIVE)
            .describedAs("The breath is held where it is.")
            .onOff(false);
    /** Whether steady breaths are repeated from the record of one. */
    public static final SwitchSetting REPEAT = Setting.named("repeat_breath", "Repeat steady breath", Effect.DRIVE)
            .describedAs("A breath that ends as it began is recorded, and those after it repeat the record until a"
                    + " setting changes.")
            .onOff(false);

    public static final Parameter RATE = Parameter.named("rate_per_min", "Rate")
            .range(2, 150, "1/min")
            .initialOfPreset(values -> values.get(PRESET).parameters().ratePerMin())
            .shown(Group.BREATHING, Effect.PATTERN)
            .describedAs("Breaths a minute; coughs at most 51.");
    public static final Parameter DEPTH = Parameter.named("depth", "Depth")
            .range(0, 2)
            .initial(1)
            .shown(Group.BREATHING, Effect.PATTERN)
            .describedAs("Multiplies all drives of the breathing preset, each at most to full.");
    public static final Parameter INSPIRATORY_FRACTION = Parameter.named("inspiratory_fraction", "Inspiratory fraction")
            .range(0.1, 0.8)
            .initialOfPreset(values -> values.get(PRESET).parameters().inspiratoryFraction())
            .shown(Group.BREATHING, Effect.PATTERN)
            .describedAs("Ti / Ttot; of a sniff less than 0.3.");
    public static final Parameter CHEST_SHARE = Parameter.named("chest_share", "Chest share")
            .range(0, 1)
            .initialOfPreset(values -> values.get(PRESET).parameters().chestShare())
            .shown(Group.BREATHING, Effect.PATTERN)
            .fitted(0.3, 0.7)
            .describedAs("Balance of chest and abdomen: 0 breathes with the diaphragm alone, 1 with the ribs"
                    + " alone, 0.5 leaves both as they stand.");

    public Breathing() {
        super(Stage.LOADS, RATE, DEPTH, INSPIRATORY_FRACTION, CHEST_SHARE);
    }

    /**
     * The breathing pattern for given settings.
     *
     * @throws BadInputException if the recording cannot be read or holds no breath, or the preset cannot breathe so
     */
    public static BreathingPattern patternOf(SettingValues values) {
        BreathingPreset preset = values.get(PRESET);
        double depth = values.states(DEPTH) ? values.get(DEPTH) : 1;
        Optional<Path> trace = values.get(TRACE);
        if (trace.isPresent()) {
            return recorded(trace.get(), balanced(preset.parameters(), values).withDepth(depth));
        }
        try {
            BreathingParameters p = preset.parameters();
            if (values.states(RATE)) {
                p = p.withRatePerMin(values.get(RATE));
            }
            if (values.states(INSPIRATORY_FRACTION)) {
                p = p.withInspiratoryFraction(values.get(INSPIRATORY_FRACTION));
            }
            return preset.pattern(balanced(p, values), depth);
        } catch (IllegalArgumentException e) {
            throw new BadInputException("preset " + preset.name() + stated(values) + ": " + e.getMessage(), e);
        }
    }

    private static BreathingParameters balanced(BreathingParameters parameters, SettingValues values) {
        return values.states(CHEST_SHARE) ? parameters.withChestShare(values.get(CHEST_SHARE)) : parameters;
    }

    /** The stated values that can make a breath of a preset impossible, for a message; empty if there are none. */
    private static String stated(SettingValues values) {
        String stated = Stream.of(RATE, INSPIRATORY_FRACTION)
                .filter(values::states)
                .map(parameter -> parameter.key() + " " + parameter.format(values.get(parameter)))
                .collect(Collectors.joining(" and "));
        return stated.isEmpty() ? "" : " with " + stated;
    }

    private static TracePattern recorded(Path trace, BreathingParameters parameters) {
        try {
            return new TracePattern(BreathingTraceReader.read(trace), parameters, true);
        } catch (IllegalArgumentException e) {
            throw new BadInputException(e.getMessage(), e);
        }
    }

    /**
     * What was read from the recording, in one sentence; empty without a recording.
     *
     * @throws BadInputException as {@link #patternOf}
     */
    public static Optional<String> traceDescription(SettingValues values) {
        return patternOf(values) instanceof TracePattern trace ? Optional.of(trace.description()) : Optional.empty();
    }

    private static Optional<Path> trace(YamlMap yaml, String key, Path folder) {
        String found = yaml.text(key);
        if (found.equals(NO_TRACE)) {
            return Optional.empty();
        }
        Path path = ParsedSetting.path(yaml, key, folder);
        if (!Files.isRegularFile(path)) {
            BadInputException missing =
                    yaml.bad(key, "found no file '" + found + "', expected a CSV file of recorded breathing");
            throw new UnreadableException(missing.getMessage(), new NoSuchFileException(found));
        }
        recorded(path, QUIET.parameters());
        return Optional.of(path);
    }
}
