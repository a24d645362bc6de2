package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.ui.window.WindowStart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code phrenic window}: opens the window, optionally with a file. */
@Command(
        name = "window",
        description = "Open the window. Without a display: exit code 4 and one sentence.",
        footer = {"", "Examples:", "  phrenic window", "  phrenic window data/scenarios/deep.yaml", "", Disclaimer.TEXT
        })
final class WindowCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "FILE",
            description = "Scenario or rehearsal plan (.yaml), thorax folder, recorded breath (.csv) or label volume to"
                    + " import; without it, a quiet breath.")
    private Path file;

    @Override
    public Integer call() throws InterruptedException {
        Optional<String> obstacle = WindowStart.obstacle();
        if (obstacle.isPresent()) {
            PrintWriter err = spec.commandLine().getErr();
            err.println(obstacle.get() + " (phrenic run and phrenic render need no window).");
            return ExitCode.NO_GRAPHICS;
        }
        WindowStart.open(Optional.ofNullable(file));
        return ExitCode.SUCCESS;
    }
}
