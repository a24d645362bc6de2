package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.phrenic.breathing.BreathingParameters;
import org.phrenic.document.YamlDocument;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.Settings;

/** What a scenario comes to: every key with its value, and whether the file, the preset or the program says so. */
public final class ScenarioInfo {
    private ScenarioInfo() {}

    public static Map<String, Object> of(Path file) {
        Scenario scenario = Scenario.read(file);
        Set<String> stated = YamlDocument.read(file).keys();
        Map<String, Object> info = new LinkedHashMap<>();
        info.put("file", file.toString());
        info.put("kind", "scenario");
        for (Setting<?> setting : Settings.all()) {
            Object value = setting == RunSettings.DURATION ? duration(scenario) : scenario.plain(setting);
            if (value != null) {
                info.put(setting.key(), entry(setting, value, stated.contains(setting.key())));
            }
        }
        return info;
    }

    /** Simulated time, s; null where a recording says it. */
    private static Object duration(Scenario scenario) {
        if (!Double.isNaN(scenario.durationS()) || scenario.trace().isPresent()) {
            return scenario.plain(RunSettings.DURATION);
        }
        BreathingParameters breath = scenario.breathing().parameters().withRatePerMin(scenario.get(Breathing.RATE));
        return scenario.durationS(scenario.breathing().pattern(breath));
    }

    private static Map<String, Object> entry(Setting<?> setting, Object value, boolean stated) {
        boolean ofPreset = setting == RunSettings.DURATION || (setting instanceof Parameter p && p.isGivenByPreset());
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("value", value);
        entry.put("unit", setting instanceof Parameter || !setting.unit().equals("1") ? setting.unit() : "");
        entry.put("from", stated ? "file" : ofPreset ? "preset" : "default");
        return entry;
    }
}
