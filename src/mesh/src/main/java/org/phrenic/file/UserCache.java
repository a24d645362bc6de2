package org.phrenic.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.Stream;
import java.util.zip.CRC32;

/**
 * Computed results in a folder of the user, kept from one run of the program to the next. An entry is found by its kind
 * and by a key that states everything it is computed from; the build of the program is part of every key. An entry that
 * is damaged counts as absent. A cache that cannot be read or written changes no result: {@link #takeNotes} then has a
 * sentence. Several processes can share a folder, because entries are written atomically.
 *
 * <p>The environment variable {@value #VARIABLE} names the folder, or {@code off} for no cache. Without it the folder
 * is {@code phrenic} in the system's folder for caches ({@code XDG_CACHE_HOME} or {@code ~/.cache},
 * {@code ~/Library/Caches}, {@code %LOCALAPPDATA%}). A program that does not run from its packaged jars has no cache.
 *
 * <p>File format, little endian: int64 {@value #MAGIC}, int32 length of the key, the key in UTF-8, int64 length of the
 * content, int64 CRC-32 of the content, the content.
 */
public final class UserCache {
    /** Environment variable with the folder, or {@code off}. */
    public static final String VARIABLE = "PHRENIC_CACHE";

    private static final long MAGIC = 0x3143_4e52_4850L;
    /** Entries of a kind that are kept; those unused for the longest time are deleted. */
    private static final int MOST_ENTRIES = 16;

    private static final String SUFFIX = ".cache";

    private final Path folder;
    private final String build;
    private final Queue<String> notes = new ConcurrentLinkedQueue<>();
    private final Set<String> noted = ConcurrentHashMap.newKeySet();

    private UserCache(Path folder, String build) {
        this.folder = folder;
        this.build = build;
    }

    /** A cache that holds nothing and keeps nothing. */
    public static UserCache off() {
        return new UserCache(null, "");
    }

    /**
     * A cache in a folder, which is created when an entry is written.
     *
     * @param build identifies the code that computes the entries
     */
    public static UserCache in(Path folder, String build) {
        return new UserCache(folder, build);
    }

    /** The cache of this user and this build; off if switched off or if the program does not run from its jars. */
    public static UserCache ofUser() {
        return OfUser.CACHE;
    }

    /** Found at the first use. */
    private static final class OfUser {
        static final UserCache CACHE = UserCacheFolder.of(System.getenv(), System.getProperties())
                .flatMap(folder -> BuildIdentity.ofProgram().map(build -> in(folder, build)))
                .orElseGet(UserCache::off);
    }

    public boolean isOff() {
        return folder == null;
    }

    /**
     * The content of an entry, little endian; empty if there is none.
     *
     * @param kind start of the file's name
     * @param key everything the entry is computed from
     */
    public Optional<ByteBuffer> read(String kind, String key) {
        if (isOff() || !Files.isRegularFile(file(kind, key))) {
            return Optional.empty();
        }
        Path file = file(kind, key);
        try {
            ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
            Optional<ByteBuffer> content = content(bytes, fullKey(key));
            if (content.isEmpty()) {
                note(file + ": found a damaged cache entry, which is computed again");
            }
            return content;
        } catch (IOException e) {
            note(file + ": found a cache entry that cannot be read, which is computed again");
            return Optional.empty();
        } finally {
            touch(file);
        }
    }

    private static Optional<ByteBuffer> content(ByteBuffer bytes, byte[] key) {
        if (bytes.remaining() < Long.BYTES + Integer.BYTES
                || bytes.getLong() != MAGIC
                || bytes.getInt() != key.length) {
            return Optional.empty();
        }
        if (bytes.remaining() < key.length + 2 * Long.BYTES) {
            return Optional.empty();
        }
        byte[] found = new byte[key.length];
        bytes.get(found);
        long length = bytes.getLong();
        long checksum = bytes.getLong();
        boolean whole =
                Arrays.equals(found, key) && length == bytes.remaining() && checksum == checksum(bytes.duplicate());
        return whole ? Optional.of(bytes.slice().order(ByteOrder.LITTLE_ENDIAN)) : Optional.empty();
    }

    /** Marks an entry as used. */
    private static void touch(Path file) {
        try {
            Files.setLastModifiedTime(file, FileTime.fromMillis(System.currentTimeMillis()));
        } catch (IOException readOnly) {
            // The order in which entries are deleted is then that of their making.
            return;
        }
    }

    /**
     * Keeps an entry and deletes the oldest of its kind beyond {@value #MOST_ENTRIES}.
     *
     * @param content from its position to its limit
     */
    public void write(String kind, String key, ByteBuffer content) {
        if (isOff()) {
            return;
        }
        byte[] full = fullKey(key);
        ByteBuffer head = ByteBuffer.allocate(3 * Long.BYTES + Integer.BYTES + full.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putLong(MAGIC)
                .putInt(full.length)
                .put(full)
                .putLong(content.remaining())
                .putLong(checksum(content.duplicate()))
                .flip();
        try {
            AtomicFile.write(file(kind, key), out -> {
                WritableByteChannel channel = Channels.newChannel(out);
                channel.write(head);
                channel.write(content.duplicate());
            });
            deleteOldest(kind);
        } catch (OutputException | IOException e) {
            note(folder + ": found a cache folder that cannot be written, so nothing is kept there (" + VARIABLE
                    + "=off switches it off)");
        }
    }

    private void deleteOldest(String kind) throws IOException {
        List<Path> entries = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            files.filter(file -> file.getFileName().toString().startsWith(kind + "-"))
                    .filter(file -> file.getFileName().toString().endsWith(SUFFIX))
                    .forEach(entries::add);
        }
        entries.sort(Comparator.comparingLong((Path file) -> file.toFile().lastModified())
                .reversed());
        for (Path old : entries.subList(Math.min(MOST_ENTRIES, entries.size()), entries.size())) {
            Files.deleteIfExists(old);
        }
    }

    private void note(String sentence) {
        if (noted.add(sentence)) {
            notes.add(sentence);
        }
    }

    /** The sentences about entries that could not be read or written since the last call. */
    public List<String> takeNotes() {
        List<String> taken = new ArrayList<>();
        for (String note = notes.poll(); note != null; note = notes.poll()) {
            taken.add(note);
        }
        return taken;
    }

    private Path file(String kind, String key) {
        byte[] full = fullKey(key);
        return folder.resolve(kind + "-" + Hashes.sha256(full).substring(0, 32) + SUFFIX);
    }

    private byte[] fullKey(String key) {
        return (build + "\n" + key).getBytes(StandardCharsets.UTF_8);
    }

    private static long checksum(ByteBuffer bytes) {
        CRC32 crc = new CRC32();
        crc.update(bytes);
        return crc.getValue();
    }
}
