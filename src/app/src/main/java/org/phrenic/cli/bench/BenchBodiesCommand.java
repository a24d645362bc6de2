package org.phrenic.cli.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;
import org.phrenic.cli.option.CoarseResolutionOption;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FileNames;
import org.phrenic.mesh.io.raster.VolumeSource;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.BodyThumbnails;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.study.body.BodyCase;
import org.phrenic.study.body.BodyCut;
import org.phrenic.study.body.BodyReport;
import org.phrenic.study.body.BodyResult;
import org.phrenic.study.body.BodyStudy;
import org.phrenic.study.body.BreathDepth;
import org.phrenic.study.body.ImportedBodies;
import org.phrenic.study.body.RandomBodies;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;

/** {@code phrenic bench bodies}: checks whether bodies breathe. */
@Command(
        name = "bodies",
        description = "A quiet and a deep breath of each body: excursion of the domes, return, divergence, organs "
                + "through the diaphragm.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench bodies patient-1 patient-2 --out result",
            "  phrenic bench bodies virtual/adult-male scan.nii.gz --cuts all --out result --pictures",
            "  phrenic bench bodies --random 60 --out result            20 minutes of processor time",
            "  phrenic bench bodies --random 6 --seed 3 --extremes --resolution medium",
            "",
            "DIR gets bodies.md, .html, .csv and .json, with --pictures also bodies.png.",
            "Exit code 3 if a body is beyond a limit.",
            Disclaimer.TEXT
        })
final class BenchBodiesCommand extends ReportingCommand {
    /** Most bodies on a sheet of pictures, which is kept in memory. */
    private static final int MOST_PICTURED = 300;
    /** Scenario keys that the command sets. */
    private static final Set<String> RESERVED =
            Set.of("preset", "trace", "anatomy", "resolution", "duration_s", "steps", "threads", "changes", "hold");

    private static final int MAX_BODIES = 10_000;
    private static final int USUAL_SEED = 1;
    private static final int THUMBNAIL_WIDTH = 220;
    private static final int THUMBNAIL_HEIGHT = 250;

    @Parameters(
            paramLabel = "BODY",
            description = "A thorax folder, virtual/adult-male or virtual/adult-female; a label volume, a folder of "
                    + "masks or one of meshes without a diaphragm is imported (needs --out).")
    private List<String> bodies = new ArrayList<>();

    @Option(
            names = "--random",
            paramLabel = "N",
            description = "So many bodies of random size and shape, made from the two virtual ones.")
    private String random = "0";

    @Option(names = "--seed", paramLabel = "N", description = "Seed of the random bodies (default 1).")
    private String seed;

    @Option(names = "--extremes", description = "Heavy bodies, high livers, barrel chests.")
    private boolean extremes;

    @Option(
            names = "--cuts",
            paramLabel = "NAME,...",
            description =
                    "Instead of each body that is not a scan, bodies imported from simulated scans of it: all, or "
                            + "some of whole, abdomen, bones, bone-meshes, lungs, lungs-liver, right-side, "
                            + "cut-ends, ribs-10, ribs-20, ribs-30, effusion, dropped, slices-5, oblique, "
                            + "turned, inspired, half-inspired, inspired-abdomen, common-labels, "
                            + "common-abdomen. Needs --out.")
    private String cuts;

    @Option(
            names = "--complete",
            paramLabel = "BODY",
            description = "Completes imported bodies (default virtual/adult-male, for scans of himself "
                    + "virtual/adult-female).")
    private String complete;

    @Mixin
    private CoarseResolutionOption resolution;

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Any other key of a scenario; may be repeated.")
    private List<String> settings = new ArrayList<>();

    @Option(names = "--threads", paramLabel = "N", description = "Bodies at a time; the numbers do not depend on it.")
    private String threads = "1";

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Folder for the reports; without it, nothing is written.")
    private Path out;

