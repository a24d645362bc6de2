package org.phrenic.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.lang.module.ModuleFinder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SpringKernelTest {
    private static final String MODULE = "jdk.incubator.vector";

    @TempDir
    Path folder;

    private static void assertSameBits(List<KernelProbe.Line> lines) {
        Map<String, List<KernelProbe.Line>> byKind =
                lines.stream().collect(Collectors.groupingBy(KernelProbe.Line::kind));
        assertThat(byKind).hasSize(KernelProbe.Springiness.values().length);
        byKind.forEach((kind, same) -> assertThat(
                        same.stream().map(KernelProbe.Line::hash).distinct())
                .as("%s", same)
                .hasSize(1));
    }

    /** Runs the probe in a process of its own and returns what it printed. */
    private List<String> probe(String... options) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(List.of(options));
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), KernelProbe.class.getName()));
        Process process = new ProcessBuilder(command)
                .redirectError(folder.resolve("stderr").toFile())
                .start();
        List<String> lines = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines()
                .toList();
        assertThat(process.waitFor())
                .as(Files.readString(folder.resolve("stderr")))
                .isZero();
        return lines;
    }

    @Test
    void kernelsGiveTheSameBitsOnAnyNumberOfThreads() {
        assertSameBits(KernelProbe.lines());
    }

    @Test
    void vectorInstructionsByNameGiveTheSameBitsToo() throws Exception {
        assumeTrue(ModuleFinder.ofSystem().find(MODULE).isPresent(), "this Java has no " + MODULE);
        List<KernelProbe.Line> lines = probe("--add-modules", MODULE).stream()
                .map(line -> line.split(" "))
                .map(p -> new KernelProbe.Line(p[0], p[1], Integer.parseInt(p[2]), Integer.parseInt(p[3])))
                .toList();
        assertThat(lines).extracting(KernelProbe.Line::kernel).contains("vector", "loops");
        assertSameBits(lines);
    }

    @Test
    void withoutTheModuleItsClassIsNeverLoaded() throws Exception {
        Path log = folder.resolve("classes.log");
        assertThat(probe("-Xlog:class+load:file=" + log)).noneMatch(line -> line.contains(" vector "));
        assertThat(Files.readAllLines(log))
                .anyMatch(line -> line.contains(EdgeLoops.class.getName()))
                .noneMatch(line -> line.contains("VectorMath") || line.contains(MODULE));
    }

    @Test
    void oneThatIsNotHereIsRefusedInASentence() {
        assumeTrue(!SpringKernel.VECTOR.isAvailable(), "this Java was started with " + MODULE);
        assertThatIllegalStateException()
                .isThrownBy(() -> SpringKernel.VECTOR.starPasses(null, null))
                .withMessage("kernel: found vector, but Java was started without --add-modules " + MODULE);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SpringKernel.of("gpu"))
                .withMessage("kernel: found 'gpu', expected one of loops, vector");
    }
}
