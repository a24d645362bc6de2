package org.phrenic.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What identifies the build of the program whose results are kept. */
class ProgramBuildTest {
    private static final String ENGINE = "org/phrenic/engine/A.class";
    private static final String MESH = "org/phrenic/mesh/A.class";

    private static final Set<String> OTHERS = Set.of("ui", "fit");

    @TempDir
    private Path folder;

    private Path jar(String name, Map<String, String> entries) throws IOException {
        Path file = folder.resolve(name);
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(file))) {
            for (Map.Entry<String, String> entry : new TreeMap<>(entries).entrySet()) {
                out.putNextEntry(new JarEntry(entry.getKey()));
                out.write(entry.getValue().getBytes(StandardCharsets.UTF_8));
            }
        }
        return file;
    }

    /** Executors of a cluster have one jar, and shards that are merged with their runs have several. */
    @Test
    void aBuildIsTheSameInOneJarAndInSeveral() throws IOException {
        Path engine = jar("engine.jar", Map.of(ENGINE, "forces", "META-INF/MANIFEST.MF", "Version: 1"));
        Path mesh = jar("mesh.jar", Map.of(MESH, "meshes"));
        Path one = jar(
                "one.jar",
                Map.of(ENGINE, "forces", MESH, "meshes", "org/phrenic/ui/A.class", "window", "org/ejml/A.class", "x"));
        assertThat(ProgramBuild.ofJars(OTHERS, List.of(mesh, engine)))
                .isPresent()
                .isEqualTo(ProgramBuild.ofJars(OTHERS, List.of(one)));
    }

    @Test
    void aBuildWithAnotherClassOrDataFileIsAnother() throws IOException {
        String data = "org/phrenic/data/breathing/quiet.yaml";
        Path first = jar("1.jar", Map.of(ENGINE, "forces", data, "rate: 12"));
        Path code = jar("2.jar", Map.of(ENGINE, "Forces", data, "rate: 12"));
        Path rate = jar("3.jar", Map.of(ENGINE, "forces", data, "rate: 15"));
        assertThat(List.of(
                        ProgramBuild.ofJars(OTHERS, List.of(first)).orElseThrow(),
                        ProgramBuild.ofJars(OTHERS, List.of(code)).orElseThrow(),
                        ProgramBuild.ofJars(OTHERS, List.of(rate)).orElseThrow()))
                .doesNotHaveDuplicates()
                .allMatch(build -> build.matches("[0-9a-f]{12}"));
    }

    /** Runs and fits are not computed by the same packages. */
    @Test
    void aBuildIsThatOfThePackagesThatCompute() throws IOException {
        String fit = "org/phrenic/fit/A.class";
        List<Path> first = List.of(jar("1.jar", Map.of(ENGINE, "forces", fit, "search")));
        List<Path> second = List.of(jar("2.jar", Map.of(ENGINE, "forces", fit, "Search")));
        assertThat(ProgramBuild.ofJars(OTHERS, first)).isEqualTo(ProgramBuild.ofJars(OTHERS, second));
        assertThat(ProgramBuild.ofJars(Set.of("ui"), first)).isNotEqualTo(ProgramBuild.ofJars(Set.of("ui"), second));
    }

    /** A development environment runs from folders of classes. */
    @Test
    void classesThatAreInNoJarHaveNoBuild() {
        assertThat(ProgramBuild.of(OTHERS, ProgramBuild.class, String.class)).isEmpty();
        assertThat(ProgramBuild.ofJars(OTHERS, List.of(folder))).isEmpty();
        assertThat(ProgramBuild.ofJars(OTHERS, List.of())).isEmpty();
        assertThat(ProgramBuild.program(OTHERS, ProgramBuild.class)).isEqualTo("phrenic (not packaged)");
    }
}
