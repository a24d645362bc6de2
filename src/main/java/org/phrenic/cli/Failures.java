package org.phrenic.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.format.BadInputException;
import org.phrenic.format.OutputException;
import picocli.CommandLine;
import picocli.CommandLine.IExecutionExceptionHandler;
import picocli.CommandLine.IParameterExceptionHandler;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** Turns whatever was thrown into one sentence on one line and an exit code. */
final class Failures implements IParameterExceptionHandler, IExecutionExceptionHandler {
    private final BooleanSupplier debug;

    Failures(BooleanSupplier debug) {
        this.debug = debug;
    }

    @Override
    public int handleParseException(ParameterException failure, String[] args) {
        CommandLine line = failure.getCommandLine();
        String sentence = failure.getMessage();
        if (failure instanceof UnmatchedArgumentException unmatched) {
            List<String> near = unmatched.getSuggestions();
            sentence += near.isEmpty()
                    ? ""
                    : ", did you mean " + near.stream().limit(3).collect(Collectors.joining(" or ")) + "?";
        }
        print(line.getErr(), sentence + " (" + line.getCommandSpec().qualifiedName() + " --help)", failure);
        return ExitCode.BAD_INPUT;
    }

    @Override
    public int handleExecutionException(Exception failure, CommandLine line, ParseResult parsed) {
        boolean told = failure.getMessage() != null && !failure.getMessage().isBlank();
        if (told && isInput(failure)) {
            print(line.getErr(), sentence(failure), failure);
            return ExitCode.BAD_INPUT;
        }
        print(
                line.getErr(),
                failure instanceof DivergenceException
                        ? failure.getMessage()
                        : "an unexpected failure, " + failure.getClass().getSimpleName()
                                + (told ? " (" + failure.getMessage() + ")" : "") + "; --debug shows where",
                failure);
        return ExitCode.FAILURE;
    }

    private static boolean isInput(Exception failure) {
        return failure instanceof BadInputException
                || failure instanceof OutputException
                || failure instanceof IllegalArgumentException
                || failure instanceof IOException
                || failure instanceof UncheckedIOException;
    }

    /** The messages of file-system exceptions are a bare path: their kind is said too. */
    private static String sentence(Exception failure) {
        Throwable cause = failure instanceof UncheckedIOException ? failure.getCause() : failure;
        if (!(cause instanceof java.nio.file.FileSystemException)) {
            return cause.getMessage();
        }
        String kind = cause.getClass().getSimpleName().replaceFirst("Exception$", "");
        return cause.getMessage() + ": "
                + kind.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    private void print(PrintWriter err, String sentence, Exception failure) {
        err.println("phrenic: " + String.valueOf(sentence).strip().replaceAll("\\s*\\R\\s*", " "));
        if (debug.getAsBoolean()) {
            failure.printStackTrace(err);
        }
        err.flush();
    }
}
