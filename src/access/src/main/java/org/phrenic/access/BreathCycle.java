package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;

/** Records the body at evenly spaced moments of one breath. {@link CycleRecorder} does the same during a live run. */
public final class BreathCycle {
    public static final int PHASES = 20;
    /** Maximum recording time, s, of a breath or, without a period, of the duration of the scenario. */
    private static final double MAX_DURATION_S = 40;

    private BreathCycle() {}

    /**
     * Simulates one breath from the current state and records it.
     *
     * @param phases number of moments; the first is the current time, the last is one interval before the end of the
     *     breath
     */
    public static List<BreathMoment> record(Simulation simulation, SceneSurfaces surfaces, int phases) {
        double start = simulation.time();
        double breathS = simulation.breathDurationS();
        List<BreathMoment> moments = new ArrayList<>();
        Frame frame = surfaces.newFrame();
        for (int i = 0; i < phases; i++) {
            double dt = simulation.stepper().dt();
            while (!isDue(simulation.time() - start, dt, breathS, i, phases)) {
                simulation.step();
            }
            surfaces.capture(frame);
            moments.add(new BreathMoment(frame.copy(), simulation.breathLabel()));
        }
        return moments;
    }

    /** Whether the next moment is due, {@code sinceS} seconds after the first. */
    static boolean isDue(double sinceS, double dtS, double breathS, int moment, int phases) {
        return sinceS >= Math.min(breathS, MAX_DURATION_S) * moment / phases - 0.5 * dtS;
    }
}
