package org.phrenic.simulation.live;

import java.util.Map;
import org.phrenic.document.ShellWord;
import org.phrenic.model.material.Numerics;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;

/** Shell command line that runs a scenario without a window. */
final class RunCommandLine {
    private RunCommandLine() {}

    /** {@code phrenic run} with every key that differs from its default, the changes and the number of steps. */
    static String of(Scenario scenario) {
        StringBuilder line = new StringBuilder("phrenic run");
        // Defaults that depend on the material or on the time step need not be stated.
        Scenario ofMaterial = Scenario.defaults().withMaterial(scenario.material());
        Map<String, Object> usual =
                ofMaterial.with(Numerics.TIME_STEP, scenario.timeStepS()).toMap();
        usual.put("material", Scenario.defaults().material().label());
        usual.put(Numerics.TIME_STEP.key(), ofMaterial.timeStepS());
        scenario.toMap().forEach((key, value) -> {
            boolean own = key.equals("name") && !scenario.states(RunSettings.NAME);
            boolean told = key.equals("changes") || key.equals("steps");
            if (!own && !told && !value.equals(usual.get(key))) {
                option(line, "--set", key + "=" + value);
            }
        });
        if (scenario.steps() >= 0) {
            option(line, "--steps", Long.toString(scenario.steps()));
        }
        scenario.changes().forEach(change -> option(line, "--change", change.text()));
        return line.toString();
    }

    private static void option(StringBuilder line, String name, String value) {
        line.append(' ').append(name).append(' ').append(ShellWord.quoted(value));
    }
}
