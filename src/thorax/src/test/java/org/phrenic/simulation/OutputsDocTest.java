package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.phrenic.simulation.observe.Observation;

/** docs/outputs.md names what a run really writes. */
class OutputsDocTest {
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `(\\w+)` \\|");

    @Test
    void columnsOfTheObservablesAreThoseOfTheDocument() throws IOException {
        assertThat(ROW.matcher(section("observables.csv")).results().map(row -> row.group(1)))
                .containsExactlyElementsOf(Observation.COLUMNS);
    }

    @Test
    void everyExcursionOfTheSummaryStandsInTheDocument() throws IOException {
        Observation nothing = new Observation(new double[Observation.COLUMNS.size()]);
        String section = section("summary.json");
        assertThat(new RunSummary(List.of(nothing, nothing), List.of()).toMap().keySet())
                .allMatch(key -> section.contains("`" + key + "`"));
    }

    private static String section(String heading) throws IOException {
        String text = Files.readString(Path.of("docs/outputs.md"));
        int start = text.indexOf("### " + heading);
        assertThat(start).as("heading of %s", heading).isNotNegative();
        int end = text.indexOf("\n### ", start + 1);
        return end < 0 ? text.substring(start) : text.substring(start, end);
    }
}
