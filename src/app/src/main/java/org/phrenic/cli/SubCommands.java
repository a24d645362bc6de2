package org.phrenic.cli;

import java.util.List;
import picocli.CommandLine;

/**
 * The subcommands of {@code phrenic}. If the first argument names a subcommand, only that one is registered, because
 * setting up the options of all of them takes longer than many commands. Otherwise all are registered, for help and for
 * messages about unknown names.
 */
final class SubCommands {
    private static final List<String> NAMES = List.of(
            "window",
            "run",
            "render",
            "info",
            "bench",
            "validate",
            "import",
            "compare",
            "fit",
            "regress",
            "reproduce",
            "rehearse",
            "sweep",
            "ultrasound");

    private SubCommands() {}

    /** Creates the command line of {@code phrenic} with the subcommands required by the arguments. */
    static CommandLine commandLine(Phrenic phrenic, String... args) {
        CommandLine line = new CommandLine(phrenic);
        List<String> wanted = args.length > 0 && NAMES.contains(args[0]) ? List.of(args[0]) : NAMES;
        wanted.forEach(name -> line.addSubcommand(type(name)));
        return line;
    }

    private static Class<?> type(String name) {
        return switch (name) {
            case "window" -> WindowCommand.class;
            case "run" -> RunCommand.class;
            case "render" -> RenderCommand.class;
            case "info" -> InfoCommand.class;
            case "bench" -> BenchCommand.class;
            case "validate" -> ValidateCommand.class;
            case "import" -> ImportCommand.class;
            case "compare" -> CompareCommand.class;
            case "fit" -> FitCommand.class;
            case "regress" -> RegressCommand.class;
            case "reproduce" -> ReproduceCommand.class;
            case "rehearse" -> RehearseCommand.class;
            case "sweep" -> SweepCommand.class;
            case "ultrasound" -> UltrasoundCommand.class;
            default -> throw new IllegalArgumentException(name + " is no command");
        };
    }
}
