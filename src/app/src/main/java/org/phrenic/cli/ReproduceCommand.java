package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.phrenic.anatomy.Resolution;
import org.phrenic.cli.option.ProvenanceOption;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.PatientPictures;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.BadInputException;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.PaperFigures;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.study.Attempts;
import org.phrenic.study.PaperScenarios;
import org.phrenic.study.fit.PatientScans;
import org.phrenic.study.paper.PatientCase;
import org.phrenic.study.paper.PatientResults;
import org.phrenic.study.paper.PatientStudy;
import org.phrenic.study.paper.ReportPictures;
import org.phrenic.study.paper.Reproduction;
import org.phrenic.study.paper.ReproductionReport;
import org.phrenic.ui.window.WindowSnapshot;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code phrenic reproduce}: compares tables, figures and claims of the paper with values computed here. */
@Command(
        name = "reproduce",
        description = "Reproduce the tables, figures and claims of Villard, Bourne and Bello 2009 in one report.",
        footer = {
            "",
            "Example:",
            "  phrenic reproduce --out reproduction",
            "",
            "DIR gets report.html, report.md and pictures/. The report comes last: a folder that has one is complete.",
            "Where nothing draws, it has a sentence in place of each picture, and the exit code is 4.",
            "Scans that cannot be used, and breaths that cannot be simulated, are named in it, and the exit code is 3.",
            "",
            Disclaimer.TEXT
        })
final class ReproduceCommand implements Callable<Integer> {
    private static final int PICTURE = 960;
    private static final int QUICK_PICTURE = 240;
    private static final int PATIENT_PICTURE = 720;
    private static final double WINDOW_S = 3.4;
    private static final double QUICK_WINDOW_S = 0.1;
    private static final String PICTURES = "pictures";
    private static final String PAGE = "report.html";
    private static final String TEXT = "report.md";

    @Spec
    private CommandSpec spec;

    @Option(names = "--out", required = true, paramLabel = "DIR", description = "Folder for report and pictures.")
    private Path out;

    @Option(names = "--quick", description = "Coarse meshes, fewer breaths, small pictures: to see that it works.")
    private boolean quick;

    @Option(
            names = "--patients",
            paramLabel = "FOLDER",
            description = "Scans at two breath levels for figs. 4 and 5: NAME_expiration.* and NAME_inspiration.*, "
                    + "volumes of labels. Without it, ../shared/segmentations/breath-pairs-true if that is "
                    + "there, else a synthetic patient.")
    private Path patients;

    @Option(
            names = "--axes",
            paramLabel = "XYZ",
            description = "Axes of the patients' volumes, such as LPS, where the files state them wrongly.")
    private String axes;

    @Mixin
    private ProvenanceOption made;

    private String noPictures = "";

    /** Patients whose scans cannot be used, each with the reason; empty if there are none. */
    private String unusable = "";

    @Override
    public Integer call() {
        ReportFolder.requireWritable(out);
        PrintWriter err = spec.commandLine().getErr();
        ProgressListener progress = new ConsoleProgress(err, "measured");
        Optional<List<PatientScans>> scans = scans();
        Map<Integer, List<FigureImage>> figures = figures(err);
        Reproduction found = Reproduction.of(quick, progress);
        PatientResults people = patientResults(scans, new ConsoleProgress(err, "patients done"));
        Map<Integer, List<Picture>> pictures = replacePictures(figures);
        Map<String, List<Picture>> segmented = new TreeMap<>();
        Map<String, List<Picture>> distances = new TreeMap<>();
        draw(people, segmented, distances);
        ReportPictures drawn = new ReportPictures(pictures, segmented, distances, noPictures);
        ReportDocument report = new ReproductionReport(found, people, drawn, made.lines()).document();
        AtomicFile.write(out.resolve(TEXT), MarkdownPage.format(report));
        AtomicFile.write(out.resolve(PAGE), HtmlPage.format(report));
        PrintWriter stdout = spec.commandLine().getOut();
        stdout.println(out.resolve(PAGE));
        stdout.println(Disclaimer.TEXT);
        stdout.flush();
        if (!unusable.isEmpty() || !found.failures().isEmpty()) {
            return ExitCode.CHECK_FAILED;
        }
        return noPictures.isEmpty() ? ExitCode.SUCCESS : ExitCode.NO_GRAPHICS;
    }

