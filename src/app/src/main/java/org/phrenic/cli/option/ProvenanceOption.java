package org.phrenic.cli.option;

import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.stream.Stream;
import org.phrenic.document.report.MachineLine;
import picocli.CommandLine.Option;

/** The first lines of a results page: what made it, by which command, on which machine and when. */
public final class ProvenanceOption {
    @Option(
            names = "--made-by",
            paramLabel = "TEXT",
            description = "What made the report, such as a commit; its first line.")
    private String madeBy = "";

    /** The option as it was given; empty without it. */
    public List<String> arguments() {
        return madeBy.isEmpty() ? List.of() : List.of("--made-by", madeBy);
    }

    /** @param command the command and its arguments, without the name of the program */
    public List<String> lines(String command) {
        String machine = MachineLine.text() + " Date: " + LocalDate.now(ZoneOffset.UTC) + ".";
        return Stream.of(madeBy, "With: phrenic " + command, machine)
                .filter(line -> !line.isEmpty())
                .toList();
    }
}
