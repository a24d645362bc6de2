package org.phrenic.scenario;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.phrenic.anatomy.Resolution;
import org.phrenic.breathing.BreathingTraceReader;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.document.KeySuggestion;
import org.phrenic.document.YamlMap;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.engine.integrator.StepPolicy;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.simulation.organ.LungModel;
import org.phrenic.simulation.organ.SternumModel;
import org.phrenic.simulation.organ.TendonRule;

/** Lays the keys of a YAML mapping over a scenario. */
final class ScenarioReader {
    static final List<String> KEYS = keys();

    private static final double MAX_DURATION_S = 86_400;
    static final double MAX_STEP_S = 0.1;
    static final int MAX_SWEEPS = 100;
    static final double MAX_REFRESH_S = 1;
    static final double MAX_SCALED_STEP_S = 0.01;
    private static final String NO_TRACE = "none";
    private static final int MAX_LINKS = 3;
    private static final long MAX_STEPS = 1_000_000_000_000L;

    private final YamlMap yaml;
    private final Path folder;

    private ScenarioReader(YamlMap yaml, Path folder) {
        this.yaml = yaml;
        this.folder = folder;
    }

    static Scenario read(Scenario base, YamlMap yaml, Path folder, String name) {
        yaml.requireOnly(KEYS);
        return new ScenarioReader(yaml, folder).over(base, name);
    }

    private static List<String> keys() {
        List<String> keys = new ArrayList<>(List.of(
                "name",
                "preset",
                "trace",
                "material",
                "anatomy",
                "resolution",
                "duration_s",
                "time_step_s",
                "integrator",
                "step_policy",
                "projection_sweeps",
                "refresh_s",
                "mass_scaling_s",
                "threads",
                "record_every_s",
                "meshes_every_s",
                "muscle",
                "pressure",
                "ribs",
                "tensegrity",
                "contact",
                "sternum",
                "lungs",
                "liver",
                "links_per_node",
                "tendon",
                "hold",
                "steps",
                "changes"));
        keys.addAll(Parameter.keys());
        return List.copyOf(keys);
    }

    private Scenario over(Scenario base, String name) {
        TissueMaterial material = choice("material", TissueMaterial.values(), ScenarioReader::label, base.material());
        Scenario scenario = new Scenario(
                yaml.text("name", name),
                preset(base.preset()),
                yaml.has("trace") ? trace() : base.trace(),
                material,
                yaml.has("anatomy") ? anatomy() : base.anatomy(),
                choice("resolution", Resolution.values(), ScenarioReader::label, base.resolution()),
                time("duration_s", base.givenDurationS(), MAX_DURATION_S),
                time("time_step_s", base.givenTimeStepS(), MAX_STEP_S),
                yaml.has("integrator")
                        ? Optional.of(
                                choice("integrator", IntegratorKind.values(), IntegratorKind::label, base.integrator()))
                        : base.givenIntegrator(),
                choice("step_policy", StepPolicy.values(), ScenarioReader::label, base.stepPolicy()),
                yaml.has("projection_sweeps")
                        ? whole("projection_sweeps", 1, MAX_SWEEPS)
                        : base.givenProjectionSweeps(),
                time("refresh_s", base.givenRefreshS(), MAX_REFRESH_S),
                time("mass_scaling_s", base.massScalingS(), MAX_SCALED_STEP_S),
                whole("threads", base.threads(), Scenario.MAX_THREADS),
                time("record_every_s", base.recordEveryS(), MAX_DURATION_S),
                meshesEveryS(base.meshesEveryS()),
                yaml.flag("muscle", base.muscle()),
                yaml.flag("pressure", base.pressure()),
                yaml.flag("ribs", base.ribs()),
                yaml.flag("tensegrity", base.tensegrity()),
                yaml.flag("contact", base.contact()),
                choice("sternum", SternumModel.values(), ScenarioReader::label, base.sternum()),
                choice("lungs", LungModel.values(), ScenarioReader::label, base.lungs()),
                yaml.flag("liver", base.liver()),
                whole("links_per_node", base.linksPerNode(), MAX_LINKS),
                choice("tendon", TendonRule.values(), ScenarioReader::label, base.tendon()),
                parameters(base.given(), material),
                yaml.flag("hold", base.hold()),
                steps(base.givenSteps()),
                yaml.has("changes") ? changes() : base.changes());
        requireStepWithinDuration(scenario);
        return scenario.requireValidChanges();
    }

    private long steps(long absent) {
        long value = yaml.integer("steps", absent);
        if (yaml.has("steps") && (value < 0 || value > MAX_STEPS)) {
            throw yaml.bad("steps", "found " + value + ", expected 0 to " + MAX_STEPS);
        }
        return value;
    }

