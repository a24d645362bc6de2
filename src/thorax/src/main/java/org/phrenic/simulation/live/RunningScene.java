package org.phrenic.simulation.live;

import java.util.List;
import java.util.Optional;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SubstepReason;
import org.phrenic.simulation.observe.Frame;

/** A scene that runs, with what is seen of it. Used by the simulation's thread, but for what it gives out. */
final class RunningScene implements AutoCloseable {
    /** Wall time between frames that are published although nobody took the last one, ns. */
    private static final long MAX_FRAME_INTERVAL_NS = 250_000_000;

    /** Wall time between two frames however fast they are taken, ns: 60 a second. */
    private static final long MIN_FRAME_INTERVAL_NS = 16_000_000;

    /** Frames kept for the timeline cost the simulation time: no more than this many a second of wall time. */
    private static final long MIN_HISTORY_INTERVAL_NS = 25_000_000;

    final Simulation simulation;
    final LiveScene scene;
    final FrameTripleBuffer pipe;
    final RunHistory history;
    private final SceneSurfaces surfaces;
    private long nextSample;
    private long publishedNs;
    private long publishedStep;
    private long keptNs;
    private Frame listenerFrame;
    private Optional<SubstepReason> substepReason = Optional.empty();
    private StabilityLimit limitSaid;
    private int substepsSaid;

    RunningScene(Simulation simulation, SceneSurfaces surfaces, List<String> notes, long id) {
        this.simulation = simulation;
        this.surfaces = surfaces;
        Frame rest = surfaces.newFrame();
        pipe = new FrameTripleBuffer(rest);
        history = new RunHistory(rest);
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
    }

    /** The scenario that gives this run again: as started, with the changes made since. */
    Scenario recordedScenario() {
        return simulation.start().withChanges(simulation.changes()).withSteps(simulation.steps());
    }

    /**
     * See {@link Simulation#substepReason}; computed when the limit has been measured again, since it takes a search.
     */
    @SuppressWarnings("ReferenceEquality")
    Optional<SubstepReason> substepReason() {
        Stepper stepper = simulation.stepper();
        if (stepper.limit() != limitSaid || stepper.substeps() != substepsSaid) {
            substepReason = simulation.substepReason();
            limitSaid = stepper.limit();
            substepsSaid = stepper.substeps();
        }
        return substepReason;
    }

    /** One step, and what is to be seen of it. */
    void step() {
        simulation.step();
        if (simulation.steps() >= nextSample) {
            sample();
            if (history.isFrameDue(simulation.time()) && System.nanoTime() - keptNs > MIN_HISTORY_INTERVAL_NS) {
                keptNs = System.nanoTime();
                publish();
            }
        }
    }

    /** Shows the scene to a watch if this is one of its steps; says whether it was. */
    boolean notifyStepListener(StepListener watch, StepListener.Trigger when) {
        boolean due = when.isDue(
                simulation.steps(), simulation.time(), simulation.stepper().dt());
        if (due) {
            listenerFrame = listenerFrame == null ? surfaces.newFrame() : listenerFrame;
            surfaces.capture(listenerFrame);
            watch.onStep(listenerFrame, simulation.breathLabel());
        }
        return due;
    }

    private void sample() {
        history.add(surfaces.observe());
        Stepper stepper = simulation.stepper();
        nextSample = stepper.steps()
                + Math.max(1, Math.round(simulation.start().get(RunSettings.RECORD_EVERY) / stepper.dt()));
    }

    /** Publishes a frame if there is another to see and somebody waits for one, or nobody has for long. */
    void publishIfDue() {
        long since = System.nanoTime() - publishedNs;
        if (simulation.steps() != publishedStep
                && (since > MAX_FRAME_INTERVAL_NS || (since > MIN_FRAME_INTERVAL_NS && pipe.isConsumed()))) {
            publish();
        }
    }

    /**
     * Publishes a frame, and keeps it for the timeline if it is time for one. Nobody ever sees a frame with a number
     * that is none.
     */
    void publish() {
        surfaces.capture(pipe.back());
        if (pipe.back().isFinite()) {
            if (history.isFrameDue(simulation.time())) {
                history.add(pipe.back());
            }
            pipe.publish();
        }
        publishedNs = System.nanoTime();
        publishedStep = simulation.steps();
    }

    /** At the start again, or at an earlier state: what was seen later is forgotten. */
    void rewound() {
        history.truncateAfter(simulation.steps() == 0 ? Double.NEGATIVE_INFINITY : simulation.time());
        nextSample = 0;
        if (simulation.steps() == 0) {
            sample();
        }
        publish();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
