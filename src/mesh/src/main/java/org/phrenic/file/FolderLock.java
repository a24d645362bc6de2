package org.phrenic.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.stream.Stream;

/**
 * Exclusive use of an output folder by one process, by an operating-system lock on the file {@value #NAME} in it. The
 * system releases the lock when the process ends, however it ends. A file system without locks gives no protection and
 * no error.
 */
public final class FolderLock implements AutoCloseable {
    static final String NAME = ".phrenic-lock";

    private final Path folder;
    private final FileChannel channel;
    private final boolean made;

    private FolderLock(Path folder, FileChannel channel, boolean made) {
        this.folder = folder;
        this.channel = channel;
        this.made = made;
    }

    /**
     * Locks a folder, which is created if it is absent.
     *
     * @throws BadInputException if another run holds it
     * @throws OutputException if the folder cannot be created
     */
    public static FolderLock of(Path folder) {
        boolean absent = !Files.exists(folder);
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new OutputException(folder + ": the folder cannot be made: " + e.getMessage(), e);
        }
        Path file = folder.resolve(NAME);
        try {
            FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            if (isHeldElsewhere(channel)) {
                channel.close();
                throw new BadInputException(
                        folder + ": found another run that writes into this folder, expected a folder"
                                + " of its own for each run");
            }
            return new FolderLock(folder, channel, absent);
        } catch (IOException e) {
            return new FolderLock(folder, null, absent);
        }
    }

    public Path folder() {
        return folder;
    }

    private static boolean isHeldElsewhere(FileChannel channel) throws IOException {
        try {
            return channel.tryLock() == null;
        } catch (OverlappingFileLockException sameProcess) {
            return true;
        }
    }

    /** Releases the folder and deletes the lock's file, and the folder if the lock made it and it is empty. */
    @Override
    public void close() {
        try {
            if (channel != null) {
                Files.deleteIfExists(folder.resolve(NAME));
                channel.close();
            }
            if (made && isEmpty()) {
                Files.deleteIfExists(folder);
            }
        } catch (IOException e) {
            // The system releases the lock at the end of the process; a file left behind locks nothing.
            return;
        }
    }

    private boolean isEmpty() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.findAny().isEmpty();
        }
    }
}
