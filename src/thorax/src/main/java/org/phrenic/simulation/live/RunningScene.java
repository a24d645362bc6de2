package org.phrenic.simulation.live;

import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.integrator.StabilityLimit;
import org.phrenic.engine.integrator.Stepper;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SubstepReason;
import org.phrenic.simulation.observe.Frame;

/**
 * A running scene with its frames and history. Used by the simulation's thread alone, except for the thread-safe
 * objects that it exposes.
 */
final class RunningScene implements AutoCloseable {
    /** Longest wall time between frames, ns, even if no reader took the last one. */
    private static final long MAX_FRAME_INTERVAL_NS = 250_000_000;

    /** Shortest wall time between frames, ns: 60 per second. */
    private static final long MIN_FRAME_INTERVAL_NS = 16_000_000;

    /**
     * Wall time after the last frame from which one is captured for the history alone, ns. Capturing takes as long as
     * ten to twenty steps, and while a reader takes frames the history gets those.
     */
    private static final long MIN_HISTORY_INTERVAL_NS = 60_000_000;

    /** Simulated time between frames of a step listener up to which readers get them instead of captures, s. */
    private static final double LISTENER_INTERVAL_S = 0.05;

    final Simulation simulation;
    final LiveScene scene;
    final FrameTripleBuffer pipe;
    final RunHistory history;
    final boolean organs;
    private final SceneSurfaces surfaces;
    private final FrameWriter writer = new FrameWriter();
    private long nextSample;
    private double[] sampled = new double[0];
    /** Step of the last sample; -1 if it is out of date. */
    private long sampledStep = -1;

    private long publishedNs;
    private long publishedStep;
    private Frame listenerFrame;
    /** Step of {@link #listenerFrame}; -1 if it is out of date. */
    private long capturedStep = -1;

    private Optional<SubstepReason> substepReason = Optional.empty();
    private StabilityLimit limitSaid;
    private int substepsSaid;

    /** @param organs whether the surfaces include the further organs of the body */
    RunningScene(Simulation simulation, SceneSurfaces surfaces, Thorax body, long id, boolean organs) {
        this.organs = organs;
        this.simulation = simulation;
        this.surfaces = surfaces;
        Frame rest = surfaces.newFrame();
        pipe = new FrameTripleBuffer(rest);
        history = new RunHistory(rest);
        int nodes = simulation.system().nodeCount();
        scene = new LiveScene(
                simulation.start(), surfaces.surfaces(), surfaces.overlays(), rest::copy, nodes, body, id);
        sample();
        publish();
    }

    /** Scenario that reproduces this run: the initial settings with the changes made since. */
    Scenario recordedScenario() {
        return simulation.start().withChanges(simulation.changes()).withSteps(simulation.steps());
    }

    /**
     * See {@link Simulation#substepReason}. Cached until the stability limit is measured again, because computing it
     * takes a search.
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

    /** Performs one step, and samples it if due. */
    void step() {
        simulation.step();
        if (simulation.steps() >= nextSample) {
            sample();
            if (history.isFrameDue(simulation.time()) && System.nanoTime() - publishedNs > MIN_HISTORY_INTERVAL_NS) {
                publishLater();
            }
        }
    }

    /** Calls the step listener if this step is due; returns whether it was. */
    boolean notifyStepListener(StepListener watch, StepListener.Trigger when) {
        boolean due = when.isDue(
                simulation.steps(), simulation.time(), simulation.stepper().dt());
        if (due && (writer.isIdle() || !passes(watch))) {
            writer.finish();
            notify(watch);
        }
        return due;
    }

    /** Whether the listener lets this step pass while a frame is at work. */
    private boolean passes(StepListener watch) {
        return watch.passes(simulation.time(), simulation.breathLabel(), breath());
    }

    private int breath() {
        return 1 + simulation.scene().drive().breathAt(simulation.time()).breath;
    }

