package org.phrenic.study.sweep;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.file.Hashes;
import org.phrenic.file.ProgramBuild;
import org.phrenic.patient.diaphragm.CageEnvelope;
import org.phrenic.scenario.Scenario;

/** Names what may change the bits of a run: version and build of the program, Java and processor. */
public final class RunMachine {
    private static final Path CPU_INFO = Path.of("/proc/cpuinfo");
    private static final String JAVA = ", Java ";
    /** What is said where the system does not tell the processor, as on macOS: the system itself. */
    private static final String UNKNOWN = "unknown processor, " + System.getProperty("os.name");

    /** Packages that compute no result of a run. */
    private static final Set<String> OTHERS = Set.of("cli", "cluster", "fit", "scene", "ui");

    private static final String TEXT = describe();

    private RunMachine() {}

    /**
     * The machine that executes this, such as {@code phrenic 0.1.0 build 0123456789ab, Java 17.0.12+7, amd64,
     * <processor>}.
     */
    static String text() {
        return TEXT;
    }

    /** The program that executes this, such as {@code phrenic 0.1.0 build 0123456789ab}. */
    public static String program() {
        return program(TEXT);
    }

    /** The program that the text of a machine states. */
    static String program(String machine) {
        int java = machine.indexOf(JAVA);
        return java < 0 ? machine : machine.substring(0, java);
    }

    private static String describe() {
        String program = ProgramBuild.program(
                OTHERS,
                RunMachine.class,
                CageEnvelope.class,
                MovingAnatomy.class,
                Scenario.class,
                Hashes.class,
                ParticleSystem.class);
        return program + JAVA + Runtime.version() + ", " + System.getProperty("os.arch") + ", " + processor();
    }

    private static String processor() {
        try (Stream<String> lines = Files.lines(CPU_INFO)) {
            return processor(lines.toList()).orElse(UNKNOWN);
        } catch (IOException | java.io.UncheckedIOException none) {
            String windows = System.getenv("PROCESSOR_IDENTIFIER");
            return windows == null ? UNKNOWN : windows;
        }
    }

    /**
     * The processor by the lines of {@code /proc/cpuinfo}: the name of its model, or on ARM, where there is none, the
     * codes of its maker and of the kinds of its cores.
     */
    static Optional<String> processor(List<String> cpuInfo) {
        Optional<String> model = values(cpuInfo, "model name").findFirst();
        return model.or(() -> Optional.of(Stream.of("CPU implementer", "CPU part")
                        .flatMap(key -> values(cpuInfo, key).distinct().sorted().map(value -> key + " " + value))
                        .collect(Collectors.joining(", ")))
                .filter(codes -> !codes.isEmpty()));
    }

    private static Stream<String> values(List<String> cpuInfo, String key) {
        return cpuInfo.stream().filter(line -> line.startsWith(key)).map(line -> line.substring(line.indexOf(':') + 1)
                .strip());
    }
}
