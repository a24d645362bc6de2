package org.phrenic.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.cli.option.FitSearchOptions;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.FitPictures;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.file.BadInputException;
import org.phrenic.file.FolderLock;
import org.phrenic.fit.Fit;
import org.phrenic.fit.FitHalf;
import org.phrenic.fit.FitReport;
import org.phrenic.fit.FitResult;
import org.phrenic.fit.FitSetup;
import org.phrenic.fit.FitTarget;
import org.phrenic.fit.LandmarkTable;
import org.phrenic.fit.Landmarks;
import org.phrenic.fit.SyntheticPatient;
import org.phrenic.fit.SyntheticStudy;
import org.phrenic.fit.TargetAlignment;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic fit}: fits a body to a second breath level. */
@Command(
        name = "fit",
        description = "Tune a body until its surfaces, breathed in and held, lie on those of a second breath level.",
        footer = {
            "",
            "Examples:",
            "  phrenic fit patient --target lung_R=inspiration/lung_R.vtp --target "
                    + "lung_L=inspiration/lung_L.vtp --out result",
            "  phrenic fit patient --target lungs=inspiration.stl --hold-out half --minutes 5 --out result",
            "  phrenic fit patient --target lung_R=r.vtp --target lung_L=l.vtp --hold-out lung_L --out result",
            "  phrenic fit virtual/adult-male --target liver=points.csv --tune "
                    + "muscle_activation,rib_rotation=0:1 --out result",
            "  phrenic fit --synthetic 5 --resolution low --evaluations 62 --out known",
            "",
            "DIR gets report.html, report.md, fit.json, fit.csv, scenario.yaml (what it takes to do the fitted "
                    + "breath again) and",
            "journal.csv, which keeps every evaluation: the same command goes on from it.",
            "Exit code 3 if scenario.yaml does not give the fitted state again.",
            Disclaimer.TEXT
        })
final class FitCommand extends ReportingCommand {
    /** Options that are read with --synthetic. */
    private static final Set<String> OF_SYNTHETIC = Set.of(
            "--synthetic",
            "--resolution",
            "--evaluations",
            "--threads",
            "--seed",
            "--out",
            "--made-by",
            "--json",
            "--debug");

    /** Scenario keys that the command sets. */
    private static final Set<String> RESERVED =
            Set.of("anatomy", "duration_s", "steps", "changes", "hold", "rate_per_min", "inspiratory_fraction");

    private static final List<String> WRITTEN = List.of("landmarks.csv", "fit.csv", "journal.csv");

    private static final String HALF = "half";
    private static final String OTHER_HALF = "other-half";
    private static final double MINUTE_S = 60;

    @Parameters(
            arity = "0..1",
            paramLabel = "THORAX",
            description = "A thorax folder, virtual/adult-male or virtual/adult-female: the body at end-expiration.")
    private String thorax;

    @Option(
            names = "--target",
            paramLabel = "PART=FILE",
            description =
                    "Surface of a part at the second breath level (stl, obj, ply, vtk, vtp), or pairs of points (csv)."
                            + " Parts: lungs, lung_R, lung_L, lung_base_R, lung_base_L, diaphragm, liver. "
                            + "lung_R and lung_L bring their bases, lungs (both in one) does not. May be repeated.")
    private List<String> targets = new ArrayList<>();

    @Option(
            names = "--synthetic",
            paramLabel = "N",
            description = "Instead: fit N (1 to 5) virtual patients whose breath is known, and say what was recovered.")
    private String synthetic;

    @Option(
            names = "--hold-out",
            paramLabel = "WHAT",
            description =
                    "Fit without it and report on it: the part of a target; half, every other square of 40 mm of all "
                            + "surfaces; or other-half, the other squares.")
    private List<String> heldOut = new ArrayList<>();

    @Option(
            names = "--tune",
            paramLabel = "KEY[=MIN:MAX],...",
            description = "What to tune and how far, instead of the usual.")
    private List<String> tune = new ArrayList<>();

    @Option(
            names = "--landmarks",
            paramLabel = "FILE",
            description = "Pairs of points inside the lungs (csv), at both levels and each in the axes of its scan, to"
                    + " report on.")
    private Path landmarks;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Folder for the report.")
    private Path out;

    @Option(names = "--preset", paramLabel = "NAME", description = "deep, quiet or quiet-supine (default deep).")
    private String preset = "deep";

