package org.phrenic.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.EOFException;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** Exit codes of files that could not be written. */
class FailureHandlerTest {
    /** A command that writes a file. */
    @Command(name = "write")
    private record Write(Runnable what) implements Runnable {
        @Override
        public void run() {
            what.run();
        }
    }

    private final StringWriter err = new StringWriter();

    private int exitCode(Runnable what) {
        return new CommandLine(new Write(what))
                .setErr(new PrintWriter(err, true))
                .setExecutionExceptionHandler(new FailureHandler(() -> false))
                .execute();
    }

    private static Runnable failure(IOException cause) {
        return () -> {
            throw new OutputException("summary.json: writing failed", cause);
        };
    }

    @Test
    void aFullDiskIsAFailureToldInOneSentence() {
        assertThat(exitCode(failure(new IOException("No space left on device"))))
                .isEqualTo(ExitCode.FAILURE);
        assertThat(err).hasToString("phrenic: summary.json: writing failed" + System.lineSeparator());
    }

    /** A file that becomes shorter while it is read: the exception has no words of its own. */
    @Test
    void anErrorWithoutWordsIsToldInOneSentence() {
        assertThat(exitCode(() -> {
                    throw new UncheckedIOException("fit.shapes: reading failed", new EOFException());
                }))
                .isEqualTo(ExitCode.BAD_INPUT);
        assertThat(err).hasToString("phrenic: fit.shapes: reading failed" + System.lineSeparator());
    }

    @Test
    void aFullDeviceIsAFailure() {
        Path full = Path.of("/dev/full");
        Assumptions.assumeTrue(Files.exists(full), "this system has no /dev/full");
        assertThat(exitCode(() -> AtomicFile.write(full, "text"))).isEqualTo(ExitCode.FAILURE);
    }

    @Test
    void aPlaceWhereNothingCanBeWrittenIsBadInput(@TempDir Path folder) throws IOException {
        assertThat(exitCode(failure(new AccessDeniedException("summary.json")))).isEqualTo(ExitCode.BAD_INPUT);
        assertThat(exitCode(() -> AtomicFile.write(folder, "text"))).isEqualTo(ExitCode.BAD_INPUT);
        Path file = Files.writeString(folder.resolve("file"), "");
        assertThat(exitCode(() -> AtomicFile.write(file.resolve("a/b"), "text")))
                .isEqualTo(ExitCode.BAD_INPUT);
    }
}
