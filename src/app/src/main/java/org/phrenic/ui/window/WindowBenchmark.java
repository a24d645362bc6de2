package org.phrenic.ui.window;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;

/**
 * Measures the window as a user has it: opens it on a scenario, waits until its door is ready, and reads simulated
 * time, frames and processor time at the ends of intervals of {@value #INTERVAL_S} s. Not called on the event dispatch
 * thread.
 */
public final class WindowBenchmark {
    /** Length of an interval, s of wall time. */
    public static final double INTERVAL_S = 5;

    /** Time from the readiness of the door to the first interval, s: compilation of what runs first. */
    private static final double WARM_UP_S = 5;

    private static final double PATIENCE_S = 300;
    private static final double TURN_DEG = 1.2;
    private static final int TURN_MS = 40;
    private static final double NANO = 1e-9;
    private static final Path TASKS = Path.of("/proc/self/task");
    private static final System.Logger LOG = System.getLogger(WindowBenchmark.class.getName());

    /**
     * What is measured.
     *
     * @param workspace arrangement of the window: the door
     * @param seconds duration of the measurement, at least one interval
     * @param width wanted width of the window, pixels
     * @param height wanted height of the window, pixels
     * @param turning whether the camera turns about the body all the time
     */
    public record Settings(Workspace workspace, double seconds, int width, int height, boolean turning) {}

    /**
     * One interval.
     *
     * @param realtimeFactor simulated over wall time
     * @param framesPerS frames shown per second
     * @param processors processor time of the process over wall time
     * @param resolution drawn over shown pixels along each side of the view at its end
     */
    public record Interval(double realtimeFactor, double framesPerS, double processors, double resolution) {}

    /**
     * Result of a measurement.
     *
     * @param firstPictureS time from the start of the process to the first frame in the window, s
     * @param readyS time from the start of the process until the door can be used, s
     * @param frame width and height of the window as the desktop shows it, pixels
     * @param view width and height of the three-dimensional view, device pixels, and OpenGL driver
     * @param threadShares processor time of threads by name over wall time; empty where the system does not tell
     * @param sheet diaphragm of the scene at rest
     */
    public record Result(
            double firstPictureS,
            double readyS,
            String frame,
            String view,
            List<Interval> intervals,
            Map<String, Double> threadShares,
            TriangleMesh sheet) {
        public double leastRealtimeFactor() {
            return intervals.stream()
                    .mapToDouble(Interval::realtimeFactor)
                    .min()
                    .orElseThrow();
        }

        public double meanRealtimeFactor() {
            return intervals.stream()
                    .mapToDouble(Interval::realtimeFactor)
                    .average()
                    .orElseThrow();
        }

        public double leastFramesPerS() {
            return intervals.stream().mapToDouble(Interval::framesPerS).min().orElseThrow();
        }

        public double meanFramesPerS() {
            return intervals.stream()
                    .mapToDouble(Interval::framesPerS)
                    .average()
                    .orElseThrow();
        }

        public double meanProcessors() {
            return intervals.stream()
                    .mapToDouble(Interval::processors)
                    .average()
                    .orElseThrow();
        }
    }

    /** State at the end of an interval. */
    private record Sample(long ns, double simulatedS, long frames, long processorNs) {}

    private final OperatingSystemMXBean machine = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private final Settings settings;
    private final Session session;
    private final PhrenicWindow window;

    private WindowBenchmark(Scenario scenario, Settings settings) {
        this.settings = settings;
        session = WindowStart.session(scenario);
        awaitToolkit();
        window = onEventThread(() -> {
            WindowPreferences preferences = WindowPreferences.unsaved();
            preferences.setNumber("x", 0);
            preferences.setNumber("y", 0);
            preferences.setNumber("width", settings.width());
            preferences.setNumber("height", settings.height());
            PhrenicWindow made = new PhrenicWindow(preferences, session);
            made.show();
            made.showWorkspace(settings.workspace());
            return made;
        });
    }

    /**
     * Opens the window, measures, and closes it.
     *
     * @param progress receives each interval
     * @throws NoGraphicsException if the window cannot draw
     * @throws BadInputException if the door cannot be used on this body
     */
    public static Result run(Scenario scenario, Settings settings, Consumer<Interval> progress)
            throws NoGraphicsException {
        WindowBenchmark benchmark = new WindowBenchmark(scenario, settings);
        try {
            return benchmark.measure(progress);
        } finally {
            onEventThread(() -> {
                benchmark.window.close();
                return null;
            });
        }
    }