    @Option(names = "--resolution", paramLabel = "NAME", description = "low, medium or high (default medium).")
    private String resolution = "medium";

    @Option(names = "--set", paramLabel = "KEY=VALUE", description = "Any other key of a scenario; may be repeated.")
    private List<String> settings = new ArrayList<>();

    @Mixin
    private final FitSearchOptions length = new FitSearchOptions(400);

    @Mixin
    private ProvenanceOption made;

    @Option(names = "--minutes", paramLabel = "M", description = "Begin no generation after so many minutes.")
    private String minutes;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of the search (default ${DEFAULT-VALUE}).")
    private String seed = "1";

    @Option(names = "--population", paramLabel = "N", description = "Breaths a generation (default 4 + 3 ln n).")
    private String population;

    @Option(names = "--no-sensitivity", description = "Do not move each parameter to both sides in the end.")
    private boolean noSensitivity;

    @Option(names = "--no-pictures", description = "Draw nothing.")
    private boolean noPictures;

    @Override
    public Integer call() {
        ReportFolder.requireWritable(out);
        ConsoleProgress printer = progress();
        if (synthetic != null) {
            return synthetic(printer);
        }
        requireRead(name -> !name.equals("--made-by"), "without --synthetic, expected both");
        if (thorax == null || targets.isEmpty()) {
            throw new BadInputException("fit: found no " + (thorax == null ? "THORAX" : "--target")
                    + ", expected a body and a --target PART=FILE, or --synthetic N");
        }
        Scenario base = scenario();
        List<FitTarget> read = targets();
        requireNotWrittenOver();
        List<FitParameter> parameters = parameters(base);
        Thorax body = SimulationRun.loadThorax(base);
        int size = population == null ? 0 : OptionValues.integer("--population", population, 4, 1000);
        double limitS = minutes == null
                ? Double.POSITIVE_INFINITY
                : MINUTE_S * OptionValues.number("--minutes", minutes, 0, 1e5);
        FitSearch.Settings search = new FitSearch.Settings(seed(), size, length.evaluations(), limitS);
        TargetAlignment alignment =
                TargetAlignment.beside(targets.stream().map(FitCommand::file).toList());
        Optional<Landmarks> inside = Optional.ofNullable(landmarks).map(file -> Landmarks.read(file, alignment));
        FitSetup.Options options =
                new FitSetup.Options(half(), alignment.sentence(), search, length.threads(), !noSensitivity, inside);
        FitSetup setup = new FitSetup(base, body, read, parameters, options);
        body.notes().forEach(printer::note);
        try (FolderLock mine = FolderLock.of(out)) {
            FitResult result = Fit.run(setup, mine.folder().resolve("journal.csv"), printer);
            printer.end();
            report(result);
            return exitCode(result.reproduced());
        }
    }

