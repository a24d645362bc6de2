package org.phrenic.ui.window;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;

/** The title of the window: the name of the scenario, with an asterisk once its values are others. */
final class ScenarioTitle {
    /** Values as opened or saved, by name; without a name, those of the preset that runs first. */
    private final Map<String, Scenario> unchanged = new HashMap<>();

    /** A scenario was opened: its values belong to its name, unless the name has some. */
    void opened(Scenario scenario) {
        unchanged.putIfAbsent(statedName(scenario), scenario);
    }

    /** A scenario was saved: its values belong to its name. */
    void saved(Scenario scenario) {
        unchanged.put(statedName(scenario), scenario);
    }

    /** {@code quiet - Phrenic}, or {@code quiet* - Phrenic}. */
    String text(Scenario present) {
        Scenario before = unchanged.getOrDefault(statedName(present), present);
        boolean changed = !lasting(present).equals(lasting(before));
        return before.name() + (changed ? "*" : "") + " - Phrenic";
    }

    private static String statedName(Scenario scenario) {
        return scenario.states(RunSettings.NAME) ? scenario.name() : "";
    }

    /** Without a hold of the breath, and without the repetition of steady breaths, which a rehearsal sets itself. */
    private static Scenario lasting(Scenario scenario) {
        return scenario.withChanges(List.of()).with("hold=false", "repeat_breath=false");
    }
}
