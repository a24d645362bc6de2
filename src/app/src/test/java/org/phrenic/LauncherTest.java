package org.phrenic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The launcher of Linux and macOS with a Java that prints its arguments and writes the archive that they ask for. */
class LauncherTest {
    private static final Path LAUNCHER = Path.of("src", "app", "src", "main", "launcher", "phrenic");
    private static final String JAVA =
            """
            #!/bin/sh
            echo "$@"
            for argument in "$@"; do
              case $argument in -XX:ArchiveClassesAtExit=*) echo classes >"${argument#*=}" ;; esac
            done
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void install() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no /bin/sh: the launcher of Linux and macOS is not tested");
        Files.copy(LAUNCHER, folder.resolve("phrenic"));
        Files.writeString(folder.resolve("phrenic.jar"), "jar");
        Path java = folder.resolve("home").resolve("bin").resolve("java");
        Files.createDirectories(java.getParent());
        Files.writeString(java, JAVA);
        assertThat(java.toFile().setExecutable(true)).isTrue();
    }

    private String start(String... arguments) throws Exception {
        return start(Map.of("PHRENIC_CACHE", folder.resolve("cache").toString()), arguments);
    }

    private String start(Map<String, String> variables, String... arguments) throws Exception {
        return start(0, variables, arguments);
    }

    private String start(int exitCode, Map<String, String> variables, String... arguments) throws Exception {
        List<String> command = Stream.concat(
                        Stream.of("/bin/sh", folder.resolve("phrenic").toString()), Stream.of(arguments))
                .toList();
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("JAVA_HOME", folder.resolve("home").toString());
        builder.environment().remove("PHRENIC_JAVA_OPTIONS");
        builder.environment().putAll(variables);
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).isEqualTo(exitCode);
        return said.strip();
    }

    @Test
    void theFirstBreathMakesAnArchiveThatLaterStartsRead() throws Exception {
        assertThat(start("run", "--steps", "1"))
                .contains("-XX:ArchiveClassesAtExit=")
                .endsWith("run --steps 1");
        assertThat(start("run", "--steps", "1"))
                .contains("-XX:SharedArchiveFile=")
                .doesNotContain("AtExit");
        assertThat(start("info", "a file")).contains("-XX:SharedArchiveFile=").endsWith("info a file");
    }

    @Test
    void aJavaThatIsTooOldIsNamedInsteadOfStarted() throws Exception {
        for (String old : List.of("11.0.21", "1.8.0_392")) {
            Files.writeString(folder.resolve("home/release"), "IMPLEMENTOR=\"X\"\nJAVA_VERSION=\"" + old + "\"\n");
            assertThat(start(1, Map.of(), "run"))
                    .matches("phrenic: found Java (11|8) in .*home, expected Java 17 or newer");
        }
        Files.writeString(folder.resolve("home/release"), "JAVA_VERSION=\"17.0.15\"\n");
        assertThat(start("--version")).endsWith("phrenic.jar --version");
    }

    @Test
    void theWindowHasAnArchiveOfItsOwn() throws Exception {
        start("run");
        assertThat(start()).contains("-XX:ArchiveClassesAtExit=").contains("-window.jsa");
        assertThat(start("window")).contains("-XX:SharedArchiveFile=").contains("-window.jsa");
    }

    @Test
    void commandsThatLoadFewClassesMakeNoArchive() throws Exception {
        assertThat(start("--version")).doesNotContain("jsa").endsWith("phrenic.jar --version");
    }

    @Test
    void anotherBuildReadsNoArchiveOfThis() throws Exception {
        start("run");
        Files.writeString(folder.resolve("phrenic.jar"), "another jar");
        assertThat(start("run")).contains("-XX:ArchiveClassesAtExit=");
    }

    /** A build may leave a jar of the same length within the minute of the last. */
    @Test
    void aJarOfTheSameLengthReadsNoArchiveOfAnother() throws Exception {
        Path jar = folder.resolve("phrenic.jar");
        Instant minute = Instant.parse("2026-01-05T10:20:00Z");
        Files.setLastModifiedTime(jar, FileTime.from(minute));
        start("run");
        assertThat(start("run")).contains("-XX:SharedArchiveFile=");
        Files.setLastModifiedTime(jar, FileTime.from(minute.plusSeconds(1)));
        assertThat(start("run")).contains("-XX:ArchiveClassesAtExit=");
    }

    /** Another place or language of the user is no other build. */
    @Test
    void anArchiveIsReadInEachTimeZone() throws Exception {
        String cache = folder.resolve("cache").toString();
        start(Map.of("PHRENIC_CACHE", cache, "TZ", "UTC"), "run");
        assertThat(start(Map.of("PHRENIC_CACHE", cache, "TZ", "EST5"), "run")).contains("-XX:SharedArchiveFile=");
    }

    /** Its process has not ended, and has written a part of it. */
    @Test
    void anArchiveThatIsStillBeingWrittenIsNotRead() throws Exception {
        Matcher asked =
                Pattern.compile("-XX:ArchiveClassesAtExit=(\\S+)\\.\\d+").matcher(start("run"));
        assertThat(asked.find()).isTrue();
        Path archive = Path.of(asked.group(1));
        Path whole = Path.of(asked.group().replaceFirst("^[^=]*=", ""));
        Path part = archive.resolveSibling(
                archive.getFileName() + "." + ProcessHandle.current().pid());
        Files.move(whole, part);
        assertThat(start("run")).contains("-XX:ArchiveClassesAtExit=").doesNotContain("SharedArchiveFile");
        assertThat(part).exists();
        assertThat(archive).doesNotExist();
    }

    @Test
    void withoutACacheThereIsNoArchive() throws Exception {
        assertThat(start(Map.of("PHRENIC_CACHE", "off"), "run")).doesNotContain("jsa");
        assertThat(start(Map.of("PHRENIC_CACHE", "Off"), "run")).doesNotContain("jsa");
        assertThat(start(Map.of("PHRENIC_CACHE", "/dev/null/cache"), "run")).doesNotContain("jsa");
    }

    /** Java ends with an error where it cannot write the archive. */
    @Test
    void aCacheThatMayNotBeWrittenGetsNoArchive() throws Exception {
        Path cache = Files.createDirectory(folder.resolve("cache"));
        assertThat(cache.toFile().setWritable(false)).isTrue();
        assumeFalse(Files.isWritable(cache), "this user may write into every folder");
        assertThat(start("run")).doesNotContain("jsa");
    }
}
