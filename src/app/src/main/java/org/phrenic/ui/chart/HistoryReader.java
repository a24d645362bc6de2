package org.phrenic.ui.chart;

import org.phrenic.simulation.live.RunHistory;

/** Carries what is new in a run's history over into a ring, and notices when the run began again. */
final class HistoryReader {
    private final SampleRingBuffer ring;
    private long samplesRead;

    HistoryReader(SampleRingBuffer ring) {
        this.ring = ring;
    }

    SampleRingBuffer ring() {
        return ring;
    }

    /** Takes everything from the beginning next time. */
    void clear() {
        ring.clear();
        samplesRead = 0;
    }

    /**
     * Takes what is new.
     *
     * @param history null before the first scene
     * @return whether there was anything, or the run began again
     */
    boolean update(RunHistory history) {
        if (history == null) {
            return false;
        }
        int size = history.size();
        long total = history.dropped() + size;
        boolean again = total < samplesRead || (size > 0 && ring.size() > 0 && history.time(size - 1) < lastTime());
        if (again) {
            clear();
        }
        int from = (int) Math.max(0, samplesRead - history.dropped());
        for (int i = from; i < size; i++) {
            try {
                double[] values = history.values(i);
                ring.add(values[0], values);
            } catch (IndexOutOfBoundsException begunAgain) {
                // The run began again in between: the next call takes it from its start.
                clear();
                return true;
            }
        }
        boolean any = total > samplesRead || again;
        samplesRead = total;
        return any;
    }

    private double lastTime() {
        return ring.time(ring.size() - 1);
    }
}
