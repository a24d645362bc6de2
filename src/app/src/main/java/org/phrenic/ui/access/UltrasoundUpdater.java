package org.phrenic.ui.access;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import javax.swing.Timer;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.plan.ImageMoment;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Computes live ultrasound images on a thread of its own and shows each when its latency has passed. Moments that come
 * while an image is being computed are dropped, so images are never late.
 */
final class UltrasoundUpdater {
    private static final long MIN_INTERVAL_NS = 45_000_000;

    private final FrameWorker worker;
    private final List<Surface> surfaces;
    private final TargetLesion target;
    private final DoubleSupplier latencyS;
    private final Consumer<Optional<UltrasoundShot>> listener;
    private Ultrasound ultrasound;
    private volatile boolean shown;
    /** When what was shown last was taken, ns; used on the event dispatch thread. */
    private long lastTakenNs = Long.MIN_VALUE;

    /**
     * @param frame of these surfaces; overwritten
     * @param latencyS time from the moment of an image to its display, s
     * @param listener gets each image on the event dispatch thread; empty when the probe is lifted
     */
    UltrasoundUpdater(
            Executor executor,
            List<Surface> surfaces,
            TargetLesion target,
            Frame frame,
            DoubleSupplier latencyS,
            Consumer<Optional<UltrasoundShot>> listener) {
        worker = new FrameWorker(executor, frame, MIN_INTERVAL_NS);
        this.surfaces = surfaces;
        this.target = target;
        this.latencyS = latencyS;
        this.listener = listener;
    }

    /** Takes a moment if no image is being computed; on the simulation's thread. */
    void offer(Frame now, Optional<ImageMoment> moment, NeedleState state) {
        long ns = System.nanoTime();
        if (moment.isEmpty()) {
            if (shown) {
                shown = false;
                show(Optional.empty(), ns);
            }
        } else if (state != null) {
            shown = true;
            worker.offer(now, frame -> compute(frame, moment.get(), state, ns));
        }
    }

    private void compute(Frame frame, ImageMoment moment, NeedleState state, long takenNs) {
        if (ultrasound == null) {
            ultrasound = new Ultrasound(surfaces, CurvilinearProbe.abdominal(), 1, Optional.of(target));
        }
        BModeImage image = moment.take(ultrasound, frame);
        show(Optional.of(UltrasoundShot.of(image, state)), takenNs);
    }

    /** Shows an image when its latency has passed. */
    private void show(Optional<UltrasoundShot> shot, long takenNs) {
        double elapsedS = 1e-9 * (System.nanoTime() - takenNs);
        int delayMs = (int) Math.max(0, Math.round(1000 * (latencyS.getAsDouble() - elapsedS)));
        // An image that is done after the probe was lifted, or after a later one was shown, is not shown.
        Timer timer = new Timer(delayMs, e -> {
            if (shot.isPresent() == shown && takenNs >= lastTakenNs) {
                lastTakenNs = takenNs;
                listener.accept(shot);
            }
        });
        timer.setRepeats(false);
        timer.start();
    }
}
