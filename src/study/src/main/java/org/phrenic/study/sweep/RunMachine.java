package org.phrenic.study.sweep;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** Names what may change the bits of a run: program version, Java and processor. */
final class RunMachine {
    private static final Path CPU_INFO = Path.of("/proc/cpuinfo");
    private static final String TEXT = describe();

    private RunMachine() {}

    /** The machine that executes this, such as {@code phrenic 0.1.0, Java 17.0.12+7, amd64, <processor>}. */
    static String text() {
        return TEXT;
    }

    private static String describe() {
        String version = RunMachine.class.getPackage().getImplementationVersion();
        return "phrenic " + (version == null ? "(not packaged)" : version) + ", Java " + Runtime.version() + ", "
                + System.getProperty("os.arch") + ", " + processor();
    }

    private static String processor() {
        try (Stream<String> lines = Files.lines(CPU_INFO)) {
            return lines.filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .findFirst()
                    .orElse("unknown processor");
        } catch (IOException | java.io.UncheckedIOException none) {
            String windows = System.getenv("PROCESSOR_IDENTIFIER");
            return windows == null ? "unknown processor" : windows;
        }
    }
}
