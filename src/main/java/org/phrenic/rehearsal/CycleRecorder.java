package org.phrenic.rehearsal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.breathing.BreathLabel;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Observation;

/**
 * Gathers the moments of one whole breath from the frames of a run that goes on, for an access map of what is breathed just now. Frames are kept no closer together than {@value #BETWEEN_S} s; of those kept, as many as are
 * wanted are taken, evenly spread in time. A breath of more than {@value #LONGEST_S} s, or a held one, counts as whole by then.
 */
public final class CycleRecorder {
    private static final double BETWEEN_S = 0.1;
    private static final double LONGEST_S = 20;
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");

    private final int phases;
    private final List<BreathMoment> kept = new ArrayList<>();
    private double breath = Double.NaN;
    private boolean whole;

    /** @param phases how many moments are wanted */
    public CycleRecorder(int phases) {
        this.phases = phases;
    }

    /**
     * Takes a frame, in order.
     *
     * @return the moments of the breath that it ends, else nothing
     */
    public Optional<List<BreathMoment>> take(Frame frame, BreathLabel label) {
        double now = frame.values()[BREATH];
        double last = kept.isEmpty()
                ? Double.NEGATIVE_INFINITY
                : kept.get(kept.size() - 1).timeS();
        if (frame.timeS() < last) {
            restart();
        }
        boolean ends =
                !kept.isEmpty() && (now != breath || frame.timeS() - kept.get(0).timeS() > LONGEST_S);
        Optional<List<BreathMoment>> cycle = Optional.empty();
        if (ends) {
            cycle = whole ? Optional.of(spread(frame.timeS())) : Optional.empty();
            kept.clear();
            whole = true;
        }
        if (kept.isEmpty() || frame.timeS() >= last + BETWEEN_S * (1 - 1e-9)) {
            whole |= kept.isEmpty() && frame.step() == 0;
            kept.add(new BreathMoment(frame.copy(), label));
        }
        breath = now;
        return cycle;
    }

    /** Forgets what was gathered: after a reset, or when the breathing was changed. */
    public void restart() {
        kept.clear();
        whole = false;
    }

    /** The first moment, then for each further one the kept frame that is nearest to its time. */
    private List<BreathMoment> spread(double endS) {
        double start = kept.get(0).timeS();
        List<BreathMoment> out = new ArrayList<>();
        int at = 0;
        for (int i = 0; i < phases; i++) {
            double time = start + (endS - start) * i / phases;
            while (at + 1 < kept.size()
                    && Math.abs(kept.get(at + 1).timeS() - time)
                            <= Math.abs(kept.get(at).timeS() - time)) {
                at++;
            }
            out.add(kept.get(at));
        }
        return out;
    }
}
