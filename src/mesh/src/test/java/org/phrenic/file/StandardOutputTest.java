package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is kept of a failure to print. */
class StandardOutputTest {
    @TempDir
    private Path folder;

    private StandardOutput printedTo(OutputStream stream) {
        return printedTo(stream, folder.resolve("unknown"));
    }

    private static StandardOutput printedTo(OutputStream stream, Path device) {
        StandardOutput output = new StandardOutput(stream, device);
        PrintWriter writer = new PrintWriter(output, true, StandardCharsets.UTF_8);
        writer.println("one");
        writer.println("two");
        return output;
    }

    private static OutputStream failing(String reason) {
        return new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException(reason);
            }
        };
    }

    @Test
    void theReasonOfAFullDiskIsKept() {
        assertThat(printedTo(failing("No space left on device")).failure()).contains("No space left on device");
    }

    @Test
    void aReaderThatHasReadEnoughIsNoFailure() {
        assertThat(printedTo(failing("Broken pipe")).failure()).isEmpty();
        assertThat(printedTo(OutputStream.nullOutputStream()).failure()).isEmpty();
    }

    /** The messages are those of a French system. */
    @Test
    void whetherTheReaderHasGoneDoesNotDependOnTheLanguage() throws Exception {
        Path pipe = folder.resolve("pipe");
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "this system has no mkfifo");
        new ProcessBuilder("/usr/bin/mkfifo", pipe.toString()).start().waitFor();
        assertThat(printedTo(failing("Relais bris\u00e9"), pipe).failure()).isEmpty();
        Path file = Files.createFile(folder.resolve("pipe.csv"));
        String full = file + ": plus de place";
        assertThat(printedTo(failing(full), file).failure()).contains(full);
    }
}
