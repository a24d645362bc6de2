package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** One run at a time writes into a folder. */
class FolderLockTest {
    @TempDir
    private Path folder;

    @Test
    void aFolderIsThatOfOneRunUntilItsEnd() {
        Path out = folder.resolve("out");
        try (FolderLock mine = FolderLock.of(out)) {
            assertThatThrownBy(() -> FolderLock.of(mine.folder()))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageStartingWith(out + ": found another run that writes into this folder");
        }
        assertThat(out).doesNotExist();
        try (FolderLock again = FolderLock.of(out)) {
            assertThat(again.folder()).isDirectory();
        }
    }

    /** A second run opens the file, the first ends and deletes it, a third makes another: two would hold a lock. */
    @Test
    void aLockOfAFileThatWasDeletedIsNone() throws IOException {
        Path file = Files.createFile(folder.resolve(FolderLock.NAME));
        try (FileChannel second = FileChannel.open(file, StandardOpenOption.WRITE)) {
            assertThat(FolderLock.isOpen(file, second)).isTrue();
            Files.delete(file);
            assertThat(FolderLock.isOpen(file, second)).isFalse();
            Files.createFile(file);
            assertThat(FolderLock.isOpen(file, second)).isFalse();
        }
    }

    @Test
    void aFileThatCannotBeDeletedLeavesTheFolderFree() throws IOException {
        FolderLock first = FolderLock.of(folder);
        Path file = folder.resolve(FolderLock.NAME);
        Path aside = Files.move(file, folder.resolve("aside"));
        Path inside = Files.createDirectories(file.resolve("inside"));
        first.close();
        Files.delete(inside);
        Files.delete(file);
        Files.move(aside, file);
        try (FolderLock second = FolderLock.of(folder)) {
            assertThat(second.folder()).isEqualTo(folder);
        }
    }
}
