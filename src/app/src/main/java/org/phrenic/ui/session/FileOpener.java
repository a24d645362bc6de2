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

/** Reads files that are opened or dropped: scenarios, rehearsal plans, thorax folders and breathing traces. */
public final class FileOpener {
    private FileOpener() {}

    /**
     * The rehearsal plan in a file; empty if the file is none.
     *
     * @throws BadInputException if the plan is not valid
     */
    public static Optional<RehearsalPlan> readPlan(Path file) {
        if (!Files.isRegularFile(file) || !isYaml(file)) {
            return Optional.empty();
        }
        YamlMap yaml = YamlDocument.read(file);
        // The steps of a plan are a list, those of a scenario their number.
        boolean plan = yaml.has("target") || yaml.isList("steps");
        return plan ? Optional.of(RehearsalPlan.read(file)) : Optional.empty();
    }

    /**
     * The scenario in a file, or the present one with the thorax folder or the trace.
     *
     * @throws BadInputException if the file is none of these
     */
    public static Scenario readScenario(Path file, Scenario present) {
        if (!Files.exists(file)) {
            throw new BadInputException(
                    file + ": found nothing there, expected a scenario, a thorax folder or a trace");
        }
        String place = file.toAbsolutePath().normalize().toString();
        if (Files.isDirectory(file) || hasSuffix(file, ".csv")) {
            String key = Files.isDirectory(file) ? "anatomy" : "trace";
            return present.with(List.of(Assignment.read(file.toString(), key, place)));
        }
        if (isYaml(file)) {
            return Scenario.read(file);
        }
        throw new BadInputException(file
                + ": found a file of another kind, expected a scenario (.yaml), a thorax folder or a trace (.csv)");
    }

    /** Whether a file is named as a scenario or a plan. */
    public static boolean isYaml(Path file) {
        return hasSuffix(file, ".yaml") || hasSuffix(file, ".yml");
    }

    private static boolean hasSuffix(Path file, String suffix) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith(suffix);
    }
}
