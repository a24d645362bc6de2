package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.phrenic.format.AtomicFile;
import org.phrenic.format.HtmlPage;
import org.phrenic.format.Json;
import org.phrenic.format.ReportDocument.Picture;
import org.phrenic.rehearsal.Goals;
import org.phrenic.rehearsal.NeedleView;
import org.phrenic.rehearsal.Rehearsal;
import org.phrenic.rehearsal.RehearsalPlan;
import org.phrenic.rehearsal.RehearsalReport;
import org.phrenic.scene.NeedlePictures;
import org.phrenic.scene.NoGraphicsException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code phrenic rehearse}: a planned needle attempt on the breathing body, and its report. */
@Command(
        name = "rehearse",
        description = "Play a planned needle attempt to a target in the liver and write its report.",
        footer = {
            "",
            "Examples:",
            "  phrenic rehearse data/exercises/1-large-target.yaml --out report",
            "  phrenic rehearse plan.yaml --out report --no-pictures --json",
            "",
            "DIR gets report.json, report.html and pictures. Exit code 3: what the plan counts as done was not reached.",
            "",
            Notice.TEXT
        })
final class RehearseCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "PLAN", description = "YAML file: body and breathing, target, needle, steps.")
    private Path planFile;

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Folder for the report.")
    private Path out;

    @Option(names = "--json", description = "Print the report as JSON instead of a table.")
    private boolean json;

    @Option(names = "--no-pictures", description = "Draw nothing.")
    private boolean noPictures;

    @Override
    public Integer call() {
        OutputFolder.require(out);
        PrintWriter err = spec.commandLine().getErr();
        ProgressPrinter progress = new ProgressPrinter(err, ProgressPrinter.isTerminal());
        Rehearsal rehearsal = Rehearsal.play(RehearsalPlan.read(planFile), progress);
        progress.end();
        RehearsalReport report = new RehearsalReport(rehearsal);
        Map<String, Object> values = report.values();
        List<Picture> needle = new ArrayList<>();
        List<Picture> map = new ArrayList<>();
        if (!noPictures) {
            draw(rehearsal, needle, map, err);
        }
        AtomicFile.write(out.resolve("report.html"), HtmlPage.of(report.document(needle, map)));
        Json.write(out.resolve("report.json"), values);
        print(rehearsal, values);
        return rehearsal.isDone() ? ExitCode.DONE : ExitCode.OUT_OF_RANGE;
    }

    private void draw(Rehearsal rehearsal, List<Picture> needle, List<Picture> map, PrintWriter err) {
        String title = rehearsal.plan().title();
        try (NeedlePictures pictures = NeedlePictures.open(rehearsal.surfaces())) {
            for (NeedleView view : rehearsal.views()) {
                for (String file : pictures.needle(out, view, title)) {
                    if (view.name().startsWith("sample")) {
                        needle.add(new Picture(file, "Needle and target in the body, " + file, ""));
                    }
                }
            }
            pictures.map(out, rehearsal.map(), title)
                    .forEach(file -> map.add(new Picture(file, "Access map on the skin, " + file, "")));
        } catch (NoGraphicsException none) {
            err.println("The report has no pictures: " + none.getMessage());
        }
    }

    private void print(Rehearsal rehearsal, Map<String, Object> values) {
        PrintWriter stdout = spec.commandLine().getOut();
        if (json) {
            stdout.print(Json.format(values));
        } else {
            Table table = new Table(false, true, false);
            rehearsal.record().headlines().forEach((key, value) -> {
                Quantity quantity = Quantity.of(key);
                table.row(quantity.label(), Quantity.shown(value), quantity.unit());
            });
            stdout.print(table.text());
            List<Goals.Outcome> goals = rehearsal.plan().goals().of(rehearsal.record());
            if (!goals.isEmpty()) {
                Table asked = new Table(false, true, true, false).row("goal", "asked", "reached", "");
                goals.forEach(g -> asked.row(
                        g.goal(), Quantity.shown(g.limit()), Quantity.shown(g.value()), g.reached() ? "yes" : "NO"));
                stdout.print("\n" + asked.text());
            }
            stdout.print("\n" + (rehearsal.isDone() ? "done" : "not done") + "\n" + Notice.TEXT + "\n");
        }
        stdout.flush();
    }
}
