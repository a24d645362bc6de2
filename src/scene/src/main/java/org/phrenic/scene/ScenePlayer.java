package org.phrenic.scene;

import java.util.List;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.BadInputException;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * A scenario simulated for its pictures, step by step as a run does it: at any time the scene is the same, bit for bit.
 */
public final class ScenePlayer implements AutoCloseable {
    private static final double PROGRESS_INTERVAL_S = 0.1;

    private final Scenario scenario;
    private final Simulation simulation;
    private final SceneSurfaces surfaces;
    private final SimulationRun.Progress progress;
    private final Frame frame;
    private final double durationS;

    /**
     * Grows or loads the body and settles it.
     *
     * @param progress told what was noticed, and how far it is
     * @throws BadInputException with one sentence, if the scenario's body cannot be simulated
     */
    public ScenePlayer(Scenario scenario, SimulationRun.Progress progress) {
        this.scenario = scenario;
        this.progress = progress;
        Thorax thorax = SimulationRun.loadThorax(scenario);
        thorax.notes().forEach(progress::note);
        simulation = Simulation.of(scenario, thorax);
        if (!simulation.stabilityMessage().isEmpty()) {
            progress.note(simulation.stabilityMessage());
        }
        surfaces = new SceneSurfaces(simulation);
        frame = surfaces.newFrame();
        durationS = simulation.durationS();
    }

    /** The surfaces, in the order of the frames. */
    public List<Surface> surfaces() {
        return surfaces.surfaces();
    }

    /** What can be drawn over them. */
    public List<Overlay> overlays() {
        return surfaces.overlays();
    }

    /** Simulated time that all of the scenario takes, s. */
    public double durationS() {
        return durationS;
    }

    /** What the breath is doing at the present step, for people: "inspiration". */
    public String phase() {
        return simulation.breathLabel().name().toLowerCase(java.util.Locale.ROOT);
    }

    /** Box about all surfaces at rest: {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm. */
    public double[] bounds() {
        return SceneBounds.of(surfaces());
    }

    /**
     * Simulates up to a time.
     *
     * @param timeS not before the last one
     * @return the scene at the step nearest to that time; the same object each time
     */
    public Frame advanceTo(double timeS) {
        long target = Math.round(timeS / scenario.timeStepS());
        if (target < simulation.steps()) {
            throw new IllegalArgumentException(
                    "found " + timeS + " s after " + simulation.time() + " s, expected times in order");
        }
        long told = System.nanoTime();
        long begun = told;
        long first = simulation.steps();
        while (simulation.steps() < target) {
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

    /** Hash of the state, as a run reports it. */
    public String stateHash() {
        return simulation.stateHash();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
