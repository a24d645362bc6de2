package org.phrenic.breathing.pattern;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.breathing.BreathingPattern;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;

/**
 * A named breathing pattern, read from a YAML file: a kind of pattern and its parameters, which may be replaced.
 *
 * <p>Keys of every kind: {@code name}, {@code kind} (periodic, hold, cough or waxing) and those of
 * {@link BreathingParameters}. Further keys by kind:
 *
 * <ul>
 *   <li>hold: {@code at} (inspiration or expiration; the latter has no depth of its own), {@code around} (preset of the
 *       other breaths), {@code breaths_before}, {@code hold_s}, {@code creep_fraction}
 *   <li>cough: {@code compression_s}, {@code expulsion_s}, {@code abdominal_pressure}
 *   <li>waxing: {@code breaths}, {@code apnoea_s}
 * </ul>
 */
public final class BreathingPreset {
    private static final List<String> NAMES = List.of(
            ("quiet quiet-supine deep hold-inspiration hold-expiration sniff" + " cough rapid-shallow cheyne-stokes")
                    .split(" "));

    private final String name;
    private final BreathingParameters parameters;
    private final Kind kind;

    /** Makes a pattern all drives of which are multiplied by a depth, each at most to full. */
    @FunctionalInterface
    private interface Kind {
        BreathingPattern pattern(BreathingParameters parameters, double depth);
    }

    private BreathingPreset(String name, BreathingParameters parameters, Kind kind) {
        this.name = name;
        this.parameters = parameters;
        this.kind = kind;
    }

    /** Names of the built-in presets. */
    public static List<String> names() {
        return NAMES;
    }

    /**
     * Returns a built-in preset.
     *
     * @throws BadInputException if there is no preset of this name
     */
    public static BreathingPreset named(String name) {
        if (!NAMES.contains(name)) {
            throw new BadInputException("breathing: no preset '" + name + "', expected " + String.join(", ", NAMES));
        }
        String file = name + ".yaml";
        return read(ShippedFile.yaml("breathing/" + file), file);
    }

    static BreathingPreset read(YamlMap yaml, String file) {
        if (yaml.keys().isEmpty()) {
            throw new BadInputException(file + ": no keys, expected lines of 'key: value'");
        }
        try {
            BreathingPreset preset = ofKind(yaml);
            // Build the pattern here, so that its errors are reported with the name of the file.
            preset.pattern();
            return preset;
        } catch (IllegalArgumentException e) {
            throw new BadInputException(file + ": " + e.getMessage(), e);
        }
    }

    private static BreathingPreset ofKind(YamlMap yaml) {
        String name = yaml.text("name");
        String kind = yaml.text("kind");
        return switch (kind) {
            case "periodic" ->
                new BreathingPreset(name, parameters(yaml), (p, depth) -> new PeriodicPattern(p.withDepth(depth)));
            case "cough" -> {
                BreathingParameters parameters = parameters(yaml, "compression_s", "expulsion_s", "abdominal_pressure");
                double compressionS = yaml.number("compression_s");
                double expulsionS = yaml.number("expulsion_s");
                double pressure = yaml.number("abdominal_pressure");
                yield new BreathingPreset(
                        name,
                        parameters,
                        (p, depth) -> new CoughPattern(
                                p.withDepth(depth), compressionS, expulsionS, Math.min(1, depth * pressure)));
            }
            case "waxing" -> {
                BreathingParameters parameters = parameters(yaml, "breaths", "apnoea_s");
                int breaths = yaml.wholeInt("breaths");
                double apnoeaS = yaml.number("apnoea_s");
                yield new BreathingPreset(
                        name, parameters, (p, depth) -> new CheyneStokesPattern(p.withDepth(depth), breaths, apnoeaS));
            }
            case "hold" -> hold(yaml, name);

            default -> throw yaml.bad("kind", "found '" + kind + "', expected periodic, hold, cough or waxing");
        };
    }

    private static BreathingPreset hold(YamlMap yaml, String name) {
        String at = yaml.text("at");
        BreathingParameters around = named(yaml.text("around")).parameters();
        int before = yaml.wholeInt("breaths_before");
        double holdS = yaml.number("hold_s");
        if (at.equals("expiration")) {
            yaml.requireOnly(List.of("name", "kind", "at", "around", "breaths_before", "hold_s"));
            return new BreathingPreset(
                    name, around, (p, depth) -> new HoldPattern(p.withDepth(depth), before, null, holdS, 0));
        }
        if (!at.equals("inspiration")) {
            throw yaml.bad("at", "found '" + at + "', expected inspiration or expiration");
        }
        BreathingParameters held = parameters(yaml, "at", "around", "breaths_before", "hold_s", "creep_fraction");
        double creep = yaml.number("creep_fraction");
        return new BreathingPreset(name, held, (p, depth) -> {
            BreathingParameters others = around.changedAs(held, p).withDepth(depth);
            return new HoldPattern(others, before, p.withDepth(depth), holdS, creep);
        });
    }

    /**
     * Reads the keys of {@link BreathingParameters}. Apart from these, name and kind, only {@code others} are allowed.
     */
    private static BreathingParameters parameters(YamlMap yaml, String... others) {
        List<String> known = new ArrayList<>(List.of("name", "kind"));
        known.addAll(YamlMap.keysOf(BreathingParameters.class));
        known.addAll(List.of(others));
        yaml.requireOnly(known);
        return yaml.bindPart(BreathingParameters.class);
    }

    /** Display name. */
    public String name() {
        return name;
    }

    /** Parameters of the held breath for a hold at inspiration, otherwise of every breath. */
    public BreathingParameters parameters() {
        return parameters;
    }

    /** Creates the pattern with the preset's own parameters. */
    public BreathingPattern pattern() {
        return pattern(parameters);
    }

    /** Creates the pattern with other parameters. */
    public BreathingPattern pattern(BreathingParameters changed) {
        return pattern(changed, 1);
    }

    /**
     * Creates the pattern with other parameters and all drives multiplied by a depth, each at most to full. The breaths
     * around a hold at inspiration change in the same proportion as the held one.
     */
    public BreathingPattern pattern(BreathingParameters changed, double depth) {
        return kind.pattern(changed, depth);
    }
}
