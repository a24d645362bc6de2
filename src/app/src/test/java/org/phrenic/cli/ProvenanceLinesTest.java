package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.cli.option.ProvenanceOption;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** The line of a results page that states the command can be typed again, and tells nothing of the machine. */
class ProvenanceLinesTest {
    private static final Set<String> LEFT_OUT =
            Set.of("--out", "--made-by", "--pictures", "--page", "--json", "--debug");

    @TempDir
    Path folder;

    /** The line of a command whose page has the lines of a {@link ProvenanceOption}. */
    private static String line(List<String> args, String... named) {
        CommandLine line = SubCommands.commandLine(new Phrenic(), args.get(0));
        line.parseArgs(args.toArray(String[]::new));
        CommandLine command = line;
        for (String word : args) {
            command = command.getSubcommands().getOrDefault(word, command);
        }
        return provenance(command).orElseThrow().lines(named).stream()
                .filter(each -> each.startsWith("With: "))
                .findFirst()
                .orElseThrow();
    }

    private static Optional<ProvenanceOption> provenance(CommandLine command) {
        return command.getCommandSpec().mixins().values().stream()
                .map(CommandSpec::userObject)
                .filter(ProvenanceOption.class::isInstance)
                .map(ProvenanceOption.class::cast)
                .findFirst();
    }

    /** Names of the commands whose pages state how they were made, such as {@code bench fits}. */
    static Stream<String> commands() {
        return commands(SubCommands.commandLine(new Phrenic()));
    }

    private static Stream<String> commands(CommandLine line) {
        String name = line.getCommandSpec().qualifiedName().replaceFirst("^phrenic ?", "");
        return Stream.concat(
                provenance(line).map(option -> name).stream(),
                line.getSubcommands().values().stream().flatMap(ProvenanceLinesTest::commands));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyOptionAndArgumentIsStatedAsItWasGiven(String name) {
        List<String> args = new ArrayList<>(List.of(name.split(" ")));
        CommandLine command = SubCommands.commandLine(new Phrenic(), args.get(0));
        for (String word : args) {
            command = command.getSubcommands().get(word);
        }
        List<String> stated = new ArrayList<>();
        for (ArgSpec positional : command.getCommandSpec().positionalParameters()) {
            args.add("some/body");
            stated.add(" some/body");
        }
        for (OptionSpec option : command.getCommandSpec().options()) {
            boolean flag = option.arity().max() == 0;
            if (option.usageHelp() || option.versionHelp()) {
                continue;
            }
            args.add(option.longestName());
            if (!flag) {
                args.add("1");
            }
            if (!LEFT_OUT.contains(option.longestName())) {
                stated.add(" " + option.longestName() + (flag ? "" : " 1"));
            }
        }
        assertThat(line(args)).startsWith("With: phrenic " + name).contains(stated);
        assertThat(line(args)).hasSize(("With: phrenic " + name + String.join("", stated)).length());
    }

    @Test
    void theCommandsWithPagesAreFound() {
        assertThat(commands())
                .contains("fit", "reproduce", "sweep", "validate", "bench error")
                .hasSizeGreaterThan(12);
    }

    @Test
    void repeatedOptionsListsAndBlanksStandAsAShellReadsThem() {
        assertThat(line(List.of(
                        "validate", "--set", "trace=a b.csv", "--anatomy", "it's", "--set", "depth=2", "--threads=3")))
                .isEqualTo(
                        "With: phrenic validate --set 'trace=a b.csv' --set depth=2 --anatomy 'it'\\''s' --threads 3");
        assertThat(line(List.of(
                        "bench", "studies", "--threads", "1,2", "--master", "local[2]", "a.yaml", "--out", "x")))
                .isEqualTo("With: phrenic bench studies a.yaml --threads 1,2 --master 'local[2]'");
    }

    @Test
    void noFolderOfTheMachineIsTold() {
        String path = folder.toString();
        assertThat(line(List.of("bench", "error", "--whole", "--scan", path, "--beside", path + "/heavy.yaml")))
                .isEqualTo("With: phrenic bench error --whole --scan DIR --beside heavy.yaml");
        assertThat(line(List.of("reproduce", "--patients", path, "--axes", "LPS", "--out", path)))
                .isEqualTo("With: phrenic reproduce --patients FOLDER --axes LPS");
        assertThat(line(List.of("sweep", "study.yaml", "--out", path), "--out", "--merge"))
                .isEqualTo("With: phrenic sweep study.yaml --out " + folder.getFileName());
        assertThat(line(List.of("validate", "--anatomy", path, "--anatomy", "virtual/adult-female")))
                .isEqualTo(
                        "With: phrenic validate --anatomy " + folder.getFileName() + " --anatomy virtual/adult-female");
        assertThat(line(List.of("validate", "--set", "anatomy=" + path)))
                .isEqualTo("With: phrenic validate --set anatomy=" + folder.getFileName());
        assertThat(line(List.of("bench", "organs", path)))
                .isEqualTo("With: phrenic bench organs " + folder.getFileName());
    }
}
