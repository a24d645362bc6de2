package org.phrenic.engine;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * A few threads that share out numbered pieces of work, thousands of times a second.
 *
 * <p>The caller works too, and pieces are claimed one by one: if a core is taken by another process its share is done by the others, so a step never waits for a
 * worker that has not begun. Idle workers spin briefly, then yield, then sleep. Nothing is allocated by {@link #run}. Which thread does a piece must not
 * matter to its result.
 */
public final class Workers implements AutoCloseable {
    /** One numbered piece of work. */
    @FunctionalInterface
    public interface Task {
        void run(int piece);
    }

    private static final int SPINS = 2_000;
    private static final int YIELDS = 200;
    private static final long PARK_NANOS = 50_000;
    private static final int PIECE_BITS = 24;
    private static final long PIECE_MASK = (1L << PIECE_BITS) - 1;

    private final Thread[] threads;
    /** Round number in the high bits, pieces still to be claimed in the low ones. */
    private final AtomicLong ticket = new AtomicLong();

    private final AtomicInteger unfinished = new AtomicInteger();
    private volatile Task task;
    private volatile boolean closed;
    private volatile Throwable failure;

    private Workers(int count) {
        threads = new Thread[count - 1];
        for (int i = 0; i < threads.length; i++) {
            threads[i] = new Thread(this::serve, "phrenic-worker-" + (i + 1));
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
     * Runs pieces 0 to {@code pieces - 1}, in any order, and returns when all are done. One caller at a time. What a piece throws is thrown here, after the others are done
     * (one of them if several do).
     */
    public void run(int pieces, Task work) {
        if (threads.length == 0 || pieces < 2) {
            for (int i = 0; i < pieces; i++) {
                work.run(i);
            }
            return;
        }
        task = work;
        unfinished.set(pieces);
        long round = (ticket.get() >>> PIECE_BITS) + 1;
        ticket.set(round << PIECE_BITS | pieces);
        claimAll(round, work);
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

    private void claimAll(long round, Task work) {
        while (true) {
            long now = ticket.get();
            long left = now & PIECE_MASK;
            if (now >>> PIECE_BITS != round || left == 0) {
                return;
            }
            if (ticket.compareAndSet(now, now - 1)) {
                try {
                    work.run((int) left - 1);
                } catch (Throwable e) {
                    // An Error too: a piece lost in silence would leave a step half done.
                    failure = e;
                } finally {
                    unfinished.decrementAndGet();
                }
            }
        }
    }

    private void serve() {
        int idle = 0;
        while (!closed) {
            long now = ticket.get();
            if ((now & PIECE_MASK) != 0) {
                // The task is read after the ticket that it was published with; a stale claim fails on the round
                // number.
                Task work = task;
                if (ticket.get() >>> PIECE_BITS == now >>> PIECE_BITS) {
                    claimAll(now >>> PIECE_BITS, work);
                }
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
