package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;

/** Reads the steps of a plan: a list of mappings, each with one key that says what is done. */
final class PlanStepYaml {
    private static final List<String> KINDS =
            List.of("wait", "hold_breath", "place", "redirect", "advance", "sample", "withdraw");
    private static final List<String> MOVE_KEYS = List.of("depth_mm", "speed_mm_per_s", "wait");
    private static final double SPEED_MM_PER_S = 50;
    private static final String AIM = "target";
    private static final String AIM_AT_REST = "target-at-end-expiration";
    private static final String BEST = "best";
    private static final String BEST_AT_REST = "best-at-end-expiration";

    private PlanStepYaml() {}

    static List<PlanStep> read(List<YamlMap> steps, String file) {
        List<PlanStep> all = new ArrayList<>();
        for (YamlMap step : steps) {
            step.requireOnly(KINDS);
            int number = all.size() + 1;
            if (step.keys().size() != 1) {
                throw new BadInputException(file + ": steps, step " + number + ": found "
                        + step.keys().size() + " keys, expected one of " + String.join(", ", KINDS));
            }
            String kind = step.keys().iterator().next();
            all.add(step(step, kind, file + ": step " + number + ", " + kind));
        }
        return List.copyOf(all);
    }

    private static PlanStep step(YamlMap step, String kind, String place) {
        return switch (kind) {
            case "wait" -> wait(step, place);
            case "hold_breath" -> new PlanStep.HoldBreath(place, step.flag(kind));
            case "place" -> {
                YamlMap map = step.map(kind);
                map.requireOnly(List.of("entry", "aim"));
                Optional<double[]> entry = entry(map);
                boolean atRest = entry.isEmpty() && map.text("entry", BEST).equals(BEST_AT_REST);
                yield new PlanStep.Place(place, entry, atRest, aim(map));
            }
            case "redirect" -> {
                YamlMap map = step.map(kind);
                map.requireOnly(List.of("aim"));
                yield new PlanStep.Redirect(place, aim(map));
            }
            case "advance" -> {
                YamlMap map = step.map(kind);
                map.requireOnly(MOVE_KEYS);
                Optional<Double> depth = map.has("depth_mm") ? Optional.of(map.number("depth_mm")) : Optional.empty();
                yield new PlanStep.Advance(place, depth, speed(map), map.flag("wait", true));
            }
            case "withdraw" -> {
                YamlMap map = step.map(kind);
                map.requireOnly(MOVE_KEYS);
                yield new PlanStep.Advance(
                        place, Optional.of(map.number("depth_mm", 0)), speed(map), map.flag("wait", true));
            }
            default -> {
                if (!step.text(kind).equals("now")) {
                    throw step.bad(kind, "found '" + step.text(kind) + "', expected 'now'");
                }
                yield new PlanStep.Sample(place);
            }
        };
    }

    /** Plain values of steps, as {@link #read} takes them. */
    static List<Map<String, Object>> toPlain(List<PlanStep> steps) {
        return steps.stream().map(PlanStepYaml::toPlain).toList();
    }

    private static Map<String, Object> toPlain(PlanStep step) {
        if (step instanceof PlanStep.WaitSeconds wait) {
            return Map.of("wait", wait.seconds());
        } else if (step instanceof PlanStep.WaitFor wait) {
            return Map.of("wait", wait.event().text());
        } else if (step instanceof PlanStep.HoldBreath hold) {
            return Map.of("hold_breath", hold.held());
        } else if (step instanceof PlanStep.Place place) {
            Map<String, Object> map = new LinkedHashMap<>();
            map.put(
                    "entry",
                    place.entryRest().isPresent()
                            ? place.entryRest().get()
                            : place.atEndExpiration() ? BEST_AT_REST : BEST);
            map.put("aim", toPlain(place.aim()));
            return Map.of("place", map);
        } else if (step instanceof PlanStep.Redirect redirect) {
            return Map.of("redirect", Map.of("aim", toPlain(redirect.aim())));
        } else if (step instanceof PlanStep.Advance advance) {
            Map<String, Object> map = new LinkedHashMap<>();
            advance.depthMm().ifPresent(depth -> map.put("depth_mm", depth));
            map.put("speed_mm_per_s", advance.speedMmPerS());
            if (!advance.awaited()) {
                map.put("wait", false);
            }
            return Map.of("advance", map);
        }
        return Map.of("sample", "now");
    }

    private static Object toPlain(PlanStep.Aim aim) {
        return aim.point().isPresent() ? aim.point().get() : aim.atRest() ? AIM_AT_REST : AIM;
    }

    private static PlanStep wait(YamlMap step, String place) {
        if (step.isNumber("wait")) {
            double seconds = step.number("wait");
            if (!(seconds >= 0)) {
                throw step.bad("wait", "found " + seconds + " s, expected 0 or more");
            }
            return new PlanStep.WaitSeconds(place, seconds);
        }
        try {
            return new PlanStep.WaitFor(place, BreathEvent.parse(step.text("wait")));
        } catch (IllegalArgumentException none) {
            throw step.bad("wait", none.getMessage());
        }
    }

    private static Optional<double[]> entry(YamlMap map) {
        if (isText(map, "entry") && !List.of(BEST, BEST_AT_REST).contains(map.text("entry"))) {
            throw map.bad(
                    "entry",
                    "found '" + map.text("entry") + "', expected '" + BEST + "', '" + BEST_AT_REST
                            + "' or three numbers in mm");
        }
        return isText(map, "entry") ? Optional.empty() : Optional.of(point(map, "entry"));
    }

    private static PlanStep.Aim aim(YamlMap map) {
        if (!map.has("aim")) {
            return new PlanStep.Aim(Optional.empty(), false);
        }
        if (!isText(map, "aim")) {
            return new PlanStep.Aim(Optional.of(point(map, "aim")), false);
        }
        return switch (map.text("aim")) {
            case AIM -> new PlanStep.Aim(Optional.empty(), false);
            case AIM_AT_REST -> new PlanStep.Aim(Optional.empty(), true);
            default ->
                throw map.bad(
                        "aim",
                        "found '" + map.text("aim")
                                + "', expected 'target', 'target-at-end-expiration' or three numbers in mm");
        };
    }

    private static boolean isText(YamlMap map, String key) {
        return map.toMap().get(key) instanceof String;
    }

    private static double speed(YamlMap map) {
        double speed = map.number("speed_mm_per_s", SPEED_MM_PER_S);
        if (!(speed > 0)) {
            throw map.bad("speed_mm_per_s", "found " + speed + ", expected more than 0");
        }
        return speed;
    }

    /** Three numbers. */
    static double[] point(YamlMap map, String key) {
        double[] p = map.numbers(key);
        if (p.length != 3) {
            throw map.bad(key, "found " + p.length + " numbers, expected three: x, y, z in mm, LPS");
        }
        return p;
    }
}
