package org.phrenic.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.UUID;
import java.util.stream.Stream;

/**
 * Exclusive use of an output folder by one process, by an operating-system lock on the file {@value #NAME} in it. The
 * system releases the lock when the process ends, however it ends. A file system without locks gives no protection and
 * no error.
 */
public final class FolderLock implements AutoCloseable {
    static final String NAME = ".phrenic-lock";
    /** Beyond all content: Windows lets nobody read bytes that are locked. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;

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
            return new FolderLock(folder, locked(file), absent);
        } catch (IOException e) {
            return new FolderLock(folder, null, absent);
        }
    }

    private static FileChannel locked(Path file) throws IOException {
        while (true) {
            FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            boolean mine = false;
            try {
                if (isHeldElsewhere(channel)) {
                    throw new BadInputException(file.getParent() + ": found another run that writes into this folder,"
                            + " expected a folder of its own for each run");
                }
                mine = isOpen(file, channel);
            } finally {
                if (!mine) {
                    channel.close();
                }
            }
            if (mine) {
                return channel;
            }
        }
    }

    /**
     * Whether a channel is that of the file which has the path. The run that held the lock may have deleted the file
     * between the opening and the locking, and a third run may have made another.
     *
     * @param locked a channel that holds the lock
     */
    static boolean isOpen(Path file, FileChannel locked) throws IOException {
        byte[] mark = UUID.randomUUID().toString().getBytes(StandardCharsets.US_ASCII);
        locked.write(ByteBuffer.wrap(mark), 0);
        return Files.exists(file) && Arrays.equals(Files.readAllBytes(file), mark);
    }

    public Path folder() {
        return folder;
    }

    private static boolean isHeldElsewhere(FileChannel channel) throws IOException {
        try {
            return channel.tryLock(LOCKED_BYTE, 1, false) == null;
        } catch (OverlappingFileLockException sameProcess) {
            return true;
        }
    }

    /** Releases the folder and deletes the lock's file, and the folder if the lock made it and it is empty. */
    @Override
    public void close() {
        try {
            if (channel != null) {
                try {
                    Files.deleteIfExists(folder.resolve(NAME));
                } finally {
                    channel.close();
                }
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
