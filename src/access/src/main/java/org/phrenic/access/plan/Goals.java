package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.attempt.AttemptEvent;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlMap;

/**
 * Goals of an exercise: whether the target must be hit, and upper limits of measures. The limits are chosen for
 * teaching and are not validated.
 *
 * @param limits upper limit of each measure, by key
 */
public record Goals(boolean hit, Map<String, Double> limits) {
    private static final String HIT = "hit";
    private static final String NO_SAMPLE = "no sample";

    /**
     * What a goal limits.
     *
     * @param byCore whether the throw of a core, which takes no time, counts against a limit of 0
     */
    private record Measure(String label, ToDoubleFunction<AttemptRecord> of, Predicate<AttemptRecord> byCore) {}

    private static final Map<String, Measure> MEASURES = new LinkedHashMap<>();

    static {
        add("attempts_at_most", "skin punctures", r -> r.count(AttemptEvent.Kind.SKIN_PUNCTURE));
        add("redirections_at_most", "redirections", r -> r.count(AttemptEvent.Kind.REDIRECTION));
        add("bone_contacts_at_most", "contacts with bone", r -> r.count(AttemptEvent.Kind.BONE_CONTACT));
        add("lung_s_at_most", "seconds in lung", r -> r.secondsIn().getOrDefault(NoGoZone.LUNG, 0.0), r -> r.zones()
                .byCore()
                .contains(NoGoZone.LUNG));
        add("no_go_s_at_most", "seconds in structures at risk", AttemptRecord::inNoGoS, AttemptRecord::isCoreInNoGo);
        add("inside_s_at_most", "seconds in the body", AttemptRecord::insideS);
        add("capsule_pull_mm_at_most", "capsule pulled aside, mm", AttemptRecord::capsulePullMm);
        add("lateral_mm_at_most", "lateral error, mm", r -> r.decisive()
                .map(TargetingError::lateralMm)
                .orElse(Double.POSITIVE_INFINITY));
    }

    private static void add(String key, String label, ToDoubleFunction<AttemptRecord> of) {
        add(key, label, of, r -> false);
    }

    private static void add(
            String key, String label, ToDoubleFunction<AttemptRecord> of, Predicate<AttemptRecord> byCore) {
        MEASURES.put(key, new Measure(label, of, byCore));
    }

    /**
     * A goal with its limit, the value in a record, and whether it is reached.
     *
     * @param byCore whether the throw of a core touched what nothing may touch
     */
    public record GoalResult(String goal, double limit, double value, boolean byCore, boolean reached) {
        /** What was reached, such as "0", "no sample" or "0, and touched by a core". */
        public String reachedText(DoubleFunction<String> number) {
            return Double.isFinite(value) ? number.apply(value) + (byCore ? ", and touched by a core" : "") : NO_SAMPLE;
        }

        /** Display name, such as "seconds in lung, at most". */
        public String label() {
            return goal.equals(HIT) ? "target hit (1) or not (0)" : measure() + ", at most";
        }

        /** What is measured, such as "seconds in lung". */
        public String measure() {
            return goal.equals(HIT) ? "target hit" : MEASURES.get(goal).label;
        }

        Map<String, Object> toMap() {
            OrderedValues map = new OrderedValues()
                    .with("goal", goal)
                    .with("limit", limit)
                    .with("value", Double.isFinite(value) ? (Object) value : NO_SAMPLE);
            if (byCore) {
                map.put("touched_by_core", true);
            }
            return map.with("reached", reached);
        }
    }

    public static Goals none() {
        return new Goals(false, Map.of());
    }

    /**
     * Reads goals.
     *
     * @throws org.phrenic.file.BadInputException for an unknown key
     */
    static Goals read(YamlMap yaml) {
        yaml.requireOnly(
                Stream.concat(Stream.of(HIT), MEASURES.keySet().stream()).toList());
        Map<String, Double> limits = new LinkedHashMap<>();
        for (String key : MEASURES.keySet()) {
            if (yaml.has(key)) {
                double limit = yaml.number(key);
                if (limit < 0) {
                    throw yaml.bad(key, "found " + yaml.text(key) + ", expected 0 or more");
                }
                limits.put(key, limit);
            }
        }
        return new Goals(yaml.flag(HIT, false), limits);
    }

    /** Values in the format that {@link #read} accepts. */
    Map<String, Object> toMap() {
        OrderedValues map = new OrderedValues();
        if (hit) {
            map.put(HIT, true);
        }
        map.putAll(limits);
        return map;
    }

    /** Text for each goal, such as "skin punctures: at most 1" or "seconds in lung: none". */
    public List<String> describe() {
        List<String> words = new ArrayList<>();
        if (hit) {
            words.add("the target is hit");
        }
        limits.forEach((key, limit) -> words.add(MEASURES.get(key).label
                + (limit == 0
                        ? ": none"
                        : ": at most " + (limit == Math.rint(limit) ? "" + Math.round(limit) : "" + limit))));
        return words;
    }

    public List<GoalResult> evaluate(AttemptRecord record) {
        List<GoalResult> all = new ArrayList<>();
        if (hit) {
            all.add(new GoalResult(HIT, 1, record.hit() ? 1 : 0, false, record.hit()));
        }
        limits.forEach((key, limit) -> {
            Measure measure = MEASURES.get(key);
            double value = measure.of.applyAsDouble(record);
            boolean byCore = limit == 0 && measure.byCore.test(record);
            all.add(new GoalResult(key, limit, value, byCore, value <= limit && !byCore));
        });
        return all;
    }

    /** Whether all goals are reached; true if there are none. */
    public boolean reached(AttemptRecord record) {
        return evaluate(record).stream().allMatch(GoalResult::reached);
    }
}
