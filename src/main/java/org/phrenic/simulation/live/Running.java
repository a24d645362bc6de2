package org.phrenic.simulation.live;

import java.util.List;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;

/** A scene that runs, with what is seen of it. Used by the simulation's thread, but for what it gives out. */
final class Running implements AutoCloseable {
    /** Wall time between frames that are published although nobody took the last one, ns. */
    private static final long UNSEEN_NS = 250_000_000;

    /** Frames kept for the timeline cost the simulation time: no more than this many a second of wall time. */
    private static final long KEPT_NS = 25_000_000;

    final Simulation simulation;
    final LiveScene scene;
    final FramePipe pipe;
    final History history;
    private final SceneSurfaces surfaces;
    private long nextSample;
    private long publishedNs;
    private long keptNs;

    Running(Simulation simulation, SceneSurfaces surfaces, List<String> notes, long id) {
        this.simulation = simulation;
        this.surfaces = surfaces;
        Frame rest = surfaces.newFrame();
        pipe = new FramePipe(rest);
        history = new History(rest);
        scene = new LiveScene(
                simulation.start(),
                surfaces.surfaces(),
                surfaces.overlays(),
                rest::copy,
                simulation.system().nodeCount(),
                simulation.springCount(),
                notes,
                id);
        sample();
        publish();
        keep();
    }

    /** The scenario that gives this run again: as started, with the changes made since. */
    Scenario recorded() {
        return simulation.start().withChanges(simulation.changes()).withSteps(simulation.steps());
    }

    /** One step, and what is to be seen of it. */
    void step() {
        simulation.step();
        if (simulation.steps() >= nextSample) {
            sample();
            long now = System.nanoTime();
            if (history.wantsFrame(simulation.time()) && now - keptNs > KEPT_NS) {
                publish();
                keep();
            }
        }
    }

    private void sample() {
        history.add(surfaces.observe());
        Stepper stepper = simulation.stepper();
        nextSample = stepper.steps() + Math.max(1, Math.round(simulation.start().recordEveryS() / stepper.dt()));
    }

    private void keep() {
        // The frame just published may be with a reader; capturing another is cheaper than waiting for it.
        surfaces.capture(pipe.writing());
        history.add(pipe.writing());
        keptNs = System.nanoTime();
    }

    /** Publishes a frame if somebody waits for one, or nobody has for long. */
    void publishIfWanted() {
        if (pipe.wanted() || System.nanoTime() - publishedNs > UNSEEN_NS) {
            publish();
        }
    }

    void publish() {
        surfaces.capture(pipe.writing());
        if (pipe.writing().isFinite()) {
            pipe.publish();
        }
        publishedNs = System.nanoTime();
    }

    /** Back at the start, or at an earlier state: what was seen later is forgotten. */
    void wentBack() {
        history.forgetAfter(simulation.time());
        if (simulation.steps() == 0) {
            history.clear();
            sample();
            publish();
            keep();
        } else {
            nextSample = simulation.steps();
            publish();
        }
    }

    @Override
    public void close() {
        simulation.close();
    }
}
