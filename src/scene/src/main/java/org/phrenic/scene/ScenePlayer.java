package org.phrenic.scene;

import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.BadInputException;
import org.phrenic.file.UserCache;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.ScheduleCheck;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * Simulates a scenario for pictures. It takes the same steps as a headless run, so that the states are bit-identical.
 */
public final class ScenePlayer implements AutoCloseable {
    private static final double PROGRESS_INTERVAL_S = 0.1;

    private final Simulation simulation;
    private final SceneSurfaces surfaces;
    private final String notInScan;
    private final SimulationRun.Progress progress;
    private final Frame frame;
    private final double durationS;

    /** @throws BadInputException if the scenario's body cannot be simulated; the message is one sentence */
    public ScenePlayer(Scenario scenario, SimulationRun.Progress progress) {
        this.progress = progress;
        ScheduleCheck.require(scenario);
        Thorax thorax = SimulationRun.loadThorax(scenario);
        notInScan = thorax.notInScanSummary();
        thorax.notes().forEach(progress::note);
        simulation = Simulation.of(scenario, thorax, UserCache.ofUser(), progress);
        if (!simulation.stabilityMessage().isEmpty()) {
            progress.note(simulation.stabilityMessage());
        }
        surfaces = SceneSurfaces.withOrgans(simulation);
        frame = surfaces.newFrame();
        durationS = simulation.durationS();
    }

    /** Surfaces, in the order of the frames. */
    public List<Surface> surfaces() {
        return surfaces.surfaces();
    }

    /** The structures of a scanned body that are not in its scan, as one line; empty if there are none. */
    public String notInScan() {
        return notInScan;
    }

    public List<Overlay> overlays() {
        return surfaces.overlays();
    }

    /** Duration of the scenario, s. */
    public double durationS() {
        return durationS;
    }

    /** Breathing phase at the current step, such as "inspiration". */
    public String phase() {
        return simulation.breathLabel().label();
    }

    /**
     * Simulates up to a time.
     *
     * @param timeS time, s; not before the time of the previous call
     * @return the frame of the nearest step; the object is reused by every call
     */
    public Frame advanceTo(double timeS) {
        if (stepsTo(timeS) < 0) {
            throw new IllegalArgumentException(
                    "found " + timeS + " s after " + simulation.time() + " s, expected times in order");
        }
        long begun = System.nanoTime();
        long told = begun;
        long first = simulation.steps();
        while (stepsTo(timeS) > 0) {
            simulation.step();
            long now = System.nanoTime();
            if ((now - told) * 1e-9 > PROGRESS_INTERVAL_S) {
                told = now;
                double perS = (simulation.steps() - first) / ((now - begun) * 1e-9);
                progress.advanced(simulation.time(), durationS, perS);
            }
        }
        surfaces.capture(frame);
        return frame;
    }

    /** Steps of the present size to the one nearest to a time. */
    private long stepsTo(double timeS) {
        return Math.round((timeS - simulation.time()) / simulation.timeStepS());
    }

    /** {@code state_sha256} of the current state. */
    public String stateHash() {
        return simulation.stateHash();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
