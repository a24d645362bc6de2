package org.phrenic.cli.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.OutputException;
import org.phrenic.scenario.Scenario;

class RunReportTest {
    /** While the results are shown, the folder is lost to a file of its name. */
    @Test
    void resultsAreShownBeforeTheirFilesAreWritten(@TempDir Path folder) {
        Path out = folder.resolve("out");
        Scenario scenario =
                Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic", "steps=1");
        List<Map<String, Object>> shown = new ArrayList<>();
        PrintWriter err = new PrintWriter(new StringWriter());
        assertThatThrownBy(() -> RunReport.run(scenario, Map.of(), out, err, summary -> {
                    shown.add(summary);
                    replaceByFile(out);
                }))
                .isInstanceOf(OutputException.class);
        assertThat(shown).singleElement().satisfies(summary -> assertThat(summary)
                .containsKey("state_sha256"));
    }

    private static void replaceByFile(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted(Comparator.reverseOrder())
                    .forEach(file -> file.toFile().delete());
            Files.writeString(folder, "");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