    /** Changes; the paths of their traces are taken from the folder of the file. */
    private List<ScheduledChange> changes() {
        List<ScheduledChange> list = new ArrayList<>();
        for (String text : yaml.texts("changes")) {
            try {
                ScheduledChange change = ScheduledChange.parse(text);
                Assignment set = change.assignment();
                String value = set.key().equals("trace") && !set.value().equals(NO_TRACE)
                        ? path("changes", set.value()).toString()
                        : set.value();
                String origin = yaml.bad("changes", "'" + text + "'").getMessage();
                list.add(new ScheduledChange(change.step(), new Assignment(origin, set.key(), value)));
            } catch (BadInputException e) {
                throw new BadInputException(
                        yaml.bad("changes", e.getMessage().replaceFirst("^--(change|set): ", ""))
                                .getMessage(),
                        e);
            }
        }
        return list;
    }

    private Map<Parameter, Double> parameters(Map<Parameter, Double> below, TissueMaterial material) {
        Map<Parameter, Double> values = new EnumMap<>(Parameter.class);
        values.putAll(below);
        for (Parameter parameter : Parameter.values()) {
            if (yaml.has(parameter.key())) {
                double value = yaml.number(parameter.key());
                parameter.rangeViolation(value).ifPresent(problem -> {
                    throw yaml.bad(parameter.key(), problem);
                });
                values.put(parameter, value);
            }
            if (values.containsKey(parameter) && !parameter.isUsedBy(material)) {
                String problem = "found it with material " + material.label() + ", which does not use it";
                throw yaml.has(parameter.key())
                        ? yaml.bad(
                                parameter.key(), problem + "; expected it with material " + other(material) + " alone")
                        : yaml.bad(
                                "material",
                                "found " + material.label() + ", expected " + other(material) + " beside the key '"
                                        + parameter.key() + "' of the scenario");
            }
        }
        return values;
    }

    private static String other(TissueMaterial material) {
        return (material == TissueMaterial.PHYSICAL ? TissueMaterial.PAPER : TissueMaterial.PHYSICAL).label();
    }

    private String preset(String absent) {
        if (!yaml.has("preset")) {
            return absent;
        }
        String found = yaml.text("preset");
        if (!BreathingPreset.names().contains(found)) {
            throw unknown("preset", found, BreathingPreset.names());
        }
        return found;
    }

    private String anatomy() {
        String found = yaml.text("anatomy");
        if (Scenario.VIRTUAL_BODIES.contains(found)) {
            return found;
        }
        Path path = path("anatomy", found);
        if (!Files.isDirectory(path)) {
            throw yaml.bad(
                    "anatomy",
                    "found no folder '" + found + "', expected " + String.join(", ", Scenario.VIRTUAL_BODIES)
                            + " or a folder of meshes");
        }
        return path.toString();
    }

    private Optional<Path> trace() {
        if (yaml.text("trace").equals(NO_TRACE)) {
            return Optional.empty();
        }
        Path path = path("trace", yaml.text("trace"));
        if (!Files.isRegularFile(path)) {
            throw yaml.bad(
                    "trace", "found no file '" + yaml.text("trace") + "', expected a CSV file of recorded breathing");
        }
        try {
            BreathingTraceReader.read(path);
        } catch (IOException e) {
            throw new BadInputException(e.getMessage(), e);
        }
        return Optional.of(path);
    }

    private Path path(String key, String text) {
        try {
            return folder.resolve(text);
        } catch (InvalidPathException e) {
            throw new BadInputException(
                    yaml.bad(key, "found '" + text + "', expected a path").getMessage(), e);
        }
    }

    private <E> E choice(String key, E[] values, Function<E, String> label, E absent) {
        if (!yaml.has(key)) {
            return absent;
        }
        String found = yaml.text(key);
        List<String> labels = Arrays.stream(values).map(label).toList();
        int index = labels.indexOf(found);
        if (index < 0) {
            throw unknown(key, found, labels);
        }
        return values[index];
    }

    private BadInputException unknown(String key, String found, List<String> known) {
        String hint = KeySuggestion.nearest(found, known)
                .map(near -> " (did you mean '" + near + "'?)")
                .orElse("");
        return yaml.bad(key, "found '" + found + "', expected one of " + String.join(", ", known) + hint);
    }

    private double time(String key, double absent, double most) {
        if (!yaml.has(key)) {
            return absent;
        }
        double value = yaml.number(key);
        if (!(value > 0) || !(value <= most)) {
            throw yaml.bad(
                    key,
                    "found " + Parameter.format(value) + ", expected more than 0, at most " + Parameter.format(most)
                            + " s");
        }
        return value;
    }

    private double meshesEveryS(double absent) {
        return yaml.isNumber("meshes_every_s") && yaml.number("meshes_every_s") == 0
                ? 0
                : time("meshes_every_s", absent, MAX_DURATION_S);
    }

    private int whole(String key, int absent, int most) {
        long value = yaml.integer(key, absent);
        if (value < 1 || value > most) {
            throw yaml.bad(key, "found " + value + ", expected 1 to " + most);
        }
        return (int) value;
    }

    private void requireStepWithinDuration(Scenario scenario) {
        if (scenario.givenDurationS() < scenario.timeStepS()) {
            throw yaml.bad(
                    yaml.has("duration_s") ? "duration_s" : "time_step_s",
                    "found a duration of " + scenario.givenDurationS() + " s with a step of " + scenario.timeStepS()
                            + " s, expected at least one step");
        }
    }

    /** Name of an enum constant in scenario files. */
    static String label(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
