package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import org.phrenic.scene.CurvesPicture;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.SceneStyle;
import org.phrenic.scene.Shot;
import org.phrenic.scene.Studio;
import org.phrenic.scene.View;
import org.phrenic.simulation.Scenario;

/** What {@code phrenic} does where no window can be opened: the default quiet breath as numbers, curves and, if anything here can draw, pictures. */
final class BreathWithoutWindow {
    static final Path OUT = Path.of("phrenic-out");
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 960;

    /** Nearly the end of inspiration of the quiet preset, s. */
    private static final double INSPIRED_S = 1.5;

    private BreathWithoutWindow() {}

    static void run(PrintWriter out, PrintWriter err) {
        err.println("No window can be opened here for want of a display: running the default quiet breath without one,"
                + " into " + OUT + " (phrenic --help lists the commands).");
        Scenario scenario = Scenario.defaults();
        RunReport.run(scenario, OUT, false, out, err);
        CurvesPicture.write(OUT.resolve("observables.csv"), "Quiet breathing", OUT.resolve("curves.png"));
        pictures(scenario, err);
        err.println("Summary, curves and pictures are in " + OUT + ".");
    }

    private static void pictures(Scenario scenario, PrintWriter err) {
        ProgressPrinter progress = new ProgressPrinter(err, ProgressPrinter.isTerminal());
        try (Studio studio = Studio.open(scenario, progress)) {
            SceneStyle style = SceneStyle.atlas(studio.surfaces());
            for (View view : List.of(View.ANTERIOR, View.LEFT)) {
                studio.picture(OUT.resolve(view.label() + "-expired.png"), 0, shot(view), style);
            }
            for (View view : List.of(View.ANTERIOR, View.LEFT)) {
                studio.picture(OUT.resolve(view.label() + "-inspired.png"), INSPIRED_S, shot(view), style);
            }
        } catch (NoGraphicsException none) {
            progress.end();
            err.println(none.getMessage() + "; the numbers and curves are there.");
        } finally {
            progress.end();
        }
    }

    private static Shot shot(View view) {
        return Shot.of(view, WIDTH, HEIGHT, "Quiet breathing, virtual adult male");
    }
}
