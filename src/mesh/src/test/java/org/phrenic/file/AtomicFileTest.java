package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {
    @TempDir
    Path folder;

    @Test
    void missingFoldersAreMadeAndNothingElseIsLeft() throws IOException {
        Path target = folder.resolve("a/b/summary.json");
        AtomicFile.write(target, "one\n");
        AtomicFile.write(target, "two\n");

        assertThat(target).hasContent("two\n");
        assertThat(target.getParent().toFile().list()).containsExactly("summary.json");
    }

    @Test
    void aFailureLeavesTheOldContentAndNoSecondFile() throws IOException {
        Path target = Files.writeString(folder.resolve("curves.csv"), "old");
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> AtomicFile.write(target, out -> {
                    out.write(new byte[100_000]);
                    throw new IOException("No space left on device");
                }))
                .withMessage(target + ": writing into folder " + folder + " failed: No space left on device");
        assertThatIllegalStateException()
                .isThrownBy(() -> AtomicFile.write(target, out -> {
                    throw new IllegalStateException("the content has a fault");
                }));

        assertThat(target).hasContent("old");
        assertThat(folder.toFile().list()).containsExactly("curves.csv");
    }

    /** As on Windows, while a scanner of viruses or another reader has the target open. */
    @Test
    void aTargetThatIsReadForAMomentIsReplacedAfterIt() throws IOException {
        int[] refusals = {2};
        AtomicFile.retrying(false, () -> {
            if (refusals[0]-- > 0) {
                throw new AccessDeniedException("curves.csv");
            }
        });
        assertThat(refusals[0]).isEqualTo(-1);
        assertThatExceptionOfType(AccessDeniedException.class)
                .isThrownBy(() -> AtomicFile.retrying(false, () -> {
                    throw new AccessDeniedException("curves.csv");
                }));
    }

    /** Windows tells an open file of another program so, where the program shares it with nobody. */
    @Test
    void aFileThatAnotherProgramKeepsOpenIsTriedAgainAndThenSaidToBeOpen() throws IOException {
        FileSystemException violation =
                new FileSystemException(".curves.csv.part0", "curves.csv", "The process cannot access the file");
        int[] refusals = {2};
        AtomicFile.retrying(true, () -> {
            if (refusals[0]-- > 0) {
                throw violation;
            }
        });
        assertThat(refusals[0]).isEqualTo(-1);
        assertThatExceptionOfType(FileSystemException.class)
                .isThrownBy(() -> AtomicFile.retrying(true, () -> {
                    throw violation;
                }))
                .withMessage("another program may have the file open (The process cannot access the file)");
    }

    /** Elsewhere the system's own reason stays: no other program keeps a file from being replaced there. */
    @Test
    void aFileSystemThatMayOnlyBeReadIsNotBlamedOnAnotherProgram() {
        FileSystemException lasting = new FileSystemException("curves.csv", null, "Read-only file system");
        int[] attempts = {0};
        assertThatExceptionOfType(FileSystemException.class)
                .isThrownBy(() -> AtomicFile.retrying(false, () -> {
                    attempts[0]++;
                    throw lasting;
                }))
                .isSameAs(lasting);
        assertThat(attempts[0]).isEqualTo(1);
    }

    @Test
    void aChangeThatCannotSucceedLaterIsTriedOnce() {
        for (FileSystemException lasting : List.of(
                new NoSuchFileException("gone"),
                new FileAlreadyExistsException("taken"),
                new NotDirectoryException("file"),
                new DirectoryNotEmptyException("full"))) {
            int[] attempts = {0};
            assertThatExceptionOfType(FileSystemException.class)
                    .isThrownBy(() -> AtomicFile.retrying(true, () -> {
                        attempts[0]++;
                        throw lasting;
                    }))
                    .isSameAs(lasting);
            assertThat(attempts[0]).isEqualTo(1);
        }
    }

    @Test
    void whatIsLeftOfARunThatDiedIsNotInTheWay() throws IOException {
        Files.writeString(folder.resolve(".a.txt.part0"), "half");
        AtomicFile.write(folder.resolve("a.txt"), "whole");
        assertThat(folder.resolve("a.txt")).hasContent("whole");
    }

    @Test
    void aFolderAsTargetOrAFileAsFolderIsToldInOneSentence() throws IOException {
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> AtomicFile.write(folder, ""))
                .withMessage(folder + ": found a folder, expected a file to write");
        Path file = Files.writeString(folder.resolve("file"), "");
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> AtomicFile.write(file.resolve("x.txt"), ""))
                .withMessageContaining("is a file, expected a folder");
    }

    /** A part of the file is written first, of whose name its user knows nothing. */
    @Test
    void aFolderThatTakesNoFileIsToldWithoutTheNameOfAPart() {
        Path tables = Path.of("/proc");
        Assumptions.assumeTrue(Files.isDirectory(tables), "no folder that takes no file");
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> AtomicFile.write(tables.resolve("x.yaml"), ""))
                .withMessage("/proc/x.yaml: writing into folder /proc failed: "
                        + "no file can be made there, choose another folder");
    }

    @Test
    void aLinkKeepsPointingWhereItDid() throws IOException {
        Path real = Files.writeString(folder.resolve("real.txt"), "old");
        Path link = folder.resolve("link.txt");
        try {
            Files.createSymbolicLink(link, real.getFileName());
        } catch (FileSystemException notAllowed) {
            Assumptions.abort("this system lets this user make no links: " + notAllowed.getMessage());
        }
        AtomicFile.write(link, "new");

        assertThat(link).isSymbolicLink();
        assertThat(real).hasContent("new");

        Files.delete(real);
        AtomicFile.write(link, "first");
        assertThat(link).as("whose file was not there").isSymbolicLink();
        assertThat(real).hasContent("first");
    }

    @Test
    void aDeviceIsWrittenDirectlyAndAFullOneIsToldSo() {
        Path full = Path.of("/dev/full");
        Assumptions.assumeTrue(Files.exists(full), "this system has no /dev/full");
        assertThatExceptionOfType(OutputException.class)
                .isThrownBy(() -> AtomicFile.write(full, "text"))
                .withMessageContaining("No space left");
        assertThat(full).exists();
    }
}
