package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** What the documents tell a reader to type is understood by the program. */
class DocumentedCommandsTest {
    private static final Pattern FENCE = Pattern.compile("(?ms)^ *```.*?^ *```$");
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");
    /** A word as a shell reads it: quoted, substituted or plain. */
    private static final Pattern WORD = Pattern.compile("(?:\"[^\"]*\"|'[^']*'|\\$\\([^)]*\\)|[^\\s\"'])+");

    static Stream<String> documentedLines() throws IOException {
        return linesOf(DocumentedCommandsTest::blocks);
    }

    static Stream<String> documentedSpans() throws IOException {
        return linesOf(DocumentedCommandsTest::spans);
    }

    @ParameterizedTest
    @MethodSource("documentedLines")
    void everyDocumentedLineIsUnderstood(String line) {
        String[] args = words(line);
        assertThat(SubCommands.commandLine(new Phrenic(), args).parseArgs(args).errors())
                .isEmpty();
        for (String arg : args) {
            if (arg.startsWith("data/")) {
                assertThat(Path.of(arg)).exists();
            }
        }
    }

    /** In a sentence a command may lack what it needs, and capital letters stand for a value. */
    @ParameterizedTest
    @MethodSource("documentedSpans")
    void everyCommandInASentenceHasTheOptionsThatItNames(String line) {
        String[] args = words(line);
        CommandLine command = SubCommands.commandLine(new Phrenic(), args);
        collectErrors(command);
        assertThat(command.parseArgs(args).errors().stream()
                        .filter(Predicate.not(MissingParameterException.class::isInstance))
                        .filter(error -> error instanceof UnmatchedArgumentException || !hasPlaceholder(args))
                        .map(Exception::getMessage))
                .isEmpty();
    }

    private static void collectErrors(CommandLine command) {
        command.getCommandSpec().parser().collectErrors(true);
        command.getSubcommands().values().forEach(DocumentedCommandsTest::collectErrors);
    }

    private static boolean hasPlaceholder(String... args) {
        return Stream.of(args).anyMatch(arg -> !arg.startsWith("-") && arg.equals(arg.toUpperCase(Locale.ROOT)));
    }

    private static Stream<String> linesOf(Documented kind) throws IOException {
        List<String> lines = new ArrayList<>();
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            for (Path document : docs.filter(p -> p.toString().endsWith(".md")).toList()) {
                lines.addAll(kind.of(Files.readString(document)));
            }
        }
        lines.addAll(kind.of(Files.readString(Path.of("README.md"))));
        return lines.stream()
                .map(line -> line.replace("java -jar target/phrenic.jar", "phrenic"))
                // A digit follows where a page states the version of a build.
                .filter(line -> line.matches("phrenic \\D.*"))
                .distinct();
    }

    /** Lines of code blocks without what the shell adds; a backslash at the end goes on with the next line. */
    private static List<String> blocks(String document) {
        return document.replaceAll("\\\\\n *", "")
                .lines()
                .map(String::strip)
                .map(line -> line.replaceAll(" +[#|>].*| +&& .*", "").strip())
                .toList();
    }

    private static List<String> spans(String document) {
        return CODE.matcher(FENCE.matcher(document).replaceAll(""))
                .results()
                .map(span -> span.group(1))
                .toList();
    }

    private static String[] words(String line) {
        return WORD.matcher(line.substring("phrenic ".length()))
                .results()
                .map(word -> word.group().replaceAll("[\"']", ""))
                .toArray(String[]::new);
    }

    private interface Documented {
        List<String> of(String document);
    }
}
