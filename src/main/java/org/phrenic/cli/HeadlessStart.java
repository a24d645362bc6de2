package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import org.phrenic.format.CsvTable;
import org.phrenic.scene.Annotations;
import org.phrenic.scene.CurvesPicture;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.SceneStyle;
import org.phrenic.scene.Shot;
import org.phrenic.scene.Studio;
import org.phrenic.scene.Transparency;
import org.phrenic.scene.View;
import org.phrenic.simulation.Scenario;

/** What {@code phrenic} does where no window can be shown: a quiet breath in numbers, curves and pictures. */
final class HeadlessStart {
    private static final int SIDE = 1000;
    private static final int SAMPLES = 4;
    private static final String TITLE = "Quiet breath, virtual adult male";

    private HeadlessStart() {}

    /**
     * Runs the default scenario into a folder: what {@code phrenic run} writes, {@code curves.png}, and pictures at the ends of expiration and inspiration. Where pictures cannot be made, that is said and
     * the rest stays.
     */
    static void run(Path out, PrintWriter stdout, PrintWriter stderr) {
        Scenario scenario = Scenario.defaults();
        RunReport.run(scenario, out, false, stdout, stderr);
        Path observables = out.resolve("observables.csv");
        System.setProperty("java.awt.headless", "true");
        if (Annotations.canWrite()) {
            CurvesPicture.write(observables, TITLE, out.resolve("curves.png"));
        } else {
            stderr.println("This Java has no fonts: no curves are drawn.");
        }
        pictures(scenario, endOfInspiration(CsvTable.read(observables)), out.resolve("pictures"), stderr);
        stderr.println("Numbers, curves and pictures are in " + out + ".");
    }

    private static double endOfInspiration(CsvTable observables) {
        double[] time = observables.numbers("time_s");
        double[] volume = observables.numbers("lung_volume_change_ml");
        int most = 0;
        // The first of the breaths: later ones would only take longer to simulate.
        for (int i = 1; i < time.length && time[i] < time[time.length - 1] / 2; i++) {
            most = volume[i] > volume[most] ? i : most;
        }
        return time[most];
    }

    private static void pictures(Scenario scenario, double inspiredS, Path folder, PrintWriter stderr) {
        ProgressPrinter progress = new ProgressPrinter(stderr, ProgressPrinter.isTerminal());
        try (Studio studio = Studio.open(scenario, progress)) {
            SceneStyle style = SceneStyle.atlas(studio.surfaces())
                    .withTransparency(Transparency.TWO_PASS)
                    .withSamples(SAMPLES);
            for (double time : new double[] {0, inspiredS}) {
                for (View view : List.of(View.ANTERIOR, View.LEFT)) {
                    String name = view.label() + (time == 0 ? "-expiration" : "-inspiration") + ".png";
                    Shot shot = Shot.of(view, SIDE, SIDE, TITLE);
                    studio.picture(folder.resolve(name), time, shot, style);
                }
            }
        } catch (NoGraphicsException none) {
            progress.note(none.getMessage());
        } finally {
            progress.end();
        }
    }
}
