package org.phrenic.access.attempt;

import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/** Where in the breath frames stand, and where it was between the last two. */
final class AttemptClock {
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int PHASE = Observation.COLUMNS.indexOf("phase");

    private double timeS = Double.NaN;
    private int breath = 1;
    private double phase;
    private double phaseBefore;
    private double passedS;
    private RespiratoryPhase label = RespiratoryPhase.PAUSE;

    /**
     * Takes a frame.
     *
     * @param doing what the breath is doing
     * @return s since the last frame; 0 for the first
     */
    double update(Frame frame, RespiratoryPhase doing) {
        double passed = Double.isNaN(timeS) ? 0 : frame.timeS() - timeS;
        if (passed < 0) {
            throw new IllegalArgumentException(
                    "found a frame of " + frame.timeS() + " s after one of " + timeS + " s, expected frames in order");
        }
        timeS = frame.timeS();
        int breathNow = 1 + (int) frame.values()[BREATH];
        phaseBefore = breathNow == breath ? phase : 0;
        passedS = passed;
        breath = breathNow;
        phase = frame.values()[PHASE];
        label = doing;
        return passed;
    }

    /** Time of the last frame, s. */
    double timeS() {
        return timeS;
    }

    /**
     * What happened between the last two frames. The phase is taken to go on evenly there; a breath that began in
     * between counts from its beginning.
     */
    AttemptEvent event(AttemptEvent.Kind kind, String structure, double atDepthMm, double when) {
        double before = passedS > 0 ? (timeS - when) / passedS : 0;
        double at = phase - before * (phase - phaseBefore);
        return new AttemptEvent(kind, structure, when, breath, at, label, atDepthMm);
    }
}
