package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A cache gives back what was written under the same key by the same build, and nothing else. */
class UserCacheTest {
    @TempDir
    Path folder;

    private static ByteBuffer bytes(int... values) {
        byte[] all = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            all[i] = (byte) values[i];
        }
        return ByteBuffer.wrap(all);
    }

    private Path onlyFile() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            List<Path> all = files.toList();
            assertThat(all).hasSize(1);
            return all.get(0);
        }
    }

    @Test
    void anEntryIsReadUnderItsKindKeyAndBuildAlone() {
        UserCache cache = UserCache.in(folder.resolve("new/folders"), "build 1");
        cache.write("body", "male", bytes(1, 2, 3));

        assertThat(cache.read("body", "male")).contains(bytes(1, 2, 3));
        assertThat(UserCache.in(folder.resolve("new/folders"), "build 1").read("body", "male"))
                .contains(bytes(1, 2, 3));
        assertThat(cache.read("body", "female")).isEmpty();
        assertThat(cache.read("settled", "male")).isEmpty();
        assertThat(UserCache.in(folder.resolve("new/folders"), "build 2").read("body", "male"))
                .isEmpty();
        assertThat(cache.takeNotes()).isEmpty();
    }

    @Test
    void aCacheThatIsOffKeepsNothing() {
        UserCache cache = UserCache.off();
        cache.write("body", "male", bytes(1));
        assertThat(cache.read("body", "male")).isEmpty();
        assertThat(cache.takeNotes()).isEmpty();
    }

    @Test
    void aDamagedEntryCountsAsAbsentWithOneSentence() throws IOException {
        UserCache cache = UserCache.in(folder, "build");
        cache.write("body", "male", bytes(1, 2, 3, 4, 5, 6));
        Path file = onlyFile();
        byte[] whole = Files.readAllBytes(file);

        // every byte and every length counts
        for (int i = 0; i < whole.length; i++) {
            byte[] changed = whole.clone();
            changed[i] ^= 0x10;
            Files.write(file, changed);
            assertThat(cache.read("body", "male")).as("byte " + i).isEmpty();
            Files.write(file, Arrays.copyOf(whole, i));
            assertThat(cache.read("body", "male")).as("length " + i).isEmpty();
        }
        assertThat(cache.takeNotes()).singleElement().asString().contains(file.toString(), "damaged");

        cache.write("body", "male", bytes(7));
        assertThat(cache.read("body", "male")).contains(bytes(7));
    }

    @Test
    void aFolderThatCannotBeWrittenCostsOneSentence() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "no folder");
        UserCache cache = UserCache.in(file, "build");
        cache.write("body", "male", bytes(1));
        cache.write("body", "female", bytes(2));
        assertThat(cache.read("body", "male")).isEmpty();
        assertThat(cache.takeNotes()).singleElement().asString().contains(file.toString(), UserCache.VARIABLE + "=off");
        assertThat(cache.takeNotes()).isEmpty();
    }

    @Test
    void theEntriesUnusedForLongestAreDeleted() throws IOException {
        UserCache cache = UserCache.in(folder, "build");
        cache.write("other", "stays", bytes(0));
        for (int i = 0; i < 16; i++) {
            cache.write("body", "b" + i, bytes(i));
            age(i);
        }
        cache.read("body", "b0");
        cache.write("body", "new", bytes(99));

        assertThat(cache.read("body", "b0")).as("used a moment ago").contains(bytes(0));
        assertThat(cache.read("body", "b1")).isEmpty();
        assertThat(cache.read("body", "b2")).contains(bytes(2));
        assertThat(cache.read("other", "stays")).contains(bytes(0));
    }

    /** Makes every entry of the test look unused for an hour, the first written for longest. */
    private void age(int written) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                if (Files.getLastModifiedTime(file).toMillis() > System.currentTimeMillis() - 1_800_000) {
                    long then = System.currentTimeMillis() - 3_600_000 + 1000L * written;
                    Files.setLastModifiedTime(file, FileTime.fromMillis(then));
                }
            }
        }
    }

    @Test
    void theFolderIsThatOfTheSystemUnlessStated() {
        Properties linux = system("Linux", "/home/a");
        assertThat(UserCacheFolder.of(Map.of(), linux)).contains(Path.of("/home/a/.cache/phrenic"));
        assertThat(UserCacheFolder.of(Map.of("XDG_CACHE_HOME", "/x"), linux)).contains(Path.of("/x/phrenic"));
        assertThat(UserCacheFolder.of(Map.of("XDG_CACHE_HOME", "x"), linux))
                .contains(Path.of("/home/a/.cache/phrenic"));
        assertThat(UserCacheFolder.of(Map.of(), system("Mac OS X", "/Users/a")))
                .contains(Path.of("/Users/a/Library/Caches/phrenic"));
        assertThat(UserCacheFolder.of(Map.of("LOCALAPPDATA", "/local"), system("Windows 11", "/Users/a")))
                .contains(Path.of("/local/Phrenic/cache"));
        assertThat(UserCacheFolder.of(Map.of(UserCache.VARIABLE, "/stated"), linux))
                .contains(Path.of("/stated"));
        assertThat(UserCacheFolder.of(Map.of(UserCache.VARIABLE, "off"), linux)).isEqualTo(Optional.empty());
        assertThat(UserCacheFolder.of(Map.of(), new Properties())).isEmpty();
    }

    private static Properties system(String name, String home) {
        Properties properties = new Properties();
        properties.setProperty("os.name", name);
        properties.setProperty("user.home", home);
        return properties;
    }

    @Test
    void theBuildIsTheContentOfItsJars() throws IOException {
        for (String name : List.of("engine", "mesh", "thorax", "scene")) {
            jar("phrenic-" + name + "-1.jar", "code of " + name);
        }
        jar("ejml-1.jar", "library");
        String build = BuildIdentity.ofFolder(folder).orElseThrow();
        String classes = folder.resolve("classes").toString();
        String path = Stream.of("thorax", "mesh", "scene", "engine")
                .map(name -> folder.resolve("phrenic-" + name + "-1.jar").toString())
                .collect(Collectors.joining(File.pathSeparator));
        String tests = File.pathSeparator + jar("phrenic-mesh-1-tests.jar", "tests");
        String library = tests + File.pathSeparator + folder.resolve("ejml-1.jar");
        assertThat(BuildIdentity.ofClassPath(classes + File.pathSeparator + path + library))
                .contains(build);
        assertThat(BuildIdentity.ofClassPath(path)).isPresent().isNotEqualTo(Optional.of(build));
        assertThat(BuildIdentity.ofClassPath(path.replace("phrenic-mesh-1.jar", "classes")))
                .isEmpty();

        jar("phrenic-scene-1.jar", "other pictures");
        assertThat(BuildIdentity.ofFolder(folder)).contains(build);
        jar("phrenic-thorax-1.jar", "code of THORAX");
        assertThat(BuildIdentity.ofFolder(folder)).isPresent().isNotEqualTo(Optional.of(build));
        jar("phrenic-thorax-1.jar", "code of thorax");
        assertThat(BuildIdentity.ofFolder(folder)).contains(build);
        Files.move(folder.resolve("ejml-1.jar"), folder.resolve("ejml-2.jar"));
        assertThat(BuildIdentity.ofFolder(folder)).isPresent().isNotEqualTo(Optional.of(build));
        Files.delete(folder.resolve("phrenic-mesh-1.jar"));
        assertThat(BuildIdentity.ofFolder(folder)).isEmpty();
    }

    private Path jar(String name, String content) throws IOException {
        Path file = folder.resolve(name);
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(file))) {
            JarEntry entry = new JarEntry("a.class");
            entry.setTime(0);
            out.putNextEntry(entry);
            out.write(content.getBytes(StandardCharsets.UTF_8));
        }
        return file;
    }
}
