package org.phrenic.cli.report;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** A command that prints its results as text or, with {@code --json}, as JSON. */
public abstract class ReportingCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Option(names = "--json", description = "Print JSON instead of tables.")
    private boolean json;

    protected final CommandLine commandLine() {
        return spec.commandLine();
    }

    protected final boolean isJson() {
        return json;
    }

    protected final PrintWriter out() {
        return spec.commandLine().getOut();
    }

    protected final PrintWriter err() {
        return spec.commandLine().getErr();
    }

    protected final ConsoleProgress progress() {
        return new ConsoleProgress(err());
    }

    /** @param counted label of the counter in progress lines, such as "cells done" */
    protected final ConsoleProgress progress(String counted) {
        return new ConsoleProgress(err(), counted);
    }

    /**
     * Refuses a given option that the command does not read.
     *
     * @param read whether an option, given by its longest name, is read
     * @param why what it was found with or without, for the message
     */
    protected final void requireRead(Predicate<String> read, String why) {
        for (OptionSpec option : commandLine().getParseResult().matchedOptions()) {
            if (!read.test(option.longestName())) {
                throw new BadInputException(option.longestName() + ": found it " + why);
            }
        }
    }

    /** Prints the values as JSON with {@code --json}, and the text otherwise. */
    protected final void print(Map<String, ?> values, Supplier<String> text) {
        out().print(json ? JsonWriter.format(values) : text.get());
        out().flush();
    }

    protected static String withDisclaimer(String text) {
        return text + "\n" + Disclaimer.TEXT + "\n";
    }

    protected static void writePages(Path folder, String name, ReportDocument report) {
        AtomicFile.write(folder.resolve(name + ".html"), HtmlPage.format(report));
        AtomicFile.write(folder.resolve(name + ".md"), MarkdownPage.format(report));
    }
}
