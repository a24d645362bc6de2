package org.phrenic.engine.parallel;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;

/**
 * A thread pool for numbered pieces of work, suited to thousands of short parallel loops a second.
 *
 * <p>The calling thread works too. Each thread first takes its own fixed range of pieces, so that their data stay in
 * its core's cache. It then takes pieces from the ranges of other threads (work stealing), so a core that is busy with
 * another process does not delay a step. Idle workers spin briefly, then yield, then sleep. {@link #run} allocates
 * nothing. The result of a piece must not depend on the thread that runs it.
 */
public final class Workers implements AutoCloseable {
    /** One numbered piece of work. */
    @FunctionalInterface
    public interface Task {
        void run(int piece);
    }

    private static final int SPINS = 2_000;
    /**
     * Number of yields before sleeping: longer than the rendering of a frame (about a millisecond). A worker that
     * sleeps at the start of a round costs 5 % if every second step is rendered.
     */
    private static final int YIELDS = 5_000;

    private static final long PARK_NANOS = 50_000;
    /** Sleep of workers that are not used; {@link #useCallerOnly} wakes them. */
    private static final long UNUSED_PARK_NANOS = 100_000_000;

    private static final int PIECE_BITS = 24;
    private static final long PIECE_MASK = (1L << PIECE_BITS) - 1;
    /** Greatest number of pieces of a round: those of one thread are counted in the low bits. */
    public static final int MOST_PIECES = (1 << PIECE_BITS) - 1;
    /** Distance between the counters of two threads, in longs: two cache lines, to avoid false sharing. */
    private static final int STRIDE = 16;

    private final Thread[] threads;
    /** For each thread: round number in the high bits, number of unclaimed pieces of its range in the low bits. */
    private final AtomicLongArray left;

    private final AtomicInteger unfinished = new AtomicInteger();
    private int pieces;
    private Task task;
    /** Written after task, pieces and counters of a round and read before them, which makes them visible to workers. */
    private volatile long round;

    private volatile boolean closed;
    private volatile boolean callerOnly;
    private volatile Throwable failure;

    private Workers(int count) {
        left = new AtomicLongArray(STRIDE * (count + 1));
        threads = new Thread[count - 1];
        for (int i = 0; i < threads.length; i++) {
            int self = i + 1;
            threads[i] = new Thread(() -> serve(self), "phrenic-worker-" + self);
            threads[i].setDaemon(true);
            threads[i].start();
        }
    }

    /**
     * Creates a pool.
     *
     * @param count number of threads, including the caller's
     * @throws IllegalArgumentException if it is less than 1
     */
    public static Workers of(int count) {
        if (count < 1) {
            throw new IllegalArgumentException("threads: found " + count + ", expected 1 or more");
        }
        return new Workers(count);
    }

    /** Number of threads, including the caller's. */
    public int count() {
        return threads.length + 1;
    }

    /**
     * Lets {@link #run} work on the calling thread alone, or on all threads. On a machine whose cores are taken by
     * other work one thread is faster than two, of which each waits for the other at every loop.
     */
    public void useCallerOnly(boolean alone) {
        callerOnly = alone;
        if (!alone) {
            for (Thread thread : threads) {
                LockSupport.unpark(thread);
            }
        }
    }

    /**
     * Runs pieces 0 to {@code pieces - 1} in any order and returns when all are done. Only one thread may call it at a
     * time. An exception of a piece is rethrown after the other pieces are done (one of them if there are several).
     *
     * @throws IllegalArgumentException if there are more than {@value #MOST_PIECES} pieces
     */
    public void run(int pieces, Task work) {
        if (pieces > MOST_PIECES) {
            throw new IllegalArgumentException("pieces: found " + pieces + ", expected at most " + MOST_PIECES);
        }
        if (threads.length == 0 || pieces < 2 || callerOnly) {
            runAlone(pieces, work);
            return;
        }
        long next = round + 1;
        task = work;
        this.pieces = pieces;
        unfinished.set(pieces);
        for (int owner = 0; owner < count(); owner++) {
            int run = firstPiece(owner + 1, pieces) - firstPiece(owner, pieces);
            left.set(STRIDE * (owner + 1), next << PIECE_BITS | run);
        }
        round = next;
        claimAll(0, next, work, pieces);
        for (int i = 0; unfinished.get() > 0; i++) {
            relax(i, false);
        }
        Throwable thrown = failure;
        if (thrown != null) {
            failure = null;
            throw unchecked(thrown);
        }
    }

    private static void runAlone(int pieces, Task work) {
        Throwable thrown = null;
        for (int i = 0; i < pieces; i++) {
            try {
                work.run(i);
            } catch (Throwable e) {
                thrown = thrown == null ? e : thrown;
            }
        }
        if (thrown != null) {
            throw unchecked(thrown);
        }
    }

    /** Throws an error; returns any other failure. A task declares no checked exceptions. */
    private static RuntimeException unchecked(Throwable thrown) {
        if (thrown instanceof Error error) {
            throw error;
        }
        return (RuntimeException) thrown;
    }

    private int firstPiece(int owner, int all) {
        return (int) ((long) all * owner / count());
    }

    /** Claims and runs pieces of a round, those of the own range first, until none is left. */
    private void claimAll(int self, long current, Task work, int all) {
        int done = 0;
        for (int i = 0; i < count(); i++) {
            int owner = (self + i) % count();
            int end = firstPiece(owner + 1, all);
            while (true) {
                long now = left.get(STRIDE * (owner + 1));
                if (now >>> PIECE_BITS != (current << PIECE_BITS) >>> PIECE_BITS || (now & PIECE_MASK) == 0) {
                    break;
                }
                // A claim for an old round fails here because the round number differs, whatever task was read.
                if (left.compareAndSet(STRIDE * (owner + 1), now, now - 1)) {
                    done++;
                    try {
                        work.run(end - (int) (now & PIECE_MASK));
                    } catch (Throwable e) {
                        // Errors are caught too: a silently lost piece would leave a step incomplete.
                        failure = e;
                    }
                }
            }
        }
        if (done > 0) {
            unfinished.addAndGet(-done);
        }
    }

    private void serve(int self) {
        long seen = 0;
        int idle = 0;
        while (!closed) {
            long now = round;
            if (now != seen) {
                seen = now;
                claimAll(self, now, task, pieces);
                idle = 0;
            } else if (callerOnly) {
                LockSupport.parkNanos(UNUSED_PARK_NANOS);
            } else {
                relax(idle++, true);
            }
        }
    }

    @SuppressWarnings("ThreadPriorityCheck") // intended: the awaited worker may need this core
    private static void relax(int turn, boolean maySleep) {
        if (turn < SPINS) {
            Thread.onSpinWait();
        } else if (turn < SPINS + YIELDS || !maySleep) {
            Thread.yield();
        } else {
            LockSupport.parkNanos(PARK_NANOS);
        }
    }

    /** Ends the worker threads. */
    @Override
    public void close() {
        closed = true;
        for (Thread thread : threads) {
            LockSupport.unpark(thread);
        }
    }
}
