package org.phrenic.cli.bench;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.cli.option.CoarseResolutionOption;
import org.phrenic.cli.option.FitSearchOptions;
import org.phrenic.cli.option.OptionValues;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.file.FolderLock;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.Attempts;
import org.phrenic.study.body.BodyCase;
import org.phrenic.study.body.RandomBodies;
import org.phrenic.study.fit.FitStudyReport;
import org.phrenic.study.fit.KnownBreath;
import org.phrenic.study.fit.PatientFit;
import org.phrenic.study.fit.PatientImport;
import org.phrenic.study.fit.PatientScans;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** {@code phrenic bench fits}: fits to real patients and to known breaths of random bodies. */
@Command(
        name = "fits",
        description = "Fits patients at two breath levels (whole, and by halves), and known breaths of random bodies.",
        footer = {
            "",
            "Examples:",
            "  phrenic bench fits --patients scans --out result          4 minutes of processor time a patient",
            "  phrenic bench fits --random 60 --evaluations 20 --out result",
            "",
            "DIR gets fits.md, .html, .json and the journals: the same command in the same folder goes on.",
            "A patient whose scans cannot be used is named, and the others are fitted.",
            "Exit code 3 if a fit ends without a result or a patient could not be fitted.",
            Disclaimer.TEXT
        })
final class BenchFitsCommand extends ReportingCommand {
    private static final int MAX_BODIES = 10_000;

    @Option(
            names = "--patients",
            paramLabel = "FOLDER",
            description = "NAME_expiration.*, NAME_inspiration.* (label volumes) and NAME_landmarks.csv, if there are.")
    private Path patients;

    @Option(names = "--random", paramLabel = "N", description = "So many random bodies (default ${DEFAULT-VALUE}).")
    private String random = "0";

    @Option(names = "--seed", paramLabel = "N", description = "Seed of bodies and searches (default ${DEFAULT-VALUE}).")
    private String seed = "1";

    @Mixin
    private CoarseResolutionOption resolution;

    @Mixin
    private final FitSearchOptions length = new FitSearchOptions(62);

    @Mixin
    private ProvenanceOption provenance;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Folder for the report.")
    private Path out;

    @Override
    public Integer call() {
        ReportFolder.requireWritable(out);
        int count = OptionValues.integer("--random", random, 0, MAX_BODIES);
        if (patients == null && count == 0) {
            throw new ParameterException(commandLine(), "found neither --patients nor --random, expected one of them");
        }
        int start = OptionValues.integer("--seed", seed, 0, Integer.MAX_VALUE);
        FitSearch.Settings search = new FitSearch.Settings(start, length.evaluations());
        Scenario base = Scenario.defaults().with("preset=deep").with(List.of(resolution.assignment()));
        List<PatientScans> pairs = patients == null ? List.of() : PatientScans.findIn(patients);
        FitStudyReport report;
        try (FolderLock mine = FolderLock.of(out)) {
            report = fit(pairs, RandomBodies.series(base, count, start), base, search);
            writePages(mine.folder(), "fits", report.document(provenance.lines()));
            JsonWriter.write(out.resolve("fits.json"), report.values());
        }
        print(report.values(), () -> {
            String failures = report.failures().stream()
                    .map(failure -> "not fitted: " + failure + ".\n")
                    .collect(Collectors.joining());
            return withDisclaimer(failures + report.summary() + ".\n");
        });
        return report.passes() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private FitStudyReport fit(
            List<PatientScans> pairs, List<BodyCase> bodies, Scenario base, FitSearch.Settings search) {
        int atATime = length.threads();
        Path journals = out.resolve("journals");
        ConsoleProgress progress = progress();
        Attempts<PatientFit> fitted = new Attempts<>();
        for (PatientScans scans : pairs) {
            Path landmarks = patients.resolve(scans.name() + "_landmarks.csv");
            fitted.add(
                    scans.name(),
                    () -> PatientFit.of(
                            PatientImport.of(scans, Optional.empty()),
                            base,
                            Optional.of(landmarks).filter(Files::isRegularFile),
                            search,
                            atATime,
                            journals,
                            progress));
        }
        fitted.failures().forEach(progress::note);
        List<KnownBreath> known = new ArrayList<>();
        for (BodyCase body : bodies) {
            progress.note(body.name());
            known.add(KnownBreath.of(body, base, search.seed() + known.size(), search, atATime, journals, progress));
        }
        progress.end();
        return new FitStudyReport(fitted.results(), known, fitted.failures());
    }
}
