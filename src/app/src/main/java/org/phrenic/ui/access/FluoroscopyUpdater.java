package org.phrenic.ui.access;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.imaging.CArm;
import org.phrenic.access.imaging.Fluoroscope;
import org.phrenic.access.imaging.SteelRod;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.scene.RadiographRenderer;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Takes radiographs of the run on a thread of its own, pulsed at most three times per second, while the beam is on. */
final class FluoroscopyUpdater {
    private static final long PULSE_NS = 330_000_000;
    private static final int PIXELS = 512;
    private static final double FIELD_MM = 360;

    private final FrameWorker worker;
    private final List<Surface> surfaces;
    private final TargetLesion target;
    private final Needle needle;
    private final GuidanceSettings settings;
    private final Consumer<FluoroscopyShot> listener;
    private Fluoroscope fluoroscope;
    /** Grey levels, which stay while the C-arm does, so that pictures of a breath can be compared. */
    private double[] range = new double[0];

    private GuidanceSettings.ArmAngles rangeAngles;

    /**
     * @param place of the frame and its surfaces; overwritten
     * @param target at whose place at rest the isocentre is
     * @param listener gets each picture on the event dispatch thread
     */
    FluoroscopyUpdater(
            FrameWorkplace place,
            TargetLesion target,
            Needle needle,
            GuidanceSettings settings,
            Consumer<FluoroscopyShot> listener) {
        worker = new FrameWorker(place.executor(), place.frame(), PULSE_NS);
        surfaces = place.surfaces();
        this.target = target;
        this.needle = needle;
        this.settings = settings;
        this.listener = listener;
    }

    /**
     * Where pictures of a scene are computed.
     *
     * @param frame of these surfaces; overwritten
     */
    record FrameWorkplace(Executor executor, List<Surface> surfaces, Frame frame) {}

    /** Takes a frame while the beam is on; on the simulation's thread. */
    void offer(Frame now, NeedleState state) {
        if (state != null && settings.isXrayOn()) {
            worker.offer(now, frame -> take(frame, state));
        }
    }

    private void take(Frame frame, NeedleState state) {
        if (fluoroscope == null) {
            fluoroscope = new Fluoroscope(surfaces, 1);
        }
        GuidanceSettings.ArmAngles angles = settings.armAngles();
        CArm arm = new CArm(
                target.restMm(),
                angles.leftObliqueDeg(),
                angles.cranialDeg(),
                CArm.SOURCE_DETECTOR_MM,
                CArm.SOURCE_ISOCENTRE_MM,
                new CArm.Detector(FIELD_MM, PIXELS, PIXELS));
        List<SteelRod> steel =
                state.hasNeedle() ? List.of(new SteelRod(state.hub(), state.tip(), needle.radiusMm())) : List.of();
        var radiograph = fluoroscope.take(frame, arm, Fluoroscope.ENERGY_KEV, steel);
        if (!angles.equals(rangeAngles)) {
            rangeAngles = angles;
            range = RadiographRenderer.range(radiograph);
        }
        FluoroscopyShot shot = FluoroscopyShot.of(radiograph, range, state);
        SwingUtilities.invokeLater(() -> listener.accept(shot));
    }
}
