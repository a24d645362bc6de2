package org.phrenic.engine.parallel;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;

/** Runs independent jobs in parallel. Results are in the order of the jobs, whatever the number of threads. */
public final class BatchRunner {
    /**
     * A named job.
     *
     * @param name name in progress messages
     * @param work the computation
     */
    public record Job<T>(String name, Supplier<T> work) {}

    private BatchRunner() {}

    /** Runs a job, unless one before it has failed: its future is never asked then. */
    private static <T> T runUnlessFailed(Job<T> job, int index, AtomicInteger firstFailed) {
        if (firstFailed.get() < index) {
            throw new CancellationException(job.name);
        }
        boolean done = false;
        try {
            T result = job.work.get();
            done = true;
            return result;
        } finally {
            if (!done) {
                firstFailed.accumulateAndGet(index, Math::min);
            }
        }
    }

    /**
     * Runs all jobs and returns their results. After a failure no later job starts; the earlier ones are run to their
     * end, so that the failure that is thrown is the first in the order of the jobs on any number of threads.
     */
    public static <T> List<T> run(List<Job<T>> jobs, int threads, ProgressListener progress) {
        ExecutorService pool = Executors.newFixedThreadPool(Math.max(1, Math.min(threads, jobs.size())), task -> {
            Thread thread = new Thread(task, "study");
            thread.setDaemon(true);
            return thread;
        });
        AtomicInteger count = new AtomicInteger();
        AtomicInteger firstFailed = new AtomicInteger(Integer.MAX_VALUE);
        try {
            List<Future<T>> futures = new ArrayList<>();
            for (int i = 0; i < jobs.size(); i++) {
                int index = i;
                Job<T> job = jobs.get(i);
                futures.add(pool.submit(() -> {
                    T result = runUnlessFailed(job, index, firstFailed);
                    synchronized (count) {
                        progress.done(count.incrementAndGet(), jobs.size(), job.name);
                    }
                    return result;
                }));
            }
            List<T> results = new ArrayList<>();
            for (Future<T> future : futures) {
                results.add(future.get());
            }
            return results;
        } catch (ExecutionException failure) {
            if (failure.getCause() instanceof RuntimeException told) {
                throw told;
            }
            if (failure.getCause() instanceof Error error) {
                throw error;
            }
            throw new IllegalStateException(failure.getCause());
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the study was interrupted", stopped);
        } finally {
            pool.shutdownNow();
        }
    }
}
