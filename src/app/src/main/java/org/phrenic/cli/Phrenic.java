package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.phrenic.cli.option.VersionProvider;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.HeadlessRun;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.ui.window.WindowStart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The {@code phrenic} command: without a subcommand it simulates a quiet breath. */
@Command(
        name = "phrenic",
        mixinStandardHelpOptions = true,
        scope = ScopeType.INHERIT,
        versionProvider = VersionProvider.class,
        synopsisSubcommandLabel = "[COMMAND]",
        usageHelpWidth = 110,
        description = "Simulate breathing: diaphragm, ribs, sternum, lungs and liver. Without a command: the window; "
                + "without a display, a quiet breath in numbers and pictures.",
        footer = {
            "",
            "Examples:",
            "  phrenic                                   the window; without a display, a quiet breath into "
                    + "./phrenic-out",
            "  phrenic window scenario.yaml              the window with a scenario, a thorax folder or a trace",
            "  phrenic run --preset deep --out result    a deep one into ./result",
            "  phrenic render --out pictures --view all  pictures of it from six sides",
            "  phrenic info scenario.yaml liver.stl      what files hold",
            "  phrenic import scan.nii.gz --out patient  a thorax folder of a segmented scan",
            "  phrenic compare a.ply b.stl               how far two surfaces lie apart",
            "  phrenic fit patient --target lungs=b.stl --out fitted   a body tuned to a second breath level",
            "  phrenic validate                          breaths held against a table of physiology",
            "  phrenic reproduce --out reproduction      the published model, as printed and as found here",
            "  phrenic rehearse plan.yaml --out report   a needle attempt to a target in the liver",
            "  phrenic sweep study.yaml --out study      many runs: which parameter decides what",
            "  phrenic ultrasound --out images           ultrasound images from a probe on the skin",
            "",
            "Exit codes: 0 done, 1 failure such as a full disk, 2 usage or bad input, 3 out of range, "
                    + "4 nothing here can draw. Results go to stdout, log and progress to stderr.",
            Disclaimer.TEXT
        })
public final class Phrenic implements Callable<Integer> {
    private static final Path DEFAULT_OUT = Path.of("phrenic-out");
    private static final String LOG_FORMAT = "java.util.logging.SimpleFormatter.format";

    @Spec
    private CommandSpec spec;

    @Option(
            names = "--debug",
            scope = ScopeType.INHERIT,
            description = "After the sentence that says what went wrong, print where.")
    private boolean debug;

    /** Ends the process with the exit code of {@link #execute}. */
    public static void main(String[] args) {
        printLogWithoutClasses();
        writeNumbersAsInFiles();
        keepToSupportedMemory();
        if (!hasLibraries()) {
            System.err.println("phrenic: found phrenic.jar without its folder lib, expected both side by side, as in"
                    + " target or in the zip");
            System.exit(ExitCode.BAD_INPUT);
        }
        System.exit(CommandProcess.run(args));
    }

    /** Lets the log on stderr consist of messages, without class and level, unless a format is set. */
    static void printLogWithoutClasses() {
        if (System.getProperty(LOG_FORMAT) == null) {
            System.setProperty(LOG_FORMAT, "%5$s%6$s%n");
        }
    }

    /** Lets window and charts show numbers as files and sentences do: decimal points and digits from 0 to 9. */
    static void writeNumbersAsInFiles() {
        Locale.setDefault(Locale.Category.FORMAT, Locale.ENGLISH);
    }

    /** Lets JOML do without sun.misc.Unsafe, about which newer Java warns on stderr and which it takes away. */
    static void keepToSupportedMemory() {
        System.setProperty("joml.nounsafe", "true");
    }

    /** Whether the jars of {@code lib} are there. This class loads without them. */
    private static boolean hasLibraries() {
        return Phrenic.class.getClassLoader().getResource("picocli/CommandLine.class") != null;
    }

    /**
     * Runs the command line {@code args}.
     *
     * @param out output for results
     * @param err output for log, progress and error messages
     * @return exit code: 0 done, 1 failure, 2 usage or bad input, 3 a result beyond its limits, 4 no graphics available
     */
    public static int execute(PrintWriter out, PrintWriter err, String... args) {
        Phrenic phrenic = new Phrenic();
        return SubCommands.execute(phrenic, () -> phrenic.debug, out, err, args);
    }

    @Override
    public Integer call() throws InterruptedException {
        Optional<String> obstacle = WindowStart.obstacle();
        if (obstacle.isEmpty()) {
            WindowStart.open(Optional.empty());
        } else {
            PrintWriter err = spec.commandLine().getErr();
            err.println(obstacle.get() + ". Running the default quiet breath without one, into " + DEFAULT_OUT
                    + " (phrenic --help lists the commands).");
            HeadlessRun.run(DEFAULT_OUT, spec.commandLine().getOut(), err);
        }
        return ExitCode.SUCCESS;
    }
}
