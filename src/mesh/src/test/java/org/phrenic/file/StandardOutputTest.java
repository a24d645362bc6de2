package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** What is kept of a failure to print. */
class StandardOutputTest {
    private static StandardOutput printedTo(OutputStream stream) {
        StandardOutput output = new StandardOutput(stream);
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
}
