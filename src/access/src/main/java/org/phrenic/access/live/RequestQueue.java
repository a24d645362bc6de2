package org.phrenic.access.live;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.phrenic.file.BadInputException;

/** Requests in the order in which they are made; made on any thread, taken on one. */
final class RequestQueue {
    private record Request(Runnable action, boolean isTurn) {}

    private final Queue<Request> requests = new ConcurrentLinkedQueue<>();

    void add(Runnable action) {
        requests.add(new Request(action, false));
    }

    /** Adds a turn of the needle, which replaces a turn right before it. */
    void addTurn(Runnable turn) {
        requests.add(new Request(turn, true));
    }

    /**
     * Executes the requests in their order, without those that another one replaces.
     *
     * @param after is done after each request that was not refused
     * @param refused is given the sentence of each one that was
     */
    void runAll(Runnable after, Consumer<String> refused) {
        for (Optional<Runnable> next = poll(); next.isPresent(); next = poll()) {
            try {
                next.get().run();
                after.run();
            } catch (BadInputException bad) {
                refused.accept(bad.getMessage());
            }
        }
    }

    /** Removes the next request that no other one replaces; empty if there is none. */
    private Optional<Runnable> poll() {
        Request next = requests.poll();
        while (next != null && next.isTurn && isTurnNext()) {
            next = requests.poll();
        }
        return Optional.ofNullable(next).map(Request::action);
    }

    private boolean isTurnNext() {
        Request next = requests.peek();
        return next != null && next.isTurn;
    }

    boolean isEmpty() {
        return requests.isEmpty();
    }

    void clear() {
        requests.clear();
    }
}
