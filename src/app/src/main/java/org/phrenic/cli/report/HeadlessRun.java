package org.phrenic.cli.report;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.phrenic.cli.chart.RunChart;
import org.phrenic.document.CsvTable;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.ScenarioRenderer;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.SceneStyle;

/** {@code phrenic} without a display: simulates a quiet breath and writes tables, curves and pictures. */
public final class HeadlessRun {
    private static final int SIDE = 1000;
    private static final String TITLE = "Quiet breath, virtual adult male";

    private HeadlessRun() {}

    /**
     * Runs the default scenario and writes into a folder: the files of {@code phrenic run}, {@code curves.png}, and
     * pictures at end-expiration and end-inspiration. Without graphics or fonts, a line on stderr says so.
     */
    public static void run(Path out, PrintWriter stdout, PrintWriter stderr) {
        Scenario scenario = Scenario.defaults();
        RunReport.run(scenario, Map.of(), out, stderr, summary -> stdout.print(RunReport.table(summary)));
        stdout.flush();
        Path observables = out.resolve("observables.csv");
        System.setProperty("java.awt.headless", "true");
        List<String> made = new ArrayList<>(List.of("Numbers"));
        if (Annotations.hasFonts()) {
            made.add("curves");
            RunChart.write(observables, TITLE, out.resolve("curves.png"));
        } else {
            stderr.println("This Java has no fonts: no curves are drawn.");
        }
        if (pictures(scenario, endOfInspiration(CsvTable.read(observables)), out.resolve("pictures"), stderr)) {
            made.add("pictures");
        }
        stderr.println(String.join(", ", made).replaceFirst(", ([^,]*)$", " and $1") + " are in " + out + ".");
    }

    private static double endOfInspiration(CsvTable observables) {
        double[] time = observables.numbers("time_s");
        double[] volume = observables.numbers("lung_volume_change_ml");
        int most = 0;
        // Only the first half is searched, because later breaths take longer to simulate.
        for (int i = 1; i < time.length && time[i] < time[time.length - 1] / 2; i++) {
            most = volume[i] > volume[most] ? i : most;
        }
        return time[most];
    }

    /** Returns whether they could be drawn. */
    private static boolean pictures(Scenario scenario, double inspiredS, Path folder, PrintWriter stderr) {
        ConsoleProgress progress = new ConsoleProgress(stderr);
        try (ScenarioRenderer studio = ScenarioRenderer.open(scenario, progress)) {
            SceneStyle style = SceneStyle.atlas(studio.surfaces()).withSamples(SceneStyle.SMOOTH_SAMPLES);
            for (double time : new double[] {0, inspiredS}) {
                for (AnatomicalView view : List.of(AnatomicalView.ANTERIOR, AnatomicalView.LEFT)) {
                    String name = view.label() + (time == 0 ? "-expiration" : "-inspiration") + ".png";
                    PictureSettings shot = PictureSettings.of(view, SIDE, SIDE, TITLE);
                    studio.shot(shot, style).writePicture(folder.resolve(name), time);
                }
            }
            return true;
        } catch (NoGraphicsException none) {
            progress.note(none.getMessage());
            return false;
        } finally {
            progress.end();
        }
    }
}