    /** Writes figures by number, and deletes before it an earlier report, which would show them. */
    Map<Integer, List<Picture>> replacePictures(Map<Integer, List<FigureImage>> figures) {
        AtomicFile.delete(out.resolve(PAGE));
        AtomicFile.delete(out.resolve(TEXT));
        Map<Integer, List<Picture>> pictures = new TreeMap<>();
        figures.forEach((number, of) -> pictures.put(number, writeFigures(of)));
        return pictures;
    }

    private Optional<List<PatientScans>> scans() {
        if (axes != null) {
            GeometryOverride.requireAxes(axes);
        }
        if (patients != null) {
            return Optional.of(PatientScans.findIn(patients));
        }
        if (axes != null) {
            throw new BadInputException(
                    "--axes " + axes + ": found no --patients, expected scans to which they belong");
        }
        return !quick && Files.isDirectory(PatientStudy.DEFAULT_FOLDER)
                ? Optional.of(PatientScans.findIn(PatientStudy.DEFAULT_FOLDER))
                : Optional.empty();
    }

    private PatientResults patientResults(Optional<List<PatientScans>> scans, ProgressListener progress) {
        PatientStudy study = new PatientStudy(quick, progress);
        if (scans.isPresent()) {
            int left = (int) scans.get().stream().filter(PatientScans::isPair).count() - PatientStudy.MAX_PATIENTS;
            String rest = left > 0 && !quick ? left + " more of the scans were left out for want of time." : "";
            Attempts<PatientCase> cases = study.of(scans.get(), Optional.ofNullable(axes));
            unusable = cases.failures().stream()
                    .map(failure -> "Not used: " + failure + ". ")
                    .collect(Collectors.joining());
            if (!cases.results().isEmpty()) {
                return new PatientResults(cases.results(), (unusable + rest).strip(), quick);
            }
        }
        String none = quick
                ? "A quick reproduction looks at no scan, and tunes nothing."
                : "No scans were found in " + PatientStudy.DEFAULT_FOLDER
                        + "; --patients FOLDER names a folder with NAME_expiration.* and NAME_inspiration.*.";
        String why = unusable.isEmpty() ? none : unusable.strip();
        String note = why + " A synthetic patient stands in: figures show what they would, and say nothing of people.";
        return new PatientResults(List.of(study.synthetic()), note, quick);
    }

    private void draw(
            PatientResults people, Map<String, List<Picture>> segmented, Map<String, List<Picture>> distances) {
        if (!noPictures.isEmpty()) {
            return;
        }
        try {
            for (int p = 0; p < people.cases().size(); p++) {
                PatientCase patient = people.cases().get(p);
                PatientPictures drawn = new PatientPictures(patient, p + 1, quick ? QUICK_PICTURE : PATIENT_PICTURE);
                segmented.put(patient.name(), writeFigures(drawn.segmentationFigures()));
                distances.put(patient.name(), writeFigures(drawn.distanceFigures()));
            }
        } catch (NoGraphicsException none) {
            noPictures = none.getMessage() + ".";
        }
    }

    private List<Picture> writeFigures(List<FigureImage> figure) {
        figure.forEach(picture -> picture.write(out.resolve(PICTURES)));
        return figure.stream()
                .map(p -> new Picture(PICTURES + "/" + p.fileName(), p.altText(), p.caption()))
                .toList();
    }

    private Map<Integer, List<FigureImage>> figures(PrintWriter err) {
        ConsoleProgress progress = new ConsoleProgress(err);
        Map<Integer, List<FigureImage>> figures = new TreeMap<>();
        Scenario breath = quick
                ? PaperScenarios.defaultModel("quiet", Resolution.LOW)
                        .with("rate_per_min=60", PaperScenarios.QUICK_MESH)
                : PaperScenarios.defaultModel("deep", Resolution.LOW);
        try {
            Optional<Scenario> published =
                    quick ? Optional.empty() : Optional.of(PaperScenarios.publishedModel("deep", Resolution.LOW));
            figures.putAll(PaperFigures.draw(breath, published, quick ? QUICK_PICTURE : PICTURE, progress));
            figures.put(2, List.of(WindowSnapshot.of(breath, quick ? QUICK_WINDOW_S : WINDOW_S)));
        } catch (NoGraphicsException none) {
            noPictures = none.getMessage() + ".";
            progress.note(noPictures);
        } finally {
            progress.end();
        }
        return figures;
    }
}
