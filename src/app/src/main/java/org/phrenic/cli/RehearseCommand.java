package org.phrenic.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.phrenic.access.plan.Goals;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.cli.option.ReportFolder;
import org.phrenic.cli.report.ConsoleProgress;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.QuantityKey;
import org.phrenic.cli.report.ReportingCommand;
import org.phrenic.cli.report.TextTable;
import org.phrenic.document.JsonWriter;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.file.AtomicFile;
import org.phrenic.scene.NeedlePictures;
import org.phrenic.scene.RehearsalPictures;
import org.phrenic.scene.gl.NoGraphicsException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code phrenic rehearse}: simulates a planned needle insertion in the breathing body and writes a report. */
@Command(
        name = "rehearse",
        description = "Play a planned needle attempt to a target in the liver and write its report.",
        footer = {
            "",
            "Examples:",
            "  phrenic rehearse data/exercises/1-large-target.yaml --out report",
            "  phrenic rehearse plan.yaml --out report --no-pictures --json",
            "",
            "DIR gets report.json, report.html and pictures. Exit code 3: what the plan counts as done was not "
                    + "reached.",
            "",
            Disclaimer.TEXT
        })
final class RehearseCommand extends ReportingCommand {
    @Parameters(paramLabel = "PLAN", description = "YAML file: body and breathing, target, needle, steps.")
    private Path planFile;

    private static final String REPORT = "report.json";
    private static final String PAGE = "report.html";

    @Option(names = "--out", paramLabel = "DIR", required = true, description = "Folder for the report.")
    private Path out;

    @Option(names = "--no-pictures", description = "Draw neither needle nor map.")
    private boolean noPictures;

    @Override
    public Integer call() {
        ReportFolder.requireWritable(out);
        ConsoleProgress progress = progress();
        Rehearsal rehearsal = Rehearsal.play(RehearsalPlan.read(planFile), progress);
        progress.end();
        RehearsalReport report = new RehearsalReport(rehearsal);
        // Those of an earlier attempt would describe other pictures.
        AtomicFile.delete(out.resolve(PAGE));
        AtomicFile.delete(out.resolve(REPORT));
        RehearsalPictures pictures = new RehearsalPictures(rehearsal, out);
        if (!noPictures) {
            draw(rehearsal, pictures);
        }
        pictures.writeImages(report);
        if (!pictures.missing().isEmpty()) {
            err().println("The report lacks pictures: " + pictures.missing());
        }
        Map<String, Object> values = report.values();
        String html = HtmlPage.format(report.document(pictures.needle(), pictures.map(), RehearsalReport.dateNow()));
        AtomicFile.write(out.resolve(PAGE), html);
        JsonWriter.write(out.resolve(REPORT), values);
        print(values, () -> text(rehearsal));
        return rehearsal.goalsReached() ? ExitCode.SUCCESS : ExitCode.CHECK_FAILED;
    }

    private static void draw(Rehearsal rehearsal, RehearsalPictures pictures) {
        try (NeedlePictures drawn = NeedlePictures.open(rehearsal.body())) {
            pictures.draw(what -> what.accept(drawn));
        } catch (NoGraphicsException | RuntimeException none) {
            pictures.setMissing(none);
        }
    }

    private static String text(Rehearsal rehearsal) {
        TextTable table = new TextTable(false, true, false);
        rehearsal.record().headlines().forEach(table::quantity);
        StringBuilder text = new StringBuilder(table.text());
        List<Goals.GoalResult> goals = rehearsal.plan().goals().evaluate(rehearsal.record());
        if (!goals.isEmpty()) {
            text.append('\n').append(text(goals));
        }
        text.append('\n').append(rehearsal.goalsReached() ? "done" : "not done");
        return withDisclaimer(text.toString());
    }

    static String text(List<Goals.GoalResult> goals) {
        TextTable asked = new TextTable(Column.list("goal | # asked | # reached | "));
        for (Goals.GoalResult g : goals) {
            String reached = g.reachedText(QuantityKey::format);
            asked.row(g.goal(), QuantityKey.format(g.limit()), reached, g.reached() ? "yes" : "NO");
        }
        return asked.text();
    }
}
