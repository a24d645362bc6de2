package org.phrenic.access.live;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

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

    /** Removes the next request that no other one replaces; empty if there is none. */
    Optional<Runnable> poll() {
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
