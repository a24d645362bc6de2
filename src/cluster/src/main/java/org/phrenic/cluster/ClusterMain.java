package org.phrenic.cluster;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.cli.Phrenic;

/**
 * Entry point of {@code phrenic-cluster.jar}: the command line of the program, whose {@code sweep} uses the master that
 * {@code spark-submit} states.
 */
public final class ClusterMain {
    private static final String MASTER = "--master";

    private ClusterMain() {}

    /** Runs the command line and ends the process with its exit code. */
    public static void main(String[] args) {
        Phrenic.main(
                withMaster(List.of(args), System.getProperty("spark.master")).toArray(String[]::new));
    }

    /** The arguments with the master of Spark, unless they state one, or need none. */
    static List<String> withMaster(List<String> args, String master) {
        List<String> all = new ArrayList<>(args);
        boolean sweeps =
                args.stream().filter(arg -> !arg.startsWith("-")).findFirst().equals(Optional.of("sweep"));
        boolean runs = sweeps && !states(args, "--merge") && !states(args, "--shard");
        if (runs && master != null && !states(args, MASTER)) {
            all.addAll(List.of(MASTER, master));
        }
        return all;
    }

    /** Whether an option is there, its value behind a blank or an equals sign. */
    private static boolean states(List<String> args, String option) {
        return args.stream().anyMatch(arg -> arg.equals(option) || arg.startsWith(option + "="));
    }
}
