package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** One run at a time writes into a folder. */
class FolderLockTest {
    private static final String REFUSAL = ": found another run that writes into this folder";

    @TempDir
    private Path folder;

    @Test
    void aFolderIsThatOfOneRunUntilItsEnd() {
        Path out = folder.resolve("out");
        try (FolderLock mine = FolderLock.of(out)) {
            assertThatThrownBy(() -> FolderLock.of(mine.folder()))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageStartingWith(out + REFUSAL);
        }
        assertThat(out).doesNotExist();
        try (FolderLock again = FolderLock.of(out)) {
            assertThat(again.folder()).isDirectory();
        }
    }

    /** The system's lock alone answers here: within a process Java refuses a second lock by a table of its own. */
    @Test
    void aFolderOfARunIsRefusedInAnotherProcess() throws Exception {
        try (FolderLock mine = FolderLock.of(folder)) {
            assertThat(answerOfAnotherProcess(mine.folder())).isEqualTo(folder + REFUSAL);
        }
        assertThat(answerOfAnotherProcess(folder)).isEqualTo("free");
    }

    private static String answerOfAnotherProcess(Path folder) throws IOException, InterruptedException {
        Process other = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        System.getProperty("java.class.path"),
                        Other.class.getName(),
                        folder.toString())
                .redirectErrorStream(true)
                .start();
        String answer = new String(other.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        other.waitFor();
        return answer;
    }

    /** The run of the other process: it says what it is told. */
    static final class Other {
        private Other() {}

        public static void main(String[] arguments) {
            String answer = "free";
            try (FolderLock lock = FolderLock.of(Path.of(arguments[0]))) {
                lock.folder();
            } catch (BadInputException e) {
                answer = e.getMessage().split(",", -1)[0];
            }
            System.out.print(answer);
        }
    }
}
