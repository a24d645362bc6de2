package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.attempt.AttemptEvent;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.document.YamlMap;

/**
 * What counts as done in an exercise: whether the target must be hit, and the most of some measures. Chosen for
 * teaching, not validated.
 *
 * @param hit whether a sample must be taken within the target
 * @param limits greatest value of measures by key
 */
public record Goals(boolean hit, Map<String, Double> limits) {
    private static final Map<String, ToDoubleFunction<AttemptRecord>> MEASURES = new LinkedHashMap<>();
    private static final String HIT = "hit";
    private static final Map<String, String> LABELS = Map.of(
            HIT,
            "target hit (1) or not (0)",
            "attempts_at_most",
            "attempts, at most",
            "redirections_at_most",
            "redirections, at most",
            "bone_contacts_at_most",
            "contacts with bone, at most",
            "lung_s_at_most",
            "seconds in lung, at most",
            "no_go_s_at_most",
            "seconds in what is to be avoided, at most",
            "inside_s_at_most",
            "seconds in the body, at most",
            "capsule_pull_mm_at_most",
            "capsule pulled aside, mm, at most",
            "lateral_mm_at_most",
            "lateral error, mm, at most");

    static {
        MEASURES.put("attempts_at_most", r -> r.count(AttemptEvent.Kind.SKIN_PUNCTURE));
        MEASURES.put("redirections_at_most", r -> r.count(AttemptEvent.Kind.REDIRECTION));
        MEASURES.put("bone_contacts_at_most", r -> r.count(AttemptEvent.Kind.BONE_CONTACT));
        MEASURES.put("lung_s_at_most", r -> r.secondsIn().getOrDefault(NoGoZone.LUNG, 0.0));
        MEASURES.put("no_go_s_at_most", AttemptRecord::inNoGoS);
        MEASURES.put("inside_s_at_most", AttemptRecord::insideS);
        MEASURES.put("capsule_pull_mm_at_most", AttemptRecord::capsulePullMm);
        MEASURES.put("lateral_mm_at_most", r -> r.samples().stream()
                .mapToDouble(TargetingError::lateralMm)
                .min()
                .orElse(Double.POSITIVE_INFINITY));
    }

    /** One goal and whether it was reached. */
    public record GoalResult(String goal, double limit, double value, boolean reached) {
        /** The goal in words: "seconds in lung, at most". */
        public String label() {
            return LABELS.get(goal);
        }

        /** Plain values for a report. */
        Map<String, Object> toMap() {
            Map<String, Object> map = new LinkedHashMap<>();
            map.put("goal", goal);
            map.put("limit", limit);
            map.put("value", Double.isFinite(value) ? (Object) value : "no sample");
            map.put("reached", reached);
            return map;
        }
    }

    /** No goals. */
    public static Goals none() {
        return new Goals(false, Map.of());
    }

    /**
     * Reads them.
     *
     * @throws org.phrenic.format.BadInputException with one sentence, for a key that is none
     */
    static Goals read(YamlMap yaml) {
        List<String> known = new ArrayList<>(MEASURES.keySet());
        known.add(0, HIT);
        yaml.requireOnly(known);
        Map<String, Double> most = new LinkedHashMap<>();
        for (String key : MEASURES.keySet()) {
            if (yaml.has(key)) {
                most.put(key, yaml.number(key));
            }
        }
        return new Goals(yaml.flag(HIT, false), most);
    }

    /** Plain values, as {@link #read} takes them. */
    Map<String, Object> toMap() {
        Map<String, Object> map = new LinkedHashMap<>();
        if (hit) {
            map.put(HIT, true);
        }
        map.putAll(limits);
        return map;
    }

    /** What is asked, in words: "attempts: at most 1", "seconds in lung: none". */
    public List<String> describe() {
        List<String> words = new ArrayList<>();
        if (hit) {
            words.add("the target is hit");
        }
        limits.forEach((key, limit) -> words.add(LABELS.get(key).replace(", at most", "")
                + (limit == 0
                        ? ": none"
                        : ": at most " + (limit == Math.rint(limit) ? "" + Math.round(limit) : "" + limit))));
        return words;
    }

    /** Each goal held against a record. */
    public List<GoalResult> evaluate(AttemptRecord record) {
        List<GoalResult> all = new ArrayList<>();
        if (hit) {
            all.add(new GoalResult(HIT, 1, record.hit() ? 1 : 0, record.hit()));
        }
        limits.forEach((key, limit) -> {
            double value = MEASURES.get(key).applyAsDouble(record);
            all.add(new GoalResult(key, limit, value, value <= limit));
        });
        return all;
    }

    /** Whether all are reached; true where there are none. */
    public boolean reached(AttemptRecord record) {
        return evaluate(record).stream().allMatch(GoalResult::reached);
    }
}
