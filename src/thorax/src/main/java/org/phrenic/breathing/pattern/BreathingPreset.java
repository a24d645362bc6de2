package org.phrenic.breathing.pattern;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.breathing.BreathingTrace;
import org.phrenic.breathing.BreathingTraceReader;

/**
 * A named way to breathe, from a YAML file: a kind of pattern and its parameters, which may be changed before it is
 * used.
 *
 * <p>Keys of every kind: {@code name}, {@code kind} (periodic, hold, cough, waxing or trace), and those of
 * {@link BreathingParameters}. Besides these, hold has {@code at} (inspiration or expiration; the latter has no depth
 * of its own), {@code around} (preset of the other breaths), {@code breaths_before}, {@code hold_s},
 * {@code creep_fraction}; cough has {@code compression_s}, {@code expulsion_s}, {@code abdominal_pressure}; waxing has
 * {@code breaths}, {@code apnoea_s}; trace has {@code file} (beside the YAML file), {@code detrend} and {@code loop}
 * (true or false).
 */
public final class BreathingPreset {
    private static final List<String> NAMES = List.of(
            "quiet",
            "quiet-supine",
            "deep",
            "hold-inspiration",
            "hold-expiration",
            "sniff",
            "cough",
            "rapid-shallow",
            "cheyne-stokes");

    private final String name;
    private final BreathingParameters parameters;
    private final Function<BreathingParameters, BreathingPattern> kind;

    private BreathingPreset(
            String name, BreathingParameters parameters, Function<BreathingParameters, BreathingPattern> kind) {
        this.name = name;
        this.parameters = parameters;
        this.kind = kind;
    }

    /** Names of the presets that come with the program. */
    public static List<String> names() {
        return NAMES;
    }

    /**
     * A preset that comes with the program.
     *
     * @throws IOException if there is none of that name
     */
    public static BreathingPreset named(String name) throws IOException {
        if (!NAMES.contains(name)) {
            throw new IOException("breathing: no preset '" + name + "', expected " + String.join(", ", NAMES));
        }
        try (InputStream in =
                BreathingPreset.class.getResourceAsStream("/org/phrenic/data/breathing/" + name + ".yaml")) {
            if (in == null) {
                throw new IOException("breathing: preset '" + name + "' is missing from the program");
            }
            return read(new InputStreamReader(in, StandardCharsets.UTF_8), name + ".yaml", null);
        }
    }

    /**
     * Reads a preset from a file.
     *
     * @throws IOException if it cannot be read or a key is missing, unknown or out of range; the message names file and
     *     key
     */
    public static BreathingPreset read(Path file) throws IOException {
        try (Reader reader = Files.newBufferedReader(file)) {
            return read(reader, file.toString(), file.toAbsolutePath().getParent());
        } catch (CharacterCodingException e) {
            throw new IOException(file + ": not text in UTF-8, expected YAML", e);
        }
    }

    static BreathingPreset read(Reader reader, String place, Path folder) throws IOException {
        YamlKeys keys = new YamlKeys(reader, place);
        try {
            String name = keys.text("name");
            BreathingPreset preset = preset(keys, place, name, folder);
            keys.done();
            // What a kind refuses is refused while the file's name is known.
            preset.pattern();
            return preset;
        } catch (IllegalArgumentException e) {
            throw new IOException(place + ": " + e.getMessage(), e);
        }
    }

    private static BreathingPreset preset(YamlKeys keys, String place, String name, Path folder) throws IOException {
        String kind = keys.text("kind");
        return switch (kind) {
            case "periodic" -> new BreathingPreset(name, parameters(keys), p -> new PeriodicPattern(name, p));
            case "cough" -> {
                double compressionS = keys.number("compression_s");
                double expulsionS = keys.number("expulsion_s");
                double pressure = keys.number("abdominal_pressure");
                yield new BreathingPreset(
                        name, parameters(keys), p -> new CoughPattern(name, p, compressionS, expulsionS, pressure));
            }
            case "waxing" -> {
                int breaths = keys.whole("breaths");
                double apnoeaS = keys.number("apnoea_s");
                yield new BreathingPreset(
                        name, parameters(keys), p -> new CheyneStokesPattern(name, p, breaths, apnoeaS));
            }
            case "hold" -> hold(keys, place, name);
            case "trace" -> trace(keys, place, name, folder);
            default ->
                throw new IOException(place + ": kind '" + kind + "', expected periodic, hold, cough, waxing or trace");
        };
    }

    private static BreathingPreset hold(YamlKeys keys, String place, String name) throws IOException {
        String at = keys.text("at");
        BreathingParameters around = named(keys.text("around")).parameters();
        int before = keys.whole("breaths_before");
        double holdS = keys.number("hold_s");
        if (at.equals("expiration")) {
            return new BreathingPreset(name, around, p -> new HoldPattern(name, p, before, null, holdS, 0));
        }
        if (!at.equals("inspiration")) {
            throw new IOException(place + ": at '" + at + "', expected inspiration or expiration");
        }
        double creep = keys.number("creep_fraction");
        return new BreathingPreset(name, parameters(keys), p -> new HoldPattern(name, around, before, p, holdS, creep));
    }

    private static BreathingPreset trace(YamlKeys keys, String place, String name, Path folder) throws IOException {
        if (folder == null) {
            throw new IOException(place + ": kind 'trace', expected one that needs no file beside the program");
        }
        BreathingTrace read = BreathingTraceReader.read(folder.resolve(keys.text("file")));
        BreathingTrace trace = keys.has("detrend") && keys.truth("detrend") ? read.detrended() : read;
        boolean loops = !keys.has("loop") || keys.truth("loop");
        return new BreathingPreset(name, parameters(keys), p -> new TracePattern(trace, p, loops));
    }

    private static BreathingParameters parameters(YamlKeys keys) throws IOException {
        return new BreathingParameters(
                keys.number("rate_per_min"),
                keys.number("inspiratory_fraction"),
                keys.number("pause_fraction"),
                keys.number("activation"),
                keys.number("pressure"),
                keys.number("rib_turn"),
                keys.number("chest_share"));
    }

    /** What to call it. */
    public String name() {
        return name;
    }

    /** Its parameters: of the held breath where a breath is held at inspiration, else of every breath. */
    public BreathingParameters parameters() {
        return parameters;
    }

    /** The pattern as it stands. */
    public BreathingPattern pattern() {
        return pattern(parameters);
    }

    /** The same kind of pattern with other parameters. */
    public BreathingPattern pattern(BreathingParameters changed) {
        return kind.apply(changed);
    }
}
