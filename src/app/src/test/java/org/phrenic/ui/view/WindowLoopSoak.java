package org.phrenic.ui.view;

import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * The window's loop for a long time without a window: a scene runs in real time, each new frame is drawn, the camera
 * turns, sliders move every few seconds, the scene is loaded anew now and then. Prints, each minute, the heap that is
 * in use after a collection, what lives of OpenGL, and threads; see docs/speed.md. Argument: minutes.
 */
public final class WindowLoopSoak implements LiveRun.Listener {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;
    private static final String[] TURNED = {
        "muscle_activation", "muscle_stiffness_n_per_m", "damping_rate_per_s", "rib_rotation"
    };
    private static final double[][] RANGE = {{0.4, 0.7}, {200, 500}, {8, 20}, {0.5, 1.2}};

    private final CountDownLatch first = new CountDownLatch(1);
    private volatile LiveScene newest;

    private WindowLoopSoak() {}

    public static void main(String[] args) throws Exception {
        new WindowLoopSoak().run(args.length > 0 ? Double.parseDouble(args[0]) : 30);
    }

    private void run(double minutes) throws Exception {
        Random random = new Random(1);
        System.out.println("minute  heap_mb  gl_objects  threads  frames  steps_per_s  realtime  uploaded_kb");
        try (OffscreenContext gl = OffscreenContext.open();
                LiveRun run = new LiveRun(Scenario.defaults(), this)) {
            first.await();
            run.play();
            LiveScene scene = null;
            Renderer renderer = null;
            Frame frame = null;
            Camera camera = null;
            SceneStyle style = null;
            long frames = 0;
            long begun = System.nanoTime();
            long changed = begun;
            long loaded = begun;
            int told = 0;
            while ((System.nanoTime() - begun) * 1e-9 < 60 * minutes) {
                if (newest != scene) {
                    scene = newest;
                    if (renderer != null) {
                        gl.release(renderer);
                    }
                    renderer = new Renderer(scene.surfaces(), scene.overlays());
                    frame = scene.newFrame().get();
                    camera = Camera.of(
                            AnatomicalView.ANTERIOR, Surface.bounds(scene.surfaces()), WIDTH / (double) HEIGHT);
                    style = SceneStyle.atlas(scene.surfaces());
                    run.play();
                }
                if (!run.copyNewestFrame(frame)) {
                    Thread.sleep(2);
                    continue;
                }
                camera = camera.orbit(0.5, 0);
                Renderer drawing = renderer;
                Frame shown = frame;
                Camera seen = camera;
                SceneStyle now = style;
                gl.run(g -> drawing.draw(g, shown, seen, now, WIDTH, HEIGHT));
                frames++;
                long time = System.nanoTime();
                if ((time - changed) * 1e-9 > 3) {
                    changed = time;
                    int which = random.nextInt(TURNED.length);
                    double value = RANGE[which][0] + random.nextDouble() * (RANGE[which][1] - RANGE[which][0]);
                    run.change(
                            List.of(Assignment.parse(TURNED[which] + "=" + String.format(Locale.ROOT, "%.3f", value))));
                }
                if ((time - loaded) * 1e-9 > 120) {
                    loaded = time;
                    run.load(Scenario.defaults().with(random.nextBoolean() ? "resolution=low" : "resolution=medium"));
                }
                if ((time - begun) * 1e-9 / 60 >= told + 1) {
                    told++;
                    System.gc();
                    Runtime runtime = Runtime.getRuntime();
                    System.out.printf(
                            Locale.ROOT,
                            "%d  %.1f  %d  %d  %d  %.0f  %.2f  %.0f%n",
                            told,
                            (runtime.totalMemory() - runtime.freeMemory()) / 1048576.0,
                            renderer.liveObjects(),
                            Thread.activeCount(),
                            frames,
                            run.status().stepsPerS(),
                            run.status().realtimeFactor(),
                            renderer.statistics().bytesUploaded() / 1024.0);
                }
            }
            gl.release(renderer);
            System.out.println("GL objects after the end: " + renderer.liveObjects());
        }
    }

    @Override
    public void loading(String what, double share) {}

    @Override
    public void ready(LiveScene scene) {
        newest = scene;
        first.countDown();
    }

    @Override
    public void failed(String sentence) {
        System.out.println("failed: " + sentence);
    }

    @Override
    public void diverged(String sentence) {
        System.out.println("diverged: " + sentence);
    }

    @Override
    public void changed() {}
}
