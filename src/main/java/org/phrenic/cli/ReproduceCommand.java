package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.phrenic.anatomy.Resolution;
import org.phrenic.format.AtomicFile;
import org.phrenic.format.HtmlPage;
import org.phrenic.format.MarkdownPage;
import org.phrenic.format.ReportDocument;
import org.phrenic.format.ReportDocument.Picture;
import org.phrenic.scene.FigurePicture;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.PaperFigures;
import org.phrenic.simulation.Scenario;
import org.phrenic.study.StudyProgress;
import org.phrenic.study.paper.PaperScene;
import org.phrenic.study.paper.Reproduction;
import org.phrenic.study.paper.ReproductionReport;
import org.phrenic.ui.WindowPicture;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code phrenic reproduce}: the paper's tables, figures and claims, as printed and as found here. */
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
            "",
            Notice.TEXT
        })
final class ReproduceCommand implements Callable<Integer> {
    private static final int PICTURE = 960;
    private static final int QUICK_PICTURE = 240;
    private static final double WINDOW_S = 3.4;
    private static final double QUICK_WINDOW_S = 0.1;
    private static final String PICTURES = "pictures";

    @Spec
    private CommandSpec spec;

    @Option(names = "--out", required = true, paramLabel = "DIR", description = "Folder for report and pictures.")
    private Path out;

    @Option(names = "--quick", description = "Low resolution, fewer breaths, small pictures: to see that it works.")
    private boolean quick;

    private String noPictures = "";

    @Override
    public Integer call() {
        OutputFolder.require(out);
        PrintWriter err = spec.commandLine().getErr();
        StudyProgress progress = new StudyProgress() {
            @Override
            public void done(int count, int total, String what) {
                err.println(count + " of " + total + " measured: " + what);
                err.flush();
            }
        };
        Map<Integer, List<FigurePicture>> figures = figures(err);
        Reproduction found = Reproduction.of(quick, progress);
        Map<Integer, List<Picture>> pictures = new TreeMap<>();
        figures.forEach((number, of) -> {
            of.forEach(picture -> picture.write(out.resolve(PICTURES)));
            pictures.put(
                    number,
                    of.stream()
                            .map(p -> new Picture(PICTURES + "/" + p.fileName(), p.alternative(), p.caption()))
                            .toList());
        });
        ReportDocument report =
                new ReproductionReport(found, pictures, noPictures, new VersionProvider().getVersion()[0]).document();
        AtomicFile.write(out.resolve("report.md"), MarkdownPage.of(report));
        AtomicFile.write(out.resolve("report.html"), HtmlPage.of(report));
        PrintWriter stdout = spec.commandLine().getOut();
        stdout.println(out.resolve("report.html"));
        stdout.println(Notice.TEXT);
        stdout.flush();
        return noPictures.isEmpty() ? ExitCode.DONE : ExitCode.NO_GRAPHICS;
    }

    private Map<Integer, List<FigurePicture>> figures(PrintWriter err) {
        ProgressPrinter progress = new ProgressPrinter(err, ProgressPrinter.isTerminal());
        Map<Integer, List<FigurePicture>> figures = new TreeMap<>();
        Scenario breath = quick
                ? PaperScene.own("quiet", Resolution.LOW).with("rate_per_min=60")
                : PaperScene.own("deep", Resolution.LOW);
        try {
            figures.putAll(PaperFigures.draw(
                    breath,
                    quick ? Optional.empty() : Optional.of(PaperScene.asPublished("deep", Resolution.LOW)),
                    quick ? QUICK_PICTURE : PICTURE,
                    progress));
            figures.put(2, List.of(WindowPicture.of(breath, quick ? QUICK_WINDOW_S : WINDOW_S)));
        } catch (NoGraphicsException none) {
            noPictures = none.getMessage() + ".";
            progress.note(noPictures);
        } finally {
            progress.end();
        }
        return figures;
    }
}
