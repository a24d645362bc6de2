package org.phrenic.scenario;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.document.KeySuggestion;
import org.phrenic.file.BadInputException;
import org.phrenic.parameter.Parameter;

/** Which keys of a scenario can be changed while it runs: all that leave the meshes as they are. */
public final class LiveKeys {
    /** In the order of the documentation. */
    public static final Set<String> ALL = all();

    private LiveKeys() {}

    private static Set<String> all() {
        Set<String> keys = new LinkedHashSet<>(List.of(
                "preset",
                "trace",
                "hold",
                "muscle",
                "pressure",
                "ribs",
                "tensegrity",
                "contact",
                "integrator",
                "time_step_s"));
        keys.addAll(Parameter.keys());
        return java.util.Collections.unmodifiableSet(keys);
    }

    /**
     * Refuses a key that cannot be changed while a simulation runs.
     *
     * @throws BadInputException with one sentence
     */
    public static void requireLive(Assignment assignment) {
        String key = assignment.key();
        if (ALL.contains(key)) {
            return;
        }
        if (ScenarioReader.KEYS.contains(key)) {
            throw new BadInputException(assignment.origin() + ": found key '" + key
                    + "', which cannot be changed while the simulation runs; expected one of "
                    + String.join(", ", ALL));
        }
        String hint = KeySuggestion.nearest(key, ALL)
                .map(near -> "did you mean '" + near + "'?")
                .orElse("expected one of " + String.join(", ", ALL));
        throw new BadInputException(assignment.origin() + ": found an unknown key '" + key + "', " + hint);
    }
}