    private void notify(StepListener watch) {
        boolean seen = watch.needsFrame() || isReaderWaiting();
        boolean later = seen && watch.maySeeFrameLater();
        RespiratoryPhase label = simulation.breathLabel();
        if (!seen || later) {
            watch.onStepWithoutFrame(simulation.time(), label, breath());
        }
        if (!seen) {
            return;
        }
        listenerFrame = listenerFrame == null ? surfaces.newFrame() : listenerFrame;
        read();
        capturedStep = simulation.steps();
        boolean shown = isReaderWaiting();
        if (shown) {
            published();
        }
        Runnable task = () -> {
            surfaces.write(listenerFrame);
            watch.onStep(listenerFrame, label);
            if (shown) {
                pipe.back().copyFrom(listenerFrame);
                handOver();
            }
        };
        if (later) {
            writer.start(task);
        } else {
            task.run();
        }
    }

    private void sample() {
        sampled = surfaces.observe();
        history.add(sampled);
        Stepper stepper = simulation.stepper();
        sampledStep = stepper.steps();
        nextSample = stepper.steps()
                + Math.max(1, Math.round(simulation.start().get(RunSettings.RECORD_EVERY) / stepper.dt()));
    }

    /** Copies the state for a frame; the observables are those of the sample of this step, if there is one. */
    private void read() {
        surfaces.read(sampledStep == simulation.steps() ? sampled : surfaces.observe());
    }

    private boolean isReaderWaiting() {
        return System.nanoTime() - publishedNs > MIN_FRAME_INTERVAL_NS && writer.isIdle() && pipe.isConsumed();
    }

    /** Whether the frames that a step listener gets are frequent enough for readers too. */
    private boolean isListenerFrequent() {
        return capturedStep >= 0
                && (simulation.steps() - capturedStep) * simulation.stepper().dt() < LISTENER_INTERVAL_S;
    }

    /** Publishes a frame if the state has changed and either a reader has taken the last frame or it is too old. */
    void publishIfDue() {
        // The settings may have changed since the step.
        sampledStep = -1;
        long since = System.nanoTime() - publishedNs;
        if (simulation.steps() != publishedStep
                && (since > MAX_FRAME_INTERVAL_NS || (isReaderWaiting() && !isListenerFrequent()))) {
            publishLater();
        }
    }

    /** Publishes a frame of the current state while the simulation goes on, unless another one is at work. */
    private void publishLater() {
        if (writer.isIdle()) {
            read();
            published();
            writer.start(() -> {
                surfaces.write(pipe.back());
                handOver();
            });
        }
    }

    /** Publishes a frame of the current state. */
    void publish() {
        capture();
        handOver();
    }

    /** Publishes a frame of the current state of a paused run, which a listener is given before. */
    void publishAtPause(StepListener watch) {
        capture();
        try {
            watch.onPause(pipe.back(), simulation.breathLabel());
        } finally {
            handOver();
        }
    }

    /** Makes the back frame one of the current state. */
    private void capture() {
        writer.finish();
        if (capturedStep == simulation.steps()) {
            pipe.back().copyFrom(listenerFrame);
        } else {
            surfaces.capture(pipe.back());
        }
        published();
    }

    private void published() {
        publishedNs = System.nanoTime();
        publishedStep = simulation.steps();
    }

    /** Publishes the back frame, and adds it to the history if due; not one with NaN or infinite values. */
    private void handOver() {
        if (pipe.back().isFinite()) {
            if (history.isFrameDue(pipe.back().timeS())) {
                history.add(pipe.back());
            }
            pipe.publish();
        }
    }

    /** Removes the history after the current time, after a restart or a return to an earlier state. */
    void rewound() {
        writer.finish();
        capturedStep = -1;
        sampledStep = -1;
        history.truncateAfter(simulation.steps() == 0 ? Double.NEGATIVE_INFINITY : simulation.time());
        nextSample = 0;
        if (simulation.steps() == 0) {
            sample();
        }
        publish();
    }

    @Override
    public void close() {
        try {
            writer.close();
        } finally {
            simulation.close();
        }
    }
}
