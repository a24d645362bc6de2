package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;

/** The page of files that commands leave, docs/outputs.md, against what they leave. */
final class OutputsPage {
    private static final Pattern KEY = Pattern.compile("\"(\\w+)\":");

    private OutputsPage() {}

    /** Every key of a JSON file stands in a section of the page. */
    static void assertHasKeys(String heading, Path json) throws IOException {
        String text = Files.readString(Path.of("docs/outputs.md"));
        int start = text.indexOf("## " + heading);
        assertThat(start).as("heading of %s", heading).isNotNegative();
        String section = text.substring(start, text.indexOf("\n## ", start));
        assertThat(KEY.matcher(Files.readString(json)).results().map(key -> key.group(1)))
                .isNotEmpty()
                .allMatch(key -> section.contains("`" + key + "`"));
    }
}
