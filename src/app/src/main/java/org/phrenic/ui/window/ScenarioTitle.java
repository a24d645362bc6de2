package org.phrenic.ui.window;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scenario.ScheduledChange;
import org.phrenic.ui.session.BodyName;

/** The title of the window: the name of the scenario, with an asterisk once its values are others. */
final class ScenarioTitle {
    /** Scenarios as read or saved, by name; without a name, that of the preset that runs first. */
    private final Map<String, Known> unchanged = new HashMap<>();

    /**
     * What belongs to a name.
     *
     * @param shown the name in the title
     * @param values each once and {@link #lasting}: a run may schedule hundreds of changes
     */
    private record Known(String shown, Set<Scenario> values) {
        Known(Scenario first) {
            this(first.name(), new LinkedHashSet<>());
            values.addAll(stages(first));
        }
    }

    /**
     * A scene was opened: its values belong to its name, unless the name has some.
     *
     * @param exercise values of the exercise that is chosen, which may be those of another scene
     */
    void opened(Scenario scenario, Optional<Scenario> exercise) {
        unchanged.computeIfAbsent(statedName(scenario), name -> new Known(scenario));
        exercise.ifPresent(this::read);
    }

    /** A file was read: its values belong to its name, as do those of other files of the same name. */
    void read(Scenario scenario) {
        Known read = new Known(scenario);
        unchanged.computeIfAbsent(statedName(scenario), name -> read).values.addAll(read.values);
    }

    /** A scenario, and what the changes that it schedules make of it, one after the other. */
    private static List<Scenario> stages(Scenario scenario) {
        List<Scenario> stages = new ArrayList<>(List.of(lasting(scenario)));
        Scenario now = scenario.withChanges(List.of());
        for (ScheduledChange change : scenario.changes()) {
            now = now.changed(List.of(change.assignment()));
            stages.add(lasting(now));
        }
        return stages;
    }

    /** A scenario was saved under another name, perhaps: its values belong to that from here on. */
    void saved(Scenario scenario, String name) {
        unchanged.put(statedName(scenario), new Known(scenario.with(RunSettings.NAME, name)));
    }

    /**
     * {@code quiet - Phrenic}, or {@code quiet* - Phrenic}; the name of a body other than the usual one stands first.
     */
    String text(Scenario present) {
        String body = BodyName.of(present);
        String name = known(present).shown + (isChanged(present) ? "*" : "");
        return (body.isEmpty() ? "" : body + ", ") + name + " - Phrenic";
    }

    /** Whether the values are others than those of the scenario of their name. */
    boolean isChanged(Scenario present) {
        return !known(present).values.contains(lasting(present));
    }

    /**
     * Whether values are lost that are others than those of the scenario of their name. The body, the preset and the
     * recorded breath are chosen again at once.
     */
    boolean losesValues(Scenario present) {
        Scenario kept = withoutChoices(lasting(present));
        return known(present).values.stream().noneMatch(one -> kept.equals(withoutChoices(one)));
    }

    private static Scenario withoutChoices(Scenario scenario) {
        return scenario.without(RunSettings.ANATOMY).without(Breathing.PRESET).without(Breathing.TRACE);
    }

    private Known known(Scenario present) {
        Known known = unchanged.get(statedName(present));
        return known == null ? new Known(present) : known;
    }

    private static String statedName(Scenario scenario) {
        return scenario.states(RunSettings.NAME) ? scenario.name() : "";
    }

    /**
     * Without the name, steps and changes, which belong to a run, a hold of the breath, and the repetition of steady
     * breaths, which a rehearsal sets itself.
     */
    private static Scenario lasting(Scenario scenario) {
        return scenario.withChanges(List.of())
                .without(RunSettings.STEPS)
                .without(RunSettings.NAME)
                .with("hold=false", "repeat_breath=false");
    }
}
