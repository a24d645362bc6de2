package org.phrenic.ui;

import org.phrenic.simulation.live.History;

/** Carries what is new in a run's history over into a ring, and notices when the run began again. */
final class HistoryFeed {
    private final SampleRing ring;
    private long seen;

    HistoryFeed(SampleRing ring) {
        this.ring = ring;
    }

    SampleRing ring() {
        return ring;
    }

    /** Takes everything from the beginning next time. */
    void restart() {
        ring.clear();
        seen = 0;
    }

    /**
     * Takes what is new.
     *
     * @param history null before the first scene
     * @return whether there was anything, or the run began again
     */
    boolean pull(History history) {
        if (history == null) {
            return false;
        }
        int size = history.size();
        long total = history.dropped() + size;
        boolean again = total < seen || (size > 0 && ring.size() > 0 && history.time(size - 1) < last());
        if (again) {
            restart();
        }
        int from = (int) Math.max(0, seen - history.dropped());
        for (int i = from; i < size; i++) {
            try {
                double[] values = history.values(i);
                ring.add(values[0], values);
            } catch (IndexOutOfBoundsException begunAgain) {
                // The run began again in between: the next call takes it from its start.
                restart();
                return true;
            }
        }
        boolean any = total > seen || again;
        seen = total;
        return any;
    }

    private double last() {
        return ring.time(ring.size() - 1);
    }
}
