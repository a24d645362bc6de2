package org.phrenic.study.sweep;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.document.Key;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.document.YamlWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Numerics;
import org.phrenic.parameter.ParsedSetting;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.scenario.Settings;

/**
 * A study as its file states it. Immutable.
 *
 * @param title of the report
 * @param model {@code breath}, {@code access} or {@code ishigami}
 * @param scenario of all runs, apart from the factors
 * @param factors that are varied
 * @param design of the points
 * @param responses of a breath; empty for a model that has its own
 * @param series observables that are recorded over time
 */
public record SweepStudy(
        String title,
        String model,
        Scenario scenario,
        List<Factor> factors,
        DesignSpec design,
        List<ResponseSpec> responses,
        List<String> series) {
    /** Columns of the journal before those of the responses. */
    public static final List<String> JOURNAL_COLUMNS = List.of("index", "failure", "wall_s", "state_sha256", "machine");

    /** Column of the journal with the fingerprint of the plan, behind these. */
    public static final String PLAN_COLUMN = "plan_fingerprint";

    private static final List<String> KEYS =
            List.of("title", "model", "scenario", "settings", "cohort", "factors", "design", "responses", "series");
    /** Keys that a model does not read. */
    private static final Map<String, List<String>> UNREAD = Map.of(
            AccessModel.NAME, List.of("responses", "series"),
            IshigamiModel.NAME, List.of("responses", "series", "scenario", "settings"));

    private static final List<String> MODELS = List.of(BreathModel.NAME, AccessModel.NAME, IshigamiModel.NAME);
    private static final Set<String> PATHS = Set.of(RunSettings.ANATOMY.key(), Breathing.TRACE.key());

    /** The cohort of a study file. */
    private record CohortSize(@Key(min = 1, max = 1_000_000) int persons, @Key(absent = "1") long seed) {}

    public SweepStudy {
        factors = List.copyOf(factors);
        responses = List.copyOf(responses);
        series = List.copyOf(series);
    }

    /**
     * Reads a study file. Relative paths in it are resolved against its folder.
     *
     * @throws BadInputException with one sentence that names file, line and key
     */
    public static SweepStudy read(Path file) {
        return of(YamlDocument.read(file), file.toAbsolutePath().getParent(), FileNames.withoutExtension(file), true);
    }

    /** Reads the text of a study whose paths are absolute, such as {@link #resolved}. */
    public static SweepStudy parse(String name, String text) {
        return of(YamlDocument.parse(name, text), Path.of("").toAbsolutePath(), name, true);
    }

    /**
     * As {@link #read}, for a study that is not evaluated: its bodies and recordings may be on another machine.
     *
     * @param text what the file states
     */
    public static SweepStudy parseWithoutBodies(Path file, String text) {
        Path folder = file.toAbsolutePath().getParent();
        return of(YamlDocument.parse(file.toString(), text), folder, FileNames.withoutExtension(file), false);
    }

    /** @param evaluated whether bodies and recordings are needed */
    private static SweepStudy of(YamlMap yaml, Path folder, String title, boolean evaluated) {
        yaml.requireOnly(KEYS);
        String model = yaml.text("model", BreathModel.NAME);
        if (!MODELS.contains(model)) {
            throw yaml.bad("model", "found '" + model + "', expected " + String.join(", ", MODELS));
        }
        DesignSpec design = yaml.map("design").bind(DesignSpec.class).withPoints(folder, SweepStudy::resolved);
        requireRead(yaml, model, design.kind());
        SweepStudy study = new SweepStudy(
                yaml.text("title", title),
                model,
                scenario(yaml, folder, evaluated),
                factors(yaml, design, folder),
                design,
                yaml.has("responses") ? bound(yaml, "responses", ResponseSpec.class) : List.of(),
                yaml.has("series") ? yaml.texts("series") : List.of());
        new StudyCheck(yaml, study, evaluated).require();
        return study;
    }

    /** Refuses what the model and the design do not read. */
    private static void requireRead(YamlMap yaml, String model, DesignSpec.Kind kind) {
        for (String key : UNREAD.getOrDefault(model, List.of())) {
            if (yaml.has(key)) {
                throw yaml.bad(key, "found it with model " + model + ", which does not read it, expected none");
            }
        }
        DesignSpec.requireRead(yaml.map("design"), kind);
        for (YamlMap factor : yaml.has("factors") ? yaml.maps("factors") : List.<YamlMap>of()) {
            boolean listed = factor.has("values");
            if (factor.has("levels") && (listed || kind != DesignSpec.Kind.GRID)) {
                String place = listed ? "with listed values" : "in a design of kind " + kind.label();
                throw factor.bad("levels", "found it " + place + ", expected it at ranges in a grid");
            }
        }
    }

    private static <T> List<T> bound(YamlMap yaml, String key, Class<T> type) {
        return yaml.maps(key).stream().map(map -> map.bind(type)).toList();
    }

    private static Scenario scenario(YamlMap yaml, Path folder, boolean evaluated) {
        Scenario base = yaml.has("scenario")
                ? Scenario.read(ParsedSetting.path(yaml, "scenario", folder))
                : Scenario.defaults();
        YamlMap settings = yaml.mapOrEmpty("settings");
        Settings.requireKeys(settings);
        List<Assignment> assignments = new ArrayList<>();
        for (Setting<?> setting : Settings.all()) {
            if (settings.has(setting.key())) {
                Object value = evaluated ? setting.read(settings, folder) : stated(setting, settings, folder);
                assignments.add(new Assignment("settings", setting, value));
            }
        }
        try {
            return base.stating(assignments);
        } catch (BadInputException refused) {
            throw new BadInputException(
                    yaml.bad("settings", refused.getMessage()).getMessage(), refused);
        }
    }

    /** The value of a setting; a body or a recording by its path, which is not looked up. */
    private static Object stated(Setting<?> setting, YamlMap settings, Path folder) {
        if (!isPath(setting.key()) || isNamed(settings.text(setting.key()))) {
            return setting.read(settings, folder);
        }
        Path path = ParsedSetting.path(settings, setting.key(), folder).normalize();
        return setting == Breathing.TRACE ? Optional.of(path) : path.toString();
    }

    private static List<Factor> factors(YamlMap yaml, DesignSpec design, Path folder) {
        if (design.kind() == DesignSpec.Kind.LIST) {
            for (String key : List.of("factors", "cohort")) {
                if (yaml.has(key)) {
                    throw yaml.bad(key, "found it besides a list, whose columns are the factors, expected none");
                }
            }
            return design.listedFactors();
        }
        List<Factor> factors = new ArrayList<>();
        if (yaml.has("factors") || !yaml.has("cohort")) {
            bound(yaml, "factors", Factor.class).forEach(factor -> factors.add(resolved(factor, folder)));
        }
        if (yaml.has("cohort")) {
            CohortSize size = yaml.map("cohort").bind(CohortSize.class);
            factors.add(Factor.listed(
                    SceneFactors.PERSON,
                    Cohort.shipped().draw(size.persons(), size.seed()).stream()
                            .map(Person::text)
                            .toList()));
        }
        return factors;
    }

    private static Factor resolved(Factor factor, Path folder) {
        return !factor.isListed()
                ? factor
                : Factor.listed(
                        factor.key(),
                        factor.values().stream()
                                .map(value -> resolved(factor.key(), value, folder))
                                .toList());
    }

    /** The value of a factor, with an absolute path if it names a file or a folder. */
    private static String resolved(String key, String value, Path folder) {
        try {
            return isPath(key) && !isNamed(value)
                    ? folder.resolve(value).normalize().toString()
                    : value;
        } catch (InvalidPathException noPath) {
            return value; // which the check of the factor refuses
        }
    }

    /** Whether a body or a recording is one by its name, which is no path. */
    private static boolean isNamed(String value) {
        return RunSettings.VIRTUAL_BODIES.contains(value) || value.equals(Breathing.NO_TRACE);
    }

    /** Whether a setting names a body or a recording, whose file or folder is elsewhere than in the study. */
    static boolean isPath(String key) {
        return PATHS.contains(key);
    }

    /** Column of the journal with the values of a series. */
    public static String seriesColumn(String series) {
        return "series " + series;
    }

    /** Whether a factor states persons. */
    boolean hasPersons() {
        return factors.stream().anyMatch(factor -> factor.key().equals(SceneFactors.PERSON));
    }

    /** A new model of this study. */
    public SweepModel newModel() {
        if (model.equals(IshigamiModel.NAME)) {
            return new IshigamiModel();
        }
        SceneFactors scene = new SceneFactors(scenario, hasPersons());
        return model.equals(AccessModel.NAME) ? new AccessModel(scene) : new BreathModel(scene, responses, series);
    }

    /**
     * The study as the text of a file that depends on no other file but bodies and recordings. Settings that the study
     * leaves open are open in it too, since their defaults may follow a factor. It does not state threads, of which
     * each run has one.
     */
    public String resolved() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("title", title);
        map.put("model", model);
        Map<String, Object> settings = settings();
        if (!settings.isEmpty()) {
            map.put("settings", settings);
        }
        if (design.kind() != DesignSpec.Kind.LIST) {
            map.put("factors", factors.stream().map(Factor::toMap).toList());
        }
        map.put("design", design.toMap());
        if (!responses.isEmpty()) {
            map.put("responses", responses.stream().map(ResponseSpec::toMap).toList());
        }
        if (!series.isEmpty()) {
            map.put("series", series);
        }
        return YamlWriter.format(map);
    }

    private Map<String, Object> settings() {
        if (model.equals(IshigamiModel.NAME)) {
            return Map.of();
        }
        Map<String, Object> settings = scenario.statedMap();
        settings.remove(Numerics.THREADS.key());
        return settings;
    }

    /**
     * What decides the results of a point, as text. Bodies and recordings are there by their names, since each machine
     * may have them in another folder.
     */
    String computed() {
        Map<String, Object> settings = new LinkedHashMap<>(settings());
        PATHS.forEach(key -> settings.computeIfPresent(key, (k, path) -> withoutFolder(k, path.toString())));
        settings.computeIfPresent(RunSettings.CHANGES.key(), (key, text) -> scenario.changes().stream()
                .map(SweepStudy::withoutFolder)
                .toList());
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("model", model);
        map.put("settings", settings);
        map.put("responses", responses.stream().map(ResponseSpec::toMap).toList());
        map.put("series", series);
        return YamlWriter.format(map);
    }

    /** The value of a factor or setting; a body or a recording by the name of its file or folder. */
    static String withoutFolder(String key, String value) {
        return isPath(key) && !isNamed(value) ? value.substring(folderLength(value)) : value;
    }

    /** A scheduled change, {@code STEP:key=value}. */
    private static String withoutFolder(ScheduledChange change) {
        Assignment made = change.assignment();
        return change.step() + ":" + made.key() + "=" + withoutFolder(made.key(), made.text());
    }

    /** Characters before the name in a path of any system. */
    private static int folderLength(String path) {
        return Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1;
    }
}
