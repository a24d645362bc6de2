package org.phrenic.cli.bench;

import java.nio.file.Path;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.OrderedValues;
import org.phrenic.file.BadInputException;
import org.phrenic.model.material.Numerics;
import org.phrenic.study.bare.BareResult;
import org.phrenic.study.bare.BareScene;
import org.phrenic.study.bare.BareSettings;
import org.phrenic.study.bare.BareWorkload;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/**
 * {@code phrenic bench}: measures engine steps per second on a mesh; subcommands measure speed, error, stability and
 * the window.
 */
@Command(
        name = "bench",
        description = "Measure the engine alone on a mesh: a particle a vertex, a spring an edge.",
        subcommands = {
            BenchSpeedCommand.class,
            BenchErrorCommand.class,
            BenchStabilityCommand.class,
            BenchBodiesCommand.class,
            BenchOrgansCommand.class,
            BenchFitsCommand.class,
            BenchWindowCommand.class,
            BenchExercisesCommand.class,
            BenchAccessCommand.class,
            BenchImagingCommand.class,
            BenchImportCommand.class,
            BenchStudiesCommand.class
        },
        synopsisSubcommandLabel = "[COMMAND]",
        footer = {
            "",
            "Example:",
            "  phrenic bench --mesh dome.obj --fixed dome.fixed.txt --loaded dome.loaded.txt --threads 2",
            "",
            "Index files hold vertex numbers from 0, one a line; --links two a line."
        })
public final class BenchCommand extends ReportingCommand {

    /** A group, so that its files are required together, and not if a subcommand is given. */
    @ArgGroup(exclusive = false)
    private Files files;

    private static final class Files {
        @Option(
                names = "--mesh",
                required = true,
                paramLabel = "FILE",
                description = "Surface: obj, ply, stl, vtk, vtp.")
        private Path mesh;

        @Option(names = "--fixed", required = true, paramLabel = "FILE", description = "Vertices that are held still.")
        private Path fixed;

        @Option(names = "--loaded", required = true, paramLabel = "FILE", description = "Vertices that carry the load.")
        private Path loaded;

        @Option(names = "--links", paramLabel = "FILE", description = "Pairs of vertices held at their distance.")
        private Path links;
    }

    @Option(names = "--steps", paramLabel = "N", description = "Steps of each timed run (default ${DEFAULT-VALUE}).")
    private int steps = BareSettings.DEFAULT.steps();

    @Option(names = "--integrator", paramLabel = "NAME", description = "Scheme (default ${DEFAULT-VALUE}).")
    private String integrator = BareSettings.DEFAULT.integrator().label();

    @Option(names = "--threads", paramLabel = "N", description = "Threads (default ${DEFAULT-VALUE}).")
    private int threads = BareSettings.DEFAULT.threads();

    @Option(
            names = "--kernel",
            paramLabel = "NAME",
            description = "How forces of springs are computed: ${DEFAULT-VALUE}, the only way there is.")
    private String kernel = BareWorkload.KERNEL;

    @Override
    public Integer call() {
        if (files == null) {
            throw new ParameterException(commandLine(), "found neither --mesh nor a sub-command, expected one of them");
        }
        if (threads < 1 || threads > Numerics.MAX_THREADS) {
            throw new BadInputException("--threads: found " + threads + ", expected 1 to " + Numerics.MAX_THREADS);
        }
        if (steps < 1) {
            throw new BadInputException("--steps: found " + steps + ", expected 1 or more");
        }
        BareSettings settings = BareSettings.DEFAULT
                .withIntegrator(OptionValues.integrator(integrator))
                .withThreads(threads)
                .withSteps(steps);
        if (!kernel.equals(BareWorkload.KERNEL)) {
            throw new BadInputException("--kernel: found '" + kernel + "', expected " + BareWorkload.KERNEL);
        }
        BareScene scene = BareScene.read(files.mesh, files.fixed, files.loaded, files.links);
        if (scene.loaded().length == 0) {
            throw new BadInputException(files.loaded + ": found no vertex index, expected at least one");
        }
        BareResult result = BareWorkload.run(scene, settings);
        if (!Double.isFinite(result.meanDz200())) {
            err().println("phrenic: the workload diverged within " + BareWorkload.CHECKED_STEPS
                    + " steps of integrator " + result.integrator());
            return ExitCode.FAILURE;
        }
        print(result);
        return ExitCode.SUCCESS;
    }

    private void print(BareResult result) {
        OrderedValues values = new OrderedValues()
                .with("steps_per_s", result.stepsPerSecond())
                .with("min", result.min())
                .with("max", result.max())
                .with("nodes", result.nodes())
                .with("edges", result.edges())
                .with("links", result.links())
                .with("threads", result.threads())
                .with("integrator", result.integrator())
                .with("kernel", result.kernel())
                .with("mean_dz_200", result.meanDz200())
                .with("roots_per_s", result.roofline().rootsPerSecond())
                .with("bytes_per_s", result.roofline().bytesPerSecond())
                .with("floor_steps_per_s", result.roofline().stepsPerSecond())
                .with("fraction_of_floor", result.fractionOfRoofline())
                .with("state_sha256", result.stateSha256());
        TextTable table = new TextTable(false, false);
        values.forEach((key, value) -> table.row(key, String.valueOf(value)));
        print(values, table::text);
    }
}
