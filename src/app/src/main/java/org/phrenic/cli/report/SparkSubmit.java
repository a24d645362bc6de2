package org.phrenic.cli.report;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.file.BadInputException;

/** Starts {@code spark-submit} of the Apache Spark in {@code SPARK_HOME} with {@code phrenic-cluster.jar}. */
public final class SparkSubmit {
    private static final String JAR = "phrenic-cluster.jar";

    private SparkSubmit() {}

    /**
     * Runs a command of the program on a cluster and waits for it. Its output goes to that of this process.
     *
     * @param master URL of the master
     * @param arguments of the program
     * @return exit code
     * @throws BadInputException with one sentence, if Spark or the jar is not there
     */
    public static int run(String master, List<String> arguments) {
        String home = System.getenv("SPARK_HOME");
        boolean onWindows = System.getProperty("os.name").startsWith("Windows");
        Path submit = home == null ? null : Path.of(home, "bin", onWindows ? "spark-submit.cmd" : "spark-submit");
        if (submit == null || !Files.isRegularFile(submit)) {
            throw new BadInputException("--master " + master + ": found no Apache Spark, expected its folder in the"
                    + " environment variable SPARK_HOME (docs/cluster.md)");
        }
        Path jar = folder().resolve(JAR);
        if (!Files.isRegularFile(jar)) {
            throw new BadInputException("--master " + master + ": found no " + jar
                    + ", expected the jar that mvn -Pcluster" + " package makes (docs/cluster.md)");
        }
        List<String> command = new ArrayList<>(List.of(submit.toString(), "--master", master, jar.toString()));
        command.addAll(arguments);
        try {
            return new ProcessBuilder(command).inheritIO().start().waitFor();
        } catch (IOException failure) {
            throw new BadInputException(submit + ": found a file that does not start, expected spark-submit", failure);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the study was interrupted", stopped);
        }
    }

    /** The folder of the program's jar. */
    private static Path folder() {
        try {
            Path code = Path.of(SparkSubmit.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            return code.toAbsolutePath().getParent();
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
