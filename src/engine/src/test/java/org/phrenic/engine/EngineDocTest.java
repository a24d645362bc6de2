package org.phrenic.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** The program of docs/engine.md compiles and runs with the engine and EJML alone, and prints what the page says. */
@Isolated("captures the standard output")
class EngineDocTest {
    private static final Path PAGE = Path.of("docs", "engine.md");

    private static String fenced(String page, String language) {
        Matcher matcher = Pattern.compile("```" + language + "\\R(.*?)```", Pattern.DOTALL)
                .matcher(page);
        assertThat(matcher.find()).as("a block of %s in %s", language, PAGE).isTrue();
        return matcher.group(1);
    }

    private static URL locationOf(Class<?> type) {
        return type.getProtectionDomain().getCodeSource().getLocation();
    }

    @Test
    void programOfThePageRunsAndPrintsWhatItPromises(@TempDir Path folder)
            throws IOException, ReflectiveOperationException, URISyntaxException {
        String page = Files.readString(PAGE);
        Path source = Files.writeString(folder.resolve("Sheet.java"), fenced(page, "java"));
        URL engine = locationOf(ParticleSystem.class);
        ByteArrayOutputStream complaints = new ByteArrayOutputStream();
        int status = ToolProvider.getSystemJavaCompiler()
                .run(
                        null,
                        complaints,
                        complaints,
                        "-proc:none",
                        "-cp",
                        Path.of(engine.toURI()).toString(),
                        "-d",
                        folder.toString(),
                        source.toString());
        assertThat(status).as(complaints.toString(StandardCharsets.UTF_8)).isZero();
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream console = System.out;
        try (URLClassLoader loader = new URLClassLoader(
                        new URL[] {folder.toUri().toURL(), engine, locationOf(DMatrixRMaj.class)},
                        ClassLoader.getPlatformClassLoader());
                PrintStream capture = new PrintStream(printed, true, StandardCharsets.UTF_8)) {
            System.setOut(capture);
            loader.loadClass("Sheet").getMethod("main", String[].class).invoke(null, (Object) new String[0]);
        } finally {
            System.setOut(console);
        }
        assertThat(printed.toString(StandardCharsets.UTF_8)).isEqualToNormalizingNewlines(fenced(page, "text"));
    }
}
