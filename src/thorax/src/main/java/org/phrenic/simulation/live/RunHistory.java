package org.phrenic.simulation.live;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;

/**
 * History of a run: observables of the last {@value #ROWS} samples (10 minutes at a sample every 0.02 s) and frames of
 * the last breaths. Both are ring buffers of bounded memory. Rows take at most 7 MB. Frames take at most
 * {@value #FRAME_BYTES} bytes and cover the last {@value #FRAMES_S} s at up to 25 frames per second. Thread-safe.
 */
public final class RunHistory {
    /** Number of samples kept. */
    public static final int ROWS = 30_000;

    static final long FRAME_BYTES = 64L << 20;
    static final double FRAMES_S = 10;
    private static final double MIN_FRAME_INTERVAL_S = 0.04;
    private static final int CHUNK = 1_000;
    private static final int COLUMNS = Observation.COLUMNS.size();

    private final List<double[]> chunks = new ArrayList<>();
    private final ArrayDeque<Frame> freeFrames = new ArrayDeque<>();
    private final ArrayList<Frame> ring = new ArrayList<>();
    private final int maxFrames;
    private final double betweenS;
    private int firstFrame;
    private long dropped;
    private int rows;
    private double lastFrameS = Double.NEGATIVE_INFINITY;

    RunHistory(Frame like) {
        long bytes = Math.max(1, bytes(like));
        maxFrames = (int) Math.max(2L, Math.min(Math.round(FRAMES_S / MIN_FRAME_INTERVAL_S), FRAME_BYTES / bytes));
        betweenS = FRAMES_S / maxFrames;
    }

    static long bytes(Frame frame) {
        return frame.bytes();
    }

    /** Removes everything after a time, s. The run continues from there. */
    synchronized void truncateAfter(double timeS) {
        while (rows > 0 && time(rows - 1) > timeS) {
            rows--;
        }
        while (!ring.isEmpty() && at(ring.size() - 1).timeS() > timeS) {
            // Restores chronological order, so that the newest frames can be removed from the end.
            Collections.rotate(ring, -firstFrame);
            firstFrame = 0;
            freeFrames.add(ring.remove(ring.size() - 1));
        }
        lastFrameS =
                ring.isEmpty() ? Double.NEGATIVE_INFINITY : at(ring.size() - 1).timeS();
    }

    synchronized void add(double[] values) {
        if (rows == ROWS) {
            dropped++;
            rows--;
        }
        long slot = (dropped + rows) % ROWS;
        int chunk = (int) (slot / CHUNK);
        while (chunks.size() <= chunk) {
            chunks.add(new double[CHUNK * COLUMNS]);
        }
        System.arraycopy(values, 0, chunks.get(chunk), (int) (slot % CHUNK) * COLUMNS, COLUMNS);
        rows++;
    }

    /** Whether the next frame is due. */
    synchronized boolean isFrameDue(double timeS) {
        return timeS >= lastFrameS + betweenS * (1 - 1e-9);
    }

    synchronized void add(Frame frame) {
        lastFrameS = frame.timeS();
        if (ring.size() < maxFrames) {
            Frame free = freeFrames.isEmpty() ? frame.copy() : freeFrames.poll();
            free.copyFrom(frame);
            // The ring is not full, so its oldest frame is first.
            ring.add(free);
        } else {
            ring.get(firstFrame).copyFrom(frame);
            firstFrame = (firstFrame + 1) % ring.size();
        }
    }

    private Frame at(int i) {
        return ring.get((firstFrame + i) % ring.size());
    }

    /** Number of samples available, oldest first. */
    public synchronized int size() {
        return rows;
    }

    /** Number of samples dropped since the start: sample i is number {@code dropped() + i} of the run. */
    public synchronized long dropped() {
        return dropped;
    }

    /** Simulated time of a sample, s. */
    public synchronized double time(int i) {
        return row(i)[offset(i)];
    }

    /** Observables of a sample, in the order of {@link Observation#COLUMNS}; a copy. */
    public synchronized double[] values(int i) {
        int from = offset(i);
        return Arrays.copyOfRange(row(i), from, from + COLUMNS);
    }

    /** Observables of the newest sample, a copy; empty without samples, as after a reset on another thread. */
    public synchronized Optional<double[]> latest() {
        return rows == 0 ? Optional.empty() : Optional.of(values(rows - 1));
    }

    private double[] row(int i) {
        if (i < 0 || i >= rows) {
            throw new IndexOutOfBoundsException("sample " + i + " of " + rows);
        }
        return chunks.get((int) ((dropped + i) % ROWS / CHUNK));
    }

    private int offset(int i) {
        return (int) ((dropped + i) % ROWS % CHUNK) * COLUMNS;
    }

    /** Number of frames available, oldest first. */
    public synchronized int frames() {
        return ring.size();
    }

    /** Simulated time of a frame, s; NaN if the index is out of range. */
    public synchronized double frameTime(int i) {
        return i < 0 || i >= ring.size() ? Double.NaN : at(i).timeS();
    }

    /** Copies a frame; false if the index is out of range or the frame is of another scene. */
    public synchronized boolean frame(int i, Frame into) {
        if (i < 0 || i >= ring.size() || !into.isOfSceneOf(at(i))) {
            return false;
        }
        into.copyFrom(at(i));
        return true;
    }
}