    /** A fitted breath is of use only if its scenario does it again. */
    static int exitCode(boolean reproduced) {
        return reproduced ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    /** Refuses landmarks and targets that the report would be written over. */
    private void requireNotWrittenOver() {
        Path[] inputs = Stream.concat(
                        Stream.ofNullable(landmarks), targets.stream().map(FitCommand::file))
                .toArray(Path[]::new);
        for (String file : WRITTEN) {
            ReportFolder.requireNotRead("--out", out.resolve(file), inputs);
        }
    }

    private static Path file(String target) {
        return Path.of(target.substring(target.indexOf('=') + 1));
    }

    private void report(FitResult result) {
        FitReport report = new FitReport(result);
        List<ReportDocument.Picture> pictures = noPictures ? List.of() : FitPictures.draw(result, out, err());
        report.write(out);
        FitSetup setup = result.setup();
        setup.options()
                .landmarks()
                .ifPresent(points -> points.write(
                        out.resolve("landmarks.csv"), setup.thorax().structuresOf(StructureKind.LUNG)));
        writePages(out, "report", report.document(pictures));
        print(report.values(), () -> {
            String distances =
                    new TextTable(FitReport.DISTANCES).rows(report.distances()).text();
            String carried = result.landmarks().map(FitCommand::inside).orElse("");
            String tuned = new TextTable(FitReport.PARAMETERS)
                    .rows(report.parameters())
                    .text();
            String limits = String.join("\n", report.limits());
            return withDisclaimer(String.join("\n", distances, carried + tuned, report.summary(), limits));
        });
    }

    private static String inside(Landmarks.Errors errors) {
        LandmarkTable table = new LandmarkTable(errors);
        return new TextTable(LandmarkTable.COLUMNS).rows(table.rows()).text() + table.shifts() + "\n\n";
    }

    private int synthetic(ConsoleProgress printer) {
        if (thorax != null) {
            throw new BadInputException("--synthetic " + synthetic + ": found the body " + thorax
                    + " beside it, expected the virtual patients alone");
        }
        requireRead(OF_SYNTHETIC::contains, "with --synthetic, which does not read it");
        int count = OptionValues.integer(
                "--synthetic", synthetic, 1, SyntheticPatient.five().size());
        Resolution meshes = OptionValues.resolution(resolution);
        FitSearch.Settings search = new FitSearch.Settings(seed(), length.evaluations());
        try (FolderLock mine = FolderLock.of(out)) {
            SyntheticStudy study = SyntheticStudy.run(count, meshes, length.threads(), search, mine.folder(), printer);
            printer.end();
            JsonWriter.write(out.resolve("synthetic.json"), study.values());
            writePages(out, "synthetic", study.document(made.lines()));
            print(
                    study.values(),
                    () -> withDisclaimer(new TextTable(SyntheticStudy.COLUMNS)
                                    .rows(study.cells())
                                    .text()
                            + study.failure().map(s -> s + "\n").orElse("")));
            return exitCode(study.failure().isEmpty());
        }
    }

    private FitHalf half() {
        if (heldOut.contains(HALF) && heldOut.contains(OTHER_HALF)) {
            throw new BadInputException("--hold-out: found " + HALF + " and " + OTHER_HALF + ", expected one of them");
        }
        return heldOut.contains(HALF) ? FitHalf.EVEN : heldOut.contains(OTHER_HALF) ? FitHalf.ODD : FitHalf.ALL;
    }

    private int seed() {
        return OptionValues.integer("--seed", seed, 0, Integer.MAX_VALUE);
    }

    private Scenario scenario() {
        List<Assignment> list = new ArrayList<>();
        OptionValues.assign(list, "--preset", "preset", preset);
        list.add(Assignment.read(thorax, "anatomy", thorax));
        OptionValues.assign(list, "--resolution", "resolution", resolution);
        list.addAll(OptionValues.assignments(settings, RESERVED, "a fit"));
        return Scenario.defaults().with(list);
    }

    private List<FitTarget> targets() {
        List<FitTarget> read = targets.stream().map(FitTarget::read).toList();
        for (int i = 0; i < read.size(); i++) {
            String name = read.get(i).name();
            if (read.subList(0, i).stream().anyMatch(t -> t.name().equals(name))) {
                throw new BadInputException(
                        "--target " + targets.get(i) + ": found its part a second time, expected it once");
            }
        }
        List<FitTarget> list = FitTarget.withBases(read);
        // The base of a held-out lung is also held out.
        list.replaceAll(t -> isHeldOut(t.part().label()) ? t.withWeight(0) : t);
        List<String> parts = list.stream().map(t -> t.part().label()).toList();
        for (String what : heldOut) {
            if (!what.equals(HALF) && !what.equals(OTHER_HALF) && !parts.contains(what)) {
                throw new BadInputException("--hold-out " + what + ": found no such target, expected " + HALF
                        + " or the part of a --target");
            }
        }
        if (list.stream().allMatch(t -> t.weight() == 0)) {
            throw new BadInputException("--hold-out: found every target held out, expected one to fit to");
        }
        return list;
    }

    private boolean isHeldOut(String part) {
        return heldOut.contains(part) || heldOut.contains(part.replace("_base", ""));
    }

    private List<FitParameter> parameters(Scenario base) {
        if (tune.isEmpty()) {
            return FitParameter.defaults(base);
        }
        List<FitParameter> list = new ArrayList<>();
        for (String text : OptionValues.split(String.join(",", tune))) {
            FitParameter parameter = FitParameter.parse(text, base);
            if (list.stream().anyMatch(p -> p.parameter() == parameter.parameter())) {
                throw new BadInputException("--tune " + text + ": found it a second time, expected it once");
            }
            list.add(parameter);
        }
        return list;
    }
}
