package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Frame;

/** One breath at evenly spaced moments. {@link CycleRecorder} gathers the same from a run that is watched. */
public final class BreathCycle {
    /** Moments of a breath unless it is said otherwise. */
    public static final int PHASES = 20;

    /** A pattern that never ends or takes longer is looked at for so long, s. */
    private static final double LONGEST_S = 40;

    private BreathCycle() {}

    /**
     * Simulates one period of the breathing from where the simulation stands, or all of a breathing that has none, such
     * as a hold.
     *
     * @param phases how many moments, the first now, the last one interval before the end
     */
    public static List<BreathMoment> record(Simulation simulation, SceneSurfaces surfaces, int phases) {
        double start = simulation.time();
        List<BreathMoment> moments = new ArrayList<>();
        Frame frame = surfaces.newFrame();
        for (int i = 0; i < phases; i++) {
            while (!isDue(
                    simulation.time() - start, simulation.stepper().dt(), simulation.breathDurationS(), i, phases)) {
                simulation.step();
            }
            surfaces.capture(frame);
            moments.add(new BreathMoment(frame.copy(), simulation.breathLabel()));
        }
        return moments;
    }

    /** Whether a moment has come, so many seconds after the first. */
    static boolean isDue(double sinceS, double dtS, double breathS, int moment, int phases) {
        return sinceS >= Math.min(breathS, LONGEST_S) * moment / phases - 0.5 * dtS;
    }
}
