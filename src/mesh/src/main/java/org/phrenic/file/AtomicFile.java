package org.phrenic.file;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.locks.LockSupport;

/**
 * Atomic file writing: the content goes to a temporary file beside the target, which then replaces the target. A reader
 * of the target sees either the old or the new content. On failure, and where the program is ended while it writes, the
 * temporary file is deleted and the target is unchanged.
 */
public final class AtomicFile {
    private static final int ATTEMPTS = 1000;
    private static final int REPLACEMENTS = 6;
    /** Pause after the first refusal; those that follow are longer by as much each. */
    private static final long PAUSE_NS = 20_000_000;

    /** Writes the content of a file. */
    @FunctionalInterface
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    private AtomicFile() {}

    /**
     * Writes {@code target} and creates missing folders. A target that is a device or a pipe is written directly.
     *
     * @throws OutputException if it cannot be written, naming the folder and the reason
     */
    public static void write(Path target, Content content) {
        if (Files.isDirectory(target)) {
            throw new OutputException(
                    target + ": found a folder, expected a file to write",
                    new FileAlreadyExistsException(target.toString()));
        }
        try {
            Path real = followed(target);
            if (Files.exists(real) && !Files.isRegularFile(real)) {
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(real))) {
                    content.writeTo(out);
                }
                return;
            }
            if (!Files.isDirectory(folder(real))) {
                createFolder(folder(real));
            }
            writeBeside(real, content);
        } catch (IOException failure) {
            throw new OutputException(
                    target + ": writing into folder " + folder(target) + " failed: " + reason(failure), failure);
        }
    }

    /** Where a symbolic link leads, which is not replaced, also where nothing is there yet; else the path itself. */
    private static Path followed(Path target) throws IOException {
        if (!Files.isSymbolicLink(target)) {
            return target;
        }
        return Files.exists(target) ? target.toRealPath() : target.resolveSibling(Files.readSymbolicLink(target));
    }

    /** Writes {@code text} as UTF-8. */
    public static void write(Path target, String text) {
        write(target, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    /**
     * Deletes a file, if there is one.
     *
     * @throws OutputException if it cannot be deleted, naming the folder and the reason
     */
    public static void delete(Path file) {
        if (Files.isDirectory(file)) {
            return;
        }
        try {
            retrying(FileNames.ON_WINDOWS, () -> Files.deleteIfExists(file));
        } catch (IOException failure) {
            throw new OutputException(
                    file + ": deleting from folder " + folder(file) + " failed: " + reason(failure), failure);
        }
    }

    private static void writeBeside(Path target, Content content) throws IOException {
        Path beside = null;
        try {
            for (int attempt = 0; beside == null; attempt++) {
                Path candidate = folder(target).resolve("." + target.getFileName() + ".part" + attempt);
                try (OutputStream file = Files.newOutputStream(
                                candidate, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
                        OutputStream out = new BufferedOutputStream(file, 1 << 16)) {
                    beside = candidate;
                    UnfinishedFiles.add(beside);
                    content.writeTo(out);
                } catch (FileAlreadyExistsException taken) {
                    if (beside != null || attempt >= ATTEMPTS) {
                        throw taken;
                    }
                }
            }
            Path whole = beside;
            retrying(FileNames.ON_WINDOWS, () -> replace(whole, target));
            UnfinishedFiles.remove(whole);
            beside = null;
        } finally {
            if (beside != null) {
                Files.deleteIfExists(beside);
                UnfinishedFiles.remove(beside);
            }
        }
    }

    private static void replace(Path beside, Path target) throws IOException {
        try {
            Files.move(beside, target, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException unsupported) {
            Files.move(beside, target, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** What changes a file. */
    @FunctionalInterface
    interface Change {
        void make() throws IOException;
    }

    /**
     * Makes a change again that is refused: Windows refuses while another program, such as a scanner, reads the file.
     * It does so as a denial of access or as a sharing violation, which Java has no class for: a
     * {@link FileSystemException} itself. Other systems mean by one of these what lasts, such as a file system that can
     * only be read.
     */
    static void retrying(boolean onWindows, Change change) throws IOException {
        for (int attempt = 1; ; attempt++) {
            try {
                change.make();
                return;
            } catch (FileSystemException refused) {
                boolean isViolation = onWindows && refused.getClass() == FileSystemException.class;
                boolean mayPass = isViolation || refused instanceof AccessDeniedException;
                if (!mayPass || attempt == REPLACEMENTS) {
                    throw isViolation ? withCause(refused) : refused;
                }
                LockSupport.parkNanos(attempt * PAUSE_NS);
            }
        }
    }

    /** A refusal of the system with what is the likely cause before its own reason. */
    private static FileSystemException withCause(FileSystemException refused) {
        FileSystemException told = new FileSystemException(
                null, null, "another program may have the file open (" + refused.getReason() + ")");
        told.initCause(refused);
        return told;
    }

    private static void createFolder(Path folder) throws IOException {
        Path nearest = ExistingPath.nearest(folder)
                .orElseThrow(() -> new NoSuchFileException(
                        String.valueOf(folder.toAbsolutePath().getRoot())));
        if (!Files.isDirectory(nearest)) {
            throw new FileAlreadyExistsException(nearest.toString());
        }
        Files.createDirectories(folder);
    }

    private static Path folder(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        return folder == null ? file.toAbsolutePath() : folder;
    }

    private static String reason(IOException failure) {
        if (failure instanceof AccessDeniedException) {
            return "no permission to write there, or another program has the file open";
        }
        if (failure instanceof FileAlreadyExistsException) {
            return failure.getMessage() + " is a file, expected a folder";
        }
        if (failure instanceof NoSuchFileException missing) {
            // A folder that is there and takes no new file, such as those of the system's own tables.
            if (Files.isDirectory(folder(Path.of(missing.getFile())))) {
                return "no file can be made there, choose another folder";
            }
            return failure.getMessage() + " does not exist";
        }
        return failure.getMessage();
    }
}
