package org.phrenic.ui.window;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.prefs.Preferences;
import javax.swing.SwingUtilities;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;

/**
 * Opens the window at 1280 by 800 on the default scene and prints when what was there, counted from the start of Java,
 * and then how many pictures a second it shows, how fast the simulation is and where the processor time goes.
 * Arguments: seconds to watch (20), and {@code key=value} of the scenario.
 */
public final class FrameRateCheck {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;
    private static final double NANO = 1e-9;
    private static final long LEAST_NS = 50_000_000;
    private static final Path TASKS = Path.of("/proc/self/task");

    private final OperatingSystemMXBean machine = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final long begunMs = ManagementFactory.getRuntimeMXBean().getStartTime();

    private FrameRateCheck() {}

    public static void main(String[] args) throws Exception {
        double seconds = args.length > 0 ? Double.parseDouble(args[0]) : 20;
        String[] settings = args.length > 1 ? java.util.Arrays.copyOfRange(args, 1, args.length) : new String[0];
        new FrameRateCheck().run(seconds, Scenario.defaults().with(settings));
        System.exit(0);
    }

    private void stage(String what) {
        System.out.printf(
                Locale.ROOT,
                "%-28s %6.2f s   %6.2f s of processor time%n",
                what,
                (System.currentTimeMillis() - begunMs) * 1e-3,
                machine.getProcessCpuTime() * NANO);
    }

    private void run(double seconds, Scenario scenario) throws Exception {
        stage("main");
        Preferences node = Preferences.userRoot().node("org/phrenic/frame-rate");
        node.clear();
        node.putInt("width", WIDTH);
        node.putInt("height", HEIGHT);
        node.putInt("x", 0);
        node.putInt("y", 0);
        Session session = new Session(scenario);
        PhrenicWindow[] made = new PhrenicWindow[1];
        SwingUtilities.invokeAndWait(() -> {
            stage("event thread");
            made[0] = new PhrenicWindow(new WindowPreferences(node), session);
            stage("window made");
            made[0].session().addListener(new Session.Listener() {
                @Override
                public void onLoading(String what, double share) {
                    stage("loading: " + what);
                }

                @Override
                public void onScene(LiveScene scene) {
                    stage("scene");
                }
            });
            made[0].show();
            stage("window shown");
        });
        PhrenicWindow window = made[0];
        boolean drawing = false;
        while (window.view().frameCount() == 0) {
            if (!drawing && window.view().graphicsInfo().isPresent()) {
                drawing = true;
                stage("graphics ready");
            }
            Thread.sleep(2);
        }
        stage("first picture");
        cpu().forEach((name, ns) -> {
            if (ns > LEAST_NS) {
                System.out.printf(Locale.ROOT, "    %-24s %6.2f s%n", name, ns * NANO);
            }
        });
        Thread.sleep(5000);
        watch(window, seconds);
        node.removeNode();
    }

    private void watch(PhrenicWindow window, double seconds) throws Exception {
        Map<String, Long> before = cpu();
        long all = machine.getProcessCpuTime();
        long begun = System.nanoTime();
        long pictures = window.view().frameCount();
        double time = window.session().live().status().timeS();
        Thread.sleep((long) (1000 * seconds));
        double wall = (System.nanoTime() - begun) * NANO;
        double shown = window.view().frameCount() - pictures;
        double simulated = window.session().live().status().timeS() - time;
        all = machine.getProcessCpuTime() - all;
        Map<String, Long> after = cpu();
        System.out.printf(
                Locale.ROOT,
                "window %dx%d, view %dx%d, %s%n",
                window.frame().getWidth(),
                window.frame().getHeight(),
                window.view().getWidth(),
                window.view().getHeight(),
                window.view().graphicsInfo().orElse(""));
        System.out.printf(
                Locale.ROOT,
                "%.1f frames/s, %.2fx real time, %d bytes uploaded a frame, %.2f of the processors used%n",
                shown / wall,
                simulated / wall,
                window.view().frame().orElseThrow().cost().bytesUploaded(),
                all * NANO / wall);
        after.forEach((name, ns) -> {
            double ms = (ns - before.getOrDefault(name, 0L)) * 1e-6;
            if (ms > 0.002 * 1000 * wall) {
                System.out.printf(
                        Locale.ROOT,
                        "%-28s %5.1f %% of a processor, %6.2f ms a frame%n",
                        name,
                        ms / wall / 10,
                        ms / shown);
            }
        });
    }

    /**
     * Processor time by the names of threads, ns; as Linux has it with those of drivers and compilers, elsewhere of
     * Java's own.
     */
    private Map<String, Long> cpu() throws IOException {
        Map<String, Long> map = new TreeMap<>();
        if (Files.isDirectory(TASKS)) {
            try (DirectoryStream<Path> tasks = Files.newDirectoryStream(TASKS)) {
                for (Path task : tasks) {
                    String name = Files.readString(task.resolve("comm")).strip();
                    String[] times = Files.readString(task.resolve("schedstat")).split(" ");
                    map.merge(name, Long.parseLong(times[0]), Long::sum);
                }
            }
            return map;
        }
        for (ThreadInfo info : threads.getThreadInfo(threads.getAllThreadIds())) {
            if (info != null) {
                map.merge(info.getThreadName(), threads.getThreadCpuTime(info.getThreadId()), Long::sum);
            }
        }
        return map;
    }
}