    private Result measure(Consumer<Interval> progress) throws NoGraphicsException {
        await("a picture", () -> window.view().frameCount() > 0 || window.view().isUnavailable());
        double firstPictureS = sinceStartS();
        if (window.view().isUnavailable()) {
            throw new NoGraphicsException(window.view().unavailableReason());
        }
        await("the door", this::isReady);
        double readyS = sinceStartS();
        Timer turning = new Timer(
                TURN_MS, e -> window.view().setCamera(window.view().camera().orbit(TURN_DEG, 0)));
        if (settings.turning()) {
            turning.start();
        }
        sleepS(WARM_UP_S);
        List<Interval> intervals = new ArrayList<>();
        Map<String, Long> threadsBefore = threadTimes();
        Sample first = sample();
        Sample before = first;
        for (int i = 0; i < Math.round(measuredS(settings.seconds()) / INTERVAL_S); i++) {
            sleepS(INTERVAL_S);
            Sample now = sample();
            Interval interval = between(before, now);
            intervals.add(interval);
            progress.accept(interval);
            before = now;
        }
        Map<String, Double> shares = shares(threadsBefore, threadTimes(), (before.ns - first.ns));
        turning.stop();
        TriangleMesh sheet = session.scene().orElseThrow().surfaces().stream()
                .filter(surface -> surface.kind() == StructureKind.DIAPHRAGM)
                .findFirst()
                .orElseThrow()
                .rest();
        String view = window.view().getWidth() + " x " + window.view().getHeight() + ", "
                + window.view().graphicsInfo().orElse("");
        String frame = window.frame().getWidth() + " x " + window.frame().getHeight();
        return new Result(firstPictureS, readyS, frame, view, intervals, shares, sheet);
    }

    private boolean isReady() {
        return onEventThread(() -> {
            if (settings.workspace() == Workspace.RESEARCHER) {
                return session.scene().isPresent() && session.live().status().timeS() > 0;
            }
            RehearsalStage stage = window.docks().rehearsalController().stage();
            if (stage == RehearsalStage.UNAVAILABLE) {
                throw new BadInputException(
                        "the rehearsal: " + window.docks().rehearsalController().unavailableReason());
            }
            return stage == RehearsalStage.READY;
        });
    }

    private Sample sample() {
        return new Sample(
                System.nanoTime(),
                session.live().status().timeS(),
                window.view().frameCount(),
                machine.getProcessCpuTime());
    }

    private Interval between(Sample from, Sample to) {
        double wallS = (to.ns - from.ns) * NANO;
        double resolution =
                window.view().frame().map(frame -> frame.resolution()).orElse(1.0);
        return new Interval(
                (to.simulatedS - from.simulatedS) / wallS,
                (to.frames - from.frames) / wallS,
                (to.processorNs - from.processorNs) * NANO / wallS,
                resolution);
    }

    /** Processor time of threads by name, ns, with those of drivers and compilers; empty except on Linux. */
    private static Map<String, Long> threadTimes() {
        Map<String, Long> times = new TreeMap<>();
        if (!Files.isDirectory(TASKS)) {
            return times;
        }
        try (DirectoryStream<Path> tasks = Files.newDirectoryStream(TASKS)) {
            for (Path task : tasks) {
                addTime(task, times);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("processor time of threads", e);
        }
        return times;
    }

    private static void addTime(Path task, Map<String, Long> times) {
        try {
            String name = Files.readString(task.resolve("comm")).strip();
            String[] fields = Files.readString(task.resolve("schedstat")).split(" ", -1);
            times.merge(name, Long.parseLong(fields[0]), Long::sum);
        } catch (IOException e) {
            LOG.log(System.Logger.Level.DEBUG, "A thread has ended while it was listed", e);
        }
    }

    private static Map<String, Double> shares(Map<String, Long> before, Map<String, Long> after, long wallNs) {
        Map<String, Double> shares = new TreeMap<>();
        after.forEach((name, ns) -> {
            double share = (ns - before.getOrDefault(name, 0L)) / (double) wallNs;
            if (share >= 0.005) {
                shares.put(name, share);
            }
        });
        return shares;
    }

    private static double sinceStartS() {
        return (System.currentTimeMillis()
                        - ManagementFactory.getRuntimeMXBean().getStartTime())
                * 1e-3;
    }

    /** Time that is measured, s: the one asked for, in whole intervals. */
    public static double measuredS(double seconds) {
        return INTERVAL_S * Math.max(1, Math.round(seconds / INTERVAL_S));
    }

    private static void await(String what, BooleanSupplier holds) {
        long end = System.nanoTime() + (long) (PATIENCE_S / NANO);
        while (!holds.getAsBoolean()) {
            if (System.nanoTime() > end) {
                throw new BadInputException("the window: found no sign of " + what + " after " + PATIENCE_S + " s");
            }
            sleepS(0.005);
        }
    }

    private static void awaitToolkit() {
        try {
            OffscreenContext.awaitToolkit();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void sleepS(double seconds) {
        try {
            Thread.sleep(Math.round(1000 * seconds));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", e);
        }
    }

    private static <T> T onEventThread(Callable<T> what) {
        FutureTask<T> task = new FutureTask<>(what);
        SwingUtilities.invokeLater(task);
        try {
            return task.get();
        } catch (java.util.concurrent.ExecutionException e) {
            throw e.getCause() instanceof RuntimeException cause ? cause : new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", e);
        }
    }
}
