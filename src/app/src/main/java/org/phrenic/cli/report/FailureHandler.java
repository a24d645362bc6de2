package org.phrenic.cli.report;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.util.Arrays;
import java.util.Collection;
import java.util.Locale;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.phrenic.document.KeySuggestion;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.file.BadInputException;
import org.phrenic.file.OutputException;
import org.phrenic.scene.gl.NoGraphicsException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Reports an exception as one sentence on stderr and maps it to an exit code. */
public record FailureHandler(BooleanSupplier debug) implements IParameterExceptionHandler, IExecutionExceptionHandler {
    private static final String DIVERGENCE_ADVICE =
            "; a shorter time_step_s, less depth or a body without faults in its diaphragm may help";

    @Override
    public int handleParseException(ParameterException failure, String[] args) {
        CommandLine line = failure.getCommandLine();
        String sentence = failure instanceof UnmatchedArgumentException unmatched
                ? unknownArgument(unmatched, line)
                : failure instanceof MissingParameterException missing
                                && !missing.getMissing().isEmpty()
                        ? missing(missing, args)
                        : failure.getMessage();
        print(line.getErr(), sentence + " (" + line.getCommandSpec().qualifiedName() + " --help)", failure);
        return ExitCode.BAD_INPUT;
    }

    @Override
    public int handleExecutionException(Exception failure, CommandLine line, ParseResult parsed) {
        boolean told = failure.getMessage() != null && !failure.getMessage().isBlank();
        if (told && isBadInput(failure)) {
            print(line.getErr(), sentence(failure), failure);
            return ExitCode.BAD_INPUT;
        }
        if (told && failure instanceof OutputException) {
            print(line.getErr(), sentence(failure), failure);
            return ExitCode.FAILURE;
        }
        if (told && failure instanceof NoGraphicsException) {
            print(line.getErr(), failure.getMessage(), failure);
            return ExitCode.NO_GRAPHICS;
        }
        String unexpected = "an unexpected failure, " + failure.getClass().getSimpleName()
                + (told ? " (" + failure.getMessage() + ")" : "") + "; --debug shows where";
        boolean diverged = failure instanceof DivergenceException;
        print(line.getErr(), diverged ? failure.getMessage() + DIVERGENCE_ADVICE : unexpected, failure);
        return ExitCode.FAILURE;
    }

    /** What is missing of what a command or a group of options needs, without what was given. */
    private static String missing(MissingParameterException failure, String... args) {
        Set<String> given = Arrays.stream(args).map(a -> a.split("=", 2)[0]).collect(Collectors.toSet());
        String lacking = failure.getMissing().stream()
                .filter(a -> !(a instanceof OptionSpec o)
                        || (o.required() && Arrays.stream(o.names()).noneMatch(given::contains)))
                .map(a -> a instanceof OptionSpec o ? o.longestName() + " " + o.paramLabel() : a.paramLabel())
                .collect(Collectors.joining(" and "));
        return lacking.isEmpty() ? failure.getMessage() : "found no " + lacking;
    }

    private static String unknownArgument(UnmatchedArgumentException failure, CommandLine line) {
        String found = failure.getUnmatched().get(0);
        Set<String> commands = line.getSubcommands().keySet();
        Collection<String> known =
                found.startsWith("-") ? line.getCommandSpec().optionsMap().keySet() : commands;
        String kind = found.startsWith("-") ? "option" : commands.isEmpty() ? "argument" : "command";
        return "found an unknown " + kind + " '" + found + "'"
                + KeySuggestion.nearest(found, known)
                        .map(near -> ", did you mean '" + near + "'?")
                        .orElse(kind.equals("command") ? ", expected one of " + String.join(", ", commands) : "");
    }

    private static boolean isBadInput(Exception failure) {
        return failure instanceof BadInputException
                || (failure instanceof OutputException output && output.isOfPlace())
                || failure instanceof IllegalArgumentException
                || failure instanceof IOException
                || failure instanceof UncheckedIOException;
    }

    /** The message of an exception. File-system exceptions contain only a path; their kind is added. */
    private static String sentence(Exception failure) {
        Throwable cause = failure instanceof UncheckedIOException ? failure.getCause() : failure;
        if (!(cause instanceof FileSystemException)) {
            return cause.getMessage() == null ? failure.getMessage() : cause.getMessage();
        }
        String kind = cause.getClass().getSimpleName().replaceFirst("Exception$", "");
        return cause.getMessage() + ": "
                + kind.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    private void print(PrintWriter err, String sentence, Exception failure) {
        err.println(
                "phrenic: " + sentence.strip().replaceAll("\\s*\\R\\s*", " ").replaceAll("\\p{Cntrl}", "?"));
        if (debug.getAsBoolean()) {
            failure.printStackTrace(err);
        }
        err.flush();
    }
}
