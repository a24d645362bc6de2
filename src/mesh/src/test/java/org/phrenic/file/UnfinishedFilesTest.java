package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a program leaves that is ended while it writes. */
class UnfinishedFilesTest {
    private static final long PATIENCE_S = 120;

    @TempDir
    private Path folder;

    /** A program that writes half of a file, and a temporary folder beside it, and then waits to be ended. */
    static final class Writer {
        private Writer() {}

        public static void main(String[] args) throws IOException {
            Path folder = Path.of(args[0]);
            AtomicFile.write(folder.resolve("whole.txt"), "whole");
            Path work = Files.createDirectory(folder.resolve("work"));
            UnfinishedFiles.add(work);
            Files.writeString(work.resolve("log.txt"), "half");
            AtomicFile.write(folder.resolve("kept.txt"), out -> {
                out.write(new byte[100_000]);
                System.out.println("writing");
                try {
                    new CountDownLatch(1).await();
                } catch (InterruptedException e) {
                    throw new IOException(e);
                }
            });
        }
    }

    @Test
    void aProgramThatIsEndedWhileItWritesLeavesWholeFilesOnly() throws Exception {
        Files.writeString(folder.resolve("kept.txt"), "of an earlier run");
        Process program = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        System.getProperty("java.class.path"),
                        Writer.class.getName(),
                        folder.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try {
            assumeTrue(program.supportsNormalTermination(), "this system ends programs without a warning");
            assertThat(program.inputReader().readLine()).isEqualTo("writing");
            assertThat(folder.toFile().list()).contains(".kept.txt.part0", "work");
            program.destroy();
            assertThat(program.waitFor(PATIENCE_S, TimeUnit.SECONDS)).isTrue();
        } finally {
            program.destroyForcibly();
        }
        assertThat(folder.toFile().list()).containsExactlyInAnyOrder("whole.txt", "kept.txt");
        assertThat(folder.resolve("kept.txt")).hasContent("of an earlier run");
    }
}
