package org.phrenic.engine.parallel;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;

/**
 * A few threads that share out numbered pieces of work, thousands of times a second.
 *
 * <p>The caller works too. Each thread has a run of pieces of its own, the same every time, so that what it touched
 * last time is still in its core's cache; who is done with his own takes pieces from the others' runs, so if a core is
 * taken by another process its share is done by the others, and a step never waits for a worker that has not begun.
 * Idle workers spin briefly, then yield, then sleep. Nothing is allocated by {@link #run}. Which thread does a piece
 * must not matter to its result.
 */
public final class Workers implements AutoCloseable {
    /** One numbered piece of work. */
    @FunctionalInterface
    public interface Task {
        void run(int piece);
    }

    private static final int SPINS = 2_000;
    /**
     * Long enough to outlast a look at the scene (about a millisecond): a worker that sleeps through the next round's
     * beginning costs a twentieth where every second step is looked at.
     */
    private static final int YIELDS = 5_000;

    private static final long PARK_NANOS = 50_000;
    private static final int PIECE_BITS = 24;
    private static final long PIECE_MASK = (1L << PIECE_BITS) - 1;
    /** Longs between two threads' counters: two cache lines, so that they do not disturb each other. */
    private static final int STRIDE = 16;

    private final Thread[] threads;
    /** For each thread: round number in the high bits, pieces of its run still to be claimed in the low ones. */
    private final AtomicLongArray left;

    private final AtomicInteger unfinished = new AtomicInteger();
    private int pieces;
    private Task task;
    /** Written after task, pieces and counters of the round, and read before them. */
    private volatile long round;

    private volatile boolean closed;
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
     * @param count threads in all, the caller's included
     * @throws IllegalArgumentException if there is not at least one
     */
    public static Workers of(int count) {
        if (count < 1) {
            throw new IllegalArgumentException("threads: found " + count + ", expected 1 or more");
        }
        return new Workers(count);
    }

    /** The threads that share the work, the caller's included. */
    public int count() {
        return threads.length + 1;
    }

    /**
     * Runs pieces 0 to {@code pieces - 1}, in any order, and returns when all are done. One caller at a time. What a
     * piece throws is thrown here, after the others are done (one of them if several do).
     */
    public void run(int pieces, Task work) {
        if (threads.length == 0 || pieces < 2) {
            for (int i = 0; i < pieces; i++) {
                work.run(i);
            }
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
            // A task declares nothing checked.
            if (thrown instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) thrown;
        }
    }

    private int firstPiece(int owner, int all) {
        return (int) ((long) all * owner / count());
    }

    /** Claims and does pieces of a round, own ones first, until none is left. */
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
                // A claim of an old round fails here on the round number, whatever was read as its task.
                if (left.compareAndSet(STRIDE * (owner + 1), now, now - 1)) {
                    done++;
                    try {
                        work.run(end - (int) (now & PIECE_MASK));
                    } catch (Throwable e) {
                        // An Error too: a piece lost in silence would leave a step half done.
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
            } else {
                relax(idle++, true);
            }
        }
    }

    @SuppressWarnings("ThreadPriorityCheck") // yielding is the point: the core may be wanted by the worker waited for
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
