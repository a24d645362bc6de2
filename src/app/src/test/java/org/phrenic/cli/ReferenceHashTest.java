package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The bits of the simulation. Each scene (materials, bodies, resolutions, integrators, changes while it runs, a
 * rehearsal) ends in the state of its reference, on one thread or on two, by the first digit of its hash. The material
 * of Villard, Bourne and Bello 2009 ends as in commit 690655c on the scanned body here, and on the virtual bodies with
 * the lungs of that commit in {@code PaperMaterialHashTest}.
 */
@Execution(ExecutionMode.CONCURRENT)
class ReferenceHashTest {
    private static final Pattern HASH = Pattern.compile("\"state_sha256\"\\s*:\\s*\"([0-9a-f]{64})\"");
    private static final Path SHARED = Path.of("..", "shared");
    private static final String PLAN_HASH = "3ce09b6b895d79a08959a7c8ce9e4ca68c77f00fcc652925b8e90aa94f01dec2";

    record ReferenceScene(String name, String options, String hash) {
        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<ReferenceScene> scenes() throws IOException {
        return resource("reference-hashes.txt")
                .lines()
                .filter(line -> !line.startsWith("#"))
                .map(line -> line.split(" \\| "))
                .map(cell -> new ReferenceScene(cell[0], cell[1], cell[2]));
    }

    private static String resource(String name) throws IOException {
        try (InputStream in = ReferenceHashTest.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void aSceneEndsInTheStateOfTheReference(ReferenceScene scene) {
        assumeTrue(
                !scene.options().contains("@shared") || Files.isDirectory(SHARED),
                "needs public data in ../shared, which is absent");
        List<String> arguments = new ArrayList<>(
                List.of("run", "--json", "--threads", scene.hash().charAt(0) < '8' ? "1" : "2"));
        arguments.addAll(
                List.of(scene.options().replace("@shared", SHARED.toString()).split(" ")));
        assertThat(hashOf(arguments)).isEqualTo(scene.hash());
    }

    @Test
    void aRehearsalEndsInTheStateOfTheReference(@TempDir Path folder) throws IOException {
        Path plan = Files.writeString(folder.resolve("plan.yaml"), resource("reference-plan.yaml"));
        String out = folder.resolve("report").toString();
        assertThat(hashOf(List.of("rehearse", plan.toString(), "--out", out, "--no-pictures", "--json")))
                .isEqualTo(PLAN_HASH);
    }

    private static String hashOf(List<String> arguments) {
        CommandLineRun run = CommandLineRun.of(arguments.toArray(String[]::new));
        Matcher matcher = HASH.matcher(run.out());
        assertThat(matcher.find())
                .as("a state_sha256 in %s%s", run.out(), run.err())
                .isTrue();
        return matcher.group(1);
    }
}
