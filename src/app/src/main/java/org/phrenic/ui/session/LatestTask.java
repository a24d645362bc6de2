package org.phrenic.ui.session;

import java.util.concurrent.Callable;
import java.util.function.Consumer;

/**
 * Tasks in the background of which the latest alone counts, whichever ends first: the user wants what was asked for
 * last. Used on the event dispatch thread.
 */
public final class LatestTask {
    private long latest;

    /** As {@link BackgroundWorker#execute}; result and failure are dropped if another task has begun meanwhile. */
    public <T> void execute(Callable<T> task, Consumer<T> onDone, Consumer<String> onFailure) {
        drop();
        long mine = latest;
        BackgroundWorker.execute(
                task, result -> ifLatest(mine, onDone, result), problem -> ifLatest(mine, onFailure, problem));
    }

    /** The tasks begun so far do not count. */
    public void drop() {
        latest++;
    }

    private <T> void ifLatest(long number, Consumer<T> consumer, T outcome) {
        if (number == latest) {
            consumer.accept(outcome);
        }
    }
}
