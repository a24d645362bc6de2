package org.phrenic.ui.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleAngles;
import org.phrenic.access.attempt.NeedleLoad;
import org.phrenic.access.plan.ImageMoment;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Live images: those of their moment, and none that waits for another. */
class UltrasoundUpdaterTest {
    private static final double[] TARGET = {40, 100, 100};
    private static final SonatedNeedle NEEDLE =
            new SonatedNeedle(new double[] {0, 100, 60}, new double[] {45, 100, 105}, Needle.standard());
    private static final ImageMoment MOMENT = new ImageMoment(
            new ProbePose(new double[] {2, 100, 100}, new double[] {1, 0, 0}, new double[] {0, 0, 1}),
            UltrasoundSettings.DEFAULT.withDepth(90),
            Optional.of(NEEDLE),
            TARGET);

    private final Queue<Runnable> work = new ArrayDeque<>();
    private final CompletableFuture<UltrasoundShot> shown = new CompletableFuture<>();

    /** A liver of 190 mm in a trunk of 200 mm, both with a corner at or near the origin. */
    private static List<Surface> body() {
        return List.of(
                box("skin", StructureKind.SKIN, 0, 200, Surface.Motion.STILL),
                box("liver", StructureKind.LIVER, 5, 190, Surface.Motion.STILL));
    }

    static Surface box(String name, StructureKind kind, double from, double side, Surface.Motion motion) {
        TriangleMesh box = Shapes.box(side, side, side);
        double[] p = box.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] += from;
        }
        return new Surface(name, kind, 0, Side.MIDLINE, box.withPositions(p), motion, new boolean[0]);
    }

    private static NeedleState state() {
        return state(1);
    }

    private static NeedleState state(double timeS) {
        return new NeedleState(
                timeS,
                RespiratoryPhase.PAUSE,
                TARGET,
                10,
                Optional.of(NEEDLE.entry()),
                true,
                NEEDLE.entry(),
                NEEDLE.tip(),
                60,
                60,
                false,
                Optional.empty(),
                List.of(),
                5,
                "",
                List.of(),
                0,
                new NeedleAngles(90, 45),
                Optional.empty(),
                NeedleLoad.NONE);
    }

    /** The latency is made shorter while an image waits, which then is the older one. */
    @Test
    void anImageDoesNotReplaceALaterOne() throws Exception {
        List<Surface> surfaces = body();
        Frame frame = Frame.still(surfaces);
        List<Double> timesS = new CopyOnWriteArrayList<>();
        CompletableFuture<Void> third = new CompletableFuture<>();
        double[] latenciesS = {0.5, 0, 1};
        AtomicInteger taken = new AtomicInteger();
        UltrasoundUpdater updater = new UltrasoundUpdater(
                work::add,
                surfaces,
                new TargetLesion(TARGET, 20),
                Frame.still(surfaces),
                () -> latenciesS[taken.get()],
                shot -> {
                    timesS.add(shot.orElseThrow().state().timeS());
                    if (timesS.contains(3.0)) {
                        third.complete(null);
                    }
                });
        for (int i = 0; i < latenciesS.length; i++) {
            taken.set(i);
            updater.offer(frame, Optional.of(MOMENT), state(i + 1));
            work.remove().run();
            // Longer than the least time between two images.
            Thread.sleep(50);
        }
        third.get(10, TimeUnit.SECONDS);
        // Where the machine is so busy that the first one's latency has passed before the second is there, it is shown.
        assertThat(timesS).isSorted().endsWith(3.0);
    }

    @Test
    void anImageIsThatOfItsMomentAndMomentsThatComeMeanwhileAreDropped() throws Exception {
        List<Surface> surfaces = body();
        Frame frame = Frame.still(surfaces);
        TargetLesion target = new TargetLesion(TARGET, 20);
        UltrasoundUpdater updater = new UltrasoundUpdater(
                work::add, surfaces, target, Frame.still(surfaces), () -> 0, shot -> shot.ifPresent(shown::complete));
        for (int i = 0; i < 3; i++) {
            updater.offer(frame, Optional.of(MOMENT), state());
            // Longer than the least time between two images.
            Thread.sleep(50);
        }
        assertThat(work).as("images begun").hasSize(1);
        work.remove().run();
        byte[] headless = MOMENT.take(
                        new Ultrasound(surfaces, CurvilinearProbe.abdominal(), 2, Optional.of(target)), frame)
                .grey();
        assertThat(shown.get(10, TimeUnit.SECONDS).image().grey()).isEqualTo(headless);
        updater.offer(frame, Optional.of(MOMENT), state());
        assertThat(work).as("the next is begun").hasSize(1);
    }
}
