package org.phrenic.study.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.phrenic.access.imaging.CArm;
import org.phrenic.access.imaging.Fluoroscope;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.LiverWindow;
import org.phrenic.access.ultrasound.ProbeOnSkin;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;

/**
 * Time of ultrasound images and radiographs of a body with its organs: alone on two threads, and ultrasound on one
 * thread beside the scene that breathes on another, at the pace of the clock, as the window runs it.
 */
public final class ImagingStudy {
    private static final int THREADS = 2;
    private static final int WARM_UP = 20;
    private static final int PICTURES = 40;
    private static final double FRAME_S = 0.02;
    private static final double NANO = 1e-9;
    private static final int PIXELS = 512;
    private static final double FIELD_MM = 400;

    private ImagingStudy() {}

    /** Times of pictures of one kind, s, in the order in which they were taken. */
    public record Times(List<Double> seconds) {
        public Times {
            seconds = List.copyOf(seconds);
        }

        /** Time that a share of the pictures needs at most, s. */
        public double quantile(double share) {
            List<Double> sorted = seconds.stream().sorted().toList();
            return sorted.get((int) Math.round(share * (sorted.size() - 1)));
        }

        /** Pictures per second, one after the other. */
        public double perS() {
            return seconds.size()
                    / seconds.stream().mapToDouble(Double::doubleValue).sum();
        }
    }

    /**
     * What was measured on one body.
     *
     * @param triangles triangles of all surfaces
     * @param radiographs frontal radiographs on two threads, alone
     * @param images ultrasound images on two threads, alone
     * @param besideScene ultrasound images on one thread while the scene runs on another
     * @param realtimeFactor simulated over wall time of that scene
     */
    public record Result(
            String body, int triangles, Times radiographs, Times images, Times besideScene, double realtimeFactor) {}

    /**
     * Measures a body.
     *
     * @param seconds wall time beside the running scene, s
     * @throws org.phrenic.engine.integrator.DivergenceException if the scene diverges beside the images
     */
    public static Result of(Scenario scenario, double seconds) {
        return of(scenario, seconds, WARM_UP, PICTURES);
    }

    /**
     * Like {@link #of(Scenario, double)}, with a choice of pictures of each kind that are taken alone.
     *
     * @param warmUp pictures before those whose time is measured
     */
    static Result of(Scenario scenario, double seconds, int warmUp, int pictures) {
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            SceneSurfaces scene = SceneSurfaces.withOrgans(simulation);
            Frame frame = scene.newFrame();
            CArm arm = new CArm(
                    LiverWindow.RIGHT_INTERCOSTAL.placeOn(scene.surfaces()),
                    0,
                    0,
                    CArm.SOURCE_DETECTOR_MM,
                    CArm.SOURCE_ISOCENTRE_MM,
                    new CArm.Detector(FIELD_MM, PIXELS, PIXELS));
            Fluoroscope fluoroscope = new Fluoroscope(scene.surfaces(), THREADS);
            Times radiographs = time(() -> fluoroscope.take(frame, arm, Fluoroscope.ENERGY_KEV), warmUp, pictures);
            Times images = time(images(scene, frame, THREADS), warmUp, pictures);
            Running running = new Running(simulation, scene, frame);
            Times beside = running.take(seconds);
            double factor = running.factor();
            int triangles = scene.surfaces().stream()
                    .mapToInt(s -> s.rest().triangles().length / 3)
                    .sum();
            return new Result(
                    RunSettings.bodyLabel(scenario.anatomy()), triangles, radiographs, images, beside, factor);
        }
    }

    private static Times time(Runnable picture, int warmUp, int pictures) {
        List<Double> seconds = new ArrayList<>();
        for (int i = -warmUp; i < pictures; i++) {
            long begun = System.nanoTime();
            picture.run();
            if (i >= 0) {
                seconds.add(NANO * (System.nanoTime() - begun));
            }
        }
        return new Times(seconds);
    }

    /** Images of a probe that is turned by a degree from one to the next. */
    private static Runnable images(SceneSurfaces scene, Frame frame, int threads) {
        Ultrasound ultrasound = new Ultrasound(scene.surfaces(), CurvilinearProbe.abdominal(), threads);
        ProbeOnSkin place = new ProbeOnSkin(scene.surfaces(), LiverWindow.RIGHT_INTERCOSTAL.placeOn(scene.surfaces()));
        int[] turned = {0};
        return () -> ultrasound.take(
                frame,
                place.pose(frame, new ProbePose.Angles(turned[0]++, 0, 0)),
                UltrasoundSettings.DEFAULT,
                Optional.empty());
    }

    /** A scene that runs on a thread of its own, no faster than the clock. */
    private static final class Running implements Callable<Double> {
        private final Simulation simulation;
        private final SceneSurfaces scene;
        private final Frame latest;
        private final AtomicBoolean ended = new AtomicBoolean();
        private final FutureTask<Double> task = new FutureTask<>(this);

        Running(Simulation simulation, SceneSurfaces scene, Frame latest) {
            this.simulation = simulation;
            this.scene = scene;
            this.latest = latest;
        }

        /** Takes images until the time is over or the scene fails. The scene does not run afterwards. */
        Times take(double seconds) {
            Frame own = latest.copy();
            Runnable image = images(scene, own, 1);
            List<Double> times = new ArrayList<>();
            new Thread(task, "scene").start();
            try {
                long begun = System.nanoTime();
                while (NANO * (System.nanoTime() - begun) < seconds && !task.isDone()) {
                    long from = System.nanoTime();
                    synchronized (latest) {
                        own.copyFrom(latest);
                    }
                    image.run();
                    times.add(NANO * (System.nanoTime() - from));
                }
            } finally {
                ended.set(true);
                awaitEnd();
            }
            return new Times(times);
        }

        /** Waits for the scene, which ends its step, however often the thread is interrupted. */
        private void awaitEnd() {
            boolean interrupted = false;
            while (!task.isDone()) {
                try {
                    task.get();
                } catch (InterruptedException stop) {
                    interrupted = true;
                } catch (ExecutionException failed) {
                    break;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }

        /** Simulated over wall time; throws what the scene failed with. */
        double factor() {
            try {
                return task.get();
            } catch (InterruptedException stop) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("the measurement was interrupted", stop);
            } catch (ExecutionException failed) {
                if (failed.getCause() instanceof RuntimeException failure) {
                    throw failure;
                }
                throw new IllegalStateException("the scene failed beside the images", failed.getCause());
            }
        }

        @Override
        public Double call() {
            Frame frame = scene.newFrame();
            double startS = simulation.time();
            long begun = System.nanoTime();
            double due = startS;
            while (!ended.get()) {
                double aheadS = simulation.time() - startS - NANO * (System.nanoTime() - begun);
                if (aheadS > 0) {
                    LockSupport.parkNanos((long) (aheadS / NANO));
                }
                simulation.step();
                if (simulation.time() >= due) {
                    due += FRAME_S;
                    scene.capture(frame);
                    synchronized (latest) {
                        latest.copyFrom(frame);
                    }
                }
            }
            return (simulation.time() - startS) / (NANO * (System.nanoTime() - begun));
        }
    }
}
