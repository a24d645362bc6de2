package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.phrenic.cli.bench.BenchCommand;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.FailureHandler;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.RunLast;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.TypeConversionException;

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
            "ultrasound",
            "motion");

    private SubCommands() {}

    /** Whether a command line needs no window, so that no display is asked for, not even one that has gone. */
    static boolean needNoWindow(String... args) {
        return args.length > 0 && NAMES.contains(args[0]) && !List.of(args).contains("window");
    }

    /** Runs the command line of {@code phrenic}; see {@link Phrenic#execute}. */
    static int execute(Phrenic phrenic, BooleanSupplier debug, PrintWriter out, PrintWriter err, String... args) {
        CommandLine line = commandLine(phrenic, args).registerConverter(Path.class, SubCommands::path);
        FailureHandler failures = new FailureHandler(debug);
        line.setOut(out).setErr(err).setParameterExceptionHandler(failures).setExecutionExceptionHandler(failures);
        line.setExecutionStrategy(SubCommands::executeLast);
        try {
            return line.execute(args);
        } catch (OutOfMemoryError full) {
            err.println("phrenic: not enough memory; give Java more, as in java -Xmx4g -jar phrenic.jar");
            return ExitCode.FAILURE;
        }
    }

    /** Runs the last command of the line, before whose name no option of the command above it may stand. */
    private static int executeLast(ParseResult parsed) {
        for (ParseResult above = parsed; above.hasSubcommand(); above = above.subcommand()) {
            String name = above.subcommand().commandSpec().name();
            for (OptionSpec option : above.matchedOptions()) {
                if (option.scopeType() != ScopeType.INHERIT && !option.usageHelp() && !option.versionHelp()) {
                    throw new ParameterException(
                            above.commandSpec().commandLine(),
                            option.longestName() + ": found it before '" + name + "', which does not read it, expected"
                                    + " options of " + name + " after its name");
                }
            }
        }
        return new RunLast().execute(parsed);
    }

    private static Path path(String text) {
        try {
            return FileNames.path(text);
        } catch (BadInputException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

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
            case "motion" -> MotionCommand.class;
            default -> throw new IllegalArgumentException(name + " is no command");
        };
    }
}
