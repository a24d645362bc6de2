package org.phrenic.access.plan;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * A planned attempt: body and breathing, target, needle, and what is done in which order. Read from YAML; unknown keys
 * are errors.
 *
 * @param title what it is
 * @param description for whom and why, in a sentence or two; may be empty
 * @param difficulty easy, medium or hard; empty where it is not said
 * @param scenario body and breathing
 * @param targetRestMm middle of the target at end-expiration; empty for one at random
 * @param seed of a target at random
 * @param diameterMm of the target; NaN, with a seed, for one drawn as lesions are
 * @param avoided what counts as no-go
 * @param moments moments of the breath for access map and path
 * @param timeoutS simulated time after which what is waited for counts as never reached
 * @param goals what counts as done
 * @param steps what is done
 * @param file that it was read from, for messages
 */
public record RehearsalPlan(
        String title,
        String description,
        String difficulty,
        Scenario scenario,
        Optional<double[]> targetRestMm,
        OptionalLong seed,
        double diameterMm,
        Needle needle,
        Set<NoGoZone> avoided,
        int moments,
        double timeoutS,
        Goals goals,
        List<PlanStep> steps,
        String file) {
    private static final List<String> KEYS = List.of(
            "title",
            "description",
            "difficulty",
            "scenario",
            "set",
            "target",
            "needle",
            "avoid",
            "phases",
            "give_up_after_s",
            "done_when",
            "steps");
    private static final List<String> DIFFICULTIES = List.of("easy", "medium", "hard");
    private static final List<String> SHIPPED =
            List.of("1-large-target.yaml", "2-dome-target.yaml", "3-held-breath.yaml");
    private static final List<String> TARGET_KEYS = List.of("rest_mm", "seed", "diameter_mm");
    private static final List<String> NEEDLE_KEYS = List.of("gauge", "length_mm");
    private static final int MOST_PHASES = 100;
    private static final double GIVE_UP_S = 60;

    /**
     * Reads a plan. Paths in it are taken from its folder.
     *
     * @throws BadInputException with one sentence that names file, line and key
     */
    public static RehearsalPlan read(Path file) {
        return of(YamlDocument.read(file), file);
    }

    /** The exercises that come with the program, from easy to hard. */
    public static List<RehearsalPlan> exercises() {
        return SHIPPED.stream().map(RehearsalPlan::shipped).toList();
    }

    /** The same on another body or breath: with keys of a scenario, as {@code key=value}, set over its own. */
    public RehearsalPlan with(List<String> set) {
        return new RehearsalPlan(
                title,
                description,
                difficulty,
                scenario.with(set.toArray(String[]::new)),
                targetRestMm,
                seed,
                diameterMm,
                needle,
                avoided,
                moments,
                timeoutS,
                goals,
                steps,
                file);
    }

    private static RehearsalPlan shipped(String name) {
        try (InputStream in = RehearsalPlan.class.getResourceAsStream("/org/phrenic/data/exercises/" + name)) {
            if (in == null) {
                throw new IllegalStateException("the exercise " + name + " is missing from the program");
            }
            return of(YamlDocument.read(name, in), Path.of(name));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static RehearsalPlan of(YamlMap yaml, Path file) {
        yaml.requireOnly(KEYS);
        YamlMap target = yaml.map("target");
        target.requireOnly(TARGET_KEYS);
        if (target.has("rest_mm") == target.has("seed")) {
            throw yaml.bad(
                    "target",
                    "found " + (target.has("seed") ? "both" : "neither")
                            + " of rest_mm and seed, expected one of them");
        }
        if (target.has("rest_mm") && !target.has("diameter_mm")) {
            throw yaml.bad("target", "found no diameter_mm, expected one, in mm");
        }
        return new RehearsalPlan(
                yaml.text("title", file.getFileName().toString().replaceFirst("\\.[^.]*$", "")),
                yaml.text("description", ""),
                difficulty(yaml),
                scenario(yaml, file),
                target.has("rest_mm") ? Optional.of(PlanStepYaml.point(target, "rest_mm")) : Optional.empty(),
                target.has("seed") ? OptionalLong.of(target.integer("seed")) : OptionalLong.empty(),
                target.number("diameter_mm", Double.NaN),
                needle(yaml),
                avoided(yaml),
                (int) within(yaml, "phases", (double) yaml.integer("phases", BreathCycle.PHASES), 2, MOST_PHASES),
                within(yaml, "give_up_after_s", yaml.number("give_up_after_s", GIVE_UP_S), 1, 3600),
                Goals.read(yaml.mapOrEmpty("done_when")),
                yaml.has("steps") ? PlanStepYaml.read(yaml.maps("steps"), file.toString()) : List.of(),
                file.toString());
    }

    private static String difficulty(YamlMap yaml) {
        String difficulty = yaml.text("difficulty", "");
        if (!difficulty.isEmpty() && !DIFFICULTIES.contains(difficulty)) {
            throw yaml.bad("difficulty", "found '" + difficulty + "', expected " + String.join(", ", DIFFICULTIES));
        }
        return difficulty;
    }

    private static double within(YamlMap yaml, String key, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw yaml.bad(key, "found " + value + ", expected " + low + " to " + high);
        }
        return value;
    }

    private static Scenario scenario(YamlMap yaml, Path file) {
        Path folder = file.toAbsolutePath().getParent();
        Scenario base =
                yaml.has("scenario") ? Scenario.read(folder.resolve(yaml.text("scenario"))) : Scenario.defaults();
        YamlMap set = yaml.mapOrEmpty("set");
        List<Assignment> assignments = new ArrayList<>();
        for (String key : set.keys()) {
            assignments.add(Assignment.read(file + ": set " + key, key, set.text(key)));
        }
        return base.with(assignments);
    }

    private static Needle needle(YamlMap yaml) {
        YamlMap needle = yaml.mapOrEmpty("needle");
        needle.requireOnly(NEEDLE_KEYS);
        Needle usual = Needle.standard();
        try {
            return new Needle(
                    (int) needle.integer("gauge", usual.gauge()), needle.number("length_mm", usual.lengthMm()));
        } catch (IllegalArgumentException none) {
            throw yaml.bad("needle", none.getMessage());
        }
    }

    private static Set<NoGoZone> avoided(YamlMap yaml) {
        if (!yaml.has("avoid")) {
            return NoGoZone.defaults();
        }
        Set<NoGoZone> avoided = EnumSet.noneOf(NoGoZone.class);
        for (String name : yaml.texts("avoid")) {
            avoided.add(Arrays.stream(NoGoZone.values())
                    .filter(one -> one.key().equals(name))
                    .findFirst()
                    .orElseThrow(() -> yaml.bad(
                            "avoid",
                            "found '" + name + "', expected "
                                    + Arrays.stream(NoGoZone.values())
                                            .map(NoGoZone::key)
                                            .collect(Collectors.joining(", ")))));
        }
        return avoided;
    }

    /** The same with other steps and a target at a place: what was done by hand. */
    RehearsalPlan withSteps(TargetLesion target, List<PlanStep> done, double lastS) {
        return new RehearsalPlan(
                title,
                description,
                difficulty,
                scenario,
                Optional.of(target.restMm()),
                OptionalLong.empty(),
                target.diameterMm(),
                needle,
                avoided,
                moments,
                Math.max(timeoutS, Math.ceil(lastS + 1)),
                goals,
                List.copyOf(done),
                file);
    }

    /**
     * Plain values of a plan with a target at a place, as {@link #read} takes them.
     *
     * @param scenarioFile where the scenario lies, from the folder of the plan
     */
    public Map<String, Object> toMap(String scenarioFile) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("title", title);
        map.put("description", description);
        if (!difficulty.isEmpty()) {
            map.put("difficulty", difficulty);
        }
        map.put("scenario", scenarioFile);
        Map<String, Object> target = new LinkedHashMap<>();
        targetRestMm.ifPresent(at -> target.put("rest_mm", at));
        seed.ifPresent(number -> target.put("seed", number));
        if (!Double.isNaN(diameterMm)) {
            target.put("diameter_mm", diameterMm);
        }
        map.put("target", target);
        Map<String, Object> used = new LinkedHashMap<>();
        used.put("gauge", needle.gauge());
        used.put("length_mm", needle.lengthMm());
        map.put("needle", used);
        map.put("avoid", avoided.stream().sorted().map(NoGoZone::key).toList());
        map.put("phases", moments);
        map.put("give_up_after_s", timeoutS);
        map.put("done_when", goals.toMap());
        map.put("steps", PlanStepYaml.toPlain(steps));
        return map;
    }

    /**
     * A plan without steps: practice on a body as it breathes now.
     *
     * @param scenario body and breathing
     * @param target where it is
     */
    public static RehearsalPlan practice(Scenario scenario, TargetLesion target, Needle needle) {
        return new RehearsalPlan(
                "Practice",
                "A target and an entry of one's own choice.",
                "",
                scenario,
                Optional.of(target.restMm()),
                OptionalLong.empty(),
                target.diameterMm(),
                needle,
                NoGoZone.defaults(),
                BreathCycle.PHASES,
                GIVE_UP_S,
                Goals.none(),
                List.of(),
                "practice");
    }

    /** The target in a body. */
    public TargetLesion target(MovingAnatomy scene) {
        try {
            return targetRestMm.isPresent()
                    ? TargetLesion.at(scene, targetRestMm.get(), diameterMm)
                    : TargetLesion.random(scene, seed.getAsLong(), diameterMm);
        } catch (BadInputException bad) {
            throw new BadInputException(file + ": " + bad.getMessage(), bad);
        }
    }
}
