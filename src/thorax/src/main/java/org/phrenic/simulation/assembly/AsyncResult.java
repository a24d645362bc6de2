package org.phrenic.simulation.assembly;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;

/** A result that is worked out on another core until it is asked for. What the work throws is thrown to who asks. */
final class AsyncResult<T> {
    private final CompletableFuture<T> future;

    private AsyncResult(CompletableFuture<T> future) {
        this.future = future;
    }

    /** Begins; the work must depend on nothing that changes meanwhile. */
    static <T> AsyncResult<T> start(Supplier<T> work) {
        return new AsyncResult<>(CompletableFuture.supplyAsync(work));
    }

    /** Waits for the result. */
    T get() {
        try {
            return future.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            if (e.getCause() instanceof Error cause) {
                throw cause;
            }
            throw e;
        }
    }
}
