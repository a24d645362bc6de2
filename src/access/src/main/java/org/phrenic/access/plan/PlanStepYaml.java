package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;

/** YAML format of plan steps: a list of mappings, each with a single key that gives the kind of the step. */
final class PlanStepYaml {
    private static final String WITHDRAW = "withdraw";
    private static final List<String> KINDS =
            List.of("wait", "hold_breath", "place", "redirect", "advance", "sample", WITHDRAW, "image", "probe");
    private static final List<String> MOVE_KEYS = List.of("depth_mm", "speed_mm_per_s", "wait");
    private static final double SPEED_MM_PER_S = 50;
    private static final String AIM = "target";
    private static final String AIM_AT_REST = "target-at-end-expiration";
    private static final String AXIAL = "axial_deg";
    private static final String CRANIAL = "cranial_deg";
    private static final String AFTER_PROGRAM = "after_program";
    private static final String LIFTED = "lifted";
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
                YamlMap map = map(step, kind, List.of("entry", "aim"));
                Optional<double[]> entry = entry(map);
                boolean atRest = entry.isEmpty() && map.text("entry", BEST).equals(BEST_AT_REST);
                yield new PlanStep.Place(place, entry, atRest, aim(map));
            }
            case "redirect" -> new PlanStep.Redirect(place, aim(map(step, kind, List.of("aim"))));
            case "advance" -> {
                YamlMap map = map(step, kind, MOVE_KEYS);
                Optional<Double> depth = map.has("depth_mm") ? Optional.of(map.number("depth_mm")) : Optional.empty();
                yield move(place, depth, map, false);
            }
            case WITHDRAW -> {
                YamlMap map = map(step, kind, MOVE_KEYS);
                yield move(place, Optional.of(map.number("depth_mm", 0)), map, true);
            }
            case "probe" -> probe(step, place);
            case "image" -> new PlanStep.Image(place, ProbeHold.read(step.map(kind)));
            default -> {
                if (!step.text(kind).equals("now")) {
                    throw step.bad(kind, "found '" + step.text(kind) + "', expected 'now'");
                }
                yield new PlanStep.Sample(place);
            }
        };
    }

    private static PlanStep probe(YamlMap step, String place) {
        if (isText(step, "probe")) {
            if (!step.text("probe").equals(LIFTED)) {
                throw step.bad(
                        "probe", "found '" + step.text("probe") + "', expected '" + LIFTED + "' or how it is held");
            }
            return new PlanStep.Probe(place, Optional.empty());
        }
        return new PlanStep.Probe(place, Optional.of(ProbeHold.read(step.map("probe"))));
    }

    private static YamlMap map(YamlMap step, String kind, List<String> keys) {
        YamlMap map = step.map(kind);
        map.requireOnly(keys);
        return map;
    }

    private static PlanStep move(String place, Optional<Double> depthMm, YamlMap map, boolean back) {
        double speed = map.number("speed_mm_per_s", SPEED_MM_PER_S);
        if (!(speed > 0)) {
            throw map.bad("speed_mm_per_s", "found " + speed + ", expected more than 0");
        }
        return new PlanStep.Advance(place, depthMm, speed, map.flag("wait", true), back);
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
        if (isList(map, "entry")) {
            return Optional.of(point(map, "entry"));
        }
        requireChoice(map, "entry", BEST, BEST_AT_REST, "three numbers in mm");
        return Optional.empty();
    }

    /** Refuses what is neither of two names; {@code more} is what else could be stated. */
    private static void requireChoice(YamlMap map, String key, String one, String other, String more) {
        Object value = map.has(key) ? map.toMap().get(key) : one;
        if (!one.equals(value) && !other.equals(value)) {
            String found = value instanceof Map ? "a mapping" : Numbers.quote(String.valueOf(value));
            throw map.bad(key, "found " + found + ", expected '" + one + "', '" + other + "' or " + more);
        }
    }

    private static PlanStep.Aim aim(YamlMap map) {
        if (isMap(map, "aim")) {
            YamlMap angles = map.map("aim");
            angles.requireOnly(List.of(AXIAL, CRANIAL, AFTER_PROGRAM));
            try {
                return PlanStep.Aim.at(
                        new NeedleAngles(angles.number(AXIAL), angles.number(CRANIAL)),
                        angles.flag(AFTER_PROGRAM, false));
            } catch (IllegalArgumentException bad) {
                throw map.bad("aim", bad.getMessage());
            }
        }
        if (isList(map, "aim")) {
            return PlanStep.Aim.at(point(map, "aim"));
        }
        requireChoice(map, "aim", AIM, AIM_AT_REST, "three numbers in mm or two angles");
        return map.text("aim", AIM).equals(AIM) ? PlanStep.Aim.TARGET : PlanStep.Aim.TARGET_AT_REST;
    }

    private static boolean isText(YamlMap map, String key) {
        return map.toMap().get(key) instanceof String;
    }

    private static boolean isList(YamlMap map, String key) {
        return map.toMap().get(key) instanceof List;
    }

    private static boolean isMap(YamlMap map, String key) {
        return map.toMap().get(key) instanceof Map;
    }

    static double[] point(YamlMap map, String key) {
        double[] p = map.numbers(key);
        if (p.length != 3) {
            throw map.bad(key, "found " + p.length + " numbers, expected three: x, y, z in mm, LPS");
        }
        return p;
    }

    /** Converts a step to the format that {@link #read} accepts. */
    static Map<String, Object> toPlain(PlanStep step) {
        if (step instanceof PlanStep.WaitSeconds wait) {
            return Map.of("wait", wait.seconds());
        } else if (step instanceof PlanStep.WaitFor wait) {
            return Map.of("wait", wait.event().text());
        } else if (step instanceof PlanStep.HoldBreath hold) {
            return Map.of("hold_breath", hold.held());
        } else if (step instanceof PlanStep.Place place) {
            Object best = place.atEndExpiration() ? BEST_AT_REST : BEST;
            Object entry = place.entryRest().isPresent() ? place.entryRest().get() : best;
            return Map.of("place", new OrderedValues().with("entry", entry).with("aim", toPlain(place.aim())));
        } else if (step instanceof PlanStep.Redirect redirect) {
            return Map.of("redirect", Map.of("aim", toPlain(redirect.aim())));
        } else if (step instanceof PlanStep.Advance advance) {
            OrderedValues map = new OrderedValues();
            advance.depthMm().ifPresent(depth -> map.put("depth_mm", depth));
            map.put("speed_mm_per_s", advance.speedMmPerS());
            if (!advance.awaited()) {
                map.put("wait", false);
            }
            return Map.of(advance.back() ? WITHDRAW : "advance", map);
        }
        if (step instanceof PlanStep.Probe probe) {
            return Map.of("probe", probe.hold().<Object>map(ProbeHold::toPlain).orElse(LIFTED));
        }
        return step instanceof PlanStep.Image image
                ? Map.of("image", image.probe().toPlain())
                : Map.of("sample", "now");
    }

    private static Object toPlain(PlanStep.Aim aim) {
        if (aim.angles().isPresent()) {
            NeedleAngles angles = aim.angles().get();
            OrderedValues map =
                    new OrderedValues().with(AXIAL, angles.axialDeg()).with(CRANIAL, angles.cranialDeg());
            return aim.afterProgram() ? map.with(AFTER_PROGRAM, true) : map;
        }
        return aim.point().isPresent() ? aim.point().get() : aim.atRest() ? AIM_AT_REST : AIM;
    }
}
