package org.phrenic.ui.session;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

/** What was dropped or opened: a scenario, a thorax folder or a recorded trace. */
public final class FileOpener {
    private FileOpener() {}

    /**
     * The plan of a needle that a file holds; empty if it is none.
     *
     * @throws BadInputException with one sentence, if it is a plan that cannot be
     */
    public static Optional<RehearsalPlan> readPlan(Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (!Files.isRegularFile(file) || !(name.endsWith(".yaml") || name.endsWith(".yml"))) {
            return Optional.empty();
        }
        YamlMap yaml = YamlDocument.read(file);
        return yaml.has("target") || yaml.has("steps") ? Optional.of(RehearsalPlan.read(file)) : Optional.empty();
    }

    /**
     * The scenario that a file makes of the present one.
     *
     * @throws BadInputException with one sentence
     */
    public static Scenario readScenario(Path file, Scenario present) {
        if (!Files.exists(file)) {
            throw new BadInputException(
                    file + ": found nothing there, expected a scenario, a thorax folder or a trace");
        }
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        String place = file.toAbsolutePath().normalize().toString();
        if (Files.isDirectory(file)) {
            return present.with(List.of(new Assignment(file.toString(), "anatomy", place)));
        }
        if (name.endsWith(".csv")) {
            return present.with(List.of(new Assignment(file.toString(), "trace", place)));
        }
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return Scenario.read(file);
        }
        throw new BadInputException(file
                + ": found a file of another kind, expected a scenario (.yaml), a thorax folder or a trace (.csv)");
    }
}