    @Option(
            names = "--pictures",
            description =
                    "Also DIR/bodies.png: thumbnails of each body from the front, the right and the back, at rest "
                            + "and at the full inspiration of the deep breath.")
    private boolean pictures;

    @Mixin
    private ProvenanceOption provenance;

    @Override
    public Integer call() throws NoGraphicsException {
        if (out == null) {
            requireRead(name -> !name.equals("--made-by"), "without --out, expected both");
        }
        if (out != null) {
            ReportFolder.requireWritable(out);
        } else if (pictures || cuts != null) {
            throw new ParameterException(
                    commandLine(), "found " + (pictures ? "--pictures" : "--cuts") + " without --out, expected both");
        }
        if (complete != null && cuts == null && bodies.stream().noneMatch(BenchBodiesCommand::isScan)) {
            throw new BadInputException("--complete " + complete + ": found neither a scan nor --cuts, expected a body"
                    + " that is imported");
        }
        requireUse();
        Scenario scenario = scenario();
        BodyStudy study = pictures ? pictured(scenario) : written(run(scenario, BodyStudy.Witness.NONE));
        BodyReport report = new BodyReport(study);
        print(
                report.values(),
                () -> TextTable.ofNumbers(report.table()) + "\n" + withDisclaimer(report.summary() + ".\n"));
        return study.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    /** Refuses options that would have no effect. */
    private void requireUse() {
        if (seed != null && randomBodies() == 0) {
            throw new BadInputException("--seed " + seed + ": found it without --random, expected both");
        }
        boolean isMade = extremes || randomBodies() > 0;
        if (cuts != null && !isMade && !bodies.isEmpty() && bodies.stream().allMatch(BenchBodiesCommand::isScan)) {
            throw new BadInputException("--cuts " + cuts + ": found scans alone, expected a body that is no scan");
        }
    }

    private int randomBodies() {
        return OptionValues.integer("--random", random, 0, MAX_BODIES);
    }

    /** Writes the report, if one is asked for. */
    private BodyStudy written(BodyStudy study) {
        if (out != null) {
            BodyReport report = new BodyReport(study);
            writePages(out, "bodies", report.document(provenance.lines()));
            AtomicFile.write(out.resolve("bodies.csv"), report.csv());
            JsonWriter.write(out.resolve("bodies.json"), report.values());
        }
        return study;
    }

    private BodyStudy run(Scenario scenario, BodyStudy.Witness witness) {
        int atATime = OptionValues.threads(threads, 1);
        List<BodyCase> cases = cases(scenario);
        if (pictures && cases.size() > MOST_PICTURED) {
            throw new BadInputException(
                    "--pictures: found " + cases.size() + " bodies, expected at most " + MOST_PICTURED);
        }
        return BodyStudy.of(scenario, cases, atATime, witness, progress("bodies done"));
    }

    /** The report is written before the sheet of pictures. */
    private BodyStudy pictured(Scenario scenario) throws NoGraphicsException {
        try (BodyThumbnails thumbnails = new BodyThumbnails(THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT)) {
            BodyStudy study = written(run(scenario, (body, when, surfaces, meshes) -> {
                if (!when.equals(BreathDepth.QUIET.preset())) {
                    thumbnails.add(body, when.equals("rest") ? "at rest" : "inspired", surfaces, meshes);
                }
            }));
            if (!thumbnails.isEmpty()) {
                thumbnails.write(
                        out.resolve("bodies.png"),
                        study.bodies().stream().map(BodyResult::name).toList());
            }
            return study;
        }
    }

    private Scenario scenario() {
        List<Assignment> list = new ArrayList<>();
        list.add(resolution.assignment());
        list.addAll(OptionValues.assignments(settings, RESERVED, "the measurement"));
        return Scenario.defaults().with(list);
    }

    private List<BodyCase> cases(Scenario scenario) {
        List<BodyCut> wanted = cuts == null ? List.of() : wantedCuts();
        List<BodyCase> cases = new ArrayList<>();
        List<BodyCase> scans = new ArrayList<>();
        for (String body : bodies) {
            if (isScan(body)) {
                scans.add(ImportedBodies.scan(FileNames.path(body), template(body), scansFolder()));
            } else {
                Scenario on = scenario.with(List.of(Assignment.read(body, "anatomy", body)));
                cases.add(new BodyCase(body, "as it is", 1, () -> SimulationRun.loadThorax(on)));
            }
        }
        if (extremes) {
            cases.addAll(RandomBodies.extremes(scenario));
        }
        cases.addAll(RandomBodies.series(
                scenario,
                randomBodies(),
                seed == null ? USUAL_SEED : OptionValues.integer("--seed", seed, 0, Integer.MAX_VALUE)));
        if (cases.isEmpty() && scans.isEmpty()) {
            throw new ParameterException(commandLine(), "found no body, expected BODY, --random or --extremes");
        }
        Stream<BodyCase> sources = cuts == null
                ? cases.stream()
                : cases.stream()
                        .flatMap(source ->
                                ImportedBodies.cuts(source, wanted, template(source.name()), scansFolder()).stream());
        List<BodyCase> all = Stream.concat(sources, scans.stream()).toList();
        (cuts == null ? scans : all).forEach(this::requireOtherFolders);
        Set<String> names = new HashSet<>();
        for (BodyCase body : all) {
            if (!names.add(body.name())) {
                throw new BadInputException("found two bodies named " + body.name()
                        + ", after the last part of their paths, expected different names");
            }
        }
        return all;
    }

    /** Refuses to write a body that is imported over one that is read. */
    private void requireOtherFolders(BodyCase imported) {
        Path[] read = Stream.concat(bodies.stream(), Stream.ofNullable(complete))
                .map(FileNames::path)
                .toArray(Path[]::new);
        ImportedBodies.folders(scansFolder(), imported.name())
                .forEach(written -> ReportFolder.requireNotRead("--out", written, read));
    }

    /** Whether a body is a file or a volume, or a folder of volumes or of meshes without a diaphragm. */
    private static boolean isScan(String body) {
        Path path = FileNames.path(body);
        if (Files.isDirectory(path)) {
            return !ThoraxFolder.isWhole(path) && (LabelVolumeFiles.isVolume(path) || ThoraxFolder.isBody(path));
        }
        boolean isVolume = LabelVolumeFiles.isVolume(path);
        if (isVolume && !Files.exists(VolumeSource.of(path).path())) {
            throw new BadInputException(body + ": found no such file, expected a body");
        }
        return isVolume || Files.exists(path);
    }

    private Path scansFolder() {
        if (out == null) {
            throw new ParameterException(commandLine(), "found a scan without --out, expected both");
        }
        return out.resolve("scans");
    }

    /** Loads what completes the scans of a body. */
    private Supplier<Thorax> template(String body) {
        String usual = body.equals(RunSettings.VIRTUAL_MAN) ? RunSettings.VIRTUAL_WOMAN : RunSettings.VIRTUAL_MAN;
        String name = complete == null ? usual : complete;
        Scenario with = Scenario.defaults().with(List.of(Assignment.read("--complete", "anatomy", name)));
        return () -> SimulationRun.loadThorax(with);
    }

    private List<BodyCut> wantedCuts() {
        return cuts.equals("all")
                ? List.of(BodyCut.values())
                : OptionValues.split(cuts).stream().map(BenchBodiesCommand::cut).toList();
    }

    private static BodyCut cut(String label) {
        return Arrays.stream(BodyCut.values())
                .filter(c -> c.label().equals(label))
                .findFirst()
                .orElseThrow(() -> new BadInputException("--cuts: found '" + label + "', expected all or "
                        + Arrays.stream(BodyCut.values()).map(BodyCut::label).collect(Collectors.joining(", "))));
    }
}
