package org.phrenic.access.plan;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.phrenic.access.BreathCycle;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.ScannedLesion;
import org.phrenic.access.TargetLesion;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/**
 * A planned attempt: body, breathing, target, needle and steps. Plans are read from YAML; unknown keys are errors.
 *
 * @param description audience and purpose in one or two sentences; may be empty
 * @param difficulty easy, medium or hard; may be empty
 * @param targetSpec target, given by position, as a lesion of the body or chosen at random
 * @param avoided zones to avoid
 * @param moments number of moments of the breath for the access map and the path
 * @param timeoutS simulated time after which a step fails, s
 * @param aids what a window shows
 * @param file file that the plan was read from, for messages
 */
public record RehearsalPlan(
        String title,
        String description,
        String difficulty,
        Scenario scenario,
        TargetSpec targetSpec,
        Needle needle,
        Set<NoGoZone> avoided,
        int moments,
        double timeoutS,
        Goals goals,
        Aids aids,
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
            "aids",
            "steps");
    /** Key of a scenario that a plan does not have. */
    private static final String CHANGES = "changes";

    private static final List<String> DIFFICULTIES = List.of("easy", "medium", "hard");
    private static final List<String> EXERCISES = List.of(
            "1-large-target.yaml",
            "2-dome-target.yaml",
            "3-held-breath.yaml",
            "4-left-lobe.yaml",
            "5-segment-five.yaml",
            "6-between-gall-bladder-and-kidney.yaml",
            "7-held-or-free.yaml",
            "8-high-colon.yaml",
            "9-small-moving.yaml");
    private static final int MAX_MOMENTS = 100;
    private static final double TIMEOUT_S = 60;
    /** More simulated time than any attempt takes, by hand over days too, s. */
    private static final double MAX_TIMEOUT_S = 1e6;

    /** Time in which a patient follows a breathing command, s. */
    private static final double REACTION_S = 0.4;

    /**
     * Specification of a target: a position, a seed for a random one, or a lesion that the body shows.
     *
     * @param restMm centre at end-expiration, LPS, mm
     * @param seed seed of a random position
     * @param lesion name of a {@link ScannedLesion}
     * @param diameterMm diameter, mm; NaN for a random one with a seed, and for its own with a lesion
     */
    public record TargetSpec(Optional<double[]> restMm, OptionalLong seed, Optional<String> lesion, double diameterMm) {
        private static TargetSpec of(TargetLesion target) {
            return new TargetSpec(
                    Optional.of(target.restMm()), OptionalLong.empty(), Optional.empty(), target.diameterMm());
        }

        private TargetLesion on(MovingAnatomy anatomy) {
            if (seed.isPresent()) {
                return TargetLesion.random(anatomy, seed.getAsLong(), diameterMm);
            }
            if (restMm.isPresent()) {
                return TargetLesion.at(anatomy, restMm.get(), diameterMm);
            }
            TargetLesion shown =
                    ScannedLesion.named(anatomy, lesion.orElseThrow()).target();
            return Double.isNaN(diameterMm) ? shown : TargetLesion.at(anatomy, shown.restMm(), diameterMm);
        }

        private OrderedValues toMap() {
            OrderedValues map = new OrderedValues();
            restMm.ifPresent(at -> map.put("rest_mm", at));
            seed.ifPresent(number -> map.put("seed", number));
            lesion.ifPresent(name -> map.put("lesion", name));
            if (!Double.isNaN(diameterMm)) {
                map.put("diameter_mm", diameterMm);
            }
            return map;
        }
    }

    /**
     * Reads a plan. Relative paths are resolved against the folder of the plan.
     *
     * @throws BadInputException if the plan is invalid; the message names file, line and key
     */
    public static RehearsalPlan read(Path file) {
        return of(YamlDocument.read(file), file);
    }

    /** The built-in exercises, in the order of their numbers. */
    public static List<RehearsalPlan> exercises() {
        return EXERCISES.stream().map(RehearsalPlan::exercise).toList();
    }

    private static RehearsalPlan exercise(String name) {
        return of(ShippedFile.yaml("exercises/" + name), Path.of(name));
    }

    /** Returns a plan without steps, for free practice with a breath recorded at so many moments. */
    public static RehearsalPlan practice(Scenario scenario, TargetLesion target, Needle needle, int moments) {
        return new RehearsalPlan(
                "Practice",
                "A target and an entry of one's own choice.",
                "",
                scenario,
                TargetSpec.of(target),
                needle,
                NoGoZone.defaults(),
                moments,
                TIMEOUT_S,
                Goals.none(),
                Aids.SEE_THROUGH,
                List.of(),
                "practice");
    }

    private static RehearsalPlan of(YamlMap yaml, Path file) {
        yaml.requireOnly(KEYS);
        return new RehearsalPlan(
                yaml.text("title", FileNames.withoutExtension(file)),
                yaml.text("description", ""),
                difficulty(yaml),
                scenario(yaml, file),
                target(yaml),
                needle(yaml),
                avoided(yaml),
                (int) within(yaml, "phases", (double) yaml.integer("phases", BreathCycle.PHASES), 2, MAX_MOMENTS),
                within(yaml, "give_up_after_s", yaml.number("give_up_after_s", TIMEOUT_S), 1, MAX_TIMEOUT_S),
                Goals.read(yaml.mapOrEmpty("done_when")),
                aids(yaml),
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

    private static Aids aids(YamlMap yaml) {
        String key = yaml.text("aids", Aids.SEE_THROUGH.key());
        return Aids.of(key).orElseThrow(() -> yaml.bad("aids", "found '" + key + "', expected " + Aids.keys()));
    }

    private static TargetSpec target(YamlMap yaml) {
        YamlMap target = yaml.map("target");
        List<String> places = List.of("rest_mm", "seed", "lesion");
        target.requireOnly(List.of("rest_mm", "seed", "lesion", "diameter_mm"));
        long given = places.stream().filter(target::has).count();
        if (given != 1) {
            String found = given == 0 ? "none" : String.valueOf(given);
            throw yaml.bad("target", "found " + found + " of rest_mm, seed and lesion, expected one of them");
        }
        if (target.has("rest_mm") && !target.has("diameter_mm")) {
            throw yaml.bad("target", "found no diameter_mm, expected one, in mm");
        }
        return new TargetSpec(
                target.has("rest_mm") ? Optional.of(PlanStepYaml.point(target, "rest_mm")) : Optional.empty(),
                target.has("seed") ? OptionalLong.of(target.integer("seed")) : OptionalLong.empty(),
                target.has("lesion") ? Optional.of(target.text("lesion")) : Optional.empty(),
                target.number("diameter_mm", Double.NaN));
    }

    private static double within(YamlMap yaml, String key, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw yaml.bad(key, "found " + value + ", expected " + low + " to " + high);
        }
        return value;
    }

    private static Scenario scenario(YamlMap yaml, Path file) {
        Path folder = file.toAbsolutePath().getParent();
        Scenario base = yaml.has("scenario") ? Scenario.read(yaml.file("scenario", folder)) : Scenario.defaults();
        YamlMap set = yaml.mapOrEmpty("set");
        if (set.has(CHANGES) || !base.changes().isEmpty()) {
            throw yaml.bad(
                    set.has(CHANGES) ? "set" : "scenario",
                    "found changes of the scenario, expected none: a plan holds the breath by its steps");
        }
        Scenario repeating = base.states(Breathing.REPEAT)
                ? base
                : base.with(List.of(Assignment.of(file.toString(), Breathing.REPEAT, true)));
        return repeating.with(set.keys().stream()
                .map(key -> Assignment.read(file + ": set " + key, key, set.text(key), folder))
                .toList());
    }

    private static Needle needle(YamlMap yaml) {
        YamlMap needle = yaml.mapOrEmpty("needle");
        needle.requireOnly(List.of("gauge", "length_mm", "core_mm"));
        Needle standard = Needle.standard();
        try {
            return new Needle(
                    needle.has("gauge") ? needle.wholeInt("gauge") : standard.gauge(),
                    needle.number("length_mm", standard.lengthMm()),
                    needle.number("core_mm", 0));
        } catch (IllegalArgumentException none) {
            throw yaml.bad("needle", none.getMessage());
        }
    }

    private static Set<NoGoZone> avoided(YamlMap yaml) {
        if (!yaml.has("avoid")) {
            return NoGoZone.defaults();
        }
        List<String> known = Arrays.stream(NoGoZone.values()).map(NoGoZone::key).toList();
        Set<NoGoZone> avoided = EnumSet.noneOf(NoGoZone.class);
        for (String name : yaml.texts("avoid")) {
            if (!known.contains(name)) {
                throw yaml.bad("avoid", "found '" + name + "', expected " + String.join(", ", known));
            }
            avoided.add(NoGoZone.values()[known.indexOf(name)]);
        }
        return avoided;
    }

    /** Returns a copy with scenario values replaced, each given as {@code key=value}. */
    public RehearsalPlan with(List<String> set) {
        return copy(scenario.with(set.toArray(String[]::new)), targetSpec, timeoutS, aids, steps);
    }

    /** Returns a copy with other aids. */
    public RehearsalPlan with(Aids shown) {
        return copy(scenario, targetSpec, timeoutS, shown, steps);
    }

    /** Returns a copy with a target at a fixed position and other steps, which last until {@code lastS}. */
    public RehearsalPlan withSteps(TargetLesion target, List<PlanStep> other, double lastS) {
        return copy(
                scenario, TargetSpec.of(target), Math.max(timeoutS, Math.ceil(lastS + 1)), aids, List.copyOf(other));
    }

    private RehearsalPlan copy(Scenario breath, TargetSpec lesion, double limitS, Aids shown, List<PlanStep> done) {
        return new RehearsalPlan(
                title,
                description,
                difficulty,
                breath,
                lesion,
                needle,
                avoided,
                moments,
                limitS,
                goals,
                shown,
                done,
                file);
    }

    /**
     * Values of the plan in the format that {@link #read} accepts.
     *
     * @param scenarioFile scenario file, relative to the folder of the plan
     */
    public Map<String, Object> toMap(String scenarioFile) {
        OrderedValues map = new OrderedValues().with("title", title).with("description", description);
        if (!difficulty.isEmpty()) {
            map.put("difficulty", difficulty);
        }
        OrderedValues tube = new OrderedValues().with("gauge", needle.gauge()).with("length_mm", needle.lengthMm());
        if (needle.coreMm() > 0) {
            tube.put("core_mm", needle.coreMm());
        }
        return map.with("scenario", scenarioFile)
                .with("target", targetSpec.toMap())
                .with("needle", tube)
                .with("avoid", avoided.stream().sorted().map(NoGoZone::key).toList())
                .with("phases", moments)
                .with("give_up_after_s", timeoutS)
                .with("done_when", goals.toMap())
                .with("aids", aids.key())
                .with("steps", steps.stream().map(PlanStepYaml::toPlain).toList());
    }

    /** Time from a breathing command by hand to the hold, s. */
    public double reactionS() {
        return REACTION_S;
    }

    /** How often the program pointed the needle, in place of a hand or before a hand turned it on. */
    public long aimsByProgram() {
        return steps.stream()
                .filter(step ->
                        (step instanceof PlanStep.Place place && place.aim().byProgram())
                                || (step instanceof PlanStep.Redirect redirect
                                        && redirect.aim().byProgram()))
                .count();
    }

    public TargetLesion target(MovingAnatomy anatomy) {
        try {
            return targetSpec.on(anatomy);
        } catch (BadInputException bad) {
            throw new BadInputException(file + ": " + bad.getMessage(), bad);
        }
    }
}
