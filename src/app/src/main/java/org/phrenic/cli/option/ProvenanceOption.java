package org.phrenic.cli.option;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.document.ShellWord;
import org.phrenic.document.report.MachineLine;
import org.phrenic.mesh.io.raster.VolumeSource;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** The first lines of a results page: what made it, by which command, on which machine and when. */
public final class ProvenanceOption {
    /** Options that say where results go and how they are shown. */
    private static final Set<String> LEFT_OUT =
            Set.of("--out", "--made-by", "--pictures", "--page", "--json", "--debug");

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(
            names = "--made-by",
            paramLabel = "TEXT",
            description = "What made the report, such as a commit; its first line.")
    private String madeBy = "";

    /** The option as it was given; empty without it. */
    public List<String> arguments() {
        return madeBy.isEmpty() ? List.of() : List.of("--made-by", madeBy);
    }

    /**
     * The lines, of which one states the command with its arguments as they were given. An option of a folder states
     * the label of the option in place of the folder; another argument that is a file or a folder states its name, so
     * that a page does not tell where it lies on this machine.
     *
     * @param named options of folders that state the name of the folder, {@code --out} among them
     */
    public List<String> lines(String... named) {
        String machine = MachineLine.text() + " Date: " + LocalDate.now(ZoneOffset.UTC) + ".";
        return Stream.of(madeBy, "With: " + given(Set.of(named)), machine)
                .filter(line -> !line.isEmpty())
                .toList();
    }

    private String given(Set<String> named) {
        ParseResult parsed = command.commandLine().getParseResult();
        List<String> words = new ArrayList<>(List.of(command.qualifiedName()));
        parsed.matchedPositionals().stream()
                .distinct()
                .flatMap(argument -> argument.originalStringValues().stream())
                .map(value -> ShellWord.quoted(withNames(value)))
                .forEach(words::add);
        for (OptionSpec option : new LinkedHashSet<>(parsed.matchedOptions())) {
            String name = option.longestName();
            if (option.arity().max() == 0) {
                words.addAll(LEFT_OUT.contains(name) ? List.of() : List.of(name));
            } else if (!LEFT_OUT.contains(name) || named.contains(name)) {
                option.originalStringValues().forEach(value -> {
                    words.add(name);
                    words.add(ShellWord.quoted(stated(option, value, named.contains(name))));
                });
            }
        }
        return String.join(" ", words);
    }

    private static String stated(ArgSpec option, String value, boolean named) {
        if (!option.type().equals(Path.class)) {
            return withNames(value);
        }
        Path path = Path.of(value);
        return Files.isDirectory(path) && !named ? option.paramLabel() : String.valueOf(path.getFileName());
    }

    /** Text in which a file or folder that is there, also behind {@code key=}, is its name. */
    private static String withNames(String text) {
        int value = text.indexOf('=') + 1;
        String named = nameOnDisk(text);
        return named.equals(text) && value > 0 ? text.substring(0, value) + nameOnDisk(text.substring(value)) : named;
    }

    /** The name of a file or folder that is there; any other text as it is. */
    private static String nameOnDisk(String text) {
        try {
            Path path = Path.of(text);
            boolean isThere = !text.isEmpty()
                    && (Files.exists(path) || Files.exists(VolumeSource.of(path).path()));
            return isThere && path.getFileName() != null ? path.getFileName().toString() : text;
        } catch (InvalidPathException none) {
            return text;
        }
    }
}
