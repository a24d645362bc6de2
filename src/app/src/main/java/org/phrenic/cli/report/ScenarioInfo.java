package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.document.YamlDocument;
import org.phrenic.parameter.Parameter;
import org.phrenic.scenario.Scenario;

/** What a scenario comes to: every key with its value, and whether the file, the preset or the program says so. */
public final class ScenarioInfo {
    private static final Map<String, Parameter> BY_KEY =
            Arrays.stream(Parameter.values()).collect(Collectors.toMap(Parameter::key, p -> p));

    private static final String DURATION = "duration_s";

    private ScenarioInfo() {}

    public static Map<String, Object> of(Path file) {
        Scenario scenario = Scenario.read(file);
        Set<String> stated = YamlDocument.read(file).keys();
        Map<String, Object> resolved = scenario.toMap();
        BreathingParameters breath = scenario.breathing().parameters();
        resolved.putIfAbsent(Parameter.RATE.key(), breath.ratePerMin());
        resolved.putIfAbsent(Parameter.INSPIRATORY_FRACTION.key(), breath.inspiratoryFraction());
        resolved.putIfAbsent(Parameter.CHEST_SHARE.key(), breath.chestShare());
        if (scenario.trace().isEmpty()) {
            BreathingParameters changed =
                    scenario.states(Parameter.RATE) ? breath.withRatePerMin(scenario.value(Parameter.RATE)) : breath;
            resolved.putIfAbsent(
                    DURATION, scenario.durationS(scenario.breathing().pattern(changed)));
        }
        Map<String, Object> info = new LinkedHashMap<>();
        info.put("file", file.toString());
        info.put("kind", "scenario");
        for (String key : Scenario.keys()) {
            if (resolved.containsKey(key)) {
                info.put(key, value(key, resolved.get(key), stated.contains(key)));
            }
        }
        return info;
    }

    private static Map<String, Object> value(String key, Object value, boolean stated) {
        Parameter parameter = BY_KEY.get(key);
        boolean ofPreset = key.equals(DURATION) || (parameter != null && parameter.isGivenByPreset());
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("value", value);
        entry.put("unit", parameter != null ? parameter.unit() : key.endsWith("_s") ? "s" : "");
        entry.put("from", stated ? "file" : ofPreset ? "preset" : "default");
        return entry;
    }
}
