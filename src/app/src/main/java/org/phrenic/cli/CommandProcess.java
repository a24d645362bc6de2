package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import org.phrenic.cli.report.ConsoleCharset;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.file.StandardOutput;
import org.phrenic.ui.window.WindowStart;

/** The command line as a process: its streams, its window system and its exit code. */
final class CommandProcess {
    private CommandProcess() {}

    /**
     * Runs the command line; returns the exit code of {@link Phrenic#execute}, or that of results that are not printed.
     */
    static int run(String... args) {
        StandardOutput results = new StandardOutput();
        Charset charset = ConsoleCharset.ofProcess();
        PrintWriter out = new PrintWriter(results, true, charset);
        PrintWriter err = new PrintWriter(System.err, true, charset);
        if (SubCommands.needNoWindow(args)) {
            System.setProperty("java.awt.headless", "true");
        } else {
            WindowStart.nameApplication();
        }
        int code = Phrenic.execute(out, err, args);
        out.flush();
        if (results.failure().isPresent()) {
            err.println("phrenic: the results could not be printed: "
                    + results.failure().get());
            code = code == ExitCode.SUCCESS ? ExitCode.FAILURE : code;
        }
        err.flush();
        return code;
    }
}
