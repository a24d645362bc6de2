package org.phrenic.study.regression;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.Key;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;

/**
 * Exercise of the regression list. It is performed and its report compared with the stored one, value by value.
 *
 * @param name of its reference file
 * @param exercise name of an exercise distributed with the program
 * @param settings that override those of the exercise, as {@code key=value}
 * @param tolerance largest error of a number relative to max(|reference|, 1); words and counts must be equal
 */
record RegressionAttempt(
        String name, String exercise, @Key(absent = "") List<String> settings, @Key(above = 0) double tolerance) {
    /** Compared parts of the report: results only, without the request and without checksums. */
    private static final Set<String> PARTS = Set.of("done", "goals", "attempt", "path", "access");

    private static final String OF = "of";
    private static final String REPORT = "report";

    /** All attempts of a list; empty if it has none. */
    static List<RegressionAttempt> list(YamlMap yaml, List<RegressionScene> scenes) {
        Set<String> names = new HashSet<>();
        scenes.forEach(scene -> names.add(scene.name()));
        List<RegressionAttempt> attempts = new ArrayList<>();
        for (YamlMap map : yaml.has("attempts") ? yaml.maps("attempts") : List.<YamlMap>of()) {
            RegressionAttempt attempt = map.bind(RegressionAttempt.class);
            RegressionScene.requireFileName(map, attempt.name);
            if (!names.add(attempt.name)) {
                throw map.bad("name", "found '" + attempt.name + "' a second time, expected each name once");
            }
            try {
                attempt.plan();
            } catch (BadInputException bad) {
                throw map.bad(
                        "exercise", "found a plan that cannot be (" + bad.getMessage() + "), expected an exercise");
            }
            attempts.add(attempt);
        }
        return attempts;
    }

    /** The simulated scenario. */
    Scenario scenario() {
        return plan().scenario();
    }

    private RehearsalPlan plan() {
        return RehearsalPlan.exercises().stream()
                .filter(plan -> plan.file().equals(exercise + ".yaml"))
                .findFirst()
                .orElseThrow(() -> new BadInputException("found no exercise '" + exercise + "' in the program"))
                .with(settings);
    }

    /** Exercise and settings in one line; references are valid only for the same line. */
    String specification() {
        return String.join(" ", exercise, String.join(" ", settings)).strip();
    }

    /** Performs the exercise on a body and returns the leaf values of its report by path. */
    Map<String, String> compute(Thorax thorax) {
        Rehearsal rehearsal = Rehearsal.play(plan(), thorax, (simulated, total, perS) -> {});
        Map<String, String> leaves = new LinkedHashMap<>();
        new RehearsalReport(rehearsal).values().forEach((key, value) -> {
            if (PARTS.contains(key)) {
                leaves(key, value, leaves);
            }
        });
        return leaves;
    }

    private static void leaves(String path, Object value, Map<String, String> out) {
        if (value instanceof Map<?, ?> map) {
            map.forEach((key, each) -> leaves(path + "." + key, each, out));
        } else if (value instanceof List<?> list) {
            for (int i = 0; i < list.size(); i++) {
                leaves(path + "." + i, list.get(i), out);
            }
        } else if (value instanceof double[] numbers) {
            for (int i = 0; i < numbers.length; i++) {
                leaves(path + "." + i, numbers[i], out);
            }
        } else {
            out.put(
                    path,
                    value instanceof Double number ? RegressionReference.rounded(number) + "" : String.valueOf(value));
        }
    }

    /** Values for YAML. */
    Map<String, Object> values(Map<String, String> leaves) {
        return new OrderedValues().with(OF, specification()).with(REPORT, new LinkedHashMap<>(leaves));
    }

    /**
     * Reads the references of this attempt.
     *
     * @throws BadInputException with one sentence, if they belong to another attempt
     */
    Map<String, String> read(YamlMap yaml) {
        yaml.requireOnly(List.of(OF, REPORT));
        if (!yaml.text(OF).equals(specification())) {
            throw yaml.bad(
                    OF,
                    "found references of another attempt (" + yaml.text(OF) + "), expected " + specification()
                            + "; --write-references makes them anew");
        }
        YamlMap report = yaml.map(REPORT);
        Map<String, String> leaves = new LinkedHashMap<>();
        report.keys().forEach(key -> leaves.put(key, report.text(key)));
        return leaves;
    }

    /** Compares a report with its references. */
    RegressionComparison compare(Map<String, String> then, Map<String, String> now) {
        if (!then.keySet().equals(now.keySet())) {
            Set<String> missing = new TreeSet<>(then.keySet());
            missing.removeAll(now.keySet());
            Set<String> added = new TreeSet<>(now.keySet());
            added.removeAll(then.keySet());
            return RegressionComparison.ofReport(
                    name, false, "", Double.NaN, "the report has other parts: missing " + missing + ", new " + added);
        }
        String worst = "";
        double most = -1;
        for (Map.Entry<String, String> entry : then.entrySet()) {
            double off = off(entry.getValue(), now.get(entry.getKey()));
            if (!(off <= most)) {
                most = off;
                worst = entry.getKey();
            }
        }
        String values = worst + " is " + now.get(worst) + ", the reference is " + then.get(worst);
        boolean holds = most <= tolerance;
        String sentence = holds ? "" : values + ", the tolerance is " + tolerance + " of it";
        return RegressionComparison.ofReport(name, holds, worst, most, sentence);
    }

    /** Relative error of a leaf; infinite if texts differ or one value is NaN. */
    private static double off(String then, String now) {
        if (then.equals(now)) {
            return 0;
        }
        try {
            double reference = Double.parseDouble(then);
            double off = Math.abs(Double.parseDouble(now) - reference) / Math.max(1, Math.abs(reference));
            return Double.isNaN(off) ? Double.POSITIVE_INFINITY : off;
        } catch (NumberFormatException words) {
            return Double.POSITIVE_INFINITY;
        }
    }
}
