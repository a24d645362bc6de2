package org.phrenic.ui.view;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.function.Consumer;
import org.phrenic.scene.gl.OffscreenContext;

/** Tasks for the render thread, in their order. Thread-safe. */
final class RenderTasks {
    private final Queue<Task> waiting = new ArrayDeque<>();
    private long begun;
    private boolean ended;

    /**
     * A task.
     *
     * @param otherwise runs in its place where nothing is drawn any more
     */
    private record Task(Consumer<OffscreenContext> what, Runnable otherwise) {}

    void add(Consumer<OffscreenContext> what, Runnable otherwise) {
        synchronized (this) {
            if (!ended) {
                waiting.add(new Task(what, otherwise));
                return;
            }
        }
        otherwise.run();
    }

    /** Whether a task waits. */
    synchronized boolean isAnyWaiting() {
        return !waiting.isEmpty();
    }

    /** Number of tasks that were begun. */
    synchronized long begun() {
        return begun;
    }

    /** Takes the first task, which waits, and runs it. */
    void runNext(OffscreenContext gl) {
        Task next;
        synchronized (this) {
            next = waiting.remove();
            begun++;
        }
        next.what.accept(gl);
    }

    /** Nothing is drawn any more: what waits, and what comes later, is told so. */
    void end() {
        List<Task> left;
        synchronized (this) {
            ended = true;
            left = new ArrayList<>(waiting);
            waiting.clear();
        }
        left.forEach(task -> task.otherwise.run());
    }
}
